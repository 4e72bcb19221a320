// The experiment: presets, every quantity, the laws of friction, lying or hanging.

import type { Experiment, Law, Parameter } from "../engine";
import type { App } from "../state";
import { h } from "./dom";
import { field, type Field } from "./field";

const COEFFICIENTS: Record<Law, string[]> = {
  stokes: ["damping"],
  coulomb: ["kinetic", "static", "normal_force"],
  newton: ["density", "drag_coefficient", "area"],
};
const NARROW = 700;
const BODY = ["mass", "stiffness", "gravity"];
const RELEASE = ["position", "velocity", "duration"];

export function controls(app: App): HTMLElement {
  const { engine, state } = app;
  const parameters = new Map(engine.parameters(state.language).map((it) => [it.name, it]));
  const fields = new Map<string, Field>();
  const dry = follow();
  const all = [...BODY, ...Object.values(COEFFICIENTS).flat(), ...RELEASE];
  for (const parameter of all.map((name) => parameters.get(name)).filter((it): it is Parameter => !!it)) {
    fields.set(parameter.name, field(app, parameter, (value) => app.tune(dry(parameter.name, value, state.draft.values))));
  }
  const rows = (names: string[]) => names.map((name) => fields.get(name)?.element);
  const present = (names: string[]) => rows(names).filter((row): row is HTMLElement => !!row);
  const choice = presets(app, () => fields.forEach((one) => one.forget()));
  const laws = lawSwitches(app, present);
  const place = hanging(app);
  const refused = h("p", { class: "wrong", hidden: true, role: "alert" });
  const durationButton = h("button", {
    type: "button", click: () => app.tune({ duration: state.solution.summary.suggestedDuration }),
  }, app.say("page-whole-motion"));

  function show(): void {
    const { draft, refusal } = state;
    for (const [name, one] of fields) {
      one.show(name === "duration" ? draft.duration : (draft.values[name] ?? parameters.get(name)!.value));
    }
    fields.get("gravity")?.element.toggleAttribute("hidden", !draft.hanging && !draft.laws.coulomb);
    fields.get("normal_force")?.element.toggleAttribute("hidden", !draft.hanging);
    laws.show();
    place.show();
    choice.show();
    const at = refusal ? fields.get(refusal.field) : undefined;
    refused.textContent = refusal && !at ? refusal.message : "";
    refused.hidden = refused.textContent === "";
  }
  let marked: Field | undefined;
  function showRefusal(): void {
    marked?.refuse("");
    marked = state.refusal ? fields.get(state.refusal.field) : undefined;
    if (state.refusal) marked?.refuse(state.refusal.message);
  }
  app.on((changed) => {
    if (!changed.has("draft")) return;
    show();
    showRefusal();
  });
  show();
  showRefusal();
  return h("section", { class: "controls", "aria-labelledby": "controls-title" },
    h("h2", { id: "controls-title" }, app.say("page-experiment")),
    choice.element, refused,
    group(app.say("page-body"), place.element, ...present(BODY)),
    group(app.say("page-friction"), ...laws.elements),
    group(app.say("page-release"), ...present(RELEASE), durationButton));
}

/** Folded away where there is little room. */
const group = (title: string, ...children: HTMLElement[]) =>
  h("details", { open: innerWidth >= NARROW, role: "group" }, h("summary", {}, h("h3", {}, title)), ...children);

/**
 * What a new value brings along: static friction follows kinetic friction where they are equal, and where kinetic
 * friction would exceed it. It comes back when that is over, as when "0,3" is typed sign by sign.
 */
function follow(): (name: string, value: number, values: Experiment["values"]) => Record<string, number> {
  let own: number | null = null;
  let given = NaN;
  return (name, value, values) => {
    if (name === "static") own = value === values.kinetic ? null : value;
    // Another example, another link.
    else if (values.static !== given) own = values.static === values.kinetic ? null : values.static ?? null;
    given = name === "static" ? value : name === "kinetic" ? Math.max(value, own ?? value) : values.static ?? NaN;
    return name === "kinetic" ? { kinetic: value, static: given } : { [name]: value };
  };
}

interface Shown {
  show(): void;
}

function presets(app: App, forget: () => void): Shown & { element: HTMLElement } {
  const all = app.engine.presets(app.state.language);
  const own = h("option", { value: "" }, app.say("page-preset-own"));
  const select = h("select", { id: "preset" }, own, ...all.map(({ id, label }) => h("option", { value: id }, label)));
  const codes = all.map(({ id, experiment }) => ({ id, code: app.engine.encode(experiment) }));
  select.addEventListener("change", () => {
    const chosen = all.find(({ id }) => id === select.value);
    if (!chosen) return;
    const lens = { ...app.state.lens, method: chosen.method ?? app.state.lens.method, step: null };
    app.update({ draft: chosen.experiment, lens, time: 0, playing: false });
    forget();
    app.announce(`${chosen.label}. ${app.state.solution.summary.sentence}`);
  });
  return {
    element: h("div", { class: "field preset" }, h("label", { for: "preset" }, app.say("page-preset")), select),
    show() {
      const code = app.engine.encode(app.state.experiment);
      // Two graphs of the article may show one experiment.
      const same = codes.filter((it) => it.code === code);
      if (!same.some(({ id }) => id === select.value)) select.value = same[0]?.id ?? "";
    },
  };
}

function lawSwitches(app: App, rows: (names: string[]) => HTMLElement[]): Shown & { elements: HTMLElement[] } {
  const parts = app.engine.laws(app.state.language).map(({ law, label }) => {
    const box = h("input", {
      type: "checkbox", id: `law-${law}`,
      change: () => app.update({ draft: withLaw(app.state.draft, law, box.checked) }),
    });
    const critical = h("button", {
      type: "button",
      click: () => {
        const damping = app.engine.criticalDamping(app.state.draft);
        // Of impossible masses and springs it is none.
        if (Number.isFinite(damping)) app.tune({ damping });
      },
    }, app.say("page-critical"));
    const inner = h("div", { class: "law-values" }, ...rows(COEFFICIENTS[law]), law === "stokes" && critical);
    return { law, box, inner, element: h("div", { class: `law ${law}` }, h("label", { class: "switch" }, box, label), inner) };
  });
  return {
    elements: parts.map((part) => part.element),
    show() {
      for (const { law, box, inner } of parts) {
        box.checked = app.state.draft.laws[law];
        inner.hidden = !box.checked;
      }
    },
  };
}

const withLaw = (draft: Experiment, law: Law, acts: boolean): Experiment => ({ ...draft, laws: { ...draft.laws, [law]: acts } });

function hanging(app: App): Shown & { element: HTMLElement } {
  const option = (value: boolean, words: string) => {
    const box = h("input", {
      type: "radio", name: "hanging",
      change: () => app.update({ draft: { ...app.state.draft, hanging: value } }),
    });
    return { value, box, element: h("label", {}, box, words) };
  };
  const options = [option(false, app.say("page-lying")), option(true, app.say("page-hanging"))];
  return {
    element: h("div", { class: "choice", role: "radiogroup", "aria-label": app.say("page-place") }, ...options.map((it) => it.element)),
    show() {
      for (const { value, box } of options) box.checked = app.state.draft.hanging === value;
    },
  };
}
