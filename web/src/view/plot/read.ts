// The values of curves at a place of the x axis.

import type { App } from "../../state";
import type { Axis, Curve, Figure } from "./figure";

const DIGITS = 4;

/** The place of the value of a rising `x` that is nearest to `at`; none beyond the ends. */
function nearest(x: ArrayLike<number>, at: number): number | undefined {
  let [low, high] = [0, x.length - 1];
  if (high < 0 || at < x[0]! || at > x[high]!) return undefined;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (x[middle]! > at) high = middle;
    else low = middle;
  }
  return at - x[low]! < x[high]! - at ? low : high;
}

/** Values have the unit of their axis: a recording may have one that is not of the SI. */
function quantity(app: App, value: number, axis: Axis): string {
  if (axis.unit === "s" || axis.unit === "m") return app.quantity(value, axis.unit);
  return `${app.engine.number(app.state.language, value, DIGITS)} ${axis.unit === "1" ? "" : axis.unit}`.trim();
}

/** Time and, for each line, its value there. */
export function valuesAt(app: App, figure: Figure, at: number): string {
  const told = (curve: Curve): string | null => {
    const k = curve.style === "points" ? undefined : nearest(curve.x, at);
    if (k === undefined) return null;
    return `${curve.label}: ${quantity(app, (curve.alone ?? curve.y)[k]!, figure.y)}`;
  };
  const lines = figure.curves.map(told).filter((it) => it !== null);
  return [`${figure.x.symbol} = ${quantity(app, at, figure.x)}`, ...lines].join(", ");
}
