// A recording: dropped or chosen, fitted, judged, with the simulated motion over it.

import { cancel, fit, take } from "../fit/session";
import type { App, Recording } from "../state";
import { askedFold } from "./asked";
import { h } from "./dom";
import { dropping } from "./dropping";
import { result } from "./result";

export function recording(app: App): HTMLElement {
  const input = h("input", { type: "file", id: "file", class: "unseen", "aria-describedby": "file-kinds" });
  input.addEventListener("change", () => {
    const [file] = input.files ?? [];
    if (file) void take(app, file, "");
  });
  const working = h("span", {});
  const stop = h("button", { type: "button", click: () => cancel(app) }, app.say("page-cancel"));
  const busy = h("div", { class: "row working", hidden: true }, h("progress", { "aria-labelledby": "working" }), working, stop);
  working.id = "working";
  const drop = h("div", { class: "drop" },
    `${app.say("page-drop")} `, input, h("label", { for: "file", class: "tool" }, app.say("page-choose-file")), h("p", { id: "file-kinds", class: "hint" }, app.say("page-file-kinds")), busy);
  const mode = h("input", { type: "checkbox", change: () => app.update({ classMode: mode.checked, revealed: false }) });
  mode.checked = app.state.classMode;
  const wrong = h("p", { class: "wrong", role: "alert", hidden: true });
  const remark = h("p", { class: "hint" });

  function show(): void {
    const now = app.state.recording;
    const lost = document.activeElement === stop && !now?.busy;
    busy.hidden = !now?.busy;
    working.textContent = now?.busy ? app.say("page-fitting", { name: now.name }) : "";
    if (lost) input.focus();
    const message = now?.refusal?.field === "file" ? now.refusal.message : "";
    if (wrong.textContent !== message) wrong.textContent = message;
    wrong.hidden = message === "";
    remark.textContent = now?.remark ?? "";
    remark.hidden = remark.textContent === "";
    if (now) name(input, now);
  }
  app.on((changed) => {
    if (changed.has("recording")) show();
    if (changed.has("classMode")) mode.checked = app.state.classMode;
  });
  show();
  const element = h("section", { class: "recording", "aria-labelledby": "recording-title" },
    h("h2", { id: "recording-title" }, app.say("page-recording")),
    h("p", {}, app.say("page-recording-text")),
    h("label", { class: "switch" }, mode, app.say("page-class-mode")), drop, askedFold(app), remark, wrong, result(app), dropping(app));
  // All sentences are of another language.
  const { recording: kept, language } = app.state;
  if (kept && kept.language !== language) void fit(app);
  return element;
}

/** The field names the file that is there, however it came. */
function name(input: HTMLInputElement, { name }: Recording): void {
  if (input.files?.[0]?.name === name) return;
  const data = new DataTransfer();
  data.items.add(new File([], name));
  input.files = data.files;
}
