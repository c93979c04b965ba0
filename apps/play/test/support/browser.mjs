// SPDX-License-Identifier: MIT
// The page in Debian's Chromium, drawn by software: opened once a test file, from its file:// address.
import {existsSync} from 'node:fs';
import {createRequire} from 'node:module';
import {dirname, join} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';

export const root = join(dirname(fileURLToPath(import.meta.url)), '..', '..', '..', '..');
export const built = process.env.PLIANT_PLAY || join(root, 'build', 'play');
export const require = createRequire(join(root, 'build', 'play', 'package.json'));
const {chromium} = require('playwright-core');

export const WIDE = {width: 1366, height: 768};
/** Of most tests: software draws few pixels sooner. */
const SMALL = {width: 1000, height: 600};
export const PHONE = {width: 390, height: 844};

const WAIT = 300000;  // ms; what takes longer hangs, also on a busy machine

const SOFTWARE = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
  '--ignore-gpu-blocklist', '--disable-gpu-watchdog', '--no-sandbox', '--disable-dev-shm-usage'];

let browser = null;
let shared = null;

/** The browser of all tests; ended by quit(). */
async function launch() {
  browser ??= await chromium.launch({
    executablePath: process.env.CHROMIUM || '/usr/bin/chromium', args: SOFTWARE, timeout: WAIT,
  });
  return browser;
}

export async function quit() {
  await browser?.close();
  [browser, shared] = [null, null];
}

/** One page for the tests of all files: each begins by opening something. */
export function sharedPage() {
  return shared ??= openPage({viewport: SMALL});
}

/** A tab at an address, with what it asked the network for and what it complained about. With less
 * motion the page begins without its start scene. */
export async function openTab(address, {viewport = WIDE, theme = 'light', wait = WAIT, ...more} = {}) {
  const context = await (await launch()).newContext({
    viewport, colorScheme: theme, acceptDownloads: true, reducedMotion: 'reduce', ...more,
  });
  context.setDefaultTimeout(wait);
  const page = await context.newPage();
  page.requests = [];
  page.complaints = [];
  page.on('request', (request) => page.requests.push(request.url()));
  page.on('pageerror', (error) => page.complaints.push(String(error)));
  page.on('console', (message) => message.type() === 'error' && page.complaints.push(message.text()));
  await page.goto(address);
  return page;
}

/** A page that is ready. */
export async function openPage({address, ...more} = {}) {
  const file = join(built, 'pliant.html');
  if (!address && !existsSync(file)) throw new Error(`${file} is missing: ./dev play builds it`);
  const page = await openTab(address ?? pathToFileURL(file).href, more);
  await page.evaluate(() => window.pliant.then((parts) => { window.P = parts; }));
  page.firstTitle = await page.textContent('#title');
  return page;
}

export async function openExample(page, name) {
  await page.evaluate((wanted) => P.open.openExample(wanted), name);
  await settle(page);
}

/** Two frames later: what was asked for has been drawn. */
export function settle(page) {
  return page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

/** Where a joint is seen, in CSS pixels of the window. */
export function placeOf(page, joint) {
  return page.evaluate((j) => {
    const box = document.getElementById('canvas').getBoundingClientRect();
    const {x, y} = P.view.orbit.project([...P.session.positions.subarray(3 * j, 3 * j + 3)]);
    return {x: box.left + x, y: box.top + y};
  }, joint);
}

/** A joint that nothing hides: the one that is picked where it is seen, and nearest to the eye. */
export function seenJoint(page, skip = 0) {
  return page.evaluate((skipped) => {
    const {view, session} = P;
    const seen = [];
    for (let j = 0; j < session.model.joints && seen.length <= skipped; ++j) {
      const {x, y} = view.orbit.project([...session.positions.subarray(3 * j, 3 * j + 3)]);
      if (view.pick(x, y)?.joint === j) seen.push(j);
    }
    return seen[skipped];
  }, skip);
}

/** Drags a joint by the mouse; waits for so many steps of the solver on the way. `corner`: of the
 * frame that the page is in, in the tab whose mouse it is. */
export async function drag(page, joint, dx, dy, {steps = 6, mouse = page.mouse, corner = {x: 0, y: 0}} = {}) {
  await settle(page);  // the first pull takes the hint's row away, and the picture grows
  const place = await placeOf(page, joint);
  const from = {x: corner.x + place.x, y: corner.y + place.y};
  await mouse.move(from.x, from.y);
  await mouse.down();
  const before = await page.evaluate(() => P.stage.history.length);
  for (let k = 1; k <= 4; ++k) await mouse.move(from.x + dx * k / 4, from.y + dy * k / 4);
  await page.waitForFunction((wanted) => P.stage.history.length >= wanted, before + steps);
  return {release: () => mouse.up()};
}

/** What a click on a choice of the save menu hands to the browser: {name, bytes}. */
export async function saved(page, kind) {
  const [download] = await Promise.all([
    page.waitForEvent('download'), page.selectOption('#save', kind),
  ]);
  return {name: download.suggestedFilename(), path: await download.path()};
}

/** The text above the picture, once there is one. */
export async function message(page) {
  await page.waitForSelector('#message:not([hidden])');
  return page.textContent('#message-text');
}
