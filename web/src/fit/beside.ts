// A fit takes from a tenth of a second to many: a worker does it, while the page goes on moving.

import type { Language } from '../engine-types';
import FitWorker from './worker?worker&inline';

export interface Task {
  module: WebAssembly.Module;
  bytes: Uint8Array;
  name: string;
  /** JSON. */
  asked: string;
  language: Language;
}

/** A fit as the engine gives it: all but the numbers as JSON. */
export interface PlainFit {
  shown: string;
  numbers: Float64Array;
}

/** What is refused is the JSON of a refusal. */
export type Answer = { fits: PlainFit[] } | { refused: string };

let busy: Worker | null = null;

/** What is under way never answers. */
export function giveUp(): void {
  busy?.terminate();
  busy = null;
}

/** Fits beside the page. Who asks again meanwhile has another file: what is under way is given up. */
export function fitBeside(task: Task): Promise<Answer> {
  giveUp();
  const worker = new FitWorker();
  busy = worker;
  return new Promise<Answer>((done, failed) => {
    worker.onmessage = ({ data }: MessageEvent<Answer>) => done(data);
    worker.onmessageerror = () => failed(new Error('the answer cannot be read'));
    worker.onerror = (event) => {
      // Told to the reader in a sentence.
      event.preventDefault();
      failed(new Error(event.message));
    };
    worker.postMessage(task);
  }).finally(() => {
    worker.terminate();
    if (busy === worker) busy = null;
  });
}
