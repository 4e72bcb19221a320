// The scene: seen together with its plot, held and thrown by mouse and finger, its scale, its numbers.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { hears, launch, open, place, value } from './open.js';

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const WINDOWS = { laptop: [1280, 600], projector: [1920, 940], tablet: [768, 900], phone: [390, 700] };
const number = (words) => Number(words.replace('−', '-').replace(/[^-\d.]/g, ''));
const field = async (page, name) => number(await value(page, name));

const box = (page, selector) => page.locator(selector).first().boundingBox();
const middle = async (page) => {
  const { x, y, width, height } = await box(page, '.mass .body');
  return [x + width / 2, y + height / 2];
};
const ruler = (page) => page.$$eval('.scene text', (all) => all.map((it) => it.textContent).filter((it) => /^[−\d]/.test(it)));
const forces = (page) => page.$$eval('.force-key li', (all) =>
  Object.fromEntries(all.map((it) => [it.querySelector('svg').classList[1], it.querySelector('.force-now')?.textContent])));

/** Pixels of a metre, read off the ruler. */
const scale = (page) => page.evaluate(() => {
  const marks = [...document.querySelectorAll('.scene text')].filter((it) => /^[−\d]/.test(it.textContent))
    .map((it) => [Number(it.textContent.replace('−', '-')), it.getBoundingClientRect()]);
  const [[a, from], [b, to]] = [marks[0], marks.at(-1)];
  return (to.left + to.width / 2 - from.left - from.width / 2) / (b - a);
});

const inside = (part, whole, slack = 1) => part.x >= whole.x - slack && part.y >= whole.y - slack
  && part.x + part.width <= whole.x + whole.width + slack && part.y + part.height <= whole.y + whole.height + slack;

describe('scene', { concurrency: 2 }, () => {
  for (const [name, [width, height]] of Object.entries(WINDOWS)) {
    for (const preset of ['article-coulomb', 'card-in-air']) {
      test(`${name}, ${preset}: scene, transport and x(t) are seen together`, () =>
        open(browser, async (page) => {
          await page.selectOption('#preset', preset);
          await page.evaluate(() => scrollTo(0, document.querySelector('.scene-frame').getBoundingClientRect().top + scrollY - 4));
          for (const part of ['.scene-frame', '.force-key', '.transport', '.plot-area']) {
            const at = await box(page, part);
            assert.ok(at.y >= 0 && at.y + at.height <= height, `${part}: ${at.y} to ${at.y + at.height} of ${height}`);
          }
        }, { viewport: { width, height }, locale: 'de-DE', hasTouch: width < 800 }));
    }
  }

  test('the scene stays in sight while one reads on, and covers nothing that has the focus', () =>
    open(browser, async (page) => {
      const covered = [];
      for (let k = 0; k < 70; k++) {
        await page.keyboard.press('Tab');
        covered.push(...await page.evaluate(() => {
          const [it, stage] = [document.activeElement, document.querySelector('.stage')];
          if (stage.contains(it) || it === document.body || it.matches('.skip')) return [];
          const [a, b] = [it.getBoundingClientRect(), stage.getBoundingClientRect()];
          const apart = a.top >= b.bottom || a.bottom <= b.top || a.right <= b.left || a.left >= b.right;
          return apart && a.top >= 0 ? [] : [it.id || it.textContent];
        }));
      }
      assert.deepEqual(covered, []);
      await page.focus('#field-duration');
      assert.ok((await page.evaluate(() => scrollY)) > 200);
      assert.ok((await box(page, '.scene')).y >= 0);
    }, { viewport: { width: 1280, height: 600 } }));

  test('a finger drags the mass, from beside it too, and the page stays', () =>
    open(browser, async (page) => {
      const [[x, y], metre] = [await middle(page), await scale(page)];
      const session = await page.context().newCDPSession(page);
      const touch = (type, by) => session.send('Input.dispatchTouchEvent', { type, touchPoints: type === 'touchEnd' ? [] : [{ x: x + by, y: y + 20 }] });
      await touch('touchStart', 18);
      for (let by = 18; by >= -60; by -= 6) await touch('touchMove', by);
      await page.waitForTimeout(300);
      await touch('touchEnd');
      // The finger holds the body at its edge, which is 15 px from its middle.
      const expected = 0.1 + (-60 - 15) / metre;
      assert.ok(Math.abs(await field(page, 'position') - expected) < 3 / metre, `${await value(page, 'position')}, not ${expected}`);
      assert.equal(await page.evaluate(() => scrollY), 0);
      await hears(page, /^Released at/);
    }, { viewport: { width: 390, height: 844 }, hasTouch: true }));

  test('a throw that leaves the scene keeps its speed', () =>
    open(browser, async (page) => {
      const [[x, y], metre] = [await middle(page), await scale(page)];
      const session = await page.context().newCDPSession(page);
      const began = Date.now() / 1000;
      const event = (type, step, buttons) => session.send('Input.dispatchMouseEvent',
        { type, x: x + 10 * step, y, button: 'left', buttons, clickCount: 1, timestamp: began + step / 200 });
      // At once, for a hand that waits at the edge asks for a larger scene.
      const steps = Array.from({ length: 12 }, (_, k) => k + 1);
      await Promise.all([event('mousePressed', 0, 1), ...steps.map((k) => event('mouseMoved', k, 1)), event('mouseReleased', 12, 0)]);
      const speed = await field(page, 'velocity');
      assert.ok(Math.abs(speed / (2000 / metre) - 1) < 0.1, `${speed} m/s, not ${2000 / metre}`);
    }));

  test('the scale holds, and grows where the hand goes to the edge; the mass is never cut off', () =>
    open(browser, async (page) => {
      const [frame, marks] = [await box(page, '.scene-frame'), await ruler(page)];
      const drag = async (to, wait) => {
        const [x, y] = await middle(page);
        await page.mouse.move(x, y);
        await page.mouse.down();
        await page.mouse.move(to, y, { steps: 6 });
        await page.waitForTimeout(wait);
        assert.ok(inside(await box(page, '.mass .body'), frame), 'in the hand');
        await page.mouse.up();
        await page.click('.play');
      };
      await drag(frame.x + frame.width / 2 + 60, 300);
      assert.ok(await field(page, 'position') < 0.03);
      assert.deepEqual(await ruler(page), marks);
      await drag(frame.x + frame.width - 3, 1200);
      const far = await field(page, 'position');
      assert.ok(far > 0.13 && far <= 0.5, String(far));
      assert.ok(number((await ruler(page)).at(-1)) > number(marks.at(-1)));
    }));

  test('a press where the moving mass has just been takes it', () =>
    open(browser, async (page) => {
      await page.selectOption('.transport select', '0.25');
      // A busy machine may press later than any hand.
      for (let tries = 0; tries < 6; tries++) {
        await page.getByRole('button', { name: 'Release again' }).click();
        await page.waitForTimeout(700);
        const [x, y] = await middle(page);
        await page.mouse.move(x, y);
        await page.mouse.down();
        await page.waitForTimeout(200);
        const taken = (await page.textContent('.play')) === 'Play' && (await place(page)) === 0;
        const [now] = await middle(page);
        await page.mouse.up();
        if (taken) return assert.ok(Math.abs(now - x) < 20, `${now - x} px`);
      }
      assert.fail('never taken');
    }));

  test('what still moves at the end of the record begins anew; what rests stops', () =>
    open(browser, async (page) => {
      await page.uncheck('#law-coulomb');
      await page.fill('#field-duration', '0.6');
      await page.click('.play');
      await hears(page, /^The record ends at 600 ms and begins anew/);
      assert.equal(await page.textContent('.play'), 'Pause');
      await page.click('.play');
      await page.check('#law-coulomb');
      await page.fill('#field-duration', '300');
      await page.fill('#field-position', '0.012');
      await page.getByRole('button', { name: 'Release again' }).click();
      await hears(page, /^The mass has come to rest at/);
      await page.waitForFunction(() => document.querySelector('.play').textContent === 'Play');
      assert.ok(await place(page) < 50);
    }));

  test('digits and units stand still while the mass moves', () =>
    open(browser, async (page) => {
      await page.click('.play');
      const shapes = new Set();
      for (let k = 0; k < 12; k++) {
        const words = await page.$$eval('.now dd, .force-now', (all) => all.map((it) => it.textContent));
        shapes.add(words.map((it) => it.replace('−', '').replace(/\d+/, '0').replace(/\d/g, '0')).join(' '));
        await page.waitForTimeout(60);
      }
      assert.equal(shapes.size, 1, [...shapes].join('\n'));
      assert.match([...shapes][0], /^(0\.000 ){3}0\.000 s 0\.0000 m 0\.0000 m\/s 0\.000 m\/s²$/);
    }));

  test('hanging at rest, the spring carries the weight, and gravity has its field', () =>
    open(browser, async (page) => {
      await page.selectOption('#preset', 'card-in-air');
      assert.ok(await page.isVisible('#field-gravity'));
      await page.fill('#field-position', '0');
      const at = await forces(page);
      assert.deepEqual([number(at.spring), number(at.weight), number(at.sum)], [-0.4905, 0.4905, 0]);
      await page.fill('#field-position', '0.1');
      const low = await forces(page);
      assert.ok(Math.abs(number(low.spring) + 0.5 + 0.4905) < 6e-4, low.spring);
      assert.match(await page.getAttribute('.scene', 'class'), /hanging/);
    }));

  test('all arrows stay in the picture, for a release that sticks as in motion', () =>
    open(browser, async (page) => {
      const slider = '.transport input[type=range]';
      for (const [preset, values] of [['article-coulomb', { position: '3 mm' }], ['card-in-air', {}], ['heavy-oil', {}], ['all-three', { velocity: '1' }]]) {
        await page.selectOption('#preset', preset);
        for (const [name, words] of Object.entries(values)) await page.fill(`#field-${name}`, words);
        for (const at of [0, 30, 60, 90, 200]) {
          await page.$eval(slider, (it, to) => { it.value = to; it.dispatchEvent(new Event('input')); }, at);
          const frame = await box(page, '.scene-frame');
          const seen = await page.$$eval('.scene > .force:not([hidden]) path, .mass .body, .lock:not([hidden])', (all) => all.map((it) => {
            const { x, y, width, height } = it.getBoundingClientRect();
            return { x, y, width, height };
          }));
          assert.ok(seen.length > 3, preset);
          for (const part of seen) assert.ok(inside(part, frame, 3), `${preset} at ${at}: ${JSON.stringify(part)} in ${JSON.stringify(frame)}`);
        }
      }
    }));
});
