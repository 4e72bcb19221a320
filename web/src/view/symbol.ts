// Symbols and units as they are set in print.

import { h } from "./dom";

/** `μ_s` and `x0` with their index below the line. */
export function symbol(name: string): HTMLElement {
  const [, letter, index] = /^(.)_?(.*)$/u.exec(name) ?? [name, name, ""];
  return h("i", { class: "symbol" }, letter ?? name, index ? h("sub", {}, index) : null);
}

const RAISED: Record<string, string> = { "^2": "²", "^3": "³" };

/** `m/s^2` as m/s²; a pure number has no unit. */
export const unitText = (unit: string) => (unit === "1" ? "" : unit.replace(/\^[23]/g, (power) => RAISED[power] ?? power));
