// The error lens: a formula or a scheme beside the exact motion, and how far off it is.

import { isRefusal } from "../engine";
import type { App } from "../state";
import { h, refuse } from "./dom";
import { axes, fileName } from "./figures";
import type { Figure } from "./plot/figure";
import { plot } from "./plot/plot";

const COUNT = 2000;
/** Of a step that the reader has chosen, and of one that he has not. */
const DIGITS = [9, 4] as const;

export function lens(app: App): HTMLElement {
  const { engine, state } = app;
  const methods = engine.methods(state.language);
  const group = (label: string, formula: boolean) => h("optgroup", { label },
    ...methods.filter(({ order }) => (order === null) === formula).map(({ id, label: name }) => h("option", { value: id }, name)));
  const select = h("select", { id: "method" }, group(app.say("page-formulas"), true), group(app.say("page-schemes"), false));
  const program = h("code", { class: "hint" });
  select.value = state.lens.method;
  const step = h("input", { id: "step", type: "text", inputmode: "decimal", autocomplete: "off", "aria-describedby": "step-wrong" });
  const wrong = h("p", { id: "step-wrong", class: "wrong", hidden: true });
  const stepRow = h("div", { class: "field" },
    h("label", { for: "step" }, `${app.say("plot-time-step")} `, h("i", { class: "symbol" }, "Δt")),
    h("span", { class: "number" }, step, h("span", { class: "unit" }, "s")), wrong);
  const sentences = h("ul", { class: "sentences" });
  const course = plot(app);
  const error = plot(app);
  const figures = h("div", { class: "plots" }, course.element, error.element);
  const open = h("details", { class: "part" },
    h("summary", {}, h("h2", {}, app.say("page-lens"))),
    h("p", {}, app.say("page-lens-text")),
    h("div", { class: "row" }, h("div", { class: "field" }, h("label", { for: "method" }, app.say("page-method")), select), stepRow, program),
    sentences, figures);

  let waiting = 0;
  function show(): void {
    clearTimeout(waiting);
    open.open = app.state.lens.open;
    if (!open.open) return;
    select.value = app.state.lens.method;
    const method = methods.find(({ id }) => id === app.state.lens.method);
    stepRow.hidden = !method?.needsStep;
    program.textContent = `federpendel compare --against ${method?.id}`;
    const length = app.state.lens.step ?? app.state.solution.summary.timeStep;
    if (document.activeElement !== step) step.value = engine.number(state.language, length, DIGITS[app.state.lens.step === null ? 1 : 0]);
    const result = app.state.solution.compare(app.state.lens.method, length, COUNT);
    figures.hidden = isRefusal(result);
    if (isRefusal(result)) {
      if (method?.needsStep) refuse(step, wrong, result.message);
      sentences.replaceChildren(...(method?.needsStep ? [] : [h("li", {}, result.message)]));
      return;
    }
    refuse(step, wrong, "");
    sentences.replaceChildren(...result.sentences.map((words) => h("li", {}, words)));
    const label = method?.label ?? "";
    course.show(besideFigure(app, label, result));
    error.show(errorFigure(app, label, result));
  }
  select.addEventListener("change", () => app.update({ lens: { ...app.state.lens, method: select.value } }));
  step.addEventListener("input", () => {
    const read = engine.parse(app.state.language, step.value, "dt");
    if (isRefusal(read)) return refuse(step, wrong, read.message);
    refuse(step, wrong, "");
    app.update({ lens: { ...app.state.lens, step: read.value } });
  });
  open.addEventListener("toggle", () => {
    if (open.open !== app.state.lens.open) app.update({ lens: { ...app.state.lens, open: open.open } });
  });
  app.on((changed) => {
    if (changed.has("lens")) show();
    else if (changed.has("solution")) waiting = later(waiting, show);
  });
  requestAnimationFrame(show);
  return h("section", { "aria-label": app.say("page-lens"), class: "lens" }, open);
}

/** Some methods take seconds for a motion: they wait until the reader's hand rests, ms. */
const REST = 150;

function later(before: number, act: () => void): number {
  clearTimeout(before);
  return setTimeout(act, REST);
}

interface Course {
  t: Float64Array;
  x: Float64Array;
  error: Float64Array;
}

function besideFigure(app: App, label: string, { t, x }: Course): Figure {
  const { solution, experiment } = app.state;
  const exact = solution.samples(0, experiment.duration, COUNT);
  return {
    name: fileName(app, app.state.lens.method), title: app.say("page-plot-method", { method: label }), description: label,
    x: axes(app).time, y: axes(app).position,
    curves: [
      { label: app.say("plot-motion"), paint: "exact", style: "line", x: exact.t, y: exact.x },
      { label, paint: "method", style: "line", x: t, y: x },
    ],
  };
}

const errorFigure = (app: App, label: string, { t, error }: Course): Figure => ({
  name: fileName(app, `${app.state.lens.method} ${app.say("plot-error")}`), title: app.say("page-plot-error", { method: label }), description: label,
  x: axes(app).time, y: axes(app).error,
  curves: [{ label: app.say("plot-error"), paint: "error", style: "line", x: t, y: error, unnamed: true }],
});
