// Opens the page as a reader does, from the disk, and hears what it says and asks for.
import assert from 'node:assert/strict';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { launch as start, visit } from '../../crates/federpendel-report/browser/browser.js';

const file = process.env.PAGE ?? resolve(import.meta.dirname, '../dist/federpendel.html');
/** From the disk, or from a server where PAGE_URL names one. */
export const url = process.env.PAGE_URL ?? pathToFileURL(file).href;
export const recordings = resolve(import.meta.dirname, '../../examples/recordings');
export const launch = start;

const DESK = { viewport: { width: 1280, height: 800 }, locale: 'en-US' };

/** Does `work` on the open page; what it says on the console or asks of the network is a fault. */
export async function open(browser, work, look = {}, address = '') {
  const { said, asked } = await visit(browser, url + address, { ...DESK, ...look }, async (page) => {
    await ready(page);
    await work(page);
  });
  assert.deepEqual(said, [], 'the console');
  const foreign = asked.filter((it) => it.split('#')[0] !== url && !it.startsWith('blob:') && !it.startsWith('data:'));
  assert.deepEqual(foreign, [], 'requests');
}

/** The page has begun, or says that it cannot. */
export async function ready(page) {
  await page.waitForSelector('.plot-area canvas[width], #failed:not([hidden])');
  assert.ok(await page.isHidden('#failed'), 'the page could not start');
}

/** The number in the field `name`, as the reader sees it. */
export const value = (page, name) => page.inputValue(`#field-${name}`);

/** What was last said to who listens. */
export const heard = (page) => page.textContent('#live');

export async function hears(page, words) {
  await page.waitForFunction((it) => new RegExp(it).test(document.getElementById('live').textContent), words.source);
}

/** The time of the scene, in seconds, from the slider's place. */
export const place = (page) => page.$eval('.transport input[type=range]', (it) => Number(it.value));

/** A recording is fitted and drawn. */
export const fitted = (page) => page.waitForSelector('.fit:not([hidden]) .plot-area canvas[width]', { timeout: 120_000 });

/** Drops files, each with its name and bytes, on the part of the page that `place` selects. */
export async function drop(page, name, bytes, { place = '.drop', more = [] } = {}) {
  const files = [[name, bytes], ...more].map(([title, content]) => [title, content.toString('base64')]);
  await page.evaluate(([where, all]) => {
    const data = new DataTransfer();
    for (const [title, content] of all) data.items.add(new File([Uint8Array.from(atob(content), (it) => it.charCodeAt(0))], title));
    const fire = (type) => document.querySelector(where).dispatchEvent(new DragEvent(type, { dataTransfer: data, bubbles: true, cancelable: true }));
    fire('dragover');
    if (document.querySelector('.veil').hidden) throw new Error('nothing shows that a drop is taken');
    if (fire('drop')) throw new Error('the browser would leave the page and show the file');
  }, [place, files]);
}
