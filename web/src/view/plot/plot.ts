// A plot on the page: draws its figure, zooms, pans, shows a cursor and the values there.

import type { App } from "../../state";
import { h } from "../dom";
import { type Palette, palette, printing } from "../palette";
import { type Axis, type Extent, extent, type Figure } from "./figure";
import { draw, type Frame, toX, toY } from "./draw";
import { gestures } from "./gestures";
import { layers } from "./layers";
import type { Pen } from "./pen";
import { valuesAt } from "./read";
import { saveMenu, svg } from "./save";
import type { Column } from "./table";
import { unitText } from "../symbol";

/** A place marked in a plot: a line across at `x`, a dot where `y` is given too. */
export interface Mark {
  x: number;
  y?: number;
}

export interface Plot {
  element: HTMLElement;
  show(figure: Figure): void;
  /** Shows the same more finely where it is zoomed. */
  refine(figure: Figure): void;
  mark(marks: Mark[], readout: string): void;
  /** The part that is shown, unless it is all. */
  zoomed(): Extent | null;
}

export interface Options {
  /** What the CSV file holds; without it, the curves. */
  columns?(): Column[];
  /** The pointer is at `x`, or has left. */
  onPoint?(x: number | null): void;
  onPick?(x: number): void;
  /** Keeps which part is shown; without it, the plot does. */
  zoom?: Zoom;
  /** Another part is shown than before; what was drawn may be too coarse. */
  onZoom?(): void;
}

/** The part that the reader wishes to see, or none for all. */
export interface Zoom {
  get(): Extent | null;
  set(to: Extent | null): void;
}

function ownZoom(): Zoom {
  let kept: Extent | null = null;
  return { get: () => kept, set: (to) => (kept = to) };
}

const PRINTED = { width: 440, height: 300 };

export const axisLabel = (app: App) => (axis: Axis) =>
  axis.unit === "1"
    ? app.say("plot-axis-pure", { name: axis.name, symbol: axis.symbol })
    : app.say("plot-axis", { name: axis.name, symbol: axis.symbol, unit: unitText(axis.unit) });

/** Smallest part that is shown, of the whole. */
const SMALLEST = 1e-6;

/** What is asked for, as near as it lies within the whole: there is nothing to be seen beside it. */
function part(wished: Extent, whole: Extent): Extent {
  const held = ([from, to]: [number, number], [low, high]: [number, number]): [number, number] => {
    const width = Math.min(Math.max(to - from, SMALLEST * (high - low)), high - low);
    const start = Math.min(Math.max(from, low), high - width);
    return [start, start + width];
  };
  return { x: held(wished.x, whole.x), y: held(wished.y, whole.y) };
}

/** What a plot shows now. */
interface Now {
  figure: Figure | null;
  whole: Extent;
  frame: Frame | null;
  marks: Mark[];
  /** What is said of the marks. */
  words: string;
  hovered: number | null;
  selection: number[] | null;
}

const NOTHING: Now = {
  figure: null, whole: { x: [0, 1], y: [0, 1] }, frame: null, marks: [], words: "", hovered: null, selection: null,
};

export function plot(app: App, options: Options = {}): Plot {
  const screen = layers();
  const parts = elements(screen.canvases);
  const now = { ...NOTHING };
  const zoom = options.zoom ?? ownZoom();
  const zoomed = () => {
    const wished = zoom.get();
    return wished && part(wished, now.whole);
  };
  const shown = () => zoomed() ?? now.whole;

  function redraw(): void {
    const { figure } = now;
    // Paper shows more than a screen has dots, in a size of its own.
    parts.paper.innerHTML = figure && printing() ? svg(app, figure, shown(), PRINTED) : "";
    const pen = screen.curves();
    if (!figure || !pen) return;
    now.frame = draw(pen, figure, shown(), screen.width, screen.height, palette(), app.state.language, axisLabel(app));
    redrawCursor();
  }
  function redrawCursor(): void {
    const pen = screen.cursor();
    if (pen && now.frame) drawCursor(pen, now.frame, now, palette());
  }
  const buttons = gestures(app, parts.area, {
    frame: () => now.frame,
    shown,
    both: () => now.figure?.x.symbol !== "t",
    zoom(to) {
      const found = to && part(to, now.whole);
      const all = found && [...found.x, ...found.y].join() === [...now.whole.x, ...now.whole.y].join();
      zoom.set(all ? null : found);
      options.onZoom?.();
      redraw();
    },
    select(box) {
      now.selection = box;
      redrawCursor();
    },
    // Without a cursor of its own, a plot tells the values at the pointer.
    point: options.onPoint ?? ((x) => {
      now.hovered = x;
      if (now.figure) parts.readout.textContent = x === null ? now.words : valuesAt(app, now.figure, x);
      redrawCursor();
    }),
    pick: (x) => options.onPick?.(x),
  });
  parts.tools.append(...buttons, saveMenu(app, () => now.figure, shown, options.columns));
  screen.fill(parts.area, redraw);
  app.on((changed) => changed.has("colours") && redraw(), parts.element);

  return {
    element: parts.element,
    zoomed,
    refine(figure) {
      now.figure = figure;
      redraw();
    },
    show(figure) {
      Object.assign(now, { figure, whole: extent(figure) });
      parts.title.textContent = figure.title;
      parts.description.textContent = figure.description;
      parts.area.setAttribute("aria-label", `${figure.title}. ${app.say("page-plot-keys")}`);
      redraw();
    },
    mark(marks, words) {
      Object.assign(now, { marks: now.figure?.empty ? [] : marks, words });
      if (now.hovered === null && parts.readout.textContent !== words) parts.readout.textContent = words;
      redrawCursor();
    },
  };
}

function elements(canvases: HTMLCanvasElement[]) {
  const title = h("h3", {});
  const tools = h("div", { class: "plot-tools" });
  const paper = h("div", { class: "plot-paper" });
  const area = h("div", { class: "plot-area", tabindex: 0, role: "group" }, ...canvases, paper);
  const readout = h("output", { class: "readout" });
  const description = h("p", { class: "unseen" });
  const element = h("figure", { class: "plot" },
    h("div", { class: "plot-head" }, title, tools), area, h("figcaption", {}, readout, description));
  return { element, title, tools, paper, area, readout, description };
}

function drawCursor(pen: Pen, at: Frame, { marks, hovered, selection }: Now, colours: Palette): void {
  pen.clip(at.left, at.top, at.width + 6, at.height, () => {
    const all: Mark[] = hovered === null ? marks : [...marks, { x: hovered }];
    for (const mark of all) {
      const x = toX(at, mark.x);
      if (mark.y !== undefined) pen.dot(x, toY(at, mark.y), 5.5, colours.cursor);
      else pen.line([x, at.top, x, at.top + at.height], colours.cursor, 1.5);
    }
    if (selection) pen.line(selection, colours.ink, 1, [4, 3]);
  });
}
