// What moves in the scene: the body with its spring and its pointer on the ruler, and the place where a hand takes it.

import type { App } from "../../state";
import { s, set } from "../dom";
import { along, type Layout, pathOf, point } from "./layout";
import { springPath } from "./parts";

/** A hand grips within so many pixels of the middle of the body: fingers are thick. */
const GRIP = 28;
/** A hand comes late where the body moves fast, s of the reader. */
const LATE = 0.25;
/** Room for a word at the edge of the picture. */
const WORD = 30;

export interface Body {
  mass: SVGGElement;
  /** From back to front. */
  elements: SVGElement[];
  /** Shows it where it is at the time of the scene. */
  move(at: Layout): void;
}

/** A rectangle around all places between two along the motion. */
const around = (at: Layout, from: number, to: number, half: number) =>
  `${pathOf(at, [[from - half, -half], [to + half, -half], [to + half, half], [from - half, half]])}Z`;

export function body(app: App): Body {
  const spring = s("path", { class: "spring" });
  const block = s("path", { class: "body" });
  const pointer = s("path", { class: "pointer" });
  const grip = s("path", { class: "grip" });
  const lock = s("text", { class: "lock" }, app.say("page-sticks"));
  const mass = s("g", {
    class: "mass", role: "slider", tabindex: 0, "aria-label": app.say("page-mass-handle"), "aria-describedby": "mass-keys",
  }, block, pointer, grip);

  function move(at: Layout): void {
    const { solution, time, playing, speed } = app.state;
    const now = solution.at(time);
    const [a, b] = [along(at, now.x), at.half];
    set(spring, { d: springPath(at, a - b) });
    set(block, { d: around(at, a, a, b) });
    set(pointer, { d: pathOf(at, [[a, b - 8], [a, b + 8]]) });
    const before = playing ? along(at, solution.at(Math.max(0, time - LATE * speed)).x) : a;
    set(grip, { d: around(at, Math.min(a, before), Math.max(a, before), Math.max(GRIP, b + 4)) });
    const [x, y] = point(at, a, 0);
    set(lock, at.hanging
      ? { x: x + b, y: y + b + 17, "text-anchor": "end" }
      : { x: Math.min(at.width - WORD, Math.max(WORD, x)), y: 18, "text-anchor": "middle" });
    mass.classList.toggle("locked", now.forces.sticking);
    lock.toggleAttribute("hidden", !now.forces.sticking);
  }
  return { mass, elements: [spring, mass, lock], move };
}
