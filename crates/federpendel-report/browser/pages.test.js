// Opens the reports given as arguments as a reader would, on telephone, desk, wall and paper:
//   node pages.test.js REPORT.html …
import assert from 'node:assert/strict';
import { basename, resolve } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { violations } from './access.js';
import { launch, visit } from './browser.js';
import * as inside from './inside.js';
import { column, isA4, sizes, torn } from './paper.js';
import { rubbish, text } from './text.js';

const WIDTHS = [390, 1000, 1600];
const files = process.argv.slice(2);
assert.notEqual(files.length, 0, 'usage: node pages.test.js REPORT.html …');

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

async function readable(page) {
  for (const [name, check] of Object.entries(inside)) {
    assert.deepEqual(await page.evaluate(check), [], name);
  }
  assert.deepEqual(rubbish(await page.evaluate(text)), []);
  assert.deepEqual(await violations(page), []);
}

async function printable(page) {
  await page.emulateMedia({ media: 'print' });
  assert.deepEqual(await page.evaluate(inside.overflow), [], 'wider than the paper');
  assert.deepEqual(await page.evaluate(torn, column.height), [], 'higher than the paper');
  assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), 'rgb(255, 255, 255)');
  const height = await page.evaluate(() => document.documentElement.scrollHeight);
  const pages = sizes(await page.pdf({ preferCSSPageSize: true }));
  assert.ok(pages.every(isA4), `not A4: ${pages}`);
  // What must not be torn leaves room at the foot of a page, seldom more than half of it.
  const [least, most] = [height / column.height, 1 + (2 * height) / column.height];
  assert.ok(least <= pages.length && pages.length <= most, `${pages.length} pages, not ${least} to ${most}`);
}

for (const file of files) {
  const url = pathToFileURL(resolve(file)).href;
  const opened = async (look, work) => {
    const { said, asked } = await visit(browser, url, look, work);
    assert.deepEqual(said, [], 'the console');
    assert.deepEqual(asked, [url], 'requests');
  };
  describe(basename(file), { concurrency: 3 }, () => {
    for (const colorScheme of ['light', 'dark']) {
      for (const width of WIDTHS) {
        const look = { colorScheme, viewport: { width, height: 900 } };
        test(`${colorScheme}, ${width} px`, () => opened(look, readable));
      }
    }
    const look = { colorScheme: 'dark', viewport: { width: column.width, height: column.height } };
    test('on paper', () => opened(look, printable));
  });
}
