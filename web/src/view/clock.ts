// Time passes: the frame loop, and what is said when the mass comes to rest or the record ends.

import type { App } from "../state";
import { ending } from "./playing";

/** A pause of the browser is no leap of the motion, s. */
const LONGEST_FRAME = 0.1;
/** How long the end of a record is looked at before it begins anew, s. */
const PAUSE = 0.7;

export function clock(app: App): void {
  let last = 0;
  let running = false;
  let paused = 0;
  let told = false;

  function frame(now: number): void {
    const { state } = app;
    running = state.playing;
    if (!running) return;
    const passed = Math.min(LONGEST_FRAME, Math.max(0, (now - last) / 1000));
    last = now;
    pass(passed);
    requestAnimationFrame(frame);
  }
  function pass(passed: number): void {
    const { state } = app;
    const [before, end, { rests }] = [state.time, ending(app), state.solution.summary];
    const time = Math.min(end, before + passed * state.speed);
    const rested = rests !== null && rests.time <= time;
    if (time < end) app.update({ time });
    else if (rested) app.update({ time, playing: false });
    else atEnd(passed, time);
    if (rested && before < rests.time) {
      app.announce(app.say("page-at-rest", { time: app.quantity(rests.time, "s"), position: app.quantity(rests.position, "m") }));
    }
  }
  /** What still moves when the record ends does not stop in the air. */
  function atEnd(passed: number, time: number): void {
    paused += passed;
    if (paused < PAUSE) return app.update({ time });
    paused = 0;
    app.update({ time: 0 });
    if (told) return;
    told = true;
    app.announce(app.say("page-at-end", { time: app.quantity(time, "s") }));
  }
  app.always((changed) => {
    if (!changed.has("playing") || !app.state.playing) return;
    [paused, told] = [0, false];
    if (running) return;
    running = true;
    last = performance.now();
    requestAnimationFrame(frame);
  });
}
