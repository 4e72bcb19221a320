// The plots of the motion, side by side, with one time across all of them.

import { type App, type PlotName, PLOTS, type State } from "../state";
import { h } from "./dom";
import * as figures from "./figures";
import { ghosts, keeper } from "./kept";
import { turns } from "./turns";
import type { Extent, Figure } from "./plot/figure";
import { plot, type Plot } from "./plot/plot";

type All = Record<PlotName, Plot>;

export function plots(app: App): HTMLElement {
  const all = make(app);
  let swings = swingsOf(app);

  const mark = () => markTime(app, all, swings);
  function draw(): void {
    swings = swingsOf(app);
    show(app, all);
    mark();
  }
  app.on((changed) => {
    if (["solution", "kept", "plots"].some((name) => changed.has(name as keyof State))) draw();
    else if (changed.has("time") || changed.has("pointed")) mark();
  });
  // Once the page is laid out, its parts have sizes.
  requestAnimationFrame(draw);
  const touched = matchMedia("(pointer: coarse)").matches;
  return h("section", { class: "plot-section", "aria-labelledby": "plots-title" },
    h("h2", { id: "plots-title" }, app.say("page-plots")),
    h("div", { class: "shown", role: "group", "aria-label": app.say("page-plots-shown") }, ...switches(app, all)),
    keeper(app), h("p", { class: "hint" }, app.say(touched ? "page-plot-hint-touch" : "page-plot-hint")),
    h("div", { class: "plots" }, ...PLOTS.map((name) => all[name].element)));
}

function make(app: App): All {
  const time = {
    onPoint: (pointed: number | null) => app.update({ pointed }),
    onPick: (t: number) => app.update({ playing: false, time: Math.min(app.state.experiment.duration, Math.max(0, t)) }),
  };
  const columns = () => figures.samples(app, ghosts(app));
  const zoom = (name: PlotName) => ({
    get: () => app.state.zooms[name] ?? null,
    set(to: Extent | null) {
      const { [name]: _, ...others } = app.state.zooms;
      app.update({ zooms: to ? { ...others, [name]: to } : others });
    },
  });
  const all: All = {
    motion: plot(app, { ...time, columns, zoom: zoom("motion"), onZoom: () => all.motion.refine(motionZoomed(app, all.motion)) }),
    // Its places are none of one time: the cursor is that of the others.
    phase: plot(app, { columns, zoom: zoom("phase"), onPoint: () => {} }),
    energy: plot(app, { ...time, zoom: zoom("energy") }),
    decrement: plot(app, { zoom: zoom("decrement") }),
  };
  return all;
}

function show(app: App, all: All): void {
  const visible = new Set(app.state.plots);
  const others = ghosts(app);
  const figure: Record<PlotName, () => Figure> = {
    motion: () => figures.motion(app, 0, Infinity, others),
    phase: () => figures.phase(app, others),
    energy: () => figures.energy(app),
    decrement: () => figures.decrement(app, app.state.solution.decrement(), "m", others),
  };
  for (const name of visible) all[name].show(figure[name]());
  if (visible.has("motion") && all.motion.zoomed()) all.motion.refine(motionZoomed(app, all.motion));
}

/** One time in all plots: that under the pointer, or else that of the scene. */
function markTime(app: App, all: All, swings: Swings): void {
  const visible = new Set(app.state.plots);
  const { solution, experiment, pointed, time } = app.state;
  const t = Math.min(Math.max(0, pointed ?? time), experiment.duration);
  const { x, v } = solution.at(t);
  const position = `x = ${app.quantity(x, "m")}`;
  if (visible.has("motion")) all.motion.mark([{ x: t }, { x: t, y: x }], `t = ${app.quantity(t, "s")}, ${position}`);
  if (visible.has("phase")) all.phase.mark([{ x, y: v }], `${position}, v = ${app.quantity(v, "m/s")}`);
  if (visible.has("energy")) all.energy.mark([{ x: t }], energies(app, t));
  if (visible.has("decrement")) markSwing(app, all.decrement, swings, t);
}

function switches(app: App, all: All): HTMLElement[] {
  return PLOTS.map((name) => {
    const box = h("input", { type: "checkbox" });
    const apply = () => {
      box.checked = app.state.plots.includes(name);
      all[name].element.hidden = !box.checked;
    };
    apply();
    box.addEventListener("change", () =>
      app.update({ plots: PLOTS.filter((one) => (one === name ? box.checked : app.state.plots.includes(one))) }));
    app.on((changed) => changed.has("plots") && apply());
    return h("label", { class: "switch" }, box, wordFor(app, name));
  });
}

/** In a word. */
function wordFor(app: App, name: PlotName): string {
  const words: Record<PlotName, string> = {
    motion: app.say("page-show-motion"), phase: app.say("page-show-phase"),
    energy: app.say("page-show-energy"), decrement: app.say("page-show-decrement"),
  };
  return words[name];
}

/** The motion as finely as the part that is shown needs it. */
function motionZoomed(app: App, one: Plot): Figure {
  const [from, to] = one.zoomed()?.x ?? [0, Infinity];
  return figures.motion(app, Math.max(0, from), to, ghosts(app));
}

function energies(app: App, t: number): string {
  const { kinetic, potential, ...heat } = app.state.solution.ledger(t, 2);
  const last = (values: Float64Array) => values.at(-1) ?? 0;
  const lost = last(heat.stokes) + last(heat.coulomb) + last(heat.newton);
  return app.say("page-energies", {
    kinetic: app.quantity(last(kinetic), "J"), potential: app.quantity(last(potential), "J"), heat: app.quantity(lost, "J"),
  });
}

interface Swings {
  turns: Float64Array;
  amplitude: Float64Array;
  loss: Float64Array;
}

const swingsOf = (app: App): Swings => ({ turns: turns(app).t, ...app.state.solution.decrement() });

/** Marks the swing that is going on. */
function markSwing(app: App, one: Plot, { turns: t0, amplitude, loss }: Swings, t: number): void {
  // Of very many swings only some are shown.
  const swing = t0.length > amplitude.length + 1 ? -1 : t0.findLastIndex((it) => it <= t);
  const [x, y] = [amplitude[swing], loss[swing]];
  if (x === undefined || y === undefined) return one.mark([], "");
  one.mark([{ x, y }], app.say("page-swing", { number: swing + 1, amplitude: app.quantity(x, "m"), loss: app.quantity(y, "m") }));
}
