// Beside the page: an engine of its own fits one recording.

import { fit, initSync } from '../wasm/federpendel.js';
import type { Answer, Task } from './beside';

onmessage = ({ data: { module, bytes, name, asked, language } }: MessageEvent<Task>) => {
  initSync({ module });
  postMessage(answer(() => fit(bytes, name, asked, language)));
};

function answer(found: () => ReturnType<typeof fit>): Answer {
  try {
    return { fits: found().map((one) => ({ shown: one.shown(), numbers: one.numbers() })) };
  } catch (thrown) {
    // Anything else is a fault, of which the page hears as an error of this worker.
    if (typeof thrown !== 'string') throw thrown;
    return { refused: thrown };
  }
}
