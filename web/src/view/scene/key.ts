// Which arrow is which, and how strong each force is now.

import type { Forces } from "../../engine";
import type { App } from "../../state";
import { h, s } from "../dom";
import { decimals, fixed } from "../fixed";
import { type Arrow, acting } from "./parts";

export interface Key {
  element: HTMLElement;
  /** For other forces than before; the strongest of them decides about decimals, N. */
  rebuild(strongest: number): void;
  show(now: Forces): void;
}

export function key(app: App): Key {
  const box = h("input", { type: "checkbox", change: () => app.update({ arrows: box.checked }) });
  box.checked = app.state.arrows;
  const list = h("ul", {});
  const cells = new Map<Arrow["name"], HTMLElement>();
  let places = 0;
  const words = (value: number) => fixed(app.state.language, value, places);
  return {
    element: h("div", { class: "force-key" }, h("label", { class: "switch" }, box, app.say("page-forces")), list),
    rebuild(strongest) {
      places = decimals(strongest);
      cells.clear();
      const rows = names(app).map(([name, word]) => {
        const cell = h("span", { class: "force-now" });
        cell.style.minWidth = `${words(-strongest).length}ch`;
        cells.set(name, cell);
        return h("li", {}, sign(name), `${word} `, h("span", { class: "unbroken" }, cell, " N"));
      });
      list.replaceChildren(...(app.state.arrows ? rows : []), ...sticking(app));
    },
    show(now) {
      for (const [name, cell] of cells) cell.textContent = words(now[name]);
    },
  };
}

function names(app: App): [Arrow["name"], string][] {
  const laws = app.engine.laws(app.state.language).map(({ law, label }): [Arrow["name"], string] => [law, label]);
  const all: [Arrow["name"], string][] = [
    ["spring", app.say("page-force-spring")], ["weight", app.say("page-force-weight")], ...laws, ["sum", app.say("page-force-sum")],
  ];
  return all.filter(([name]) => acting(app, name));
}

const sign = (name: string) =>
  s("svg", { viewBox: "0 0 34 10", "aria-hidden": "true", class: `force ${name}` },
    s("path", { d: "M0 5H25", class: "shaft" }), s("path", { d: "M34 5L25 0.5V9.5Z", class: "head" }));

/** What the mark on the guide means. */
function sticking(app: App): HTMLElement[] {
  const { experiment: { laws }, solution: { summary: { stickingOffset } } } = app.state;
  if (!laws.coulomb || !(stickingOffset > 0)) return [];
  const mark = s("svg", { viewBox: "0 0 34 10", "aria-hidden": "true" }, s("rect", { x: 4, y: 1, width: 26, height: 8, class: "sticking" }));
  return [h("li", {}, mark, app.say("plot-sticking-band", { offset: app.quantity(stickingOffset, "m") }))];
}
