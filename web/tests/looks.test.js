// What keeps people from the page: size of the window, colours, language, paper.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { violations } from '../../crates/federpendel-report/browser/access.js';
import * as inside from '../../crates/federpendel-report/browser/inside.js';
import { isA4, sizes } from '../../crates/federpendel-report/browser/paper.js';
import { rubbish } from '../../crates/federpendel-report/browser/text.js';
import { launch, open, recordings } from './open.js';

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const pictures = process.env.PICTURES;
if (pictures) mkdirSync(pictures, { recursive: true });
const WINDOWS = { phone: [390, 844], laptop: [1280, 800], projector: [1920, 1080] };

/** Everything open and on, as much as there can be on the page. */
async function unfold(page) {
  for (const part of await page.$$('details:not([open], .menu) > summary')) await part.click();
  await page.selectOption('#preset', { index: -1 + (await page.$$('#preset option')).length });
  for (const box of await page.$$('.shown input')) await box.check();
  await page.setInputFiles('#file', join(recordings, 'vernier.csv'));
  await page.waitForSelector('.fit:not([hidden]) .plot-area canvas[width]', { timeout: 120_000 });
}

async function readable(page) {
  assert.deepEqual(await page.evaluate(inside.headings), [], 'headings');
  // What the command line calls a method stands there too.
  const methods = await page.$$eval('#method option', (all) => all.map((it) => it.value));
  const words = rubbish(await page.evaluate(() => `${document.title}\n${document.body.innerText}`));
  assert.deepEqual(words.filter((it) => !methods.includes(it)), []);
  assert.deepEqual(await violations(page), []);
  const [wide, room] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
  assert.ok(wide <= room, `${wide} px in a window of ${room} px`);
}

describe('looks', { concurrency: 2 }, () => {
  for (const [name, [width, height]] of Object.entries(WINDOWS)) {
    for (const [colorScheme, locale] of [['light', 'de-DE'], ['dark', 'en-GB']]) {
      test(`${name}, ${colorScheme}, ${locale}`, { timeout: 180_000 }, () =>
        open(browser, async (page) => {
          await readable(page);
          const shot = (part) => pictures && page.screenshot({ path: join(pictures, `${name}-${colorScheme}-${part}.png`), fullPage: true });
          await shot('plain');
          await unfold(page);
          await readable(page);
          await shot('all');
        }, { viewport: { width, height }, colorScheme, locale }));
    }
  }

  test('everything is reached by key, in sight', () =>
    open(browser, async (page) => {
      const seen = new Set();
      for (let k = 0; k < 120; k++) {
        await page.keyboard.press('Tab');
        const at = await page.evaluate(() => {
          const it = document.activeElement;
          const { outlineStyle } = getComputedStyle(it);
          const stroke = it.matches('.mass') && getComputedStyle(it.querySelector('.body')).strokeWidth === '5px';
          return { name: it.id || it.className.baseVal || it.className || it.textContent, marked: outlineStyle !== 'none' || stroke, body: it === document.body };
        });
        if (at.body) break;
        assert.ok(at.marked, `no focus to be seen on ${at.name}`);
        seen.add(at.name);
      }
      for (const name of ['language', 'preset', 'field-mass', 'mass', 'play', 'plot-area', 'file']) assert.ok(seen.has(name), name);
    }));

  test('on paper: values and plots, no controls, white', () =>
    open(browser, async (page) => {
      await page.emulateMedia({ media: 'print', colorScheme: 'dark' });
      assert.ok(await page.isHidden('.controls'));
      assert.ok(await page.isVisible('.printed'));
      assert.equal(await page.locator('.plot-paper svg').count(), 4);
      assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), 'rgb(255, 255, 255)');
      const paper = await page.pdf({ preferCSSPageSize: true, ...(pictures ? { path: join(pictures, 'paper.pdf') } : {}) });
      assert.ok(sizes(paper).every(isA4));
      assert.ok(sizes(paper).length === 1, `${sizes(paper).length} pages`);
      assert.match(await page.textContent('.printed .source'), /\d{4}.*#1;mass=/);
      await page.emulateMedia({ media: 'screen' });
      await page.click('.lens:not(.numeric) summary');
      await page.waitForSelector('.lens .sentences li');
      await page.emulateMedia({ media: 'print' });
      await page.waitForFunction(() => document.querySelectorAll('.lens .plot-paper svg').length === 2);
    }, { colorScheme: 'dark' }));
});
