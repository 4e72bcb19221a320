// What play, release and steps do to the time of the scene.

import type { App } from "../state";
import { turns } from "./turns";

/** How long one looks at a rest before the time stops, s of the reader. */
const LOOK = 1;

/** The reader wishes for little motion: nothing moves unless it is played. */
export const calm = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

/** Where playing ends: a moment after the rest, or else with the record. */
export function ending(app: App): number {
  const { experiment, solution, speed } = app.state;
  return Math.min(experiment.duration, (solution.summary.rests?.time ?? Infinity) + LOOK * speed);
}

/** Begins anew. */
export function release(app: App, playing = !calm()): void {
  app.update({ held: false, time: 0, playing });
  app.announce(released(app));
}

/** The mass is let go. Where it shall not move by itself, it is shown at one turning point after the other. */
export function letGo(app: App): void {
  if (!calm() || app.state.time >= app.state.experiment.duration) return release(app);
  const begins = app.state.time === 0 ? `${released(app)} ${app.say("page-calm")} ` : "";
  app.update({ held: false });
  app.announce(begins + go(app, 1));
}

export function toggle(app: App): void {
  const { playing, time } = app.state;
  if (!playing && time >= ending(app)) return release(app, true);
  app.update({ playing: !playing });
}

/** To the turning point after or before this time. */
export const step = (app: App, direction: 1 | -1) => app.announce(go(app, direction));

/** Goes there, and says where that is; the release and the end are places to stop too. */
function go(app: App, direction: 1 | -1): string {
  const { solution, time, experiment } = app.state;
  const { t, x } = turns(app);
  const stops = t.filter((it) => it > 0 && it < experiment.duration);
  const near = 1e-9 * experiment.duration;
  const next = direction > 0
    ? (stops.find((it) => it > time + near) ?? experiment.duration)
    : (stops.findLast((it) => it < time - near) ?? 0);
  app.update({ playing: false, time: next });
  const place = x[t.indexOf(next)] ?? solution.at(next).x;
  return app.say("page-stands", { time: app.quantity(next, "s"), position: app.quantity(place, "m") });
}

function released(app: App): string {
  const { values } = app.state.experiment;
  const place = app.quantity(values.position ?? 0, "m");
  const speed = app.quantity(values.velocity ?? 0, "m/s");
  return `${app.say("page-released", { position: place, velocity: speed })} ${app.state.solution.summary.sentence}`;
}
