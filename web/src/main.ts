// The page: loads the engine, builds the parts, builds them anew in another language.

import { type Language, load } from "./engine";
import { experimentOfAddress, keepAddress, viewOfAddress } from "./address";
import { type App, createApp, type Theme } from "./state";
import { clock } from "./view/clock";
import { controls } from "./view/controls";
import { h } from "./view/dom";
import { header, notice, wear } from "./view/header";
import { lens } from "./view/lens";
import { numbers } from "./view/numbers";
import { toggle } from "./view/playing";
import { publish, whenColoursChange } from "./view/palette";
import { plots } from "./view/plots";
import { printed } from "./view/print";
import { recording } from "./view/recording";
import { scene } from "./view/scene/scene";
import { summary, transport } from "./view/transport";

/** What the reader chose last time, where the browser keeps it for a file. */
const kept = {
  get(name: string): string | null {
    try {
      return localStorage.getItem(name);
    } catch {
      return null;
    }
  },
  set(name: string, value: string): void {
    try {
      localStorage.setItem(name, value);
    } catch {
      // Without a place to keep it, the choice holds for this visit.
    }
  },
};

function firstLanguage(): Language {
  const wished = kept.get("language") ?? navigator.language;
  return wished.startsWith("de") ? "de" : "en";
}

function firstTheme(): Theme {
  const wished = kept.get("theme");
  return wished === "light" || wished === "dark" ? wished : "system";
}

function build(app: App): void {
  document.documentElement.lang = app.state.language;
  document.title = app.say("page-title");
  const stage = h("section", { class: "stage", "aria-labelledby": "stage-title" },
    h("h2", { id: "stage-title", class: "unseen" }, app.say("page-stage")), scene(app), transport(app));
  const main = h("main", { id: "main", tabindex: -1 },
    h("div", { class: "bench" }, stage, summary(app), printed(app), plots(app)), controls(app), numbers(app), lens(app), recording(app));
  const place = () => main.classList.toggle("hangs", app.state.experiment.hanging);
  place();
  app.on((changed) => changed.has("experiment") && place());
  document.getElementById("page")!.replaceChildren(
    h("a", { class: "skip", href: "#main", click: skip }, app.say("page-skip")),
    header(app),
    main,
    h("footer", {}, h("p", {}, app.say("page-footer"))));
  arrange();
  measure.disconnect();
  for (const part of document.querySelectorAll(".stage, .scene-frame")) measure.observe(part);
}

/** Beside the motion the controls come first, where there is room; below it after the plots. As for the eye, so for keys. */
const wide = matchMedia("(min-width: 62rem)");
function arrange(): void {
  const [bench, panel] = [document.querySelector(".bench"), document.querySelector(".controls")];
  if (wide.matches) bench?.before(panel!);
  else bench?.after(panel!);
}

/** What stays at the top of the window must not cover what has the focus. */
const measure = new ResizeObserver(() => {
  const heights = [...document.querySelectorAll<HTMLElement>(".stage, .scene-frame")].map((it) => it.offsetHeight);
  document.documentElement.style.setProperty("--stuck", `${heights.find((it) => it > 0) ?? 0}px`);
});

/** The address keeps the experiment, so the link to the content must not replace it. */
function skip(event: Event): void {
  event.preventDefault();
  document.getElementById("main")?.focus();
}

async function start(): Promise<void> {
  const engine = await load();
  wear(firstTheme());
  const linked = experimentOfAddress(engine);
  const app = createApp(engine, firstLanguage(), firstTheme(), linked);
  if (linked) app.update(viewOfAddress(engine, linked));
  keepAddress(app);
  app.always((changed) => {
    if (changed.has("theme")) {
      kept.set("theme", app.state.theme);
      wear(app.state.theme);
      app.update({ colours: app.state.colours + 1 });
    }
    if (changed.has("language")) {
      kept.set("language", app.state.language);
      app.forget();
      build(app);
      document.getElementById("language")?.focus();
    }
  });
  whenColoursChange(() => {
    publish();
    app.update({ colours: app.state.colours + 1 });
  });
  clock(app);
  build(app);
  wide.addEventListener("change", arrange);
  const broken = () => notice(app, app.say("page-link-broken"));
  if (location.hash.length > 1 && !linked) broken();
  addEventListener("hashchange", () => {
    const draft = experimentOfAddress(engine);
    if (draft) {
      notice(app, "");
      app.update({ draft, playing: false, ...viewOfAddress(engine, draft) });
    } else if (location.hash.length > 1) broken();
  });
  addEventListener("keydown", (event) => {
    if (event.key !== " " || event.target !== document.body) return;
    event.preventDefault();
    toggle(app);
  });
}

start().catch((fault: unknown) => {
  document.getElementById("failed")!.hidden = false;
  throw fault;
});
