// What the engine takes and gives. All numbers are SI.

export type Language = 'en' | 'de';
export type Law = 'stokes' | 'coulomb' | 'newton';

/** Values by the names of `Parameter`; a law that is switched off keeps its own. */
export interface Experiment {
  values: Record<string, number>;
  laws: Record<Law, boolean>;
  hanging: boolean;
  duration: number;
}

export interface Parameter {
  name: string;
  symbol: string;
  /** As it is printed; empty for a pure number. */
  unit: string;
  label: string;
  description: string;
  /** Which values are allowed, in words. */
  allowed: string;
  slider: { low: number; high: number; logarithmic: boolean };
  /** The value to begin with. */
  value: number;
}

/** Why something is not done: the parameter by its name, or '', and a sentence. */
export interface Refusal {
  field: string;
  message: string;
  /** What a field of choices can be set to. */
  offers?: Offer[];
}

/** Something of a file that a field can be set to. */
export interface Offer {
  value: string;
  label: string;
}

/** What the reader says of the experiment, field by field as written. */
export type Asked = Readonly<Record<string, string>>;

export interface Preset {
  id: string;
  label: string;
  experiment: Experiment;
  /** The method that the article's graph shows beside it. */
  method: string | null;
}

export interface Summary {
  kind: string;
  rests: { time: number; position: number; swings: number } | null;
  angularFrequency: number;
  /** Name, symbol and value of what follows from mass, spring and friction. */
  derived: [string, string, string][];
  offset: number;
  amplitude: number;
  /** Half its width. */
  stickingOffset: number;
  /** Of the release. */
  energy: number;
  suggestedDuration: number;
  /** Of numeric methods, to begin with. */
  timeStep: number;
  sentence: string;
}

export interface Series {
  t: Float64Array;
  x: Float64Array;
  v: Float64Array;
  a: Float64Array;
}

export interface Ledger {
  t: Float64Array;
  kinetic: Float64Array;
  potential: Float64Array;
  stokes: Float64Array;
  coulomb: Float64Array;
  newton: Float64Array;
}

/** Along the motion. */
export interface Forces {
  /** Where the mass hangs, the spring carries its weight too. */
  spring: number;
  /** Zero where the mass lies: the guide carries it. */
  weight: number;
  stokes: number;
  coulomb: number;
  newton: number;
  sum: number;
  sticking: boolean;
}

/** The loss of amplitude that one law, or 'all' together, costs at each amplitude of the grid. */
export interface Part {
  law: Law | 'all';
  label: string;
  loss: Float64Array;
}

export interface Decrement {
  amplitude: Float64Array;
  loss: Float64Array;
  grid: Float64Array;
  parts: Part[];
}

export interface Compared {
  t: Float64Array;
  x: Float64Array;
  /** Of the method against the exact motion, signed. */
  error: Float64Array;
  sentences: string[];
}

/** A formula of the article or a numeric method. */
export interface Method {
  id: string;
  label: string;
  /** Whether it takes steps of one length. */
  needsStep: boolean;
  /** Declared. */
  order: number | null;
}

export interface Solution {
  summary: Summary;
  /** Even times, ends included. */
  samples(from: number, to: number, count: number): Series;
  /** For the curve x(t) between two times: of more swings than `count` samples show, the extremes. */
  course(from: number, to: number, count: number): Series;
  /** For the phase portrait of the record: of too many loops, some whole ones. */
  orbit(count: number): Series;
  envelope(count: number): { t: Float64Array; x: Float64Array };
  at(time: number): { x: number; v: number; a: number; forces: Forces };
  /** The release is one too where the mass is at rest then. */
  turningPoints(most: number): { t: Float64Array; x: Float64Array };
  ledger(to: number, count: number): Ledger;
  /** Of the record: of more swings than `count` samples show, fewer rows, each the mean over a period. */
  energies(count: number): Ledger;
  decrement(): Decrement;
  compare(method: string, step: number, count: number): Compared | Refusal;
  free(): void;
}

/** A recording and its fit. */
export interface Fitted {
  name: string;
  quantity: 'position' | 'velocity' | 'acceleration';
  /** Of the values; empty where the file names none. */
  unit: string;
  t: Float64Array;
  value: Float64Array;
  /** Number of the first value that was fitted. */
  first: number;
  fit: Float64Array;
  residual: Float64Array;
  /** Lengths in the unit `length`. */
  decrement: Decrement;
  length: string;
  /** The verdict. */
  sentences: string[];
  rows: [string, string][];
  notes: string[];
  experiment: Experiment | null;
  /** Why there is none, if the reader can do something about it. */
  noExperiment: string | null;
  valueColumns: Offer[];
  timeColumns: Offer[];
  /** The whole report, as HTML, with a `figure` for each picture. */
  report: string;
}

export interface Engine {
  parameters(language: Language): Parameter[];
  laws(language: Language): { law: Law; label: string }[];
  presets(language: Language): Preset[];
  methods(language: Language): Method[];
  solve(experiment: Experiment, language: Language): Solution | Refusal;
  criticalDamping(experiment: Experiment): number;
  encode(experiment: Experiment): string;
  decode(text: string): Experiment | null;
  /** What is assumed of some fields, or which is refused. */
  checkAsked(asked: Asked, language: Language): { remarks: Readonly<Record<string, string>> } | Refusal;
  /** Beside the page, which goes on meanwhile. The fit before it is given up, and never answers. */
  fit(bytes: Uint8Array, name: string, asked: Asked, language: Language): Promise<Fitted[] | Refusal>;
  /** Gives up what is being fitted. */
  giveUp(): void;
  text(language: Language, id: string, variables?: Record<string, string | number>): string;
  number(language: Language, value: number, digits: number): string;
  quantity(language: Language, value: number, unit: string, digits: number): string;
  nine(language: Language, value: number): string;
  parse(language: Language, text: string, parameter: string): { value: number } | Refusal;
}
