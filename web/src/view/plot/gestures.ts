// Zoom and pan: by mouse, finger, wheel, key and button.

import type { App } from "../../state";
import { h } from "../dom";
import { type Frame, fromX, fromY } from "./draw";
import type { Extent } from "./figure";

interface Hands {
  frame(): Frame | null;
  shown(): Extent;
  /** Whether both axes are zoomed together; along time the heights stay. */
  both(): boolean;
  /** Shows this part, or all. */
  zoom(to: Extent | null): void;
  /** Corners of the rectangle being drawn, if one is. */
  select(box: number[] | null): void;
  point(x: number | null): void;
  pick(x: number): void;
}

const scaled = ([from, to]: [number, number], factor: number, about = (from + to) / 2): [number, number] => [
  about + (from - about) * factor,
  about + (to - about) * factor,
];
const zoomed = ({ x, y }: Extent, factor: number, heights: boolean, aboutX?: number, aboutY?: number): Extent =>
  ({ x: scaled(x, factor, aboutX), y: heights ? scaled(y, factor, aboutY) : y });
const shifted = ([from, to]: [number, number], by: number): [number, number] => [from + by, to + by];
const width = ([from, to]: [number, number]) => to - from;

/** Nearer than this is a click, pixels. */
const STILL = 5;

export function gestures(app: App, area: HTMLElement, hands: Hands): HTMLElement[] {
  const closer = (factor: number, x?: number, y?: number, heights = hands.both()) =>
    hands.zoom(zoomed(hands.shown(), factor, heights, x, y));
  const pan = (partX: number, partY: number) => {
    const { x, y } = hands.shown();
    hands.zoom({ x: shifted(x, partX * width(x)), y: shifted(y, partY * width(y)) });
  };

  const keys: Record<string, () => void> = {
    "+": () => closer(0.5), "-": () => closer(2), "0": () => hands.zoom(null),
    ArrowLeft: () => pan(-0.1, 0), ArrowRight: () => pan(0.1, 0), ArrowUp: () => pan(0, 0.1), ArrowDown: () => pan(0, -0.1),
  };
  area.addEventListener("keydown", (event) => {
    const act = event.ctrlKey || event.metaKey || event.altKey ? undefined : keys[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  });

  // The wheel scrolls the page unless the plot has been clicked on or Ctrl is held.
  area.addEventListener("wheel", (event) => {
    const frame = hands.frame();
    if (!frame || !(event.ctrlKey || document.activeElement === area)) return;
    event.preventDefault();
    // With Shift some browsers turn the wheel sideways.
    const factor = 1.2 ** Math.sign(event.deltaY || event.deltaX);
    closer(factor, fromX(frame, event.offsetX), fromY(frame, event.offsetY), event.shiftKey || hands.both());
  }, { passive: false });

  pinch(area, hands, drag(area, hands));
  area.addEventListener("dblclick", () => hands.zoom(null));
  const button = (sign: string, label: string, act: () => void) =>
    h("button", { type: "button", class: "tool", "aria-label": label, title: label, click: act }, sign);
  return [
    button("+", app.say("page-zoom-in"), () => closer(0.5)),
    button("−", app.say("page-zoom-out"), () => closer(2)),
    button("↺", app.say("page-zoom-all"), () => hands.zoom(null)),
  ];
}

/** A rectangle drawn with the mouse is enlarged; with Shift, or by a finger, the picture is moved. */
function drag(area: HTMLElement, hands: Hands): () => void {
  let start: { x: number; y: number; moves: boolean; extent: Extent; frame: Frame } | null = null;
  const far = (event: PointerEvent) =>
    start !== null && Math.hypot(event.offsetX - start.x, event.offsetY - start.y) > STILL;

  area.addEventListener("pointerdown", (event) => {
    const frame = hands.frame();
    if (!frame || event.button !== 0) return;
    area.setPointerCapture(event.pointerId);
    const moves = event.shiftKey || event.pointerType === "touch";
    start = { x: event.offsetX, y: event.offsetY, moves, extent: hands.shown(), frame };
  });
  area.addEventListener("pointermove", (event) => {
    const frame = hands.frame();
    if (!frame) return;
    if (!start) return hands.point(fromX(frame, event.offsetX));
    if (!far(event)) return;
    const { x, y, moves, extent } = start;
    if (!moves) return hands.select([x, y, event.offsetX, y, event.offsetX, event.offsetY, x, event.offsetY, x, y]);
    const [byX, byY] = [fromX(start.frame, x) - fromX(start.frame, event.offsetX), fromY(start.frame, y) - fromY(start.frame, event.offsetY)];
    hands.zoom({ x: shifted(extent.x, byX), y: shifted(extent.y, byY) });
  });
  area.addEventListener("pointerup", (event) => {
    if (!start) return;
    const { x, y, moves, frame } = start;
    if (!far(event)) hands.pick(fromX(frame, x));
    else if (!moves) hands.zoom(enlarged(frame, hands.shown(), [x, y], [event.offsetX, event.offsetY]));
    start = null;
    hands.select(null);
  });
  const giveUp = () => {
    start = null;
    hands.select(null);
  };
  area.addEventListener("pointercancel", giveUp);
  area.addEventListener("pointerleave", () => hands.point(null));
  return giveUp;
}

/** Two fingers; the first of them gives up what it has begun. */
function pinch(area: HTMLElement, hands: Hands, giveUp: () => void): void {
  const fingers = new Map<number, PointerEvent>();
  let start: { apart: number; extent: Extent; frame: Frame; middle: { x: number; y: number } } | null = null;
  const middle = ([a, b]: PointerEvent[]) => ({ x: (a!.offsetX + b!.offsetX) / 2, y: (a!.offsetY + b!.offsetY) / 2 });
  const apart = ([a, b]: PointerEvent[]) => Math.hypot(a!.offsetX - b!.offsetX, a!.offsetY - b!.offsetY);
  const lift = (event: PointerEvent) => {
    fingers.delete(event.pointerId);
    start = null;
  };
  area.addEventListener("pointerdown", (event) => {
    const frame = hands.frame();
    if (event.pointerType !== "touch" || !frame) return;
    fingers.set(event.pointerId, event);
    if (fingers.size !== 2) return;
    giveUp();
    const both = [...fingers.values()];
    start = { apart: apart(both), extent: hands.shown(), frame, middle: middle(both) };
  });
  area.addEventListener("pointermove", (event) => {
    if (!fingers.has(event.pointerId)) return;
    fingers.set(event.pointerId, event);
    if (!start) return;
    const both = [...fingers.values()];
    const factor = start.apart / Math.max(STILL, apart(both));
    // What was between the fingers stays there.
    const { frame, middle: from } = start;
    const to = middle(both);
    const [x, y] = [fromX(frame, from.x), fromY(frame, from.y)];
    const large = zoomed(start.extent, factor, hands.both(), x, y);
    const scale = hands.both() ? factor : 1;
    hands.zoom({ x: shifted(large.x, (x - fromX(frame, to.x)) * factor), y: shifted(large.y, (y - fromY(frame, to.y)) * scale) });
  });
  for (const end of ["pointerup", "pointercancel"] as const) area.addEventListener(end, lift);
}

/** What a rectangle holds. A flat one leaves the heights as they are, an upright one the widths. */
function enlarged(frame: Frame, shown: Extent, [x0, y0]: [number, number], [x1, y1]: [number, number]): Extent {
  const order = (a: number, b: number): [number, number] => (a < b ? [a, b] : [b, a]);
  const flat = Math.abs(y1 - y0) < 3 * STILL;
  const upright = Math.abs(x1 - x0) < 3 * STILL;
  return {
    x: upright ? shown.x : order(fromX(frame, x0), fromX(frame, x1)),
    y: flat ? shown.y : order(fromY(frame, y0), fromY(frame, y1)),
  };
}
