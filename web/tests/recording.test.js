// A recording is dropped, judged, and laid beside the simulated motion.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { drop, fitted, heard, launch, open, recordings } from './open.js';

const program = process.env.FEDERPENDEL;
assert.ok(program, 'FEDERPENDEL must name the program federpendel');
/** The recording vernier.csv as workbooks, and damaged ones. */
const workbooks = join(recordings, '../../crates/federpendel-fit/tests/data');

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

// What was released, from the README beside the recordings, and the coefficient that is not there.
const FILES = {
  'phyphox.csv': /Stokes/,
  'phyphox-deutsch.zip': /Newton/,
  'vernier.csv': /Coulomb/,
  'pasco.csv': /Newton/,
  'federpendel-deutsch.csv': /Coulomb/,
};

describe('recording', { concurrency: 2 }, () => {
  for (const [name, law] of Object.entries(FILES)) {
    test(`${name} is dropped and judged`, { timeout: 180_000 }, () =>
      open(browser, async (page) => {
        await drop(page, name, readFileSync(join(recordings, name)));
        await fitted(page);
        assert.match(await page.textContent('.verdict'), law);
        assert.ok((await page.$$('.fit table tr')).length > 3);
      }));
  }

  for (const name of ['vernier.xlsx', 'vernier.xls']) {
    test(`${name} is read as the command line reads it`, { timeout: 180_000 }, () =>
      open(browser, async (page) => {
        const file = join(workbooks, name);
        const told = execFileSync(program, ['fit', file, '--lang', 'en'], { encoding: 'utf8' }).replace(/\s+/g, ' ');
        await drop(page, name, readFileSync(file));
        await fitted(page);
        const verdict = (await page.locator('.verdict p, p.verdict').allTextContents()).map((it) => it.replace(/\s+/g, ' ').trim());
        assert.match(verdict.join(' '), /Coulomb/);
        for (const sentence of verdict) assert.ok(told.includes(sentence), `“${sentence}” in ${told}`);
      }));
  }

  test('a damaged workbook gets the message of the command line', () =>
    open(browser, async (page) => {
      for (const name of ['vernier.xlsx', 'vernier.xls']) {
        const bytes = readFileSync(join(workbooks, name)).subarray(0, 9000);
        await drop(page, `damaged-${name}`, bytes);
        await page.waitForFunction((it) => document.querySelector('.recording > .wrong')?.textContent.startsWith(it), `damaged-${name}:`);
        const { stderr } = spawnSync(program, ['fit', '-', '--lang', 'en'], { input: bytes, encoding: 'utf8' });
        const message = (await page.textContent('.recording > .wrong')).split(': ').slice(1).join(': ').trim();
        assert.match(message, /cannot be opened/);
        // What its reader says is English, and for who reads terminals.
        const told = stderr.replace(/\s+/g, ' ').replace(/ \(its reader says: [^)]*\)/, '').toLowerCase();
        assert.ok(told.includes(message.toLowerCase()), `“${message}” in ${stderr}`);
      }
    }));

  test('in class the verdict waits until it is asked for; the report and the fitted motion can be had', { timeout: 180_000 }, () =>
    open(browser, async (page) => {
      await page.getByLabel('For the class').check();
      await page.setInputFiles('#file', join(recordings, 'vernier.csv'));
      await fitted(page);
      assert.equal(await page.locator('.verdict').count(), 0);
      // Neither seen, nor heard, nor in the document.
      const words = await page.evaluate(() => document.documentElement.outerHTML);
      for (const told of [/friction acts/i, /Coulomb\) friction/, /a_c/, /AICc/]) {
        assert.doesNotMatch(words.slice(words.indexOf('class="fit"')), told);
        assert.doesNotMatch(await page.textContent('#live'), told);
      }
      const saved = page.locator('.fit .plot').first();
      await saved.getByText('Save', { exact: true }).click();
      const [drawing] = await Promise.all([page.waitForEvent('download'), saved.getByRole('button', { name: 'SVG' }).click()]);
      assert.doesNotMatch(readFileSync(await drawing.path(), 'utf8'), /Fit|friction/);
      // A guess of one's own can be laid over it.
      await page.getByLabel('Lay the simulated motion over it').check();
      await page.getByRole('button', { name: 'Show the verdict' }).click();
      assert.match(await page.textContent('.verdict'), /Coulomb/);
      const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Save the report' }).click()]);
      assert.equal(download.suggestedFilename(), 'vernier.html');
      const report = readFileSync(await download.path(), 'utf8');
      assert.match(report, /^<!DOCTYPE html>[^]*Coulomb/i);
      // What the program's report has too, and every picture.
      for (const words of ['95 % interval', 'AICc', 'Value ± standard error', 'Correlations', 'is not needed', String(new Date().getFullYear())]) {
        assert.ok(report.includes(words), words);
      }
      assert.equal(report.match(/<svg/g).length, 3);
      await page.selectOption('#language', 'de');
      await page.waitForFunction(() => /Reibung/.test(document.querySelector('.fit').textContent), null, { timeout: 120_000 });
      await page.selectOption('#language', 'en');
      // What was asked for stays in another language.
      await page.waitForFunction(() => /friction acts/.test(document.querySelector('.verdict')?.textContent), null, { timeout: 120_000 });
      await page.getByRole('button', { name: 'Simulate the fitted motion' }).click();
      assert.equal(await page.inputValue('#preset'), '');
      // The reader is led to the scene.
      await page.waitForFunction(() => Math.abs(document.querySelector('.stage').getBoundingClientRect().top) < 100);
      assert.match(await heard(page), /scene shows the fitted motion/);
      assert.ok(await page.evaluate(() => document.activeElement.matches('.play')));
      // What was fitted lies on the fit, on the scale of the recording.
      const course = page.locator('.fit .plot').first();
      await course.getByText('Save', { exact: true }).click();
      const [csv] = await Promise.all([page.waitForEvent('download'), course.getByRole('button', { name: 'CSV', exact: true }).click()]);
      const [head, ...rows] = readFileSync(await csv.path(), 'utf8').trim().split('\n').map((row) => row.split(','));
      const column = (name) => head.findIndex((it) => it.includes(name));
      // Curves at the same times share their column of times.
      const times = (k) => head.findLastIndex((it, i) => i < k && /^Time/.test(it));
      const points = (k) => rows.filter((row) => row[k] !== '' && row[k] !== undefined).map((row) => [Number(row[times(k)]), Number(row[k])]);
      const [fit, simulated] = [points(column('Fit')), points(column('Simulated'))];
      assert.ok(fit.length > 300 && simulated.length > 300);
      for (const [t, x] of fit.slice(0, 300)) {
        const next = simulated.findIndex(([time]) => time >= t);
        if (next > 0) assert.ok(Math.abs(simulated[next][1] - x) < 0.003, `${simulated[next][1]} beside ${x} at ${t} s`);
      }
    }));
});
