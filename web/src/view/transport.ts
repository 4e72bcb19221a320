// Play, pause, steps, slow motion, and where the motion is now.

import type { App } from "../state";
import { h } from "./dom";
import { decimals, fixed, largest } from "./fixed";
import { release, step, toggle } from "./playing";

const SPEEDS: [number, string][] = [[1, "1"], [0.25, "¼"], [0.1, "1/10"]];
const STEPS = 2000;
/** Those of the fields and axes. */
const UNITS = { t: "s", x: "m", v: "m/s", a: "m/s²" };
const NAMES = ["t", "x", "v", "a"] as const;
/** Times at which the largest values are looked for. */
const LOOKS = 500;

export function transport(app: App): HTMLElement {
  const play = h("button", { type: "button", class: "play", click: () => toggle(app) });
  const slider = h("input", { type: "range", min: 0, max: STEPS, step: 1, "aria-label": app.say("page-time") });
  slider.addEventListener("input", () => app.update({ playing: false, time: (Number(slider.value) / STEPS) * app.state.experiment.duration }));
  // A thumb that came down here to scroll has moved nothing.
  let before = 0;
  slider.addEventListener("pointerdown", () => (before = app.state.time));
  slider.addEventListener("pointercancel", () => app.update({ time: before }));
  const button = (id: string, sign: string, act: () => void) =>
    h("button", { type: "button", "aria-label": id, title: id, click: act }, sign);
  const now = readout(app);

  function show(): void {
    const { time, playing, experiment } = app.state;
    const action = app.say(playing ? "page-pause" : "page-play");
    if (play.textContent !== action) play.textContent = action;
    slider.value = String((time / experiment.duration) * STEPS);
    slider.setAttribute("aria-valuetext", app.quantity(time, "s"));
    now.show();
  }
  app.on((changed) => {
    if (changed.has("solution")) now.measure();
    if (changed.has("time") || changed.has("playing") || changed.has("solution")) show();
  });
  now.measure();
  show();
  return h("div", { class: "transport" },
    h("div", { class: "buttons" },
      button(app.say("page-restart"), "|◁", () => release(app)),
      button(app.say("page-previous-turning-point"), "◁", () => step(app, -1)),
      play,
      button(app.say("page-next-turning-point"), "▷", () => step(app, 1)),
      speeds(app)),
    slider, now.element);
}

function readout(app: App) {
  const cells = { t: h("span"), x: h("span"), v: h("span"), a: h("span") };
  const places = { t: 0, x: 0, v: 0, a: 0 };
  const words = (name: keyof typeof UNITS, value: number) => fixed(app.state.language, value, places[name]);
  return {
    element: h("dl", { class: "now" }, ...NAMES.map((name) => h("div", {}, h("dt", {}, name), h("dd", {}, cells[name], ` ${UNITS[name]}`)))),
    /** How many digits there are must not change while the mass moves, nor in the hand. */
    measure(): void {
      if (app.state.held) return;
      const { solution, experiment: { duration } } = app.state;
      const series = solution.samples(0, duration, LOOKS);
      for (const name of NAMES) {
        const most = largest(series[name]);
        places[name] = decimals(most);
        cells[name].style.minWidth = `${words(name, name === "t" ? most : -most).length}ch`;
      }
    },
    show(): void {
      const { time, solution } = app.state;
      const now = { t: time, ...solution.at(time) };
      for (const name of NAMES) cells[name].textContent = words(name, now[name]);
    },
  };
}

/** How the motion ends. */
export function summary(app: App): HTMLElement {
  const element = h("p", { class: "summary" });
  const show = () => {
    const { sentence } = app.state.solution.summary;
    if (element.textContent !== sentence) element.textContent = sentence;
  };
  app.on((changed) => changed.has("solution") && show());
  show();
  return element;
}

function speeds(app: App): HTMLElement {
  const select = h("select", {
    "aria-label": app.say("page-speed"), title: app.say("page-speed"),
    change: () => app.update({ speed: Number(select.value) }),
  }, ...SPEEDS.map(([speed, words]) => h("option", { value: speed }, `×${words}`)));
  select.value = String(app.state.speed);
  return select;
}
