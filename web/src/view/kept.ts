// Motions that the reader keeps, to hold others beside them.

import { type Experiment, isRefusal, type Solution } from "../engine";
import { type App, LOOKS } from "../state";
import { h, s } from "./dom";
import { DASHES } from "./palette";
import { acting, LAW_OF, matters } from "./matters";
import { unitText } from "./symbol";

type Kept = App["state"]["kept"][number];

/** A kept motion as the plots draw it. */
export interface Ghost {
  label: string;
  paint: `kept${Kept["look"]}`;
  solution: Solution;
  duration: number;
}

interface Solved {
  solution: Solution;
  duration: number;
  /** How long it should be. */
  wished: number;
}

const solved = new WeakMap<Experiment, Solved>();

/** Long enough to be seen beside the motion on the page; where it would swing too often so long, as long as it was kept. */
function solve(app: App, experiment: Experiment): Solved | null {
  const wished = Math.max(experiment.duration, app.state.experiment.duration);
  const known = solved.get(experiment);
  if (known?.wished === wished) return known;
  for (const duration of [wished, experiment.duration]) {
    const solution = app.engine.solve({ ...experiment, duration }, app.state.language);
    if (isRefusal(solution)) continue;
    known?.solution.free();
    const found = { solution, duration, wished };
    solved.set(experiment, found);
    return found;
  }
  return null;
}

export const ghosts = (app: App): Ghost[] =>
  app.state.kept.flatMap(({ experiment, look }) => {
    const found = solve(app, experiment);
    if (!found) return [];
    const { solution, duration } = found;
    return [{ solution, duration, label: labelOf(app, experiment), paint: `kept${look}` as const }];
  });

/** Coefficients that tell more than the law alone. */
const TELLING = ["damping", "kinetic"];

/** The laws, and what else is not the same in all motions that are shown. */
export function labelOf(app: App, it: Experiment): string {
  const others = [app.state.experiment, ...app.state.kept.map(({ experiment }) => experiment)];
  const differs = (name: string) => others.some((other) => {
    const law = LAW_OF[name];
    return (!law || other.laws[law]) && (!matters(other, name) || other.values[name] !== it.values[name]);
  });
  const told = app.engine.parameters(app.state.language)
    .filter(({ name }) => matters(it, name) && (TELLING.includes(name) || differs(name)))
    .sort((a, b) => Number(b.name in LAW_OF) - Number(a.name in LAW_OF))
    .map(({ name, symbol, unit, value }) =>
      `${symbol.replace("_", "")} = ${app.engine.number(app.state.language, it.values[name] ?? value, 4)} ${unitText(unit)}`.trim().replaceAll(" ", "\u00a0"));
  return [acting(it).join(" + ") || app.say("mix-none"), told.join("; ")].join(" ").trim();
}

/** The button that keeps the motion, and the kept ones, each with a button to remove it. */
export function keeper(app: App): HTMLElement {
  const list = h("ul", {});
  const keep = h("button", { type: "button", click: add }, app.say("page-keep"));

  function add(): void {
    const { kept, experiment } = app.state;
    const look = LOOKS.find((it) => kept.every((other) => other.look !== it));
    const known = kept.some((it) => app.engine.encode(it.experiment) === app.engine.encode(experiment));
    if (look !== undefined && !known) app.update({ kept: [...kept, { experiment, look }] });
  }
  function item({ experiment, look }: Kept): HTMLElement {
    const label = labelOf(app, experiment);
    const remove = () => {
      app.update({ kept: app.state.kept.filter((it) => it.experiment !== experiment) });
      keep.focus();
    };
    return h("li", {},
      s("svg", { width: 34, height: 10, "aria-hidden": "true" },
        s("line", { x1: 0, y1: 5, x2: 34, y2: 5, stroke: `var(--kept${look})`, "stroke-width": 2.5, "stroke-dasharray": DASHES[`kept${look}`]!.join(" ") })),
      label, h("button", { type: "button", class: "tool", "aria-label": app.say("page-forget", { curve: label }), click: remove }, "×"));
  }
  const show = () => {
    list.replaceChildren(...app.state.kept.map(item));
    keep.disabled = app.state.kept.length === LOOKS.length;
  };
  app.on((changed) => (changed.has("kept") || (changed.has("solution") && app.state.kept.length > 0)) && show());
  show();
  return h("div", { class: "kept" }, keep, list);
}
