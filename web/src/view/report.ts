// The report of a fit: one HTML page to read, print and hand in.

import type { Fitted } from "../engine";
import type { App } from "../state";
import { h } from "./dom";
import { type Figure, extent } from "./plot/figure";
import { svg } from "./plot/save";
import { courseFigure, lossFigure, residualFigure } from "./recorded";

const STYLE = `
body { font: 1rem/1.5 system-ui, sans-serif; max-width: 50rem; margin: 0 auto; padding: 1rem; color: #1c1b1a; background: #fff; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.15rem; margin: 1.8rem 0 0.3rem; break-after: avoid; }
.verdict:first-of-type { font-weight: 600; font-size: 1.1rem; }
svg { display: block; width: 100%; height: auto; }
table { border-collapse: collapse; } caption, figcaption, footer { text-align: left; color: #55514b; font-size: 0.9rem; padding: 0.3rem 0; }
th, td { text-align: left; font-weight: 400; padding: 0.2rem 1.5rem 0.2rem 0; border-top: 1px solid #cfcac2; vertical-align: baseline; }
thead th { font-weight: 600; } figure { margin: 0.5rem 0; break-inside: avoid; } tr { break-inside: avoid; }
@page { size: A4; margin: 18mm; } @media print { body { padding: 0; font-size: 10.5pt; } }`;

export function report(app: App, fitted: Fitted): string {
  const title = app.say("measured-title", { name: fitted.name });
  const page = document.implementation.createHTMLDocument(title);
  page.documentElement.lang = app.state.language;
  page.head.prepend(h("meta", { charset: "utf-8" }), h("meta", { name: "viewport", content: "width=device-width, initial-scale=1" }));
  page.head.append(h("style", {}, STYLE));
  const date = new Date().toLocaleDateString(app.state.language);
  page.body.append(h("main", {},
    h("h1", {}, title),
    ...fitted.sentences.map((words) => h("p", { class: "verdict" }, words)),
    table(fitted),
    drawn(app, fitted)),
    h("footer", {}, h("p", {}, app.say("page-report-footer", { date }))));
  return `<!DOCTYPE html>\n${page.documentElement.outerHTML}\n`;
}

export const table = (fitted: Fitted) =>
  h("table", {}, h("tbody", {}, ...fitted.rows.map(([name, value]) => h("tr", {}, h("th", { scope: "row" }, name), h("td", {}, value)))));

/** The sections of the report as a part of the page, which shows the figures elsewhere. */
export function sections({ report }: Fitted): HTMLElement {
  const place = h("div", { class: "sections" });
  place.innerHTML = report.replaceAll("h2>", "h4>");
  place.querySelectorAll("figure").forEach((figure) => figure.remove());
  return place;
}

/** The same with the figures drawn. */
function drawn(app: App, fitted: Fitted): HTMLElement {
  const place = h("div", {});
  place.innerHTML = fitted.report;
  place.querySelectorAll("figure").forEach((figure) => figure.insertAdjacentHTML("afterbegin", drawings(app, fitted, figure.dataset.name!)));
  return place;
}

function drawings(app: App, fitted: Fitted, name: string): string {
  const figures: Figure[] = name === "figure-loss"
    ? [lossFigure(app, fitted, false)] : [courseFigure(app, fitted, false), residualFigure(app, fitted)];
  return figures.map((figure) => svg(app, figure, extent(figure))).join("");
}
