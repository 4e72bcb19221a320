// Files that are dropped, anywhere on the page.

import { refuse, take } from "../fit/session";
import type { App } from "../state";
import { h } from "./dom";

/** The page is built anew in another language: what listened before is told to stop. */
let listening: AbortController | undefined;

/** Takes what is dropped; the element shows that it would be taken. */
export function dropping(app: App): HTMLElement {
  const veil = h("div", { class: "veil", "aria-hidden": "true", hidden: true }, h("p", {}, app.say("page-drop-now")));
  listening?.abort();
  listening = new AbortController();
  const listen = (name: "dragover" | "dragleave" | "drop", act: (event: DragEvent, data: DataTransfer) => void) =>
    addEventListener(name, (event) => {
      const data = event.dataTransfer;
      // Text that is dragged within the page is not ours.
      if (data?.types.includes("Files")) act(event, data);
    }, { signal: listening!.signal });
  listen("dragover", (event, data) => {
    event.preventDefault();
    data.dropEffect = "copy";
    veil.hidden = false;
  });
  listen("dragleave", (event) => {
    if (event.relatedTarget === null) veil.hidden = true;
  });
  listen("drop", (event, data) => {
    event.preventDefault();
    veil.hidden = true;
    takeFirst(app, data);
    document.querySelector(".recording")?.scrollIntoView();
  });
  return veil;
}

/** The first file; a folder is none. */
function takeFirst(app: App, data: DataTransfer): void {
  const all = [...data.items].filter((item) => item.kind === "file");
  const files = all.filter((item) => !item.webkitGetAsEntry()?.isDirectory).map((item) => item.getAsFile());
  const [first] = files;
  const name = first?.name ?? data.files[0]?.name ?? "";
  if (!first) return refuse(app, name, app.say("page-folder", { name }));
  void take(app, first, files.length > 1 ? app.say("page-first-of-many", { count: files.length, name }) : "");
}
