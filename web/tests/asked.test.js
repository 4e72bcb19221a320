// What the reader says of the experiment: the same numbers as on the command line, and refusals at the field.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { fitted, launch, open, recordings } from './open.js';

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const program = process.env.FEDERPENDEL;
const file = (name) => join(recordings, name);
const unfold = (page) => page.click('.asked > summary');
async function write(page, name, words) {
  await page.fill(`#asked-${name}`, words);
  await page.press(`#asked-${name}`, 'Enter');
}
const rows = (page) => page.$$eval('.fit > .wide tr', (all) => all.map((row) => [...row.children].map((it) => it.textContent)));
const shows = (page, words) => page.waitForFunction((it) => new RegExp(it).test(document.querySelector('.fit').textContent), words, { timeout: 120_000 });

describe('asked', { concurrency: 2 }, () => {
  test('with a mass, a guide and a unit come the numbers of the command line', { timeout: 180_000 }, () =>
    open(browser, async (page) => {
      assert.ok(program, 'FEDERPENDEL names no program');
      await page.setInputFiles('#file', file('tracker.txt'));
      await fitted(page);
      assert.equal(await page.getByRole('button', { name: 'Simulate the fitted motion' }).count(), 0);
      assert.match(await page.textContent('.fit'), /unit of its lengths is missing/);
      await unfold(page);
      await write(page, 'unit', 'm');
      await page.getByRole('button', { name: 'Simulate the fitted motion' }).waitFor({ timeout: 120_000 });
      await write(page, 'mass', '250(1) g');
      await page.selectOption('#asked-support', 'horizontal');
      await shows(page, 'kinetic coefficient');
      const told = ['fit', file('tracker.txt'), '--unit', 'm', '--mass', '250(1) g', '--horizontal', '--lang', 'en'];
      const said = execFileSync(program, told, { encoding: 'utf8', env: { ...process.env, COLUMNS: '200' } });
      const lines = said.split('\n').map((line) => line.trim().replace(/ {2,}/g, '  '));
      const shown = await rows(page);
      assert.ok(shown.length > 10);
      for (const [name, value] of shown) assert.ok(lines.includes(`${name}  ${value}`), `${name}: ${value}\n${said}`);
    }));

  test('what is refused is said at its field, and what was fitted stands', { timeout: 180_000 }, () =>
    open(browser, async (page) => {
      await page.setInputFiles('#file', file('vernier.csv'));
      await fitted(page);
      await page.selectOption('#language', 'de');
      await shows(page, 'Reibung');
      await unfold(page);
      for (const [name, words] of [['mass', '250 N'], ['unit', 'kg'], ['from', 'x'], ['rate', '-1 Hz']]) {
        await write(page, name, words);
        await page.waitForSelector(`#asked-${name}[aria-invalid]`);
        const message = await page.textContent(`#asked-${name}-wrong`);
        assert.match(message, new RegExp(words.split(' ').at(-1)), message);
        assert.doesNotMatch(message, /--|allowed/);
        assert.ok(await page.isVisible('.verdict'));
        await write(page, name, '');
        await page.waitForSelector(`#asked-${name}:not([aria-invalid])`);
      }
      await write(page, 'mass', '250');
      assert.match(await page.textContent('#asked-mass-hint'), /250 kg/);
    }));

  test('a fit that ends while one types leaves what is typed', { timeout: 180_000 }, () =>
    open(browser, async (page) => {
      await page.setInputFiles('#file', file('vernier.csv'));
      await fitted(page);
      await unfold(page);
      await write(page, 'from', '1');
      await page.fill('#asked-from', '');
      await page.waitForSelector('.working', { state: 'hidden', timeout: 120_000 });
      assert.equal(await page.inputValue('#asked-from'), '');
      await page.press('#asked-from', 'Enter');
      await page.getByRole('button', { name: 'Find beginning and end again' }).waitFor({ state: 'hidden', timeout: 120_000 });
    }));

  test('a part is fitted as it is shown, and the whole again', { timeout: 180_000 }, () =>
    open(browser, async (page) => {
      await page.setInputFiles('#file', file('vernier.csv'));
      await fitted(page);
      const part = async () => (await rows(page)).find(([name]) => name === 'fitted part')[1];
      const whole = await part();
      await page.locator('.fit .plot').first().getByRole('button', { name: 'Zoom in' }).click();
      await page.getByRole('button', { name: 'Fit only the part shown' }).click();
      await page.getByRole('button', { name: 'Find beginning and end again' }).waitFor({ timeout: 120_000 });
      assert.notEqual(await part(), whole);
      assert.notEqual(await page.inputValue('#asked-from'), '');
      await page.getByRole('button', { name: 'Find beginning and end again' }).click();
      await page.waitForFunction((it) => document.querySelector('.fit').textContent.includes(it), whole, { timeout: 120_000 });
    }));

  test('a file whose times are not known offers its columns', { timeout: 180_000 }, () =>
    open(browser, async (page) => {
      const at = (k) => ({ a: 0.5 * ((k * 7) % 4), b: k * 0.05, c: Math.exp(-0.05 * k * 0.05) * Math.cos(5 * k * 0.05) });
      const lines = Array.from({ length: 400 }, (_, k) => `${at(k).a};${at(k).b.toFixed(3)};${at(k).c.toFixed(5)}`);
      await page.setInputFiles('#file', { name: 'a.csv', mimeType: 'text/csv', buffer: Buffer.from(['a;b;c', ...lines].join('\n')) });
      await page.waitForSelector('#asked-time[aria-invalid]', { timeout: 60_000 });
      await page.selectOption('#asked-time', { label: 'b' });
      await fitted(page);
      assert.ok(await page.locator('#asked-time:not([aria-invalid])').count());
      await page.selectOption('#asked-value', { label: 'c' });
      await shows(page, 'columnc');
    }));
});
