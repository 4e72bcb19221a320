// Files that come, are refused, take long, and go.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { drop, fitted, hears, launch, open, recordings } from './open.js';

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const vernier = readFileSync(join(recordings, 'vernier.csv'));
const named = (page) => page.$eval('#file', (it) => it.files[0]?.name ?? '');
const refused = async (page, words) => {
  await page.waitForSelector('.recording > .wrong:not([hidden])', { timeout: 60_000 });
  assert.match(await page.textContent('.recording > .wrong'), words);
  assert.ok(await page.isHidden('.fit'));
};
/** Workers of which every one meets a fault: what they are to work with is none. */
const FAULTY = `globalThis.Worker = class extends Worker {
  postMessage(task) { super.postMessage({ ...task, module: null }); }
};`;
/** Workers that never answer. */
const SILENT = `globalThis.Worker = class extends Worker { postMessage() {} };`;

describe('dropping', { concurrency: 2 }, () => {
  test('anywhere on the page; the first of several, and its name stands at the field and above the result', { timeout: 180_000 }, () =>
    open(browser, async (page) => {
      await drop(page, 'first.csv', vernier, { place: 'header', more: [['second.csv', vernier]] });
      await fitted(page);
      assert.ok(await page.isHidden('.veil'));
      assert.equal(await named(page), 'first.csv');
      assert.match(await page.textContent('.fit .file'), /^first\.csv/);
      assert.match(await page.textContent('.recording'), /2 files at once: the first is fitted, first\.csv/);
      await page.selectOption('#language', 'de');
      await page.waitForFunction(() => /Reibung/.test(document.querySelector('.verdict')?.textContent), null, { timeout: 120_000 });
      assert.equal(await named(page), 'first.csv');
    }));

  test('a broken file takes the verdict before it away, and the page goes on', { timeout: 180_000 }, () =>
    open(browser, async (page) => {
      await drop(page, 'vernier.csv', vernier);
      await fitted(page);
      await drop(page, 'broken.csv', Buffer.from('nothing, to, see\nhere,,\n'));
      await refused(page, /broken\.csv/);
      assert.equal(await named(page), 'broken.csv');
      assert.equal(await page.locator('.verdict').count(), 0);
      await drop(page, 'broken.zip', Buffer.from('PK\x03\x04 broken'));
      await page.waitForFunction(() => /broken\.zip.*cannot be opened/.test(document.querySelector('.recording > .wrong').textContent));
      assert.doesNotMatch(await page.textContent('.recording > .wrong'), /EOCD|--/);
      await page.fill('#field-mass', '0.6');
      assert.notEqual(await page.textContent('.summary'), '');
      await drop(page, 'vernier.csv', vernier);
      await fitted(page);
      assert.ok(await page.isHidden('.recording > .wrong'));
    }));

  test('a folder gets a sentence', () =>
    open(browser, async (page) => {
      const folder = mkdtempSync(join(tmpdir(), 'recordings-'));
      const session = await page.context().newCDPSession(page);
      const at = { x: 300, y: 100, data: { items: [], files: [folder], dragOperationsMask: 1 } };
      for (const type of ['dragEnter', 'dragOver', 'drop']) await session.send('Input.dispatchDragEvent', { type, ...at });
      await refused(page, new RegExp(`${basename(folder)}.*folder`));
    }));

  test('a fault where it is fitted is said, and the page is not busy', () =>
    open(browser, async (page) => {
      await page.evaluate(FAULTY);
      await drop(page, 'vernier.csv', vernier);
      await refused(page, /vernier\.csv.*fault of its own/);
      assert.ok(await page.isHidden('.working'));
    }));

  test('a fit is seen to go on and can be cancelled', () =>
    open(browser, async (page) => {
      await page.evaluate(SILENT);
      await drop(page, 'vernier.csv', vernier);
      await page.waitForSelector('.working:not([hidden]) progress');
      await hears(page, /Fitting vernier\.csv/);
      await page.getByRole('button', { name: 'Cancel' }).focus();
      await page.keyboard.press('Enter');
      await refused(page, /vernier\.csv.*cancelled/);
      assert.ok(await page.isHidden('.working'));
      assert.ok(await page.evaluate(() => document.activeElement.id === 'file'));
    }));
});
