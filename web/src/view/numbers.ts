// The numbers of the motion, with the digits of the command line.

import type { App } from "../state";
import { h } from "./dom";
import { symbol } from "./symbol";
import { turns } from "./turns";

/** Rows of the table; the CSV file has the whole record. */
const MOST_ROWS = 100;

export function numbers(app: App): HTMLElement {
  const values = h("dl", { class: "derived" });
  const rows = h("tbody", {});
  const points = h("table", {},
    h("caption", {}, app.say("plot-turning-points")),
    h("thead", {}, h("tr", {},
      h("th", { scope: "col" }, app.say("page-number")),
      h("th", { scope: "col" }, app.say("page-point-time")),
      h("th", { scope: "col" }, app.say("page-point-position")))), rows);
  const open = h("details", { class: "part" },
    h("summary", {}, h("h2", {}, app.say("page-numbers"))), h("div", { class: "numbers" }, values, h("div", { class: "wide", tabindex: 0, role: "region", "aria-label": app.say("plot-turning-points") }, points)));

  function show(): void {
    if (!open.open) return;
    const { language } = app.state;
    const nine = (value: number) => app.engine.nine(language, value);
    values.replaceChildren(...derived(app).map(([name, sign, value]) =>
      h("div", {}, h("dt", {}, `${name} `, sign && symbol(sign)), h("dd", {}, value))));
    const { t, x } = turns(app);
    // A release at rest is where the motion begins, no turning point of it.
    const from = t[0] === 0 ? 1 : 0;
    rows.replaceChildren(...[...t.slice(from, from + MOST_ROWS)].map((time, k) =>
      h("tr", {}, h("td", {}, String(k + 1)), h("td", {}, nine(time)), h("td", {}, nine(x[k + from]!)))));
    points.hidden = rows.children.length === 0;
  }
  open.addEventListener("toggle", show);
  app.on((changed) => changed.has("solution") && show());
  return h("section", { class: "lens numeric", "aria-label": app.say("page-numbers") }, open);
}

type Row = [name: string, symbol: string, value: string];

function derived(app: App): Row[] {
  const { summary } = app.state.solution;
  const rows: Row[] = [[app.say("page-known-as"), "", summary.kind], ...summary.derived];
  if (summary.rests) {
    const nine = (it: number) => app.engine.nine(app.state.language, it);
    rows.push([app.say("page-rest-time"), "", `${nine(summary.rests.time)} s`]);
    rows.push([app.say("page-rest-position"), "", `${nine(summary.rests.position)} m`]);
  }
  return rows;
}
