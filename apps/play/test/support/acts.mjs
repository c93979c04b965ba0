// SPDX-License-Identifier: MIT
// What a person does with the page, one act after the other: the same in each browser. A page is
// Playwright's or Puppeteer's; nothing is used here that one of them has not.
import assert from 'node:assert/strict';
import {placeOf, seenJoint, settle} from './browser.mjs';

const steps = (page) => page.evaluate(() => P.stage.history.length);
const positions = (page) => page.evaluate(() => [...P.session.positions]);
const text = (page, id) => page.evaluate((name) => document.getElementById(name).textContent, id);

/** From the middle of a joint by so many pixels, until so many steps were made. */
async function pulled(page, joint, dx, dy, wanted = 4) {
  const {x, y} = await placeOf(page, joint);
  const before = await steps(page);
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let k = 1; k <= 4; ++k) await page.mouse.move(x + dx * k / 4, y + dy * k / 4);
  await page.waitForFunction((least) => P.stage.history.length >= least, {}, before + wanted);
  await page.mouse.up();
  await page.waitForFunction(() => !P.hand.held && !P.hand.busy);
}

async function pressed(page, ...keys) {
  for (const key of keys.slice(0, -1)) await page.keyboard.down(key);
  await page.keyboard.press(keys.at(-1));
  for (const key of keys.slice(0, -1).reverse()) await page.keyboard.up(key);
}

/** What the page hands to the browser as a file: its name and its text. */
function savedText(page, kind) {
  return page.evaluate((wanted) => new Promise((done) => {
    const {createObjectURL} = URL;
    const {click} = HTMLAnchorElement.prototype;
    let blob = null;
    URL.createObjectURL = (made) => createObjectURL.call(URL, blob = made);
    HTMLAnchorElement.prototype.click = async function take() {
      [URL.createObjectURL, HTMLAnchorElement.prototype.click] = [createObjectURL, click];
      done([this.download, await blob.text()]);
    };
    const menu = document.getElementById('save');
    menu.value = wanted;
    menu.dispatchEvent(new Event('change'));
  }), kind);
}

export const ACTS = {
  async 'opens with the start molecule and the hint'(page) {
    assert.match(await text(page, 'title'), /^three_helices\.pdb · \d+ joints/);
    assert.equal(await text(page, 'hint-text'), 'Drag any atom');
  },

  async 'a drag pulls an atom, the bars stay whole'(page) {
    await page.evaluate(() => P.open.openExample('alanine_dipeptide.pdb'));
    await settle(page);
    const start = await positions(page);
    await pulled(page, await seenJoint(page, 2), 60, -40);
    assert.notDeepEqual(await positions(page), start);
    assert.ok(await page.evaluate(() => P.stage.last.residual) <= 1e-6);
    assert.equal(await page.evaluate(() => document.getElementById('hint').hidden), true);
  },

  async 'undo takes it back to the bit'(page) {
    await page.click('#undo');
    await page.waitForFunction(() => P.stage.history.length === 0);
    assert.deepEqual(await positions(page), await page.evaluate(() => [...P.stage.frames.at(0).positions]));
  },

  async 'a pinned atom stays'(page) {
    const joint = await seenJoint(page, 1);
    const {x, y} = await placeOf(page, joint);
    await page.keyboard.down('Control');
    await page.mouse.click(x, y);
    await page.keyboard.up('Control');
    assert.deepEqual(await page.evaluate(() => [...P.session.pins]), [joint]);
    const was = (await positions(page)).slice(3 * joint, 3 * joint + 3);
    await pulled(page, await seenJoint(page, 4), 50, 30);
    assert.deepEqual((await positions(page)).slice(3 * joint, 3 * joint + 3), was);
  },

  async 'the recording is played'(page) {
    const frames = await page.evaluate(() => P.stage.frames.length);
    assert.ok(frames >= 5);
    await page.click('#play');
    await page.waitForFunction((last) => P.stage.at === last && !P.transport.playing, {}, frames - 1);
    await page.click('#live');
  },

  async 'is saved as PDB and as a force file'(page) {
    const frames = await page.evaluate(() => P.stage.frames.length);
    const [name, pdb] = await savedText(page, 'pdb');
    assert.equal(name, 'alanine_dipeptide.pdb');
    assert.equal(pdb.match(/^MODEL /gm).length, frames);
    const [, forces] = await savedText(page, 'forces');
    assert.match(forces, /pliant-forces/);
  },

  async 'keys choose, pull, pin, undo and turn'(page) {
    await page.evaluate(() => document.getElementById('canvas').focus());
    await pressed(page, '.');
    assert.notEqual(await text(page, 'said'), '');
    const before = await steps(page);
    await pressed(page, 'Shift', 'ArrowRight');
    await page.waitForFunction((count) => P.stage.history.length === count + 1, {}, before);
    await pressed(page, 'z');
    await page.waitForFunction((count) => P.stage.history.length === count, {}, before);
    const turn = await page.evaluate(() => P.view.orbit.axes.flat());
    await pressed(page, 'ArrowLeft');
    assert.notDeepEqual(await page.evaluate(() => P.view.orbit.axes.flat()), turn);
    const pins = await page.evaluate(() => P.session.pins.size);
    await pressed(page, 'p');
    assert.notEqual(await page.evaluate(() => P.session.pins.size), pins);
  },

  async 'dark and light'(page) {
    const theme = () => page.evaluate(() => document.documentElement.dataset.theme);
    const was = await theme();
    await pressed(page, 't');
    assert.notEqual(await theme(), was);
    await page.click('#theme');
    assert.equal(await theme(), was);
  },
};
