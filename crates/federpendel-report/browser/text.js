// What a reader may see of how a page is made: nothing.
import { readdirSync, readFileSync } from 'node:fs';

const locale = new URL('../../federpendel-text/locales/en/', import.meta.url);
const lines = readdirSync(locale).flatMap((file) => readFileSync(new URL(file, locale), 'utf8').split('\n'));
// Names within the catalogue; a word without a hyphen may well stand in a sentence.
const ids = new Set(lines.map((line) => line.match(/^([a-z0-9]+-[a-z0-9-]+) *=/)?.[1]).filter(Boolean));

// Everything that can be read, in drawings too. Runs within the page.
export function text() {
  const drawn = [...document.querySelectorAll('svg')].map((svg) => svg.textContent);
  return [document.title, document.body.innerText, ...drawn].join('\n');
}

// Names of the catalogue, and signs that only a template or TeX knows.
export function rubbish(text) {
  const names = text.split(/[^a-z0-9-]+/).filter((word) => ids.has(word));
  return [...names, ...(text.match(/\$|\{\{|\}\}|\{%|\\[a-z]+|\bNaN\b/g) ?? [])];
}
