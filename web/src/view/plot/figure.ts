// What a plot shows, whoever draws it.

import type { Paint } from "../palette";

export interface Curve {
  label: string;
  paint: Paint;
  x: ArrayLike<number>;
  y: ArrayLike<number>;
  /** An area reaches down to `base`. */
  style: "line" | "points" | "area";
  base?: ArrayLike<number>;
  /** What stands in a table instead of `y`: of areas on top of each other, each alone. */
  alone?: ArrayLike<number>;
  /** Left out of the legend, as the lower half of an envelope is. */
  unnamed?: boolean;
}

/** A stripe between two values of y. */
export interface Band {
  label: string;
  from: number;
  to: number;
}

export interface Axis {
  name: string;
  symbol: string;
  /** `1` for a pure number. */
  unit: string;
}

export interface Figure {
  /** Of exported files: letters, digits and hyphens. */
  name: string;
  title: string;
  description: string;
  x: Axis;
  y: Axis;
  curves: Curve[];
  band?: Band;
  /** Heights only tell something from zero on. */
  fromZero?: boolean;
  /** Said where there is nothing to draw. */
  empty?: string;
}

export interface Extent {
  x: [number, number];
  y: [number, number];
}

function spread(values: [number, number], from: ArrayLike<number>): void {
  for (let i = 0; i < from.length; i++) {
    const value = from[i]!;
    if (value < values[0]) values[0] = value;
    if (value > values[1]) values[1] = value;
  }
}

/** What holds all curves, with some air above and below. */
export function extent(figure: Figure): Extent {
  const x: [number, number] = [Infinity, -Infinity];
  const y: [number, number] = [Infinity, -Infinity];
  for (const curve of figure.curves) {
    spread(x, curve.x);
    spread(y, curve.y);
    if (curve.base) spread(y, curve.base);
  }
  if (!(x[0] <= x[1])) return { x: [0, 1], y: [0, 1] };
  if (figure.fromZero) y[0] = Math.min(y[0], 0);
  const air = 0.05 * (y[1] - y[0]) || Math.abs(y[1]) || 1;
  const width = x[1] - x[0] || 1;
  return {
    x: figure.x.symbol === "t" ? [x[0], x[0] + width] : [x[0] === 0 ? 0 : x[0] - 0.04 * width, x[1] + 0.04 * width],
    y: [y[0] === 0 ? 0 : y[0] - air, y[1] + air],
  };
}
