// The four plots of a motion, as figures.

import type { Decrement, Law, Series, Solution } from "../engine";
import { type App, SAMPLES } from "../state";
import { type Ghost, labelOf } from "./kept";
import { acting } from "./matters";
import { turns } from "./turns";
import type { Axis, Curve, Figure } from "./plot/figure";
import type { Column } from "./plot/table";

/** Turning points beyond which they would hide the curve. */
const MOST_POINTS = 400;
/** Points of the envelope. */
const COLUMNS = 1000;
/** Rows of a file when the user does not say how many, as on the command line. */
const CSV_SAMPLES = 2001;
/** Areas are wider than lines: more columns than this are not to be told apart, and each costs more than a sample. */
const ENERGIES = 2500;

export const axes = (app: App) => {
  const axis = (id: string, symbol: string, unit: string): Axis => ({ name: app.say(id), symbol, unit });
  return {
    time: axis("plot-time", "t", "s"),
    position: axis("plot-position", "x", "m"),
    velocity: axis("plot-speed", "v", "m/s"),
    energy: axis("plot-energy", "E", "J"),
    amplitude: axis("plot-mean-amplitude", "A", "m"),
    loss: axis("plot-loss", "ΔA", "m"),
    error: axis("plot-error", "Δx", "m"),
  };
};

/** `federpendel-coulomb-auslenkung`: the laws and what is shown, in letters that every disk takes. */
export function fileName(app: App, shown: string): string {
  const plain = (words: string) => words.toLowerCase().replaceAll("ß", "ss").replace(/[äöü]/g, (it) => `${{ ä: "a", ö: "o", ü: "u" }[it]}e`)
    .replace(/[^a-z0-9]+/g, "-");
  return plain(["federpendel", ...(acting(app.state.experiment).length > 0 ? acting(app.state.experiment) : [app.say("mix-none")]), shown].join(" "));
}

/** The name of the motion: beside others what distinguishes it. */
const nameOf = (app: App, others: Ghost[]) =>
  others.length > 0 ? `${app.say("plot-motion")}: ${labelOf(app, app.state.experiment)}` : app.say("plot-motion");

const still = (app: App) => ({ empty: app.say("page-plot-still") });

/** x(t) between two times, with envelope, turning points and sticking band. */
export function motion(app: App, from: number, to: number, others: Ghost[]): Figure {
  const { solution, experiment } = app.state;
  const { summary } = solution;
  const points = turns(app);
  const curve = (label: string, paint: Curve["paint"], one: Solution, duration: number): Curve => {
    const { t, x } = one.course(Math.min(from, duration), Math.min(to, duration), SAMPLES);
    return { label, paint, style: "line", x: t, y: x };
  };
  const curves = others.map(({ label, paint, solution: one, duration }) => curve(label, paint, one, duration));
  curves.push(curve(nameOf(app, others), "exact", solution, experiment.duration));
  if (points.t.length > 1) curves.push(...envelope(app));
  if (points.t.length > 0 && points.t.length <= MOST_POINTS) {
    curves.push({ label: app.say("plot-turning-points"), paint: "points", style: "points", x: points.t, y: points.x });
  }
  const half = summary.stickingOffset;
  return {
    name: fileName(app, app.say("page-show-motion")), title: app.say("page-plot-motion"), description: summary.sentence,
    x: axes(app).time, y: axes(app).position, curves, ...(summary.amplitude === 0 && others.length === 0 ? still(app) : {}),
    ...(experiment.laws.coulomb && half > 0
      ? { band: { label: app.say("plot-sticking-band", { offset: app.quantity(half, "m") }), from: -half, to: half } } : {}),
  };
}

/** Every turning point counts on both sides. */
function envelope(app: App): Curve[] {
  const label = app.say("plot-envelope");
  const { t, x } = app.state.solution.envelope(COLUMNS);
  const side = (sign: 1 | -1, unnamed: boolean): Curve =>
    ({ label, paint: "envelope", style: "line", x: t, y: x.map((value) => sign * value), unnamed });
  return [side(1, false), side(-1, true)];
}

export function phase(app: App, others: Ghost[]): Figure {
  const { solution } = app.state;
  const curve = (label: string, paint: Curve["paint"], one: Solution): Curve => {
    const { x, v } = one.orbit(SAMPLES);
    return { label, paint, style: "line", x, y: v };
  };
  const own = curve(nameOf(app, others), "exact", solution);
  const moves = solution.summary.amplitude > 0 && solution.summary.rests?.time !== 0;
  return {
    name: fileName(app, app.say("page-show-phase")), title: app.say("page-plot-phase"), description: solution.summary.sentence,
    x: axes(app).position, y: axes(app).velocity,
    curves: [...others.map(({ label, paint, solution: one }) => curve(label, paint, one)), { ...own, unnamed: others.length === 0 }],
    ...(moves || others.length > 0 ? {} : still(app)),
  };
}

/** Samples of the motions, as the command line writes them: time, place, velocity and acceleration. */
export function samples(app: App, others: Ghost[]): Column[] {
  const { duration } = app.state.experiment;
  const own = app.state.solution.samples(0, duration, CSV_SAMPLES);
  const head = (id: string, unit: string, label = "") => `${label && `${label}: `}${id} (${unit})`;
  const heads = [app.say("fit-quantity-position"), app.say("fit-quantity-velocity"), app.say("fit-quantity-acceleration")] as const;
  const of = ({ x, v, a }: Series, label?: string): Column[] => [
    { head: head(heads[0], "m", label), values: x }, { head: head(heads[1], "m/s", label), values: v },
    { head: head(heads[2], "m/s^2", label), values: a },
  ];
  return [
    { head: head(app.say("plot-time"), "s"), values: own.t },
    ...of(own, others.length > 0 ? nameOf(app, others) : undefined),
    ...others.flatMap(({ label, solution }) => of(solution.samples(0, duration, CSV_SAMPLES), label)),
  ];
}

/** Energies on top of each other; their sum stays that of the release. */
export function energy(app: App): Figure {
  const { solution, experiment } = app.state;
  const ledger = solution.energies(ENERGIES);
  const parts: { label: string; paint: Curve["paint"]; part: Float64Array }[] = [
    { label: app.say("plot-energy-kinetic"), paint: "kinetic", part: ledger.kinetic },
    { label: experiment.hanging ? app.say("page-energy-hanging") : app.say("plot-energy-potential"), paint: "potential", part: ledger.potential },
  ];
  const heat: [Law, string][] = [
    ["stokes", app.say("plot-energy-stokes")],
    ["coulomb", app.say("plot-energy-coulomb")],
    ["newton", app.say("plot-energy-newton")],
  ];
  for (const [law, label] of heat) {
    if (experiment.laws[law]) parts.push({ label, paint: law, part: ledger[law] });
  }
  let base = new Float64Array(ledger.t.length);
  const curves = parts.map(({ label, paint, part }): Curve => {
    const y = base.map((value, k) => value + part[k]!);
    const curve: Curve = { label, paint, style: "area", x: ledger.t, y, base, alone: part };
    base = y;
    return curve;
  });
  return {
    name: fileName(app, app.say("page-show-energy")),
    title: ledger.t.length < ENERGIES ? app.say("page-plot-energy-mean") : app.say("page-plot-energy"), description: app.say("page-plot-energy-description"),
    x: axes(app).time, y: axes(app).energy, curves, fromZero: true, ...(solution.summary.energy === 0 ? still(app) : {}),
  };
}

/** What each swing costs; `others` are held beside it. */
export function decrement(app: App, swings: Decrement, length = "m", others: Ghost[] = []): Figure {
  const points = (paint: Curve["paint"], { amplitude: x, loss: y }: Decrement): Curve =>
    ({ label: app.say("plot-decrement-swings"), paint, style: "points", x, y });
  const curves = others.flatMap(({ label, paint, solution }): Curve[] => {
    const found = solution.decrement();
    const law = found.parts.slice(0, 1).map(({ loss }): Curve => ({ label, paint, style: "line", x: found.grid, y: loss }));
    return [...law, { ...points(paint, found), label, unnamed: law.length > 0 }];
  });
  for (const { law, label, loss } of swings.parts) {
    curves.push({ label, paint: law === "all" ? "exact" : law, style: "line", x: swings.grid, y: loss });
  }
  curves.push(points("points", swings));
  const { amplitude, loss } = axes(app);
  return {
    name: fileName(app, app.say("page-show-decrement")), title: app.say("page-plot-decrement"), description: app.say("page-plot-decrement-description"),
    x: { ...amplitude, unit: length || "1" }, y: { ...loss, unit: length || "1" }, curves, fromZero: true,
    ...(curves.every(({ x }) => x.length === 0) ? { empty: app.say("page-plot-no-swings") } : {}),
  };
}
