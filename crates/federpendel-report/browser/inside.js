// What is asked of an open page. Each function runs within the page and returns what is wrong, one text each.

// What sticks out of the window, other than within a box that scrolls.
export function overflow() {
  const wide = document.documentElement.clientWidth;
  const wrong = [];
  const total = document.documentElement.scrollWidth;
  if (total > wide) wrong.push(`the page is ${total} px wide in a window of ${wide} px`);
  for (const element of document.querySelectorAll('body *')) {
    if (element.closest('.skip, title, desc')) continue;
    const scrolls = element.parentElement.closest('.wide');
    if (scrolls && getComputedStyle(scrolls).overflowX === 'auto') continue;
    const { left, right } = element.getBoundingClientRect();
    if (right > wide + 0.5 || left < -0.5) wrong.push(`${element.outerHTML.slice(0, 90)} from ${left} to ${right} px`);
  }
  return wrong;
}

// Captions, and what is said below a row, are read without scrolling sideways.
export function sideways() {
  const wide = document.documentElement.clientWidth;
  return [...document.querySelectorAll('.caption, .below p')]
    .filter((element) => element.getBoundingClientRect().right > wide + 0.5)
    .map((element) => element.textContent.slice(0, 90));
}

// Headings begin with one of the first level, and none skips a level.
export function headings() {
  const levels = [...document.querySelectorAll('h1, h2, h3, h4, h5, h6')].map((it) => Number(it.tagName[1]));
  const wrong = levels.filter((level, place) => level > (levels[place - 1] ?? 0) + 1);
  if (levels.filter((level) => level === 1).length !== 1) wrong.push('not one heading of the first level');
  return wrong.map(String);
}

// Every link leads somewhere within the page, and no name is given twice.
export function links() {
  const ids = [...document.querySelectorAll('[id]')].map((it) => it.id);
  const twice = ids.filter((id, place) => ids.indexOf(id) !== place).map((id) => `${id} is there twice`);
  const targets = [...document.querySelectorAll('a')].map((it) => it.getAttribute('href'));
  const lost = targets.filter((target) => !target.startsWith('#') || !ids.includes(target.slice(1)));
  return [...twice, ...lost.map((target) => `${target} leads nowhere`)];
}

// Every drawing has a name and a description for who does not see it.
export function drawings() {
  const says = (svg, tag) => svg.querySelector(`:scope > ${tag}`)?.textContent.trim();
  const named = (svg) => {
    const ids = svg.getAttribute('aria-labelledby')?.split(' ') ?? [];
    return ids.length > 0 && ids.every((id) => svg.contains(document.getElementById(id)));
  };
  return [...document.querySelectorAll('svg')]
    .filter((svg) => svg.getAttribute('role') !== 'img' || !named(svg) || !says(svg, 'title') || !says(svg, 'desc'))
    .map((svg) => svg.outerHTML.slice(0, 90));
}

// No label sticks out of its drawing.
export function labels() {
  const sticksOut = (label) => {
    const [frame, box] = [label.ownerSVGElement, label].map((it) => it.getBoundingClientRect());
    return box.left < frame.left - 1 || box.right > frame.right + 1 || box.top < frame.top - 1 || box.bottom > frame.bottom + 1;
  };
  return [...document.querySelectorAll('svg text')].filter(sticksOut).map((label) => label.textContent);
}

// Every part of a formula takes up room, but for those that are room themselves or cannot be seen.
export function formulas() {
  const unseen = (element) => /^[\s\u2061-\u2064]*$/.test(element.textContent);
  return [...document.querySelectorAll('math, math *')]
    .filter((element) => !unseen(element))
    .filter((element) => {
      const { width, height } = element.getBoundingClientRect();
      return width === 0 || height === 0;
    })
    .map((element) => element.outerHTML);
}
