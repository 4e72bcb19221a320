// The end of the address restores the experiment and how it is shown, and says so where it cannot.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { launch, open, place, value } from './open.js';

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

/** The address, once it has followed the last change. */
const address = async (page) => {
  await page.waitForTimeout(500);
  return page.evaluate(() => location.hash);
};
const notice = (page) => page.textContent('#notice');
const plots = (page) => page.$$eval('.shown input', (all) => all.map((it) => it.checked));

describe('address', { concurrency: 2 }, () => {
  test('a link restores time, speed, plots and the error lens', () => {
    let link = '';
    return open(browser, async (page) => {
      await page.fill('#field-mass', '0.7');
      await page.locator('.shown input').nth(2).uncheck();
      await page.getByLabel('Speed').selectOption('0.25');
      await page.getByRole('heading', { name: 'How good is the formula' }).click();
      await page.selectOption('#method', 'article-scheme');
      await page.fill('#step', '0.01');
      await page.getByRole('button', { name: 'On to the next turning point' }).click();
      link = await address(page);
    }).then(() => open(browser, async (page) => {
      assert.equal(await value(page, 'mass'), '0.7');
      assert.deepEqual(await plots(page), [true, true, false, true]);
      assert.equal(await page.getByLabel('Speed').inputValue(), '0.25');
      assert.equal(await page.inputValue('#method'), 'article-scheme');
      assert.equal(await page.inputValue('#step'), '0.01');
      assert.ok((await page.locator('.sentences li').count()) > 0);
      assert.ok((await place(page)) > 0);
      assert.equal(await address(page), link);
      assert.equal(await notice(page), '');
    }, {}, link));
  });

  test('a link restores kept curves, enlarged parts and the mode for the class; another language leaves them', () => {
    let link = '';
    const pictures = (page) => page.$$eval('.plots .plot-area canvas:first-child', (all) => all.map((it) => it.toDataURL()));
    let seen = [];
    return open(browser, async (page) => {
      const keep = page.getByRole('button', { name: 'Keep this curve' });
      await keep.click();
      await page.selectOption('#preset', 'article-stokes');
      await keep.click();
      // The first look stays free, so that the second must come back as the second.
      await page.getByRole('button', { name: /^Remove/ }).first().click();
      await page.selectOption('#preset', 'all-three');
      for (const name of [0, 1, 2, 3]) await page.getByRole('button', { name: 'Zoom in' }).nth(name).click();
      await page.getByLabel('For the class').check();
      link = await address(page);
      // The pointer would be seen in a plot.
      await page.mouse.move(0, 0);
      seen = await pictures(page);
    }).then(() => open(browser, async (page) => {
      // Not deepEqual, which would print the pictures.
      assert.ok((await pictures(page)).every((picture, k) => picture === seen[k]), 'the plots look as they did');
      assert.match(await page.locator('.kept li line').getAttribute('stroke'), /kept1/);
      assert.ok(await page.getByLabel('For the class').isChecked());
      assert.equal(await address(page), link);
      await page.selectOption('#language', 'de');
      assert.equal(await address(page), link);
      await page.evaluate(() => (location.hash = '#1;mass=3'));
      await page.waitForFunction(() => document.querySelector('#field-mass').value === '3');
      assert.equal(await page.locator('.kept li').count(), 0);
      assert.equal((await address(page)).includes('zoom'), false);
      // A link of somebody else shows no verdict that is hidden.
      assert.ok(await page.locator('.recording input[type=checkbox]').first().isChecked());
    }, {}, link));
  });

  test('enlarged parts and kept curves that cannot be are passed over', () =>
    open(browser, async (page) => {
      assert.equal(await notice(page), '');
      assert.equal(await page.locator('.kept li').count(), 0);
      await page.getByRole('button', { name: 'On to the next turning point' }).click();
      assert.doesNotMatch(await address(page), /zoom|kept/);
    }, {}, '#1;mass=2;zoom-motion=3_1_0_1;zoom-phase=0_1_0;zoom-energy=0_x_0_1;zoom-decrement=0_1e999_0_1;kept0=1~mass:-1;kept1=2;kept7=1'));

  test('signs that a mailer has written otherwise are understood', () =>
    open(browser, async (page) => {
      assert.ok(await page.isChecked('#law-stokes'));
      assert.ok(await page.isChecked('#law-newton'));
      assert.ok(!(await page.isChecked('#law-coulomb')));
      assert.equal(await value(page, 'mass'), '2');
    }, {}, '#1%3Bmass%3D2%3Blaws%3Dstokes%2Bnewton'));

  for (const wrong of ['#2;mass=1', '#1;kinetic=0.5', '#1;mass=-1', '#1;laws=magic', '#nothing']) {
    test(`${wrong} is said to be no experiment`, () =>
      open(browser, async (page) => assert.match(await notice(page), /no experiment that this page can read/), {}, wrong));
  }

  test('what is said of a broken address goes with it', () =>
    open(browser, async (page) => {
      assert.match(await notice(page), /no experiment/);
      await page.evaluate(() => (location.hash = '#1;mass=3'));
      await page.waitForFunction(() => document.querySelector('#field-mass').value === '3');
      assert.equal(await notice(page), '');
    }, {}, '#2;x'));

  test('a moment and an age are shown, or refused, at once', { timeout: 60_000 }, async () => {
    for (const duration of ['3e-9', '1e-12', '1e9']) {
      for (const laws of ['coulomb', 'stokes', 'newton', 'none']) {
        await open(browser, (page) => page.fill('#field-mass', '0.6'), {}, `#1;laws=${laws};duration=${duration}`);
      }
    }
  });

  test('a language later the refusal stands, in that language', () =>
    open(browser, async (page) => {
      await page.fill('#field-static', '0.001');
      assert.match(await page.textContent('#field-static-wrong'), /allowed/);
      await page.selectOption('#language', 'de');
      assert.match(await page.textContent('#field-static-wrong'), /erlaubt/);
      assert.match(await page.textContent('.summary'), /Die Masse/);
    }));

  test('what comes from the address replaces what is in the fields', () =>
    open(browser, async (page) => {
      await page.fill('#field-mass', 'heavy');
      await page.evaluate(() => (location.hash = '#1;mass=2'));
      await page.waitForFunction(() => document.getElementById('field-mass').value === '2');
      assert.equal(await page.getAttribute('#field-mass', 'aria-invalid'), null);
    }));

  test('typing kinetic friction sign by sign leaves static friction as it was', () =>
    open(browser, async (page) => {
      await page.fill('#field-static', '0.03');
      await page.fill('#field-kinetic', '');
      await page.type('#field-kinetic', '2 %');
      assert.equal(await value(page, 'static'), '0.03');
      assert.equal(await page.getAttribute('#field-static', 'aria-invalid'), null);
    }));
});
