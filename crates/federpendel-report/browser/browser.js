// Debian's Chromium, with nothing that asks the network of its own accord.
import { chromium } from 'playwright-core';

const args = [
  '--no-sandbox', // for who runs the tests as root
  '--disable-gpu',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];

export const launch = () => chromium.launch({ executablePath: '/usr/bin/chromium', args });

// Opens `url`, does `work` on it, and returns what the page said and asked for meanwhile.
export async function visit(browser, url, look, work) {
  const context = await browser.newContext(look);
  const page = await context.newPage();
  const said = [];
  const asked = [];
  page.on('console', (message) => said.push(`${message.type()}: ${message.text()}`));
  page.on('pageerror', (error) => said.push(String(error)));
  page.on('request', (request) => asked.push(request.url()));
  try {
    await page.goto(url);
    await work(page);
  } finally {
    await context.close();
  }
  return { said, asked };
}
