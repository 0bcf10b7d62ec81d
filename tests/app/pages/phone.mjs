// Pages on screens that are small, or are turned.

import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const kTablet = { width: 1024, height: 700 }, kUpright = { width: 390, height: 844 };

export async function tryTurned(browser, open, claim, folder) {
  const context = await browser.newContext({ viewport: kTablet, isMobile: true, hasTouch: true });
  const page = await open(context, join(folder, 'walk.html'), '#t=1');
  // The browser says that its window has changed with its next picture.
  const becomes = (on) => page.waitForFunction((wanted) => {
    const expanded = document.getElementById('layers-toggle').getAttribute('aria-expanded');
    return document.getElementById('layers').checkVisibility() === wanted && expanded === String(wanted);
  }, on, { timeout: 20_000 }).then(() => true, () => false);
  claim('where there is room the panel of layers is open', await becomes(true));
  await page.setViewportSize(kUpright);
  claim('turned upright it is closed', await becomes(false));
  await page.tap('#layers-toggle');
  claim('a tap opens it', await becomes(true));
  await page.setViewportSize(kTablet);
  await page.waitForFunction(() => matchMedia('(min-width: 800px)').matches);
  await page.setViewportSize(kUpright);
  claim('and turning closes it again', await becomes(false));
  await context.close();
}

export async function tryReport(browser, claim, folder) {
  const context = await browser.newContext({ viewport: { width: 360, height: 740 }, isMobile: true, hasTouch: true });
  const page = await context.newPage();
  await page.goto(pathToFileURL(join(folder, 'report.html')).href);
  const [wide, picture, plan, box] = await page.evaluate(() => [
    document.documentElement.scrollWidth, ...['.picture img', '.plan img', '.plan'].map((one) => document.querySelector(one).clientWidth),
  ]);
  claim('a report is as wide as the phone', wide <= 360 && picture <= 360, [wide, picture]);
  // Its letters are 12 of 1160 units or so: they take 6 pixels to be read.
  claim('but its plan is large enough to be read, and is moved within its frame', plan >= 600 && box <= 360, [plan, box]);
  const reached = await page.evaluate(() => {
    const frame = document.querySelector('.plan');
    frame.scrollLeft = 1e4;
    return frame.scrollLeft + frame.clientWidth >= frame.querySelector('img').clientWidth;
  });
  claim('to its other end', reached);
  const raw = await page.evaluate(() => /[0-9]e[-+]?[0-9]/.exec(document.body.innerText.replaceAll(/[0-9a-f]{64}/g, ''))?.[0] ?? '');
  claim('no figure of a report has a power of ten', raw === '', raw);
  await context.close();
}
