// Everything the page knows, and the one way to change it.

import { type Asked, type Engine, type Experiment, type Fitted, isRefusal, type Language, type Refusal, type Solution } from "./engine";
import type { Extent } from "./view/plot/figure";

export const PLOTS = ["motion", "phase", "energy", "decrement"] as const;
export type PlotName = (typeof PLOTS)[number];

/** The looks of kept motions. */
export const LOOKS = [0, 1, 2] as const;
export type Look = (typeof LOOKS)[number];

export type Theme = "system" | "light" | "dark";

export interface Recording {
  name: string;
  /** None where the file could not be read. */
  bytes: Uint8Array | null;
  /** Of the sentences in `fits` and `refusal`. */
  language: Language;
  /** What the engine found in the file, run by run; nothing while it is read for the first time, and where it is refused. */
  fits: Fitted[];
  chosen: number;
  busy: boolean;
  /** Why the file is refused, or a field that says something of it. */
  refusal: Refusal | null;
  /** What is said of how it came, as that it is the first of several. */
  remark: string;
}

export interface State {
  language: Language;
  theme: Theme;
  /** What the controls say. It may be impossible; `experiment` is the last one that was not. */
  draft: Experiment;
  experiment: Experiment;
  solution: Solution;
  /** Why the draft is impossible. */
  refusal: Refusal | null;
  /** Time of the scene, s. */
  time: number;
  playing: boolean;
  /** Seconds of the motion in a second of the reader. */
  speed: number;
  /** The mass is in the reader's hand. */
  held: boolean;
  /** Time under the pointer in a plot, s. */
  pointed: number | null;
  arrows: boolean;
  /** Without a step of the reader, that of the motion. */
  lens: { method: string; step: number | null; open: boolean };
  /** Which plots are shown. */
  plots: readonly PlotName[];
  /** The parts of the plots that the reader has enlarged. */
  zooms: Partial<Record<PlotName, Extent>>;
  /** Motions to compare with, each with the number of its look. */
  kept: { experiment: Experiment; look: Look }[];
  recording: Recording | null;
  /** What the reader says of the recorded experiment. */
  asked: Asked;
  /** The verdict waits until it is asked for. */
  classMode: boolean;
  revealed: boolean;
  overlaid: boolean;
  /** Counts how often the colours have changed. */
  colours: number;
}

export type Change = Partial<State>;
export type Changed = ReadonlySet<keyof State>;

export interface App {
  readonly engine: Engine;
  readonly state: Readonly<State>;
  update(change: Change): void;
  /** Puts values into the draft. */
  tune(values: Record<string, number>): void;
  /**
   * Calls `draw` after every change, with the names of what has changed, until the page is built anew, or `part` has been
   * in the page and is no longer.
   */
  on(draw: (changed: Changed) => void, part?: Node): void;
  /** The same, before all others and for ever. */
  always(draw: (changed: Changed) => void): void;
  /** Forgets all that `on` was given. */
  forget(): void;
  say(id: string, variables?: Record<string, string | number>): string;
  quantity(value: number, unit: string, digits?: number): string;
  /** Tells who listens instead of looking. */
  announce(sentence: string): void;
}

interface Listener {
  draw: (changed: Changed) => void;
  part: Node | undefined;
  /** The part has been in the page. */
  seen: boolean;
}

/** Times at which a motion is drawn. */
export const SAMPLES = 10_000;

const DIGITS = 3;
/** Narrower than this, in pixels, there is room for one plot to begin with. */
const NARROW = 700;
/** The address of the command line's built-in experiment: dry friction, which stops the mass. */
const BUILT_IN = "1";

/** The page's model, with this experiment or else the built-in one. */
export function createApp(engine: Engine, language: Language, theme: Theme, given: Experiment | null): App {
  const start = given ?? engine.decode(BUILT_IN);
  if (!start) throw new Error("the engine knows no experiment to begin with");
  const first = engine.solve(start, language);
  if (isRefusal(first)) throw new Error(first.message);
  const state = initial(engine, language, theme, start, first);
  const lasting: ((changed: Changed) => void)[] = [];
  let listeners: Listener[] = [];

  function solveAgain(changed: Set<keyof State>): void {
    const result = engine.solve(state.draft, state.language);
    state.refusal = isRefusal(result) ? result : null;
    changed.add("refusal");
    if (!isRefusal(result)) return take(state.draft, result, changed);
    // The motion stays, and speaks the new language too.
    const same = changed.has("language") && engine.solve(state.experiment, state.language);
    if (same && !isRefusal(same)) take(state.experiment, same, changed);
  }
  function take(experiment: Experiment, solution: Solution, changed: Set<keyof State>): void {
    state.solution.free();
    Object.assign(state, { solution, experiment, time: Math.min(state.time, experiment.duration) });
    for (const name of ["solution", "experiment"] as const) changed.add(name);
  }

  return {
    engine,
    state,
    update(change) {
      Object.assign(state, change);
      const changed = new Set(Object.keys(change) as (keyof State)[]);
      if (changed.has("draft") || changed.has("language")) solveAgain(changed);
      for (const draw of lasting) draw(changed);
      listeners = listeners.filter(({ part, seen }) => !part || part.isConnected || !seen);
      for (const one of listeners) {
        one.seen ||= one.part?.isConnected ?? false;
        one.draw(changed);
      }
    },
    tune(values) {
      const { duration = state.draft.duration, ...rest } = values;
      this.update({ draft: { ...state.draft, duration, values: { ...state.draft.values, ...rest } } });
    },
    on: (draw, part) => void listeners.push({ draw, part, seen: false }),
    always: (draw) => void lasting.push(draw),
    forget: () => (listeners = []),
    say: (id, variables) => engine.text(state.language, id, variables),
    quantity: (value, unit, digits = DIGITS) => engine.quantity(state.language, value, unit, digits),
    announce(sentence) {
      const live = document.getElementById("live");
      if (live) live.textContent = sentence;
    },
  };
}

/** What is shown to begin with. */
export const firstPlots = (): readonly PlotName[] => (innerWidth < NARROW ? ["motion"] : PLOTS);

function initial(engine: Engine, language: Language, theme: Theme, experiment: Experiment, solution: Solution): State {
  return {
    language, theme, draft: experiment, experiment, solution, refusal: null,
    time: 0, playing: false, speed: 1, held: false, pointed: null, arrows: true,
    lens: { method: engine.methods(language)[0]?.id ?? "", step: null, open: false },
    plots: firstPlots(), zooms: {},
    kept: [], recording: null, asked: {}, classMode: false, revealed: false, overlaid: false, colours: 0,
  };
}
