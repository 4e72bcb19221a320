// The plots of a recording, as figures.

import { type Fitted, isRefusal } from "../engine";
import { type App, SAMPLES } from "../state";
import { axes, decrement } from "./figures";
import type { Axis, Curve, Figure } from "./plot/figure";

/** What each swing of the recording costs; without the fitted law where that is not to be seen. */
export function lossFigure(app: App, fitted: Fitted, hidden: boolean): Figure {
  const swings = { ...fitted.decrement, parts: hidden ? [] : fitted.decrement.parts };
  return { ...decrement(app, swings, fitted.length), name: "loss" };
}

function valueAxis(app: App, fitted: Fitted): Axis {
  const { position, velocity } = axes(app);
  const known: Record<Fitted["quantity"], Axis> = {
    position, velocity, acceleration: { name: app.say("derived-acceleration"), symbol: "a", unit: "m/s^2" },
  };
  return { ...known[fitted.quantity], unit: fitted.unit || "1" };
}

export function courseFigure(app: App, fitted: Fitted, hidden: boolean): Figure {
  const curves: Curve[] = [{ label: app.say("plot-recorded"), paint: "points", style: "points", x: fitted.t, y: fitted.value }];
  const times = fitted.t.slice(fitted.first, fitted.first + fitted.fit.length);
  if (!hidden) curves.push({ label: app.say("plot-fit"), paint: "exact", style: "line", x: times, y: fitted.fit });
  if (app.state.overlaid) curves.push(simulated(app, fitted, times[0] ?? 0));
  return {
    name: "recording", title: app.say("page-plot-recording"), description: hidden ? "" : (fitted.sentences[0] ?? ""),
    x: axes(app).time, y: valueAxis(app, fitted), curves,
  };
}

/** The motion on the page, begun where the fit begins, on the scale of the recording. */
function simulated(app: App, fitted: Fitted, begin: number): Curve {
  const { solution, experiment } = app.state;
  const series = solution.samples(0, experiment.duration, SAMPLES);
  const { factor, zero } = scaleOf(app, fitted, begin);
  const y = series[COLUMN[fitted.quantity]].map((value) => factor * value + zero);
  return { label: app.say("page-simulated"), paint: "method", style: "line", x: series.t.map((t) => t + begin), y };
}

const COLUMN = { position: "x", velocity: "v", acceleration: "a" } as const;

interface Scale {
  factor: number;
  zero: number;
}
const scales = new WeakMap<Fitted, Scale>();

/**
 * Unit and zero of the recording: the straight line from what was fitted as an experiment to what was fitted, which are
 * one motion. A recording without such an experiment has that of the page as it is.
 */
function scaleOf(app: App, fitted: Fitted, begin: number): Scale {
  const known = scales.get(fitted);
  if (known) return known;
  const motion = fitted.experiment && app.engine.solve(fitted.experiment, app.state.language);
  if (!motion || isRefusal(motion)) return { factor: 1, zero: 0 };
  const column = COLUMN[fitted.quantity];
  const inside = [...fitted.fit.keys()].filter((k) => fitted.t[k + fitted.first]! - begin <= fitted.experiment!.duration);
  const pairs = inside.map((k): [number, number] => [motion.at(fitted.t[fitted.first + k]! - begin)[column], fitted.fit[k]!]);
  motion.free();
  const scale = line(pairs);
  scales.set(fitted, scale);
  return scale;
}

/** Least squares. */
function line(pairs: [number, number][]): Scale {
  const mean = (of: (pair: [number, number]) => number) => pairs.reduce((sum, pair) => sum + of(pair), 0) / pairs.length;
  const [x, y] = [mean((it) => it[0]), mean((it) => it[1])];
  const factor = mean((it) => (it[0] - x) * (it[1] - y)) / mean((it) => (it[0] - x) ** 2);
  return { factor, zero: y - factor * x };
}

export function residualFigure(app: App, fitted: Fitted): Figure {
  const axis = valueAxis(app, fitted);
  return {
    name: "residuals", title: app.say("page-plot-residuals"), description: app.say("plot-residual"),
    x: axes(app).time, y: { ...axis, name: app.say("plot-residual"), symbol: `Δ${axis.symbol}` },
    curves: [{
      label: app.say("plot-residual"), paint: "points", style: "points", unnamed: true,
      x: fitted.t.slice(fitted.first, fitted.first + fitted.residual.length), y: fitted.residual,
    }],
  };
}
