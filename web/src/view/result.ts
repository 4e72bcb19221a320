// What was found in a recording: the verdict, the numbers, the plots.

import type { Fitted } from "../engine";
import type { App } from "../state";
import { answer } from "./asked";
import { download, h } from "./dom";
import type { Figure } from "./plot/figure";
import { plot, type Plot } from "./plot/plot";
import { courseFigure, lossFigure, residualFigure } from "./recorded";
import { report, sections, table } from "./report";

export function result(app: App): HTMLElement {
  const place = h("div", { class: "fit", hidden: true });
  let shown: unknown[] = [];
  function show(): void {
    const { recording, classMode, revealed } = app.state;
    // What is fitted anew stands until it is done.
    const now = [recording?.fits, recording?.chosen, classMode, revealed];
    if (now.every((it, k) => it === shown[k])) return;
    shown = now;
    place.replaceChildren(...parts(app, place));
  }
  app.on(show);
  show();
  return place;
}

function parts(app: App, place: HTMLElement): HTMLElement[] {
  const { recording: now, classMode, revealed } = app.state;
  const fitted = now?.fits[now.chosen];
  place.hidden = !fitted;
  if (!now || !fitted) return [];
  const hidden = classMode && !revealed;
  const head = h("h3", { class: "file" }, fitted.name);
  if (hidden) {
    const reveal = h("button", { type: "button", click: () => app.update({ revealed: true }) }, app.say("page-reveal"));
    return [head, ...chooser(app), h("p", {}, app.say("page-verdict-hidden")), h("div", { class: "row" }, reveal, overlay(app)), pictures(app, fitted, true)];
  }
  return [
    head, ...chooser(app),
    h("div", { class: "verdict" }, ...fitted.sentences.map((words) => h("p", {}, words))),
    h("div", { class: "wide" }, table(fitted)),
    h("ul", { class: "notes" }, ...fitted.notes.map((words) => h("li", {}, words))),
    h("div", { class: "row" }, overlay(app), ...actions(app, fitted)),
    fitted.noExperiment ? h("p", { class: "hint" }, fitted.noExperiment) : "",
    pictures(app, fitted, false),
    h("details", { class: "part" }, h("summary", {}, h("h3", {}, app.say("page-details"))),
      sections(fitted)),
  ].filter((part): part is HTMLElement => part !== "");
}

function chooser(app: App): HTMLElement[] {
  const now = app.state.recording;
  if (!now || now.fits.length < 2) return [];
  const select = h("select", { id: "run" }, ...now.fits.map(({ name }, k) => h("option", { value: k }, name)));
  select.value = String(now.chosen);
  select.addEventListener("change", () => {
    app.update({ recording: { ...app.state.recording!, chosen: Number(select.value) }, revealed: false });
    document.getElementById("run")?.focus();
  });
  return [h("div", { class: "field" }, h("label", { for: "run" }, app.say("page-run")), select)];
}

function overlay(app: App): HTMLElement {
  const box = h("input", { type: "checkbox", change: () => app.update({ overlaid: box.checked }) });
  box.checked = app.state.overlaid;
  app.on((changed) => {
    if (changed.has("overlaid")) box.checked = app.state.overlaid;
  }, box);
  return h("label", { class: "switch" }, box, app.say("page-overlay"));
}

function actions(app: App, fitted: Fitted): HTMLElement[] {
  const { experiment } = fitted;
  const base = fitted.name.replace(/\.[^.]*$/, "");
  const save = () => download(`${base}.html`, new Blob([report(app, fitted)], { type: "text/html" }));
  const simulate = () => {
    app.update({ draft: experiment!, time: 0, playing: false, overlaid: true });
    document.querySelector(".stage")?.scrollIntoView();
    document.querySelector<HTMLElement>(".play")?.focus({ preventScroll: true });
    app.announce(app.say("page-simulating"));
  };
  return [
    ...(experiment ? [h("button", { type: "button", click: simulate }, app.say("page-simulate-fit"))] : []),
    h("button", { type: "button", click: save }, app.say("page-report")),
  ];
}

function pictures(app: App, fitted: Fitted, hidden: boolean): HTMLElement {
  const shownOnly = h("button", { type: "button", hidden: true, click: () => window(course.zoomed()?.x) }, app.say("page-fit-shown"));
  const whole = h("button", { type: "button", click: () => window(undefined) }, app.say("page-fit-whole"));
  const { from, to } = app.state.asked;
  whole.hidden = !from && !to;
  const course = plot(app, { onZoom: () => (shownOnly.hidden = !course.zoomed()) });
  /** As a machine writes numbers, which everyone reads. */
  const written = (time: number) => String(Number(time.toPrecision(6)));
  function window(part: [number, number] | undefined): void {
    const [begin, end] = part?.map(written) ?? ["", ""];
    answer(app, { ...app.state.asked, from: begin!, to: end! });
  }
  const all: [Plot, () => Figure][] = [[course, () => courseFigure(app, fitted, hidden)]];
  if (!hidden) all.push([plot(app), () => residualFigure(app, fitted)]);
  all.push([plot(app), () => lossFigure(app, fitted, hidden)]);
  const element = h("div", {},
    h("div", { class: "row" }, shownOnly, whole), h("div", { class: "plots" }, ...all.map(([one]) => one.element)));
  const draw = () => all.forEach(([one, figure]) => one.show(figure()));
  app.on((changed) => {
    if (changed.has("overlaid") || (changed.has("solution") && app.state.overlaid)) course.show(courseFigure(app, fitted, hidden));
  }, element);
  requestAnimationFrame(draw);
  return element;
}
