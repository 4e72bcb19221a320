// The mass is let go: by mouse, by key, with a throw; and where it comes to rest.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { heard, hears, launch, open, place, value } from './open.js';

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const middle = async (page) => {
  const { x, y, width, height } = await page.locator('.mass .body').boundingBox();
  return [x + width / 2, y + height / 2];
};

/** Metres that a way of the mouse on the scene means, read off the ruler. */
const metres = (page, pixels) =>
  page.evaluate((way) => {
    const marks = [...document.querySelectorAll('.scene text')]
      .filter((it) => /^[−\d]/.test(it.textContent))
      .map((it) => [Number(it.textContent.replace('−', '-')), it.getBoundingClientRect()])
      .map(([at, box]) => [at, box.left + box.width / 2]);
    const [first, last] = [marks[0], marks.at(-1)];
    return (way * (last[0] - first[0])) / (last[1] - first[1]);
  }, pixels);

async function drag(page, way) {
  const [x, y] = await middle(page);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + way / 2, y, { steps: 4 });
  await page.mouse.move(x + way, y, { steps: 4 });
  // Held still before it is let go.
  await page.waitForTimeout(400);
  await page.mouse.up();
}

describe('release', { concurrency: 3 }, () => {
  test('by mouse: the place is that of the mouse, and the motion begins', () =>
    open(browser, async (page) => {
      const [way, before] = [await metres(page, -150), Number(await value(page, 'position'))];
      await drag(page, -150);
      assert.ok(Math.abs(Number(await value(page, 'position')) - (before + way)) < 0.001, await value(page, 'position'));
      assert.equal(await value(page, 'velocity'), '0');
      await hears(page, /^Released at .* with 0 m\/s\. The mass comes to rest/);
      await page.waitForFunction(() => Number(document.querySelector('.transport input[type=range]').value) > 20);
    }));

  test('by mouse, hanging: down is down', () =>
    open(browser, async (page) => {
      await page.selectOption('#preset', 'card-in-air');
      const before = Number(await value(page, 'position'));
      const [x, y] = await middle(page);
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + 40, y - 100, { steps: 5 });
      const held = Number(await value(page, 'position'));
      assert.ok(held < before - 0.05, `${before} to ${held}`);
      const [, now] = await middle(page);
      assert.ok(Math.abs(now - (y - 100)) < 2, `the mass is ${now - (y - 100)} px from the mouse`);
      await page.mouse.up();
    }));

  test('by mouse in motion: the mass is thrown with the speed of the mouse', () =>
    open(browser, async (page) => {
      const [x, y] = await middle(page);
      const expected = await metres(page, -500);
      const session = await page.context().newCDPSession(page);
      // Times of its own, for a busy machine sends the events when it can: 5 pixels in every 10 ms.
      const began = Date.now() / 1000;
      const event = (type, step, buttons) => session.send('Input.dispatchMouseEvent',
        { type, x: x - 5 * step, y, button: 'left', buttons, clickCount: 1, timestamp: began + step / 100 });
      await event('mousePressed', 0, 1);
      for (let step = 1; step <= 30; step++) await event('mouseMoved', step, 1);
      await event('mouseReleased', 30, 0);
      const speed = Number((await value(page, 'velocity')).replace('−', '-'));
      assert.ok(Math.abs(speed / expected - 1) < 0.1, `${speed} m/s, not ${expected}`);
    }));

  test('by key: arrows move the mass, Enter lets it go', () =>
    open(browser, async (page) => {
      await page.focus('.mass');
      for (const key of ['ArrowLeft', 'ArrowLeft', 'Shift+ArrowRight']) await page.keyboard.press(key);
      assert.equal(await value(page, 'position'), '0.081');
      assert.match(await page.getAttribute('.mass', 'aria-valuetext'), /^81(\.0)? mm$|^0\.081 m$|^8\.1 cm$/);
      await page.keyboard.press('Enter');
      await hears(page, /^Released at/);
      await page.waitForFunction(() => Number(document.querySelector('.transport input[type=range]').value) > 20);
    }));

  test('the mass comes to rest, visibly and audibly', () =>
    open(browser, async (page) => {
      await page.fill('#field-position', '0.02');
      await page.click('.play');
      await hears(page, /^The mass has come to rest at/);
      assert.ok(await page.locator('.mass.locked').isVisible());
      assert.ok(await page.getByText('sticks', { exact: true }).isVisible());
    }));

  test('steps from turning point to turning point', () =>
    open(browser, async (page) => {
      const next = page.getByRole('button', { name: 'On to the next turning point' });
      await next.click();
      // Half a period without friction: dry friction leaves it as it is.
      assert.match(await heard(page), /^At 497 ms the mass is at −9\.02 cm|^At 497 ms .*−90\.2 mm/);
      const first = await place(page);
      await next.click();
      assert.ok((await place(page)) > first);
    }));

  test('whoever wishes for little motion is shown the turning points, and starts the motion himself', () =>
    open(browser, async (page) => {
      await page.focus('.mass');
      await page.keyboard.press('Enter');
      await hears(page, /^Released at .* jumps .* At 497 ms the mass is at −9\.02 cm|−90\.2 mm/);
      const first = await place(page);
      await page.waitForTimeout(300);
      assert.ok(first > 0 && (await place(page)) === first, 'nothing moves by itself');
      await page.keyboard.press('Enter');
      await hears(page, /^At .* the mass is at 8/);
      assert.ok((await place(page)) > first);
      await page.click('.play');
      await page.waitForFunction((from) => Number(document.querySelector('.transport input[type=range]').value) > from + 20, await place(page));
    }, { reducedMotion: 'reduce' }));
});
