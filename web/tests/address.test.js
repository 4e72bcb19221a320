// The end of the address restores the experiment and how it is shown, and says so where it cannot.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { readFile } from 'node:fs/promises';
import { drop, fitted, launch, open, place, recordings, value } from './open.js';

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

/** The address, once it has followed the last change. */
const address = async (page) => {
  await page.waitForTimeout(500);
  return page.evaluate(() => location.hash);
};
const notice = (page) => page.textContent('#notice');
const looks = (page) => page.$$eval('.kept li line', (all) => all.map((it) => it.getAttribute('stroke')));
const plots = (page) => page.$$eval('.shown input', (all) => all.map((it) => it.checked));

/** The curves of the four plots, as points of red, green, blue and opacity; the pointer is out of the way. */
async function pictures(page) {
  await page.mouse.move(0, 0);
  const all = await page.$$eval('.plot-section .plot-area', (areas) => areas.map((area) => {
    const canvas = area.querySelector('canvas');
    // A copy, as the browser warns where a canvas is drawn on and read.
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', { willReadFrequently: true });
    copy.drawImage(canvas, 0, 0);
    const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
    return btoa(data.reduce((text, byte) => text + String.fromCharCode(byte), ''));
  }));
  return all.map((one) => Buffer.from(one, 'base64'));
}
/** The edges of lines may come out a little different whenever they are drawn. */
const alike = (one, other) => one.length === other.length && one.every((it, k) => Math.abs(it - other[k]) < 16);

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
    let seen = [];
    return open(browser, async (page) => {
      const keep = page.getByRole('button', { name: 'Keep this curve' });
      await keep.click();
      await page.selectOption('#preset', 'article-stokes');
      await keep.click();
      // The first look becomes free for the third curve: the order is not that of the looks.
      await page.getByRole('button', { name: /^Remove/ }).first().click();
      await page.selectOption('#preset', 'all-three');
      await keep.click();
      await page.selectOption('#preset', 'card-in-air');
      for (const name of [0, 1, 2, 3]) await page.getByRole('button', { name: 'Zoom in' }).nth(name).click();
      await page.getByLabel('For the class').check();
      link = await address(page);
      seen = await pictures(page);
    }).then(() => open(browser, async (page) => {
      const now = await pictures(page);
      assert.equal(now.length, 4);
      assert.ok(now.every((picture, k) => alike(picture, seen[k])), 'the plots look as they did');
      assert.deepEqual(await looks(page), ['var(--kept1)', 'var(--kept0)']);
      assert.ok(await page.getByLabel('For the class').isChecked());
      await page.selectOption('#language', 'de');
      assert.equal(await address(page), link);
    }, {}, link));
  });

  test('another link takes what is kept and enlarged away, but shows no verdict that is hidden', { timeout: 120_000 }, () =>
    open(browser, async (page) => {
      await page.getByRole('button', { name: 'Keep this curve' }).click();
      await page.getByRole('button', { name: 'Zoom in' }).first().click();
      await page.locator('.shown input').nth(2).uncheck();
      await page.getByRole('heading', { name: 'How good is the formula' }).click();
      const file = 'tracker.txt';
      await drop(page, file, await readFile(`${recordings}/${file}`));
      await fitted(page);
      const go = async (mass, more = '') => {
        await page.evaluate((it) => (location.hash = it), `#1;mass=${mass}${more}`);
        await page.waitForFunction((it) => document.querySelector('#field-mass').value === it, mass);
      };
      assert.ok(await page.isVisible('.verdict'));
      await go('3');
      assert.deepEqual(await looks(page), []);
      assert.deepEqual(await plots(page), [true, true, true, true]);
      assert.doesNotMatch(await address(page), /zoom|method/);
      await go('4', ';class=yes');
      assert.ok(await page.getByLabel('For the class').isChecked());
      assert.equal(await page.locator('.verdict').count(), 0);
      await go('5');
      assert.equal(await page.locator('.verdict').count(), 0);
      await page.getByRole('button', { name: 'Show the verdict' }).click();
      assert.ok(await page.isVisible('.verdict'));
      await go('6', ';class=yes');
      assert.equal(await page.locator('.verdict').count(), 0);
    }));

  test('enlarged parts and kept curves that cannot be are passed over', () =>
    open(browser, async (page) => {
      assert.equal(await notice(page), '');
      assert.deepEqual(await looks(page), []);
      await page.getByRole('button', { name: 'On to the next turning point' }).click();
      assert.doesNotMatch(await address(page), /zoom|kept/);
    }, {}, '#1;mass=2;zoom-motion=3_1_0_1;zoom-phase=0_1_0;zoom-energy=_1__1;zoom-decrement=0_1e999_0_1'
      + ';kept0=1~mass:-1;kept1=1~laws:newton~duration:1e9;kept7=1;50%'));

  test('a kept curve that would swing too often beside a long motion is drawn as long as it was kept', () =>
    open(browser, async (page) => {
      await page.selectOption('#language', 'de');
      assert.equal(await page.locator('.kept li').count(), 1);
      const [motion] = await pictures(page);
      await page.getByRole('button', { name: /entfernen/ }).click();
      assert.ok(!alike((await pictures(page))[0], motion), 'it was drawn');
    }, {}, '#1;laws=coulomb;stiffness=1;duration=5000;kept0=1~laws:newton~stiffness:10000~duration:100'));

  test('on a telephone the plots that were chosen come back', () => {
    const telephone = { viewport: { width: 390, height: 800 } };
    let link = '';
    return open(browser, async (page) => {
      assert.deepEqual(await plots(page), [true, false, false, false]);
      for (const one of [1, 2, 3]) await page.locator('.shown input').nth(one).check();
      link = await address(page);
    }, telephone).then(() => open(browser, async (page) => assert.deepEqual(await plots(page), [true, true, true, true]), telephone, link));
  });

  test('what is kept while the mass moves is in the address', () =>
    open(browser, async (page) => {
      await page.getByRole('button', { name: 'Play' }).click();
      await page.getByRole('button', { name: 'Keep this curve' }).click();
      assert.match(await address(page), /kept0=/);
    }, {}, '#1;laws=none;duration=100'));

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
