// One quantity: its name, symbol, unit, a number to type and a slider.

import { isRefusal, type Parameter } from "../engine";
import type { App } from "../state";
import { h, refuse } from "./dom";
import { symbol as signOf, unitText } from "./symbol";

export interface Field {
  element: HTMLElement;
  /** Shows the value, unless the reader is typing here. */
  show(value: number): void;
  /** Gives up what was typed and could not be taken. */
  forget(): void;
  /** Shows what is wrong, or nothing. */
  refuse(message: string): void;
}

/** Steps of a slider. */
const STEPS = 500;
const DIGITS = 9;

const onScale = ({ low, high, logarithmic }: Parameter["slider"], value: number) =>
  STEPS * (logarithmic ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low));

/** Three digits are enough for a slider, and read better. */
const fromScale = ({ low, high, logarithmic }: Parameter["slider"], step: number) => {
  const part = step / STEPS;
  const value = logarithmic ? low * (high / low) ** part : low + (high - low) * part;
  return Math.abs(value) < 1e-12 * (high - low) ? 0 : Number(value.toPrecision(3));
};

/** `change` takes each value that can be read, and says nothing about whether it is possible beside the others. */
export function field(app: App, parameter: Parameter, change: (value: number) => void): Field {
  const id = `field-${parameter.name}`;
  const { symbol, label, slider, name } = parameter;
  const unit = unitText(parameter.unit);
  const number = h("input", {
    id, type: "text", inputmode: "decimal", autocomplete: "off", spellcheck: "false", "aria-describedby": `${id}-wrong ${id}-unit`,
  });
  const range = h("input", { type: "range", min: 0, max: STEPS, step: 1, "aria-label": `${label} ${symbol}` });
  let current = NaN;
  /** What was last given from here: another value than that comes from elsewhere. */
  let given = NaN;
  let waiting = 0;
  const wrong = h("p", { id: `${id}-wrong`, class: "wrong", hidden: true });

  const tell = (message: string) => refuse(number, wrong, message);
  const written = (value: number) => app.engine.number(app.state.language, value, DIGITS);
  function place(value: number): void {
    const step = onScale(slider, value);
    range.value = String(Number.isFinite(step) ? Math.min(STEPS, Math.max(0, step)) : 0);
    range.setAttribute("aria-valuetext", `${written(value)} ${unit}`.trim());
  }
  number.addEventListener("input", () => {
    const read = app.engine.parse(app.state.language, number.value, name);
    if (isRefusal(read)) return tell(read.message);
    tell("");
    given = read.value;
    change(read.value);
  });
  number.addEventListener("change", () => {
    if (!number.hasAttribute("aria-invalid")) number.value = written(current);
  });
  range.addEventListener("input", () => {
    give(fromScale(slider, Number(range.value)));
  });
  // A thumb that came down here to scroll has moved nothing.
  let before = NaN;
  range.addEventListener("pointerdown", () => (before = current));
  range.addEventListener("pointercancel", () => give(before));

  function give(value: number): void {
    tell("");
    number.value = written(value);
    given = value;
    // A slider moves more often than a screen shows.
    waiting ||= requestAnimationFrame(() => {
      waiting = 0;
      change(given);
    });
  }

  return {
    element: h("div", { class: "field" },
      h("label", { for: id, title: `${parameter.description}: ${parameter.allowed}` }, `${label} `, signOf(symbol)),
      range, h("span", { class: "number" }, number, h("span", { id: `${id}-unit`, class: "unit" }, unit)), wrong),
    show(value) {
      const elsewhere = value !== current && value !== given;
      current = value;
      place(value);
      if (elsewhere) tell("");
      const typing = document.activeElement === number || number.hasAttribute("aria-invalid");
      if (elsewhere || !typing) number.value = written(value);
    },
    forget() {
      tell("");
      number.value = written(current);
    },
    refuse: tell,
  };
}
