// SPDX-License-Identifier: MIT
// The page in Debian's Firefox by WebDriver BiDi, on a screen in memory: without any (headless) it gives
// no WebGL.
import {spawn} from 'node:child_process';
import {existsSync} from 'node:fs';
import {join} from 'node:path';
import {createInterface} from 'node:readline';
import {pathToFileURL} from 'node:url';
import {built, require} from './browser.mjs';

const BINARY = process.env.FIREFOX || '/usr/bin/firefox-esr';
const SCREEN = '/usr/bin/Xvfb';

function puppeteerFile() {
  try {
    return require.resolve('puppeteer-core');
  } catch {
    return null;
  }
}

/** What is missing for it, in words; empty if nothing is. */
export function missing() {
  const lacks = [BINARY, SCREEN].filter((file) => !existsSync(file));
  if (!puppeteerFile()) lacks.push('puppeteer-core');
  return lacks.length ? `${lacks.join(', ')} not there: apt-get install firefox-esr xvfb, ./dev play` : '';
}

async function startScreen() {
  const screen = spawn(SCREEN, ['-displayfd', '1', '-screen', '0', '1280x900x24'], {stdio: ['ignore', 'pipe', 'ignore']});
  for await (const line of createInterface({input: screen.stdout})) return {screen, display: `:${line.trim()}`};
  throw new Error(`${SCREEN} did not start`);
}

/** A page that is ready, and what ends its browser. */
export async function openFirefox(viewport = {width: 1000, height: 600}) {
  const {default: puppeteer} = await import(pathToFileURL(puppeteerFile()).href);
  const {screen, display} = await startScreen();
  const browser = await puppeteer.launch({
    browser: 'firefox', executablePath: BINARY, headless: false,
    env: {...process.env, DISPLAY: display, LIBGL_ALWAYS_SOFTWARE: '1'},
    extraPrefsFirefox: {'webgl.force-enabled': true, 'ui.prefersReducedMotion': 1},
  });
  const close = async () => { await browser.close(); screen.kill(); };
  const page = await browser.newPage();
  page.setDefaultTimeout(300000);
  await page.setViewport(viewport);
  await page.goto(pathToFileURL(join(built, 'pliant.html')).href);
  await page.evaluate(() => window.pliant.then((parts) => { window.P = parts; }));
  return {page, close};
}
