// Fingers instead of a mouse: the mass follows them, the page scrolls, nothing sticks out of a telephone.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { fitted, launch, open, recordings, value } from './open.js';

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
const NARROW = { ...PHONE, viewport: { width: 320, height: 640 }, locale: 'de-DE' };

/** Fingers that come down at their first places, go through the others together, and are lifted. */
async function touch(page, ...fingers) {
  const client = await page.context().newCDPSession(page);
  const send = (type, step) => client.send('Input.dispatchTouchEvent',
    { type, touchPoints: step === undefined ? [] : fingers.map((way, id) => ({ id, x: way[step][0], y: way[step][1] })) });
  await send('touchStart', 0);
  for (let step = 1; step < fingers[0].length; step++) {
    await send('touchMove', step);
    await page.waitForTimeout(16);
  }
  await send('touchEnd');
}

const way = ([x, y], [byX, byY], steps = 8) => Array.from({ length: steps + 1 }, (_, k) => [x + (byX * k) / steps, y + (byY * k) / steps]);
async function middle(page, selector) {
  const { x, y, width, height } = await page.locator(selector).first().boundingBox();
  return [x + width / 2, y + height / 2];
}
const scrolled = (page) => page.evaluate(() => Math.round(scrollY));
const wide = (page) => page.evaluate(() => document.documentElement.scrollWidth - innerWidth);

describe('touch', { concurrency: 2 }, () => {
  test('the mass follows a finger that does not move straight', () =>
    open(browser, async (page) => {
      const before = Number(await value(page, 'position'));
      await touch(page, way(await middle(page, '.mass .body'), [-40, -110]));
      assert.ok(Number(await value(page, 'position')) < before - 0.01, await value(page, 'position'));
      assert.equal(await scrolled(page), 0);
    }, PHONE));

  test('beside the mass the page scrolls, lying and hanging', () =>
    open(browser, async (page) => {
      for (const preset of [null, 'card-in-air']) {
        if (preset) await page.selectOption('#preset', preset);
        await page.evaluate(() => scrollTo(0, 0));
        const { x, y, height } = await page.locator('.scene').boundingBox();
        await touch(page, way([x + 12, y + height - 8], [0, -90]));
        await page.waitForFunction(() => scrollY > 40);
      }
    }, PHONE));

  test('a thumb that scrolls over a slider changes nothing', () =>
    open(browser, async (page) => {
      await page.locator('.controls summary').first().tap();
      const slider = page.locator('.controls .field:has(#field-mass) input[type=range]');
      // The stage stays at the top and would cover it.
      await slider.evaluate((it) => it.scrollIntoView({ block: 'center' }));
      const before = await value(page, 'mass');
      const { x, y, width, height } = await slider.boundingBox();
      const from = await scrolled(page);
      await touch(page, way([x + 0.3 * width, y + height / 2], [8, -160], 12));
      await page.waitForFunction((it) => Math.abs(scrollY - it) > 30, from);
      assert.equal(await value(page, 'mass'), before);
    }, PHONE));

  test('what is between two fingers goes with them', () =>
    open(browser, async (page) => {
      await page.locator('.plot-area').first().scrollIntoViewIfNeeded();
      const [x, y] = await middle(page, '.plot-area');
      await page.locator('.plot-section').getByRole('button', { name: 'Zoom in' }).first().tap();
      const look = () => page.locator('.plot-area canvas').first().screenshot();
      const whole = await look();
      await touch(page, way([x - 30, y], [50, 0]), way([x + 30, y], [50, 0]));
      assert.notDeepEqual(await look(), whole);
      assert.equal(await page.evaluate(() => visualViewport.scale), 1, 'the page itself is not enlarged');
      assert.match(await page.textContent('.plot-section > .hint'), /double tap/);
    }, PHONE));

  test('nothing sticks out of a narrow telephone, menus and a recording with it', () =>
    open(browser, async (page) => {
      await page.setInputFiles('#file', join(recordings, 'tracker.txt'));
      await fitted(page);
      assert.ok((await wide(page)) <= 0, `by ${await wide(page)} px`);
      for (const menu of await page.locator('.menu summary').all()) {
        if (!(await menu.isVisible())) continue;
        await menu.tap();
        assert.ok((await wide(page)) <= 0, `an open menu by ${await wide(page)} px`);
        await page.locator('h1').tap();
        assert.equal(await page.locator('.menu[open]').count(), 0, 'a tap elsewhere closes it');
      }
    }, NARROW));
});
