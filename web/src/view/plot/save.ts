// A plot as a file: SVG, PNG, and its numbers as CSV.

import type { App } from "../../state";
import { download, h } from "../dom";
import { printed } from "../palette";
import { draw } from "./draw";
import type { Axis, Extent, Figure } from "./figure";
import { canvasPen, type Size, svgDocument, svgPen } from "./pen";
import { axisLabel } from "./plot";
import { type Column, csv } from "./table";

const SIZE = { width: 800, height: 450 };
/** Pixels of the PNG for each of the SVG. */
const SHARPNESS = 3;

export function saveMenu(
  app: App, figure: () => Figure | null, shown: () => Extent, columns?: () => Column[],
): HTMLElement {
  const item = (words: string, act: (figure: Figure) => void) =>
    h("button", {
      type: "button",
      click: () => {
        const now = figure();
        if (now) act(now);
        menu.open = false;
        menu.querySelector("summary")?.focus();
      },
    }, words);
  const saveTable = (now: Figure, german: boolean) =>
    download(`${now.name}.csv`, new Blob([csv(columns?.() ?? columnsOf(now), german)], { type: "text/csv" }));
  const menu = h("details", { class: "menu" },
    h("summary", { class: "tool" }, app.say("page-save")),
    h("div", { class: "menu-items" },
      item("SVG", (now) => download(`${now.name}.svg`, new Blob([svg(app, now, shown())], { type: "image/svg+xml" }))),
      item("PNG", (now) => png(app, now, shown(), (blob) => download(`${now.name}.png`, blob))),
      item(app.say("page-csv"), (now) => saveTable(now, false)),
      item(app.say("page-csv-german"), (now) => saveTable(now, true)),
    ),
  );
  const elsewhere = ({ target }: Event) => {
    if (!menu.contains(target as Node)) menu.open = false;
  };
  menu.addEventListener("toggle", () => {
    if (menu.open) document.addEventListener("pointerdown", elsewhere);
    else document.removeEventListener("pointerdown", elsewhere);
  });
  menu.addEventListener("keydown", (event) => {
    if (event.key !== "Escape") return;
    menu.open = false;
    menu.querySelector("summary")?.focus();
  });
  return menu;
}

function ruler(): CanvasRenderingContext2D {
  const at = document.createElement("canvas").getContext("2d");
  if (!at) throw new Error("this browser does not draw");
  return at;
}

/** The figure as an SVG document, on paper. */
export function svg(app: App, figure: Figure, extent: Extent, size: Size = SIZE): string {
  const parts: string[] = [];
  const pen = svgPen(parts, canvasPen(ruler()), figure.name);
  draw(pen, figure, extent, size.width, size.height, printed, app.state.language, axisLabel(app));
  return svgDocument(parts, figure.name, size, figure.title, figure.description, printed.paper);
}

function png(app: App, figure: Figure, extent: Extent, done: (blob: Blob) => void): void {
  const at = ruler();
  at.canvas.width = SIZE.width * SHARPNESS;
  at.canvas.height = SIZE.height * SHARPNESS;
  at.scale(SHARPNESS, SHARPNESS);
  at.fillStyle = printed.paper;
  at.fillRect(0, 0, SIZE.width, SIZE.height);
  draw(canvasPen(at), figure, extent, SIZE.width, SIZE.height, printed, app.state.language, axisLabel(app));
  at.canvas.toBlob((blob) => blob && done(blob));
}

const head = ({ name, unit }: Axis) => (unit === "1" ? name : `${name} (${unit})`);
const same = (a: ArrayLike<number>, b: ArrayLike<number>) =>
  a === b || (a.length === b.length && Array.prototype.every.call(a, (value, k) => value === b[k]));

/** The curves side by side; those at the same places share their column. */
function columnsOf({ curves, x, y }: Figure): Column[] {
  const columns: Column[] = [];
  let places: ArrayLike<number> | null = null;
  for (const curve of curves) {
    if (!places || !same(places, curve.x)) columns.push({ head: head(x), values: curve.x });
    places = curve.x;
    columns.push({ head: curves.length > 1 ? `${curve.label}: ${head(y)}` : head(y), values: curve.alone ?? curve.y });
  }
  return columns;
}
