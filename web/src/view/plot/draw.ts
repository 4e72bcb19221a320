// Draws a figure with a pen: legend, axes, grid, band, curves.

import { DASHES, type Palette } from "../palette";
import type { Axis, Curve, Extent, Figure } from "./figure";
import type { Pen } from "./pen";
import { ticks, type Tick } from "./ticks";

/** Where the curves lie in the picture, and what they show. */
export interface Frame {
  left: number;
  top: number;
  width: number;
  height: number;
  extent: Extent;
}

const lineOf = (pen: Pen) => Math.round(1.45 * pen.size);
const GAP = 8;
const RIGHT = 14;
/** Room for the sign of a curve beside its name. */
const KEY = 32;

export const toX = (frame: Frame, x: number) =>
  frame.left + ((x - frame.extent.x[0]) / (frame.extent.x[1] - frame.extent.x[0])) * frame.width;
export const toY = (frame: Frame, y: number) =>
  frame.top + frame.height - ((y - frame.extent.y[0]) / (frame.extent.y[1] - frame.extent.y[0])) * frame.height;
export const fromX = (frame: Frame, px: number) =>
  frame.extent.x[0] + ((px - frame.left) / frame.width) * (frame.extent.x[1] - frame.extent.x[0]);
export const fromY = (frame: Frame, py: number) =>
  frame.extent.y[0] + ((frame.top + frame.height - py) / frame.height) * (frame.extent.y[1] - frame.extent.y[0]);

/** A figure of `width` by `height`; `within` joins an axis and its unit into words. */
export function draw(
  pen: Pen, figure: Figure, extent: Extent, width: number, height: number, colours: Palette, language: string,
  axisLabel: (axis: Axis) => string,
): Frame {
  const line = lineOf(pen);
  // Without anything to be seen there is nothing to be named or measured.
  const top = figure.empty ? 0 : legend(pen, figure, width, colours);
  const yTicks = ticks(extent.y, (height - top) / (3.5 * pen.size), language);
  const left = Math.ceil(Math.max(24, ...yTicks.map((tick) => pen.width(tick.label)))) + GAP;
  const frame: Frame = { left, top: top + line + GAP, width: width - left - RIGHT, height: 0, extent };
  frame.height = Math.max(10, height - frame.top - 2 * line - GAP);
  const xTicks = ticks(extent.x, frame.width / (6 * pen.size), language);
  if (!figure.empty) grid(pen, frame, xTicks, yTicks, colours);
  pen.text(axisLabel(figure.y), 2, top + line - 4, colours.ink, "start");
  pen.text(axisLabel(figure.x), frame.left + frame.width, height - 6, colours.ink, "end");
  pen.clip(frame.left, frame.top, frame.width, frame.height, () => {
    if (figure.empty) return;
    if (figure.band) band(pen, frame, figure.band.from, figure.band.to, colours);
    for (const curve of figure.curves) trace(pen, frame, curve, colours);
  });
  for (const [k, words] of (figure.empty ? wrapped(pen, figure.empty, 0.8 * frame.width) : []).entries()) {
    pen.text(words, frame.left + frame.width / 2, frame.top + frame.height / 2 + k * line, colours.faint, "middle");
  }
  const [x, y] = [frame.left, frame.top + frame.height];
  pen.line([x, frame.top, x, y, x + frame.width, y], colours.faint, 1);
  return frame;
}

function grid(pen: Pen, frame: Frame, xTicks: Tick[], yTicks: Tick[], colours: Palette): void {
  const bottom = frame.top + frame.height;
  for (const { value, label } of xTicks) {
    const x = toX(frame, value);
    pen.line([x, frame.top, x, bottom], colours.grid, 1);
    const most = frame.left + frame.width + RIGHT - pen.width(label) / 2;
    pen.text(label, Math.min(x, most), bottom + lineOf(pen) - 2, colours.faint, "middle");
  }
  for (const { value, label } of yTicks) {
    const y = toY(frame, value);
    pen.line([frame.left, y, frame.left + frame.width, y], colours.grid, value === 0 ? 2 : 1);
    pen.text(label, frame.left - GAP + 2, y + 4, colours.faint, "end");
  }
}

function band(pen: Pen, frame: Frame, from: number, to: number, colours: Palette): void {
  const [low, high] = [toY(frame, from), toY(frame, to)];
  const right = frame.left + frame.width;
  // Never thinner than can be seen.
  const half = Math.max(0.75, (low - high) / 2);
  const middle = (low + high) / 2;
  pen.shape([frame.left, middle - half, right, middle - half, right, middle + half, frame.left, middle + half], colours.band);
}

/** Points of a curve in the picture. What lies within a pixel of the last one cannot be seen and is left out. */
function onPaper(frame: Frame, x: ArrayLike<number>, y: ArrayLike<number>): number[] {
  const points: number[] = [];
  const [scaleX, scaleY] = [toX(frame, 1) - toX(frame, 0), toY(frame, 1) - toY(frame, 0)];
  const [originX, originY] = [toX(frame, 0), toY(frame, 0)];
  let [lastX, lastY] = [NaN, NaN];
  const last = Math.min(x.length, y.length) - 1;
  for (let i = 0; i <= last; i++) {
    const px = originX + scaleX * x[i]!;
    const py = originY + scaleY * y[i]!;
    if (!Number.isFinite(py)) continue;
    if (i < last && Math.abs(px - lastX) < 0.7 && Math.abs(py - lastY) < 0.7) continue;
    points.push(px, py);
    [lastX, lastY] = [px, py];
  }
  return points;
}

function trace(pen: Pen, frame: Frame, curve: Curve, colours: Palette): void {
  const points = onPaper(frame, curve.x, curve.y);
  const colour = colours[curve.paint];
  if (points.length === 0) return;
  if (curve.style === "points") {
    const radius = points.length > 400 ? 1.4 : 3;
    for (let i = 0; i < points.length; i += 2) pen.dot(points[i]!, points[i + 1]!, radius, colour);
  } else if (curve.style === "area") {
    pen.shape([...points, ...backwards(onPaper(frame, curve.x, curve.base ?? []))], colour);
    pen.line(points, colours.paper, 1);
  } else {
    pen.line(points, colour, curve.paint === "exact" ? 2 : 1.6, DASHES[curve.paint]);
  }
}

function backwards(points: number[]): number[] {
  const turned: number[] = [];
  for (let i = points.length - 2; i >= 0; i -= 2) turned.push(points[i]!, points[i + 1]!);
  return turned;
}

/** Words in lines that are no wider than `width`, where words let them. */
function wrapped(pen: Pen, label: string, width: number): string[] {
  const lines: string[] = [];
  for (const word of label.split(" ")) {
    const longer = lines.length > 0 ? `${lines.at(-1)} ${word}` : word;
    if (lines.length > 0 && pen.width(longer) <= width) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}

interface Entry {
  label: string;
  key(x: number, y: number): void;
}

/** The names of the curves with their signs, in as many rows as they need; returns where they end. */
function legend(pen: Pen, figure: Figure, width: number, colours: Palette): number {
  const square = (x: number, y: number, colour: string) => pen.shape([x + 5, y - 6, x + 21, y - 6, x + 21, y + 5, x + 5, y + 5], colour);
  const entries: Entry[] = figure.curves
    .filter((curve) => !curve.unnamed)
    .map((curve) => ({
      label: curve.label,
      key(x, y) {
        const colour = colours[curve.paint];
        if (curve.style === "points") pen.dot(x + 13, y, 3, colour);
        else if (curve.style === "area") square(x, y, colour);
        else pen.line([x, y, x + 26, y], colour, 2, DASHES[curve.paint]);
      },
    }));
  if (figure.band) entries.push({ label: figure.band.label, key: (x, y) => square(x, y, colours.band) });
  const line = lineOf(pen);
  let [x, y] = [2, 10];
  for (const entry of entries) {
    const words = wrapped(pen, entry.label, width - KEY);
    const needed = KEY + Math.max(...words.map((it) => pen.width(it)));
    if (x > 2 && x + needed > width) [x, y] = [2, y + line];
    entry.key(x, y);
    for (const [k, it] of words.entries()) pen.text(it, x + KEY, y + 4 + k * line, colours.ink, "start");
    if (words.length > 1) [x, y] = [width, y + (words.length - 1) * line];
    else x += needed + 16;
  }
  return entries.length > 0 ? y + GAP : 0;
}
