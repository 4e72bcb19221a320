// What the reader says of the recorded experiment: how the file is to be read, what was measured beside it.

import { type Asked, isRefusal, type Offer, type Refusal } from "../engine";
import { fit } from "../fit/session";
import type { App } from "../state";
import { h, refuse } from "./dom";

interface Field {
  element: HTMLElement;
  control: HTMLInputElement | HTMLSelectElement;
  /** Shows the answer, unless another is being typed: a fit that ends meanwhile must not take it away. */
  show(value: string): void;
  /** What is wrong, or else what is assumed. */
  say(refusal: string, remark: string): void;
}

function field(app: App, name: string, label: string, control: HTMLInputElement | HTMLSelectElement, unit = ""): Field {
  const id = `asked-${name}`;
  const wrong = h("p", { id: `${id}-wrong`, class: "wrong", role: "alert", hidden: true });
  const hint = h("p", { id: `${id}-hint`, class: "hint", hidden: true });
  control.id = id;
  control.setAttribute("aria-describedby", `${id}-wrong ${id}-hint`);
  let typing = false;
  control.addEventListener("input", () => (typing = control instanceof HTMLInputElement));
  control.addEventListener("change", () => {
    typing = false;
    answer(app, { ...app.state.asked, [name]: control.value });
  });
  control.addEventListener("blur", () => (typing = false));
  const shown = unit ? h("span", { class: "number" }, control, h("span", { class: "unit" }, unit)) : control;
  return {
    control,
    element: h("div", { class: "field" }, h("label", { for: id }, label), shown, wrong, hint),
    show(value) {
      if (!typing) control.value = value;
    },
    say(refusal, remark) {
      refuse(control, wrong, refusal);
      hint.textContent = remark;
      hint.hidden = remark === "";
    },
  };
}

/** What is written may be refused; then what was fitted stands. */
export function answer(app: App, asked: Asked): void {
  app.update({ asked });
  if (app.state.recording?.bytes && !isRefusal(app.engine.checkAsked(asked, app.state.language))) void fit(app);
}

const text = (example = "") => h("input", { type: "text", autocomplete: "off", spellcheck: "false", placeholder: example });
const option = ({ value, label }: Offer) => h("option", { value }, label);

function fields(app: App): Map<string, Field> {
  const own = (name: string) => app.say(`asked-${name.replace("_", "-")}`);
  const choices = [
    { value: "", label: app.say("page-support-unknown") },
    { value: "horizontal", label: app.say("page-support-horizontal") },
    { value: "force", label: app.say("page-support-force") },
  ];
  const all: [string, string, HTMLInputElement | HTMLSelectElement, string?][] = [
    ["unit", own("unit"), text("cm")],
    ["value", app.say("measured-values-column"), h("select")],
    ["time", app.say("measured-times-column"), h("select")],
    ["table", own("table"), h("select")],
    ["rate", own("rate"), text("100 Hz")],
    ["from", own("from"), text(), "s"],
    ["to", own("to"), text(), "s"],
    ["mass", own("mass"), text("250 g")],
    ["spring_mass", own("spring_mass"), text("30 g")],
    ["stiffness", own("stiffness"), text("12 N/m")],
    ["support", own("support"), h("select", {}, ...choices.map(option))],
    ["normal_force", own("normal_force"), text("2 N")],
  ];
  return new Map(all.map(([name, label, control, unit]) => [name, field(app, name, label, control, unit)]));
}

export function askedFold(app: App): HTMLElement {
  const all = fields(app);
  const rows = (...names: string[]) => names.map((name) => all.get(name)!.element);
  const fold = h("details", { class: "part asked" },
    h("summary", {}, h("h3", {}, app.say("page-asked"))),
    h("p", { class: "hint" }, app.say("page-asked-text")),
    h("fieldset", {}, h("legend", {}, app.say("page-plot-recording")), ...rows("unit", "value", "time", "table", "rate", "from", "to")),
    h("fieldset", {}, h("legend", {}, app.say("physical-help-heading")), ...rows("mass", "spring_mass", "stiffness", "support", "normal_force")));
  let file = "";
  let offers: Record<string, Offer[]> = {};

  function show(): void {
    const { recording, asked, language } = app.state;
    if (file !== recording?.name) [file, offers] = [recording?.name ?? "", {}];
    const fitted = recording?.fits[recording.chosen];
    if (fitted) offers = { ...offers, value: fitted.valueColumns, time: fitted.timeColumns };
    const checked = app.engine.checkAsked(asked, language);
    const refusal: Refusal | null = isRefusal(checked) ? checked : (recording?.refusal ?? null);
    if (refusal?.offers?.length) offers[refusal.field] = refusal.offers;
    for (const [name, { element, control, show, say }] of all) {
      if (control instanceof HTMLSelectElement && name !== "support") {
        control.replaceChildren(...[{ value: "", label: app.say("page-as-found") }, ...(offers[name] ?? [])].map(option));
      }
      show(asked[name] ?? "");
      say(refusal?.field === name ? refusal.message : "", isRefusal(checked) ? "" : (checked.remarks[name] ?? ""));
      element.hidden = (name === "table" && !offers.table) || (name === "normal_force" && asked.support !== "force");
    }
    if (refusal && all.has(refusal.field)) fold.open = true;
  }
  app.on((changed) => {
    if (changed.has("recording") || changed.has("asked")) show();
  });
  show();
  return fold;
}
