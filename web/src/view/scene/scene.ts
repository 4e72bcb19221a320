// The scene: spring, body, guide and medium to scale, with the forces on the body.

import type { Forces } from "../../engine";
import type { App } from "../../state";
import { h, s, set } from "../dom";
import { largest } from "../fixed";
import { body } from "./body";
import { hand } from "./hand";
import { key } from "./key";
import { along, layout, type Layout, type Size } from "./layout";
import { acting, type Arrow, arrows, band, fixed, FORCES, medium, place } from "./parts";

/** Times at which the largest force is looked for, and periods that they are spread over. */
const LOOKS = 200;
const PERIODS = 4;
/** Room for throws beyond the amplitude. */
const ROOM = 1.12;
/** A scale is kept until another experiment makes it so many times too coarse. */
const COARSE = 4;
const FALLBACK = 0.1;
/** Height of letters for which the scene is laid out, pixels; with larger ones all of it grows. */
const LETTERS = 16;
const magnification = () => parseFloat(getComputedStyle(document.documentElement).fontSize) / LETTERS;

export function scene(app: App): HTMLElement {
  const back = s("g", {});
  const forces = arrows();
  const moving = body(app);
  const drawing = s("svg", { class: "scene", role: "group", "aria-label": app.say("page-scene-description") },
    back, ...moving.elements, ...forces.map((it) => it.group));
  const frame = h("div", { class: "scene-frame" }, drawing);
  const legend = key(app);
  const scale = { range: 0, force: 0 };
  let size: Size = { width: 800, height: 400 };
  let letters = magnification();
  let at: Layout = layout(app.state, size, FALLBACK);

  /** What one compares keeps its scale until it no longer fits. The hand alone changes it while it holds the mass. */
  function rescale(coarsest: number): void {
    if (app.state.held) return;
    scale.range = kept(scale.range, farthest(app) || FALLBACK, coarsest);
    at = layout(app.state, size, scale.range);
    const strength = forcesOver(app, at);
    scale.force = kept(scale.force, strength.perPixel, coarsest);
    legend.rebuild(strength.most);
  }
  function rebuild(coarsest: number): void {
    rescale(coarsest);
    at = layout(app.state, size, scale.range);
    set(drawing, { viewBox: `0 0 ${at.width} ${at.height}`, width: at.width * letters, height: at.height * letters });
    drawing.classList.toggle("hanging", at.hanging);
    set(moving.mass, { "aria-orientation": at.hanging ? "vertical" : "horizontal" });
    back.replaceChildren(...ground(app, at));
    move();
  }
  function move(): void {
    const now = app.state.solution.at(app.state.time);
    moving.move(at);
    legend.show(now.forces);
    placeForces(app, at, forces, along(at, now.x), now.forces, scale.force);
  }
  app.on((changed) => {
    // What the hand has made small stays beside what was large before.
    if (changed.has("solution")) rebuild(COARSE);
    else if (changed.has("held") || changed.has("arrows")) rebuild(Infinity);
    else if (changed.has("time")) move();
  });
  hand(app, moving.mass, drawing, {
    layout: () => at,
    grow(factor, most) {
      scale.range = Math.max(scale.range, Math.min(most, scale.range * factor));
    },
  });
  new ResizeObserver(() => {
    if (frame.clientWidth === 0) return;
    letters = magnification();
    size = { width: frame.clientWidth / letters, height: frame.clientHeight / letters };
    scale.force = 0;
    rebuild(Infinity);
  }).observe(frame);
  rebuild(COARSE);
  return h("div", { class: "view" }, h("div", { class: "picture" }, frame, hints(app)), legend.element);
}

/** What does not move. */
function ground(app: App, at: Layout): SVGElement[] {
  const { experiment, solution: { summary: { stickingOffset } } } = app.state;
  const sticks = experiment.laws.coulomb && stickingOffset > 0;
  return [...medium(app, at), ...fixed(app, at), ...(sticks ? [band(at, stickingOffset)] : [])];
}

/** Those that act, each in the next row; a pixel is so many newtons. */
function placeForces(app: App, at: Layout, all: Arrow[], from: number, now: Forces, perPixel: number): void {
  let row = 0;
  for (const arrow of all) {
    const shown = app.state.arrows && acting(app, arrow.name);
    place(at, arrow, shown ? row++ : row, from, shown ? now[arrow.name] / perPixel : 0);
  }
}

const hints = (app: App) => h("div", { class: "hints" },
  h("p", { class: "hint" }, app.say("page-scene-hint")), h("p", { class: "hint keys", id: "mass-keys" }, app.say("page-scene-keys")));

/** A scale that is large enough and not far too large stays. */
const kept = (old: number, needed: number, coarsest: number) =>
  old >= 0.99 * needed && old <= coarsest * needed ? old : ROOM * needed;

/** How far from x = 0 the body is at most within the record: at the release, where it first turns round, or at the end. */
function farthest(app: App): number {
  const { solution, experiment } = app.state;
  return largest([solution.at(0).x, ...solution.turningPoints(2).x, solution.at(experiment.duration).x]);
}

/** The largest force, and how many newtons a pixel must mean for every arrow to stay within the picture. */
function forcesOver(app: App, at: Layout): { most: number; perPixel: number } {
  const { solution, experiment } = app.state;
  const until = Math.min(experiment.duration, (PERIODS * 2 * Math.PI) / solution.summary.angularFrequency);
  const found = { most: 0, perPixel: Number.MIN_VALUE };
  for (let k = 0; k <= LOOKS; k++) {
    const { x, forces } = solution.at((k / LOOKS) * until);
    const a = along(at, x);
    for (const name of FORCES) {
      const force = forces[name];
      // At the edge an arrow may begin behind the middle of the body, by half its length.
      const room = Math.min(0.8 * at.reach, 2 * (force > 0 ? at.end - a : a - at.wall));
      found.most = Math.max(found.most, Math.abs(force));
      found.perPixel = Math.max(found.perPixel, Math.abs(force) / Math.max(1, room));
    }
  }
  return found;
}
