// Two canvases on top of each other: curves below, and above them what moves with time.

import { h } from "../dom";
import { canvasPen, type Pen } from "./pen";

/** Height of letters in that of the page. */
const LETTERS = 0.83;

export interface Layers {
  canvases: HTMLCanvasElement[];
  readonly width: number;
  readonly height: number;
  /** A pen on an empty layer; none while the plot has no size. */
  curves(): Pen | null;
  cursor(): Pen | null;
  /** Follows the size of `area`, and calls `resized` when it has changed. */
  fill(area: HTMLElement, resized: () => void): void;
}

export function layers(): Layers {
  const canvases = [0, 1].map(() => h("canvas", { "aria-hidden": "true" }));
  // Asking the browser at every redraw would make it lay out the page each time.
  let [width, height, letters] = [0, 0, 13];

  function clean(canvas: HTMLCanvasElement): Pen | null {
    const at = canvas.getContext("2d");
    if (!at || width === 0) return null;
    const [wide, high] = [Math.round(width * devicePixelRatio), Math.round(height * devicePixelRatio)];
    if (canvas.width !== wide) canvas.width = wide;
    if (canvas.height !== high) canvas.height = high;
    at.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
    at.clearRect(0, 0, width, height);
    return canvasPen(at, letters);
  }
  return {
    canvases,
    get width() {
      return width;
    },
    get height() {
      return height;
    },
    curves: () => clean(canvases[0]!),
    cursor: () => clean(canvases[1]!),
    fill(area, resized) {
      new ResizeObserver(() => {
        [width, height] = [area.clientWidth, area.clientHeight];
        letters = Math.round(LETTERS * Number.parseFloat(getComputedStyle(document.documentElement).fontSize));
        resized();
      }).observe(area);
    },
  };
}
