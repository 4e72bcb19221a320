// The end of the address: the experiment as the engine writes it, and behind it how the page shows it. Names that are not
// known are passed over, so that old links open in new pages, and new ones in old pages.

import { type Engine, type Experiment, isRefusal } from "./engine";
import { type App, type Change, firstPlots, LOOKS, PLOTS, type PlotName, type State } from "./state";
import type { Extent } from "./view/plot/figure";

/** How long the address waits for the next change, ms: browsers refuse to write it at every move of a slider. */
const DELAY = 250;

const LINKED: (keyof State)[] = ["experiment", "time", "playing", "speed", "arrows", "plots", "zooms", "lens", "kept", "classMode"];

/** Keeps the address up to date, but for the time alone while it runs. */
export function keepAddress(app: App): void {
  let waiting = 0;
  app.always((changed) => {
    const running = (name: keyof State) => app.state.playing && name === "time";
    if (!LINKED.some((name) => changed.has(name) && !running(name))) return;
    clearTimeout(waiting);
    waiting = setTimeout(() => history.replaceState(null, "", link(app)), DELAY);
  });
}

/** The whole address that leads here. */
export const address = (app: App) => location.href.split("#")[0] + link(app);

/** What is not as it is to begin with is written. */
function link({ engine, state }: App): string {
  const { time, speed, arrows, plots, lens, classMode } = state;
  const view = [
    time > 0 && `time=${time}`, speed !== 1 && `speed=${speed}`, !arrows && "forces=no",
    plots.join() !== firstPlots().join() && `plots=${plots.join("+")}`,
    lens.open && `method=${lens.method}`, lens.open && lens.step !== null && `step=${lens.step}`, classMode && "class=yes",
    ...PLOTS.map((name) => state.zooms[name] && `zoom-${name}=${bounds(state.zooms[name])}`),
    ...state.kept.map(({ experiment, look }) => `kept${look}=${nested(engine.encode(experiment))}`),
  ];
  return `#${[engine.encode(state.experiment), ...view.filter(Boolean)].join(";")}`;
}

const bounds = ({ x, y }: Extent) => [...x, ...y].join("_");

/** An experiment within the address of another: signs that do not end a part of that one. */
const nested = (encoded: string) => encoded.replaceAll(";", "~").replaceAll("=", ":");
const unnested = (written: string) => written.replaceAll("~", ";").replaceAll(":", "=");

/** Some programs that pass links on write signs as %2B. What is no sign so written stays. */
const unescaped = (text: string) => text.replace(/(?:%[0-9a-f]{2})+/gi, (signs) => {
  try {
    return decodeURIComponent(signs);
  } catch {
    return signs;
  }
});

const given = () => unescaped(location.hash.slice(1));

/** The experiment of the address, if there is one and it can be. */
export const experimentOfAddress = (engine: Engine) => possible(engine, given());

/** The experiment so written, if it can be read and its motion computed. */
function possible(engine: Engine, written: string): Experiment | null {
  const experiment = engine.decode(written);
  if (!experiment) return null;
  const solution = engine.solve(experiment, "en");
  if (isRefusal(solution)) return null;
  solution.free();
  return experiment;
}

/** How the address shows that experiment. */
export function viewOfAddress(engine: Engine, { duration }: Experiment): Change {
  const parts = new Map(given().split(";").map((part) => part.split("=", 2) as [string, string]));
  const positive = (name: string): number | null => {
    const value = Number(parts.get(name));
    return value > 0 && Number.isFinite(value) ? value : null;
  };
  const shown = parts.get("plots")?.split(/[+ ]/);
  const methods = engine.methods("en").map(({ id }) => id);
  const method = methods.find((id) => id === parts.get("method"));
  return {
    time: Math.min(positive("time") ?? 0, duration),
    speed: positive("speed") ?? 1,
    arrows: parts.get("forces") !== "no",
    plots: shown ? PLOTS.filter((name) => shown.includes(name)) : firstPlots(),
    zooms: zooms(parts),
    kept: kept(engine, parts),
    lens: { method: method ?? methods[0] ?? "", step: method ? positive("step") : null, open: method !== undefined },
    // A link of a teacher hides verdicts; none shows those that are hidden.
    ...(parts.get("class") === "yes" && { classMode: true, revealed: false }),
  };
}

function zooms(parts: Map<string, string>): State["zooms"] {
  const rising = (from: number, to: number) => from < to && Number.isFinite(to - from);
  const found = PLOTS.flatMap((name): [PlotName, Extent][] => {
    const bounds = (parts.get(`zoom-${name}`) ?? "").split("_");
    const [left = NaN, right = NaN, low = NaN, high = NaN] = bounds.map((it) => (it === "" ? NaN : Number(it)));
    return bounds.length === 4 && rising(left, right) && rising(low, high) ? [[name, { x: [left, right], y: [low, high] }]] : [];
  });
  return Object.fromEntries(found);
}

/** The motions to compare with, in the order in which they were kept. */
function kept(engine: Engine, parts: Map<string, string>): State["kept"] {
  return [...parts].flatMap(([name, written]) => {
    const look = LOOKS.find((it) => name === `kept${it}`);
    const experiment = look === undefined ? null : possible(engine, unnested(written));
    return look !== undefined && experiment ? [{ experiment, look }] : [];
  });
}
