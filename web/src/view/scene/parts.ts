// The parts of the scene: each draws itself anew from the layout and the state.

import type { Law } from "../../engine";
import type { App } from "../../state";
import { s, set } from "../dom";
import { ticks } from "../plot/ticks";
import { along, type Layout, pathOf, point, ROW } from "./layout";

const COILS = 12;
const SPRING_WIDTH = 9;
/** Room of the ruler's numbers beside what hangs. */
const NUMBERS = 70;

/** A zigzag from the wall to the body, whose edge is at `to`. */
export function springPath(at: Layout, to: number): string {
  const lead = 8;
  const length = to - at.wall - 2 * lead;
  const coil = (k: number): [number, number] => [
    at.wall + lead + ((k + 0.5) / (2 * COILS)) * length,
    k % 2 ? -SPRING_WIDTH : SPRING_WIDTH,
  ];
  const inner = Array.from({ length: 2 * COILS }, (_, k) => coil(k));
  return pathOf(at, [[at.wall, 0], [at.wall + lead, 0], ...inner, [to - lead, 0], [to, 0]]);
}

/** Wall, guide and ruler; for a lying body the guide carries it. */
export function fixed(app: App, at: Layout): SVGElement[] {
  const ruler = at.half + 6;
  const from = (at.wall - at.origin) / at.scale;
  const to = (at.end - at.origin) / at.scale;
  // Where numbers are wider than high, fewer fit.
  const room = (at.end - at.wall) / (at.hanging ? 42 : 70);
  const marks = ticks([from, to], room, app.state.language).flatMap(({ value, label }) => {
    const a = along(at, value);
    const [x, y] = point(at, a, ruler + (at.hanging ? 18 : 24));
    return [
      s("path", { d: pathOf(at, [[a, ruler], [a, ruler + (value === 0 ? 12 : 7)]]), class: "guide" }),
      s("text", { x, y: at.hanging ? y + 4 : y, "text-anchor": at.hanging ? "start" : "middle" }, label),
    ];
  });
  const words = app.say("plot-axis", { name: app.say("plot-position"), symbol: "x", unit: "m" });
  const unit = at.hanging
    ? s("text", { x: at.width - 8, y: at.height - 8, "text-anchor": "end", class: "axis" }, words)
    : s("text", { x: at.end, y: at.middle + ruler + 42, "text-anchor": "end", class: "axis" }, words);
  return [
    s("path", { d: pathOf(at, [[at.wall, -34], [at.wall, at.hanging ? 34 : ruler]]), class: "wall" }),
    s("path", { d: pathOf(at, [[at.wall, ruler], [at.end, ruler]]), class: "guide" }),
    ...marks,
    unit,
  ];
}

/** The stretch within which dry friction holds the body, as far as it is in the picture. */
export function band(at: Layout, half: number): SVGElement {
  const ruler = at.half + 6;
  const [from, to] = [Math.max(at.wall, along(at, -half)), Math.min(at.end, along(at, half))];
  const shape = pathOf(at, [[from, ruler], [to, ruler], [to, ruler + 7], [from, ruler + 7]]);
  return s("path", { d: `${shape}Z`, class: "sticking" });
}

/** What the body moves through: streaks that get denser with the medium, a tint for oil. They keep off spring and numbers. */
export function medium(app: App, at: Layout): SVGElement[] {
  const { laws, values } = app.state.experiment;
  const parts: SVGElement[] = [];
  const across: [number, number] = at.hanging ? [-at.middle, at.width - at.middle] : [-at.middle, at.half + 6];
  const [from, to] = [point(at, at.wall, across[0]), point(at, at.end, across[1])];
  const box = { x: from[0], y: from[1], width: to[0] - from[0], height: to[1] - from[1] };
  if (laws.stokes) parts.push(s("rect", { ...box, class: "oil" }));
  if (laws.newton) {
    const liquid = (values.density ?? 0) > 100;
    const rows = liquid ? 9 : 5;
    for (let k = 1; k <= rows; k++) {
      const c = across[0] + (k / (rows + 1)) * (across[1] - across[0]);
      if (Math.abs(c) < SPRING_WIDTH + 5 || (c > at.half && c < at.half + NUMBERS)) continue;
      const wave = Array.from({ length: 60 }, (_, i): [number, number] => [
        at.wall + (i / 59) * (at.end - at.wall), c + 2.5 * Math.sin(i * 0.9 + k),
      ]);
      parts.push(s("path", { d: pathOf(at, wave), class: liquid ? "stream liquid" : "stream" }));
    }
  }
  return parts;
}

export interface Arrow {
  name: "spring" | "weight" | Law | "sum";
  element: SVGPathElement;
  head: SVGPathElement;
  group: SVGGElement;
}

/** From the body upwards. */
export const FORCES: Arrow["name"][] = ["spring", "weight", "stokes", "coulomb", "newton", "sum"];

/** Whether there is such a force: the weight of what lies presses on the guide, not along the motion. */
export function acting(app: App, name: Arrow["name"]): boolean {
  const { hanging, laws } = app.state.experiment;
  return name === "spring" || name === "sum" || (name === "weight" ? hanging : laws[name]);
}

export function arrows(): Arrow[] {
  return FORCES.map((name) => {
    const element = s("path", { class: "shaft" });
    const head = s("path", { class: "head" });
    return { name, element, head, group: s("g", { class: `force ${name}` }, element, head) };
  });
}

/** An arrow of `length` pixels from the middle of the body, in its own row above it; none leaves the picture. */
export function place(at: Layout, arrow: Arrow, row: number, from: number, length: number): void {
  const c = -at.half - 12 - ROW * row;
  const seen = Math.abs(length) >= 1;
  arrow.group.toggleAttribute("hidden", !seen);
  if (!seen) return;
  const tip = Math.min(at.end, Math.max(at.wall, from + length));
  const back = tip - Math.sign(length) * Math.min(9, Math.abs(length));
  set(arrow.element, { d: pathOf(at, [[tip - length, c], [back, c]]) });
  set(arrow.head, { d: `${pathOf(at, [[tip, c], [back, c - 4.5], [back, c + 4.5]])}Z` });
}
