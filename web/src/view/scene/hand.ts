// The reader's hand: holds the mass, lets it go, throws it; by pointer or by key.

import type { Parameter } from "../../engine";
import type { App } from "../../state";
import { set } from "../dom";
import { letGo } from "../playing";
import { along, type Layout, position } from "./layout";

/** The speed of a throw is that of the last moments before it, ms. */
const MEMORY = 90;
/** Who has not moved for so long holds still, ms. */
const STILL = 180;
/** Slower than this is no throw, pixels per second. */
const THROW = 80;
/** Whoever is faster than this at the edge throws, and wants to see no more of the scene. */
const FAST = 300;

/** At the edge the picture comes to show so many times as much in a second. */
const GROWTH = 2.5;
/** Between two pictures a slow screen takes no longer, ms. */
const LONGEST_FRAME = 50;

const rounded = (value: number) => (Math.abs(value) < 1e-12 ? 0 : Number(value.toPrecision(3)));
const within = (value: number, least: number, most: number) => Math.min(most, Math.max(least, value));

interface Step {
  /** ms */
  time: number;
  /** Along the motion, pixels of the scene. It may lie outside of what the scene shows. */
  place: number;
}

/** Pixels per second at the end of the trail. */
function paceOf(trail: Step[], now: number): number {
  const [first, last] = [trail[0], trail.at(-1)];
  if (!first || !last || now - last.time > STILL || last.time <= first.time) return 0;
  return (1000 * (last.place - first.place)) / (last.time - first.time);
}

export interface Stage {
  layout(): Layout;
  /** Lets the scene show `factor` times as much, up to `most` metres to both sides. */
  grow(factor: number, most: number): void;
}

/** Where a pointer is along the motion. */
function pixelsOf(event: PointerEvent, at: Layout, scene: SVGSVGElement): number {
  const box = scene.getBoundingClientRect();
  return ((at.hanging ? event.clientY - box.top : event.clientX - box.left) * at.width) / box.width;
}

export function hand(app: App, mass: SVGElement, scene: SVGSVGElement, stage: Stage): void {
  const slider = app.engine.parameters(app.state.language).find(({ name }) => name === "position")!.slider;
  /** The pointer that holds the mass, and where it does, from the middle of the body. */
  let held: { pointer: number; grip: number } | null = null;
  let trail: Step[] = [];
  let waiting = 0;
  let shown = 0;

  const pixels = (event: PointerEvent) => pixelsOf(event, stage.layout(), scene);
  function take(event: PointerEvent): void {
    if (event.button !== 0 || held) return;
    mass.setPointerCapture(event.pointerId);
    const at = stage.layout();
    const off = pixels(event) - along(at, app.state.solution.at(app.state.time).x);
    // What has moved on while the hand came is in the hand all the same.
    held = { pointer: event.pointerId, grip: within(off, -at.half, at.half) };
    trail = [];
    app.update({ held: true, playing: false, time: 0 });
    move(event);
  }
  function move(event: PointerEvent): void {
    if (event.pointerId !== held?.pointer) return;
    const now = event.timeStamp;
    const before = trail.filter(({ time }) => now - time < MEMORY);
    trail = [...(before.length > 0 ? before : trail.slice(-1)), { time: now, place: pixels(event) - held.grip }];
    // A hand moves more often than a screen shows.
    waiting ||= requestAnimationFrame(follow);
  }
  /** The mass goes with the hand to the edge of the scene, and there the scene grows. */
  function follow(now: number): void {
    waiting = 0;
    const place = trail.at(-1)?.place;
    if (place === undefined) return;
    const passed = within(now - shown, 0, LONGEST_FRAME);
    shown = now;
    const { origin, reach } = stage.layout();
    if (held && Math.abs(place - origin) >= reach) {
      waiting = requestAnimationFrame(follow);
      if (Math.abs(paceOf(trail, now)) < FAST) stage.grow(GROWTH ** (passed / 1000), slider.high);
    }
    app.tune({ position: rounded(position(stage.layout(), within(place, origin - reach, origin + reach))), velocity: 0 });
  }
  function drop(event: PointerEvent): void {
    if (event.pointerId !== held?.pointer) return;
    held = null;
    cancelAnimationFrame(waiting);
    follow(event.timeStamp);
    // Where the system takes the finger away, nobody throws.
    if (event.type === "pointercancel") return app.update({ held: false });
    const pace = paceOf(trail, event.timeStamp);
    if (Math.abs(pace) > THROW) app.tune({ velocity: rounded((pace / stage.layout().scale) * app.state.speed) });
    letGo(app);
  }
  // WebKit selects the page's text from here on.
  mass.addEventListener("selectstart", (event) => event.preventDefault());
  mass.addEventListener("pointerdown", take);
  mass.addEventListener("pointermove", move);
  mass.addEventListener("pointerup", drop);
  mass.addEventListener("pointercancel", drop);
  keys(app, mass, slider);
}

/** Arrows move the release, with Shift in small steps; Enter or Space lets go. */
function keys(app: App, mass: SVGElement, { low, high }: Parameter["slider"]): void {
  const step = 10 ** Math.floor(Math.log10((high - low) / 20));
  const to = (value: number) => {
    app.update({ playing: false, time: 0 });
    app.tune({ position: rounded(value), velocity: 0 });
  };
  mass.addEventListener("keydown", (event) => {
    const by = step * (event.shiftKey ? 0.1 : 1);
    const here = app.state.experiment.values.position ?? 0;
    const moves: Record<string, () => void> = {
      ArrowRight: () => to(here + by), ArrowDown: () => to(app.state.experiment.hanging ? here + by : here - by),
      ArrowLeft: () => to(here - by), ArrowUp: () => to(app.state.experiment.hanging ? here - by : here + by),
      PageUp: () => to(here + 5 * step), PageDown: () => to(here - 5 * step),
      Home: () => to(low), End: () => to(high), Enter: () => letGo(app), " ": () => letGo(app),
    };
    const act = moves[event.key];
    if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    act();
  });
  const describe = () => {
    const x = app.state.experiment.values.position ?? 0;
    set(mass, {
      "aria-valuemin": low, "aria-valuemax": high, "aria-valuenow": x, "aria-valuetext": app.quantity(x, "m"),
    });
  };
  app.on((changed) => changed.has("experiment") && describe());
  describe();
}
