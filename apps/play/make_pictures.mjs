// SPDX-License-Identifier: MIT
// Pictures of the page, taken of the real one in Chromium: a hand pulls a protein about. Writes
// FOLDER/NNN.png; data/play_picture.py makes a still and an animation of them.
//   node apps/play/make_pictures.mjs FILE.pdb FOLDER
import {mkdirSync} from 'node:fs';
import {basename, join} from 'node:path';
import {openPage, placeOf, quit, settle} from './test/support/browser.mjs';

const [file, folder] = process.argv.slice(2);
const FRAMES = 40;
const REACH = 150;  // how far the pointer goes, CSS pixels

mkdirSync(folder, {recursive: true});
const page = await openPage({viewport: {width: 1100, height: 680}});
await page.setInputFiles('#file', file);
await page.waitForFunction((name) => window.P.session.fileName === name, basename(file), {timeout: 120000});
await page.evaluate(() => {
  const {quality} = P.view;
  quality.isFixed = true;  // as a graphics processor would draw it, also while it moves
  quality.use(0);
  P.hint.done();
});
await settle(page);

/** A joint that nothing hides, furthest to the right. */
const joint = await page.evaluate(() => {
  const {view, session} = P;
  const placed = Array.from({length: session.model.joints}, (_, j) => [j,
    view.orbit.project([...session.positions.subarray(3 * j, 3 * j + 3)])]);
  placed.sort(([, one], [, other]) => other.x - one.x);
  return placed.find(([j, {x, y}]) => view.pick(x, y)?.joint === j)[0];
});
const from = await placeOf(page, joint);
const shot = (number) =>
  page.screenshot({path: join(folder, `${String(number).padStart(3, '0')}.png`)});
await page.mouse.move(from.x, from.y);
await page.mouse.down();
for (let k = 0; k < FRAMES; ++k) {
  const turn = 2 * Math.PI * k / FRAMES;  // round, and back to where it began
  const before = await page.evaluate(() => P.stage.history.length);
  await page.mouse.move(from.x - REACH * (1 - Math.cos(turn)) / 2, from.y + REACH * Math.sin(turn));
  await page.waitForFunction((count) => P.stage.history.length > count, before, {timeout: 60000});
  await settle(page);
  await shot(k);
}
await page.mouse.up();
await quit();
