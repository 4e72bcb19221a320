// The controls: what is typed, what is refused, what a link keeps, both languages.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { violations } from '../../crates/federpendel-report/browser/access.js';
import { launch, open, ready, value } from './open.js';

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const summary = (page) => page.textContent('.summary');
const wrong = (page, name) => page.textContent(`#field-${name}-wrong`);

describe('controls', { concurrency: 3 }, () => {
  test('a number with a comma, a point or a unit is the same number', () =>
    open(browser, async (page) => {
      const said = [];
      for (const written of ['0.05', '0,05', '5 cm', '5,0 cm']) {
        await page.fill('#field-position', '0.09');
        await page.fill('#field-position', written);
        said.push(await summary(page));
      }
      assert.equal(new Set(said).size, 1, said.join('\n'));
    }));

  test('what cannot be is refused beside its field, and the last motion stays', () =>
    open(browser, async (page) => {
      const before = await summary(page);
      for (const written of ['-1', 'heavy', '']) {
        await page.fill('#field-mass', written);
        assert.equal(await page.getAttribute('#field-mass', 'aria-invalid'), 'true', written);
        assert.notEqual(await wrong(page, 'mass'), '');
        assert.equal(await summary(page), before);
      }
      await page.fill('#field-mass', '0.5');
      assert.equal(await page.getAttribute('#field-mass', 'aria-invalid'), null);
      await page.fill('#field-static', '0.001');
      assert.match(await wrong(page, 'static'), /0\.001.*0\.02/);
      assert.equal(await summary(page), before);
      // The other of the two makes it possible.
      await page.fill('#field-kinetic', '0.0005');
      assert.equal(await page.getAttribute('#field-static', 'aria-invalid'), null);
      assert.notEqual(await summary(page), before);
    }));

  test('laws are switched, critical damping is a button', () =>
    open(browser, async (page) => {
      await page.uncheck('#law-coulomb');
      assert.match(await summary(page), /swings without end/);
      await page.check('#law-stokes');
      await page.getByRole('button', { name: 'Set critical damping' }).click();
      // 2√(0.5 · 20)
      assert.match(await value(page, 'damping'), /^6\.3245553/);
    }));

  test('a link restores the experiment', () =>
    open(browser, async (page) => {
      await page.fill('#field-kinetic', '0.0123');
      await page.check('#law-newton');
      await page.fill('#field-velocity', '-0.4');
      const said = await summary(page);
      await page.getByRole('button', { name: 'Copy link' }).click();
      const address = page.url();
      await page.goto('about:blank');
      await page.goto(address);
      await ready(page);
      assert.equal(await summary(page), said);
      assert.equal(await value(page, 'kinetic'), '0.0123');
      assert.equal(await value(page, 'velocity'), '−0.4');
      assert.ok(await page.isChecked('#law-newton'));
    }));

  test('rubbish after # leaves the page as it is', () =>
    open(browser, async (page) => assert.equal(await value(page, 'mass'), '0.5'), {}, '#nonsense'));

  test('light or dark as chosen, curves and page alike', () =>
    open(browser, async (page) => {
      const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
      const curve = () => page.locator('.plot-area canvas').first().evaluate((it) => it.toDataURL());
      const [page0, curve0] = [await paper(), await curve()];
      assert.equal(page0, 'rgb(255, 255, 255)');
      await page.selectOption('#theme', 'dark');
      assert.equal(await paper(), 'rgb(22, 24, 26)');
      assert.notEqual(await curve(), curve0);
      assert.deepEqual(await violations(page), []);
      await page.emulateMedia({ colorScheme: 'dark' });
      await page.selectOption('#theme', 'light');
      assert.equal(await paper(), page0);
      assert.equal(await curve(), curve0);
      assert.deepEqual(await violations(page), []);
    }));

  test('the language is that of the browser, and can be changed', () =>
    open(browser, async (page) => {
      assert.equal(await page.getAttribute('html', 'lang'), 'de');
      assert.equal(await value(page, 'mass'), '0,5');
      await page.fill('#field-mass', '0,75');
      await page.selectOption('#language', 'en');
      assert.equal(await page.textContent('h1'), 'Mass on a spring, with friction');
      assert.equal(await value(page, 'mass'), '0.75');
      assert.equal(await page.evaluate(() => document.activeElement.id), 'language');
    }, { locale: 'de-AT' }));
});
