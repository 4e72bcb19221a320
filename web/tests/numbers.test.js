// Every preset shows the numbers of the command line, in all nine digits.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { after, before, describe, test } from 'node:test';
import { launch, open, value } from './open.js';

const program = process.env.FEDERPENDEL;
assert.ok(program, 'FEDERPENDEL must name the program federpendel');

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const LAWS = { stokes: ['damping'], coulomb: ['kinetic', 'static'], newton: ['density', 'drag_coefficient', 'area'] };

/** The experiment that the controls show, as arguments of the command line. */
async function argumentsOf(page) {
  const names = ['mass', 'stiffness', 'position', 'velocity', 'duration'];
  for (const [law, coefficients] of Object.entries(LAWS)) {
    if (await page.isChecked(`#law-${law}`)) names.push(...coefficients);
    // Without its coefficient, the built-in experiment would keep the law.
    else if (law === 'coulomb') names.push('none');
  }
  const hanging = await page.isChecked('input[name=hanging] >> nth=1');
  names.push(hanging ? 'normal_force' : 'gravity');
  const experiment = { oscillator: {}, friction: {}, release: {}, record: {} };
  const sections = { mass: 'oscillator', stiffness: 'oscillator', gravity: 'oscillator', normal_force: 'oscillator', position: 'release', velocity: 'release', duration: 'record' };
  for (const name of names.filter((it) => it !== 'none')) {
    const number = Number((await value(page, name)).replace('−', '-'));
    assert.ok(Number.isFinite(number), `${name}: ${await value(page, name)}`);
    const law = Object.keys(LAWS).find((it) => LAWS[it].includes(name));
    if (law) (experiment.friction[law] ??= {})[name] = number;
    else experiment[sections[name]][name] = number;
  }
  return experiment;
}

const toml = (experiment) =>
  Object.entries(experiment)
    .map(([section, values]) => {
      const lines = Object.entries(values).map(([name, it]) =>
        typeof it === 'number' ? `${name} = ${it}` : `${name} = { ${Object.entries(it).map(([key, number]) => `${key} = ${number}`).join(', ')} }`);
      return `[${section}]\n${lines.join('\n')}\n`;
    })
    .join('');

const details = (experiment) =>
  execFileSync(program, ['simulate', '-', '--details', '--lang', 'en'], { input: toml(experiment), encoding: 'utf8' });

/** Rows of the table of turning points: number, time, place. */
const rows = (text) => [...text.matchAll(/^ *(\d+) +([\d.]+) +([−\d.]+)$/gm)].map((it) => it.slice(1));

const numbersOf = (page) =>
  page.evaluate(() => ({
    rows: [...document.querySelectorAll('.numbers tbody tr')].map((row) => [...row.cells].map((cell) => cell.textContent)),
    values: [...document.querySelectorAll('.derived dd')].map((it) => it.textContent),
  }));

describe('numbers', () => {
  test('of every preset are those of the command line', () =>
    open(browser, async (page) => {
      await page.click('.numeric summary');
      const presets = await page.$$eval('#preset option', (all) => all.map((it) => it.value).filter(Boolean));
      assert.ok(presets.length >= 9, presets.join());
      for (const preset of presets) {
        await page.selectOption('#preset', preset);
        const printed = details(await argumentsOf(page));
        const shown = await numbersOf(page);
        const known = rows(printed);
        assert.deepEqual(shown.rows.slice(0, known.length), known, preset);
        // Time and place of the rest stand in the table of turning points, without their units.
        for (const number of shown.values) assert.ok(printed.includes(number.replace(/ [sm]$/, '')), `${preset}: ${number} in\n${printed}`);
      }
    }));
});
