// The title, and how the reader wants the page: language, light or dark, a link to this very experiment.

import type { Language } from "../engine";
import type { App, Theme } from "../state";
import { address } from "../address";
import { h } from "./dom";
import { publish } from "./palette";

const LANGUAGES: [Language, string][] = [["de", "Deutsch"], ["en", "English"]];

export function header(app: App): HTMLElement {
  const language = h("select", { id: "language" }, ...LANGUAGES.map(([value, words]) => h("option", { value, lang: value }, words)));
  language.value = app.state.language;
  language.addEventListener("change", () => app.update({ language: language.value as Language }));
  const themes: [Theme, string][] = [
    ["system", app.say("page-theme-system")], ["light", app.say("page-theme-light")], ["dark", app.say("page-theme-dark")],
  ];
  const theme = h("select", { id: "theme" }, ...themes.map(([value, words]) => h("option", { value }, words)));
  theme.value = app.state.theme;
  theme.addEventListener("change", () => app.update({ theme: theme.value as Theme }));
  return h("header", {},
    h("h1", {}, app.say("page-title")),
    h("div", { class: "wishes" },
      h("label", { for: "language" }, app.say("page-language")), language,
      h("label", { for: "theme" }, app.say("page-theme")), theme,
      h("button", { type: "button", click: () => void copyLink(app) }, app.say("page-link")),
      h("button", { type: "button", click: () => print() }, app.say("page-print"))),
    h("p", { id: "notice", class: "notice" }));
}

/** Says something of the whole page below its title, and to who listens. */
export function notice(app: App, sentence: string): void {
  document.getElementById("notice")!.textContent = sentence;
  app.announce(sentence);
}

async function copyLink(app: App): Promise<void> {
  const here = address(app);
  history.replaceState(null, "", here);
  try {
    await navigator.clipboard.writeText(here);
    notice(app, app.say(location.protocol === "file:" ? "page-link-of-file" : "page-link-copied"));
  } catch {
    // Some browsers let no page from a disk write there.
    notice(app, app.say("page-link-in-address"));
  }
}

export function wear(theme: Theme): void {
  document.documentElement.dataset.theme = theme;
  publish();
}
