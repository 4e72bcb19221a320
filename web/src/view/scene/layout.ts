// Where things stand in the scene: along the motion and across it, lying or hanging.

import type { State } from "../../state";

export interface Layout {
  hanging: boolean;
  /** Pixels per metre. */
  scale: number;
  /** Where the wall, the place x = 0 and the end of the room are along the motion, pixels. */
  wall: number;
  origin: number;
  end: number;
  /** How far the middle of the body may be from x = 0, pixels. */
  reach: number;
  /** Half the side of the body, which grows with the cube root of its mass. */
  half: number;
  width: number;
  height: number;
  /** Where the middle of the body moves, across the motion. */
  middle: number;
}

export interface Size {
  width: number;
  /** Of what hangs; what lies is as high as it needs. */
  height: number;
}

/** Between the arrows of the forces, across the motion. */
export const ROW = 15;
const WALL = 22;
const SHORTEST_SPRING = 34;
const MARGIN = 14;
/** Beside what hangs: the ruler with its numbers. */
const RULER = 76;
/** Below what hangs: the name of the ruler. */
const NAME = 20;

/** The scene of a size, in which the body may move `range` metres to both sides. */
export function layout(state: Readonly<State>, size: Size, range: number): Layout {
  const { hanging, laws, values } = state.experiment;
  const half = Math.min(30, Math.max(9, 15 * Math.cbrt((values.mass ?? 1) / 0.5)));
  const rows = (hanging ? 3 : 2) + Object.values(laws).filter(Boolean).length;
  const arrows = half + 14 + ROW * rows;
  const width = Math.max(size.width, hanging ? arrows + half + RULER : 0);
  const middle = hanging ? arrows + (width - arrows - half - RULER) / 2 : arrows + 10;
  const height = hanging ? size.height : middle + half + 54;
  const end = (hanging ? height - NAME : width) - MARGIN;
  const reach = Math.max(1, (end - WALL - SHORTEST_SPRING - 2 * half) / 2);
  return {
    hanging, width, height, half, reach, end, middle,
    scale: reach / range,
    wall: WALL,
    origin: WALL + SHORTEST_SPRING + half + reach,
  };
}

export const along = (at: Layout, x: number) => at.origin + at.scale * x;
export const position = (at: Layout, pixels: number) => (pixels - at.origin) / at.scale;

/** A point `a` along and `c` across the motion: below it when lying, to its right when hanging. */
export const point = (at: Layout, a: number, c: number): [number, number] =>
  at.hanging ? [at.middle + c, a] : [a, at.middle + c];

export const pathOf = (at: Layout, points: [number, number][]) =>
  points.map(([a, c], k) => `${k ? "L" : "M"}${point(at, a, c).map((it) => it.toFixed(1)).join(" ")}`).join("");
