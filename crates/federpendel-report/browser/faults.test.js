// The checks find what they are there to find: a page for every fault.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { violations } from './access.js';
import { launch, visit } from './browser.js';
import * as inside from './inside.js';
import { column, isA4, sizes, torn } from './paper.js';
import { rubbish, text } from './text.js';

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const look = { viewport: { width: 390, height: 900 } };
const pageOf = (body) =>
  `data:text/html,${encodeURIComponent(`<!DOCTYPE html><html lang="en"><meta charset="utf-8"><title>T</title><body>${body}`)}`;
const open = (body, work) => visit(browser, pageOf(body), look, work);

describe('faults', () => {
  const faults = {
    overflow: ['<p style="width:500px">', '<p style="position:absolute;left:-9px">a'],
    sideways: ['<div style="overflow-x:auto"><div class="caption" style="width:500px">a</div></div>'],
    headings: ['<h1>a</h1><h3>b</h3>', '<h2>a</h2>', '<h1>a</h1><h1>b</h1>'],
    links: ['<a href="#nowhere">a</a>', '<a href="http://example.org">a</a>', '<p id="a"><p id="a">'],
    drawings: ['<svg role="img"><title>a</title><desc>b</desc></svg>', '<svg role="img" aria-labelledby="a"><title id="a">a</title></svg>'],
    labels: ['<svg width="100" height="50"><text x="80" y="20">too long</text></svg>'],
    formulas: ['<math><mi style="display:none">x</mi></math>'],
  };
  for (const [name, bodies] of Object.entries(faults)) {
    for (const body of bodies) {
      test(`${name}: ${body}`, () =>
        open(body, async (page) => assert.notDeepEqual(await page.evaluate(inside[name]), [])));
    }
  }
  for (const body of ['report-contents', '5 $', '{{', '\\frac']) {
    test(`text: ${body}`, () =>
      open(body, async (page) => assert.deepEqual(rubbish(await page.evaluate(text)), [body.replace('5 ', '')])));
  }
  test('violations: faint text', () =>
    open('<main><h1>a</h1><p style="color:#bbb">hardly to be read</p></main>', async (page) =>
      assert.match((await violations(page)).join(), /^color-contrast/)));
  test('torn: a figure higher than a page', () =>
    open('<figure style="height:3000px">', async (page) =>
      assert.equal((await page.evaluate(torn, column.height)).length, 1)));
  test('sizes: two pages of A5', () =>
    open('<style>@page { size: A5 }</style><p style="break-after:page">a<p>b', async (page) => {
      const found = sizes(await page.pdf({ preferCSSPageSize: true }));
      assert.equal(found.length, 2);
      assert.ok(!found.some(isA4));
    }));
  test('what a page says and asks for is heard', async () => {
    const { said, asked } = await open('<img src="http://127.0.0.1:9/a.png" alt="a">', (page) => page.waitForTimeout(300));
    assert.deepEqual(asked, ['http://127.0.0.1:9/a.png']);
    assert.equal(said.length, 1);
  });
});
