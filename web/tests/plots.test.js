// The plots: files, zoom, values under the cursor, the error lens, and how fast they follow a slider.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { after, before, describe, test } from 'node:test';
import { violations } from '../../crates/federpendel-report/browser/access.js';
import { launch, open } from './open.js';

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

/** A frame of a screen at 60 pictures a second takes 16 ms; a busy machine without a graphics card gets more. */
const GENEROUS = 60;

async function save(page, plot, what) {
  const figure = page.locator('.plot-section .plot').nth(plot);
  await figure.getByText('Save', { exact: true }).click();
  const [file] = await Promise.all([page.waitForEvent('download'), figure.getByRole('button', { name: what, exact: true }).click()]);
  return { name: file.suggestedFilename(), bytes: readFileSync(await file.path()) };
}

describe('plots', { concurrency: 2 }, () => {
  test('each is saved as SVG, PNG and CSV', () =>
    open(browser, async (page) => {
      for (let plot = 0; plot < 4; plot++) {
        const svg = await save(page, plot, 'SVG');
        assert.match(svg.name, /\.svg$/);
        const labels = await page.evaluate((text) => {
          const file = new DOMParser().parseFromString(text, 'image/svg+xml');
          const within = ({ x, y }) => x >= 0 && x <= 800 && y >= 0 && y <= 450;
          const texts = [...file.querySelectorAll('text')];
          return {
            faults: file.querySelectorAll('parsererror').length,
            words: texts.map((it) => it.textContent),
            outside: texts.filter((it) => !within({ x: Number(it.getAttribute('x')), y: Number(it.getAttribute('y')) })).length,
            shapes: file.querySelectorAll('polyline, polygon, circle').length,
          };
        }, svg.bytes.toString());
        assert.equal(labels.faults, 0);
        assert.equal(labels.outside, 0);
        assert.ok(labels.shapes > 10);
        assert.ok(labels.words.some((it) => / in (m|s|J|m\/s)$/.test(it)), labels.words.join());
        const png = await save(page, plot, 'PNG');
        assert.equal(png.bytes.subarray(1, 4).toString(), 'PNG');
        const csv = (await save(page, plot, 'CSV')).bytes.toString().trim().split('\n');
        const file = await save(page, plot, 'CSV with semicolons');
        assert.match(file.name, /^federpendel-coulomb-[a-z-]+\.csv$/);
        const text = file.bytes.toString();
        // What Excel needs to read letters.
        assert.equal(text[0], '\ufeff');
        const german = text.trim().split('\n');
        assert.equal(csv.length, german.length);
        assert.equal(german[1].replaceAll(',', '.').replaceAll(';', ','), csv[1]);
        for (const cell of csv.slice(1).flatMap((row) => row.split(','))) assert.match(cell, /^(-?\d+(\.\d*[1-9])?)?$/);
      }
    }));

  test('a table of samples holds the numbers of the command line', () =>
    open(browser, async (page) => {
      const rows = (text) => text.trim().split('\n').map((row) => row.split(',').slice(0, 4));
      const [head, ...shown] = rows((await save(page, 0, 'CSV')).bytes.toString());
      const [known, ...printed] = rows(execFileSync(process.env.FEDERPENDEL, ['simulate', '--format', 'csv', '--duration', '5.5'], { encoding: 'utf8' }));
      assert.deepEqual(head, known);
      assert.equal(shown.length, printed.length);
      for (const [k, row] of shown.entries()) {
        for (const [i, cell] of row.entries()) assert.ok(Math.abs(cell - printed[k][i]) < 1e-10, `${k}: ${row} and ${printed[k]}`);
      }
    }));

  test('a kept motion that cannot be shown so long stays as it was', () =>
    open(browser, async (page) => {
      const set = async (name, words) => {
        await page.fill(`#field-${name}`, words);
        await page.press(`#field-${name}`, 'Enter');
      };
      await set('duration', '1');
      await set('mass', '0.001');
      await set('stiffness', '1000');
      await page.uncheck('#law-coulomb');
      await page.check('#law-newton');
      await set('density', '0.1');
      await page.getByRole('button', { name: 'Keep this curve' }).click();
      await page.uncheck('#law-newton');
      await set('duration', '1000');
      await set('mass', '1');
      await set('stiffness', '20');
      assert.match(await page.inputValue('#field-stiffness'), /^20$/);
    }));

  test('however far a plot is enlarged, neighbouring ticks differ', () =>
    open(browser, async (page) => {
      for (let k = 0; k < 10; k++) await page.locator('.plot-section .plot').nth(3).getByRole('button', { name: 'Zoom in' }).click();
      const { bytes } = await save(page, 3, 'SVG');
      const labels = [...bytes.toString().matchAll(/<text[^>]*>([^<]*10[⁻⁰-⁹¹²³]+)</g)].map(([, label]) => label);
      assert.ok(labels.length > 3, 'ticks are written with powers of ten there');
      assert.equal(new Set(labels).size, labels.length, labels.join('; '));
    }));

  test('up to three curves are kept, named by what differs, and can be removed', () =>
    open(browser, async (page) => {
      const keep = page.getByRole('button', { name: 'Keep this curve' });
      const texts = async (plot) => (await save(page, plot, 'SVG')).bytes.toString().match(/<text[^>]*>[^<]*/g).map((it) => it.replace(/.*>/, '').replaceAll('\u00a0', ' '));
      await keep.click();
      await keep.click();
      assert.equal(await page.locator('.kept li').count(), 1, 'the same motion is kept once');
      await page.selectOption('#preset', 'article-stokes');
      await keep.click();
      await page.selectOption('#preset', 'all-three');
      for (const plot of [0, 1, 3]) {
        const words = (await texts(plot)).join(' ');
        assert.match(words, /Coulomb μ = 0\.02/);
        assert.match(words, /Stokes D = 0\.2 kg\/s/);
      }
      const [head, ...rows] = (await save(page, 0, 'CSV')).bytes.toString().trim().split('\n');
      assert.match(head, /^Time \(s\),.*Coulomb/);
      // One column of times, and three each for three motions.
      assert.ok(rows.every((row) => row.split(',').length === 10));
      await keep.click();
      assert.ok(await keep.isDisabled());
      assert.deepEqual(await violations(page), []);
      // A kept motion survives another language.
      await page.selectOption('#language', 'de');
      assert.match((await page.textContent('.kept li')).replaceAll('\u00a0', ' '), /Coulomb μ = 0,02/);
      await page.getByRole('button', { name: /^Coulomb.* entfernen/ }).click();
      assert.equal(await page.locator('.kept li').count(), 2);
    }));

  test('of thousands of swings the pictures are full, not woven', () =>
    open(browser, async (page) => {
      // The share of paper within the outline of the curve, on a row through its middle.
      const holes = (plot) => page.evaluate((k) => {
        const canvas = document.querySelectorAll('.plot-section .plot-area canvas:first-child')[k];
        const { width, height } = canvas;
        const row = canvas.getContext('2d').getImageData(0, Math.round(height * 0.62), width, 1).data;
        const blue = Array.from({ length: width }, (_, x) => row[4 * x + 2] > 120 && row[4 * x] < 60 && row[4 * x + 3] > 200);
        const inside = blue.slice(blue.indexOf(true), blue.lastIndexOf(true) + 1);
        return { size: inside.length / width, holes: inside.filter((it) => !it).length / inside.length };
      }, plot);
      for (const plot of [0, 1]) {
        const { size, holes: share } = await holes(plot);
        assert.ok(size > 0.4 && share < 0.02, `plot ${plot}: ${share} of ${size}`);
      }
    }, {}, '#1;mass=0.5;stiffness=20;position=0.1;velocity=0;kinetic=0.00001;static=0.00001;laws=coulomb;duration=10000'));

  test('zoom by key, by button and by mouse, and back', () =>
    open(browser, async (page) => {
      const area = page.locator('.plot-area').first();
      const picture = () => area.locator('canvas').first().evaluate((it) => it.toDataURL());
      const whole = await picture();
      await area.focus();
      await page.keyboard.press('+');
      const closer = await picture();
      assert.notEqual(closer, whole);
      await page.keyboard.press('ArrowRight');
      assert.notEqual(await picture(), closer);
      await page.keyboard.press('0');
      assert.equal(await picture(), whole);
      await page.getByRole('button', { name: 'Zoom in' }).first().click();
      assert.equal(await picture(), closer);
      // There is nothing to be seen before the release.
      await area.focus();
      for (let k = 0; k < 12; k++) await page.keyboard.press('ArrowLeft');
      const begin = await picture();
      await page.keyboard.press('ArrowLeft');
      assert.equal(await picture(), begin);
      await page.getByRole('button', { name: 'Show all' }).first().click();
      assert.equal(await picture(), whole);
      const box = await area.boundingBox();
      await page.mouse.move(box.x + 150, box.y + 120);
      await page.mouse.down();
      await page.mouse.move(box.x + 300, box.y + 200, { steps: 3 });
      await page.mouse.up();
      assert.notEqual(await picture(), whole);
    }));

  test('two fingers zoom, in the phase portrait both axes', () =>
    open(browser, async (page) => {
      const area = page.locator('.plot-section .plot-area').nth(1);
      await area.scrollIntoViewIfNeeded();
      const { x, y, width, height } = await area.boundingBox();
      const session = await page.context().newCDPSession(page);
      const touch = (type, apart) => session.send('Input.dispatchTouchEvent', {
        type, touchPoints: apart === null ? [] : [-1, 1].map((side, id) => ({ id, x: x + width / 2 + side * apart, y: y + height / 2 })),
      });
      const ticks = () => save(page, 1, 'SVG').then(({ bytes }) => bytes.toString().match(/<text[^>]*>[−\d.]+</g).map((it) => it.replace(/.*>|</g, '')));
      const before = await ticks();
      await touch('touchStart', 30);
      for (let apart = 40; apart <= 120; apart += 10) await touch('touchMove', apart);
      await touch('touchEnd', null);
      const after = await ticks();
      const largest = (all) => Math.max(...all.map((it) => Number(it.replace('−', '-'))));
      // Velocities reach further than places: those are the heights.
      assert.ok(largest(after) < 0.5 * largest(before), `${before} to ${after}`);
    }, { hasTouch: true }));

  test('the cursor is one in all plots', () =>
    open(browser, async (page) => {
      const box = await page.locator('.plot-area').first().boundingBox();
      const readouts = () => page.$$eval('.plot-section .readout', (all) => all.map((it) => it.textContent));
      const before = await readouts();
      await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
      const now = await readouts();
      for (const [k, words] of now.entries()) assert.notEqual(words, before[k], `plot ${k}`);
    }));

  test('the error lens shows every method, and refuses a step in words', () =>
    open(browser, async (page) => {
      await page.click('.lens:not(.numeric) summary');
      const methods = await page.$$eval('#method option', (all) => all.map((it) => it.value));
      assert.ok(methods.length > 8);
      for (const method of methods) {
        await page.selectOption('#method', method);
        assert.ok((await page.$$('.lens .sentences li')).length > 0, method);
      }
      await page.fill('#step', '1 ns');
      assert.match(await page.textContent('#step-wrong'), /steps/, 'so many steps would stop the page');
      await page.fill('#step', '1 ms');
      await page.selectOption('#method', 'article-scheme');
      assert.match(await page.textContent('.lens code'), /article-scheme/);
      const plot = page.locator('.lens .plot').nth(1);
      await plot.scrollIntoViewIfNeeded();
      const box = await plot.locator('.plot-area').boundingBox();
      await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
      assert.match(await plot.locator('.readout').textContent(), /^t = [\d.]+ s, Error: −?[\d.]+/);
      await page.fill('#step', '-1');
      assert.equal(await page.getAttribute('#step', 'aria-invalid'), 'true');
      await page.fill('#step', '1 ms');
      assert.equal(await page.getAttribute('#step', 'aria-invalid'), null);
    }));

});

// Alone, so that nothing else takes the machine's time.
describe('speed', () => {
  test('a move of a slider redraws all plots of 10 000 samples in time', (context) =>
    open(browser, async (page) => {
      const times = await page.evaluate(async () => {
        const slider = document.querySelector('#field-stiffness').closest('.field').querySelector('input[type=range]');
        const taken = [];
        for (let step = 200; step < 240; step++) {
          slider.value = step;
          slider.dispatchEvent(new Event('input', { bubbles: true }));
          // The page draws in the next frame, and has asked for it before this does.
          const began = await new Promise(requestAnimationFrame);
          taken.push(performance.now() - began);
        }
        return taken.sort((a, b) => a - b);
      });
      const median = times[20];
      context.diagnostic(`from the slider's move to the redrawn plots: median ${median.toFixed(1)} ms, longest ${times.at(-1).toFixed(1)} ms`);
      assert.ok(median < GENEROUS, `${median} ms`);
    }));
});
