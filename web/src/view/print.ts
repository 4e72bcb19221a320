// What stands on paper in place of the controls: every value, and how the motion ends.

import type { App } from "../state";
import { address } from "../address";
import { h } from "./dom";
import { matters } from "./matters";
import { symbol as signOf } from "./symbol";

const DIGITS = 6;

export function printed(app: App): HTMLElement {
  const parameters = app.engine.parameters(app.state.language);
  const laws = app.engine.laws(app.state.language);
  const place = h("section", { class: "printed" });

  function show(): void {
    const { experiment, solution } = app.state;
    const used = parameters.filter(({ name }) => matters(experiment, name));
    const acting = laws.filter(({ law }) => experiment.laws[law]).map(({ label }) => label);
    const row = (name: (string | Node)[], value: string) => h("div", {}, h("dt", {}, ...name), h("dd", {}, value));
    place.replaceChildren(
      h("p", {}, [app.say(experiment.hanging ? "page-hanging" : "page-lying"), ...acting].join(", ")),
      h("dl", {},
        ...used.map(({ name, label, symbol, unit, value }) =>
          row([`${label} `, signOf(symbol)], app.quantity(experiment.values[name] ?? value, unit, DIGITS)))),
      h("p", {}, solution.summary.sentence),
      h("p", { class: "source" }, `${new Date().toLocaleDateString(app.state.language, { dateStyle: "long" })}, ${address(app)}`));
  }
  app.on((changed) => changed.has("colours") && show());
  show();
  return place;
}
