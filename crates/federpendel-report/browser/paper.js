// What is asked of a page on paper: A4, everything within its margins, nothing torn that belongs together.

const MILLIMETRE = 96 / 25.4;
const A4 = { width: 210, height: 297 };
// The margins that the style sheet sets, mm.
const MARGIN = { x: 20, top: 20, bottom: 22 };
export const column = {
  width: Math.floor((A4.width - 2 * MARGIN.x) * MILLIMETRE),
  height: Math.floor((A4.height - MARGIN.top - MARGIN.bottom) * MILLIMETRE),
};

// Sizes of the pages of a PDF of Chromium, in points.
export function sizes(pdf) {
  const boxes = pdf.toString('latin1').matchAll(/\/MediaBox\s*\[0 0 ([\d.]+) ([\d.]+)\]/g);
  return [...boxes].map(([, width, height]) => [Number(width), Number(height)]);
}

export const isA4 = ([width, height]) =>
  Math.abs(width - (A4.width * 72) / 25.4) < 1 && Math.abs(height - (A4.height * 72) / 25.4) < 1;

// What is higher than a page although it must not be torn. Runs within the page.
export function torn(height) {
  return [...document.querySelectorAll('figure, tr, .claim, .formula, .notice')]
    .filter((element) => element.getBoundingClientRect().height > height)
    .map((element) => element.outerHTML.slice(0, 90));
}
