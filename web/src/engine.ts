// The engine: the exports of crates/federpendel-wasm with their types.

import { Decoder } from 'lzma1/decoder';
import { InputBuffer, OutputBuffer } from 'lzma1/streams';
import * as wasm from './wasm/federpendel.js';
import packed from 'virtual:engine';
import { fitBeside, giveUp, type PlainFit } from './fit/beside';
import type {
  Compared, Decrement, Engine, Experiment, Fitted, Law, Method, Parameter, Preset, Refusal, Solution, Summary,
} from './engine-types';

export type * from './engine-types';

/** Whether something was refused. */
export function isRefusal(found: object): found is Refusal {
  return 'message' in found && 'field' in found;
}

/** What `make` gives, or what it throws as a refusal. Anything else is a fault and goes on. */
function orRefusal<T>(make: () => T): T | Refusal {
  try {
    return make();
  } catch (thrown) {
    if (typeof thrown !== 'string') throw thrown;
    return JSON.parse(thrown) as Refusal;
  }
}

/** `count` columns that stand one behind the other. */
function columns(numbers: Float64Array, count: number): Float64Array[] {
  const rows = numbers.length / count;
  return Array.from({ length: count }, (_, i) => numbers.subarray(i * rows, (i + 1) * rows));
}

interface Plain {
  amplitude: number[];
  loss: number[];
  grid: number[];
  parts: { law: Law | 'all'; label: string; loss: number[] }[];
}

function decrement(plain: Plain): Decrement {
  return {
    amplitude: Float64Array.from(plain.amplitude),
    loss: Float64Array.from(plain.loss),
    grid: Float64Array.from(plain.grid),
    parts: plain.parts.map((part) => ({ ...part, loss: Float64Array.from(part.loss) })),
  };
}

function compared(inner: wasm.Compared): Compared {
  const [t, x, error] = columns(inner.numbers(), 3);
  const sentences = inner.sentences();
  inner.free();
  return { t, x, error, sentences };
}

/** The last answer again for who asks the same: several plots draw one motion. */
function remembered<Asked extends number[], T>(make: (...asked: Asked) => T): (...asked: Asked) => T {
  let last: { asked: Asked; answer: T } | undefined;
  return (...asked) => {
    if (!last || asked.some((it, k) => it !== last!.asked[k])) last = { asked, answer: make(...asked) };
    return last.answer;
  };
}

function series(numbers: Float64Array) {
  const [t, x, v, a] = columns(numbers, 4);
  return { t, x, v, a };
}

function ledger(numbers: Float64Array) {
  const [t, kinetic, potential, stokes, coulomb, newton] = columns(numbers, 6);
  return { t, kinetic, potential, stokes, coulomb, newton };
}

function points(numbers: Float64Array) {
  const [t, x] = columns(numbers, 2);
  return { t, x };
}

function solution(inner: wasm.Solution): Solution {
  return {
    summary: JSON.parse(inner.summary()) as Summary,
    samples: (from, to, count) => series(inner.samples(from, to, count)),
    course: (from, to, count) => series(inner.course(from, to, count)),
    orbit: (count) => series(inner.orbit(count)),
    envelope: (count) => points(inner.envelope(count)),
    at(time) {
      const [x, v, a, spring, weight, stokes, coulomb, newton, sum, sticking] = inner.at(time);
      return { x, v, a, forces: { spring, weight, stokes, coulomb, newton, sum, sticking: sticking === 1 } };
    },
    turningPoints: remembered((most) => points(inner.turningPoints(most))),
    ledger: (to, count) => ledger(inner.ledger(to, count)),
    energies: (count) => ledger(inner.energies(count)),
    decrement: remembered(() => decrement(JSON.parse(inner.decrement()) as Plain)),
    compare: (method, step, count) => orRefusal(() => compared(inner.compare(method, step, count))),
    free: () => inner.free(),
  };
}

interface PlainFitted extends Omit<Fitted, 't' | 'value' | 'fit' | 'residual' | 'decrement'> {
  count: number;
  decrement: Plain;
}

function fitted({ shown: text, numbers }: PlainFit): Fitted {
  const { count, ...shown } = JSON.parse(text) as PlainFitted;
  const all = (numbers.length - 2 * count) / 2;
  return {
    ...shown,
    t: numbers.subarray(0, all),
    value: numbers.subarray(all, 2 * all),
    fit: numbers.subarray(2 * all, 2 * all + count),
    residual: numbers.subarray(2 * all + count),
    decrement: decrement(shown.decrement),
  };
}

/** What the engine is made of, for those who need one of their own. */
let module: WebAssembly.Module;

const engine: Engine = {
  parameters: (language) => JSON.parse(wasm.parameters(language)) as Parameter[],
  laws: (language) => JSON.parse(wasm.laws(language)) as { law: Law; label: string }[],
  presets: (language) => JSON.parse(wasm.presets(language)) as Preset[],
  methods: (language) => JSON.parse(wasm.methods(language)) as Method[],
  solve: (experiment, language) =>
    orRefusal(() => solution(new wasm.Solution(JSON.stringify(experiment), language))),
  criticalDamping: (experiment) => wasm.criticalDamping(JSON.stringify(experiment)),
  encode: (experiment) => wasm.encode(JSON.stringify(experiment)),
  decode(text) {
    const found = wasm.decode(text);
    return found === undefined ? null : (JSON.parse(found) as Experiment);
  },
  checkAsked: (asked, language) =>
    orRefusal(() => ({ remarks: Object.fromEntries(JSON.parse(wasm.checkAsked(JSON.stringify(asked), language)) as [string, string][]) })),
  async fit(bytes, name, asked, language) {
    const answer = await fitBeside({ module, bytes, name, asked: JSON.stringify(asked), language });
    return 'refused' in answer ? (JSON.parse(answer.refused) as Refusal) : answer.fits.map(fitted);
  },
  giveUp,
  text: (language, id, variables = {}) => wasm.text(language, id, JSON.stringify(variables)),
  number: (language, value, digits) => wasm.number(language, value, digits),
  quantity: (language, value, unit, digits) => wasm.quantity(language, value, unit, digits),
  nine: (language, value) => wasm.number(language, value, 9),
  parse: (language, text, name) =>
    orRefusal(() => ({ value: wasm.parse(language, text, name) })),
};

/** The module, which the page holds compressed within itself. */
function unpacked(): Uint8Array<ArrayBuffer> {
  const bytes = Uint8Array.from(atob(packed), (sign) => sign.charCodeAt(0));
  const module = new OutputBuffer(4 * bytes.length);
  new Decoder().decompress(new InputBuffer(bytes), module);
  return new Uint8Array(module.toArray());
}

export async function load(): Promise<Engine> {
  module = await WebAssembly.compile(unpacked());
  wasm.initSync({ module });
  return engine;
}
