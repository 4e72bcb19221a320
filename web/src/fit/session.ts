// A file is fitted: what becomes of it, step by step, stands in the state of the page.

import { type Asked, isRefusal, type Refusal } from "../engine";
import type { App, Recording } from "../state";

/** Counts what was begun: what comes late is of a file that another has replaced. */
let turn = 0;

/** What is said of one file, and of no other. */
const OF_FILE = ["unit", "value", "time", "rate", "table", "from", "to"];

const aboutApparatus = (asked: Asked): Asked =>
  Object.fromEntries(Object.entries(asked).filter(([name]) => !OF_FILE.includes(name)));

function change(app: App, change: Partial<Recording>): void {
  const { recording } = app.state;
  if (recording) app.update({ recording: { ...recording, ...change } });
}

const ofFile = (message: string): Refusal => ({ field: "file", message });

/** Another file: nothing of the one before is left. */
function begin(app: App, name: string, remark = ""): void {
  app.engine.giveUp();
  const { asked, language } = app.state;
  app.update({
    recording: { name, bytes: null, language, fits: [], chosen: 0, busy: true, refusal: null, remark },
    asked: aboutApparatus(asked), revealed: false,
  });
}

/** What is no file at all. */
export function refuse(app: App, name: string, message: string): void {
  turn++;
  begin(app, name);
  change(app, { busy: false, refusal: ofFile(message) });
}

export async function take(app: App, file: File, remark: string): Promise<void> {
  const mine = ++turn;
  const { name } = file;
  begin(app, name, remark);
  const bytes = await file.arrayBuffer().then((content) => new Uint8Array(content), () => null);
  if (mine !== turn) return;
  if (!bytes) return change(app, { busy: false, refusal: ofFile(app.say("page-unreadable", { name })) });
  change(app, { bytes });
  await fit(app);
}

/** Fits the file that is there, in the language and with the answers that are there now. */
export async function fit(app: App): Promise<void> {
  const { recording, asked, language } = app.state;
  // A file that could not be read has only been refused, in another language.
  if (!recording?.bytes) return app.update({ recording: null });
  const mine = ++turn;
  const { name, bytes } = recording;
  const fits = recording.language === language ? recording.fits : [];
  change(app, { busy: true, refusal: null, language, fits });
  app.announce([recording.remark, app.say("page-fitting", { name })].join(" "));
  // A fault of the engine, where a fit or a refusal was due.
  const found = await app.engine.fit(bytes, name, asked, language).catch(() => ofFile(app.say("page-fit-fault", { name })));
  if (mine !== turn) return;
  if (isRefusal(found)) {
    app.announce("");
    // A field that is refused leaves what was found before it was changed.
    return change(app, { busy: false, refusal: found, fits: found.field === "file" ? [] : fits });
  }
  const chosen = Math.min(app.state.recording?.chosen ?? 0, found.length - 1);
  change(app, { busy: false, fits: found, chosen });
  const hidden = app.state.classMode && !app.state.revealed;
  app.announce([app.say("page-fitted", { name }), hidden ? "" : (found[chosen]?.sentences[0] ?? "")].join(" "));
}

export function cancel(app: App): void {
  turn++;
  app.engine.giveUp();
  const { name } = app.state.recording ?? { name: "" };
  change(app, { busy: false, fits: [], refusal: ofFile(app.say("page-cancelled", { name })) });
}
