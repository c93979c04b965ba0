// SPDX-License-Identifier: MIT
// The first ten seconds: what the page says, and what it does by itself.
import assert from 'node:assert/strict';
import {join} from 'node:path';
import {after, before, describe, test} from 'node:test';
import {pathToFileURL} from 'node:url';
import {
  built, drag, message, openExample, openPage, openTab, seenJoint, settle, sharedPage,
} from './support/browser.mjs';

const SIZES = [[420, 800], [800, 600], [1400, 900]].map(([width, height]) => ({width, height}));

/** Where an element is, and which part of it the picture shares. */
const overPicture = (page, id) => page.evaluate((name) => {
  const [a, b] = [document.getElementById(name), document.getElementById('canvas')].map((x) => x.getBoundingClientRect());
  const share = (one, other) => Math.max(0, Math.min(a[other], b[other]) - Math.max(a[one], b[one]));
  return {height: a.height, bottom: a.bottom, shared: share('left', 'right') * share('top', 'bottom')};
}, id);

describe('first', () => {
test('the hint is there before any script has run, and over no part of the picture', async () => {
  for (const viewport of SIZES) {
    const page = await openTab(pathToFileURL(join(built, 'pliant.html')).href, {viewport, javaScriptEnabled: false});
    assert.equal(await page.textContent('#hint-text'), 'Drag any atom');
    const box = await page.locator('#hint-text').boundingBox();
    const canvas = await page.locator('#canvas').boundingBox();
    assert.ok(box.width > 80 && box.y >= 0 && box.y + box.height <= canvas.y, JSON.stringify({box, canvas}));
    assert.ok(box.x >= 0 && box.x + box.width <= viewport.width);
    await page.context().close();
  }
});

test('one drag, as the hint says, of any atom moves it, and the hint is gone', async () => {
  const page = await openPage({viewport: SIZES[1]});
  const words = (await page.textContent('#hint-text')).match(/^Drag any (atom|joint)$/);
  assert.ok(words && await page.isVisible('#hint'));
  const count = await page.evaluate(() => P.session.model.joints);
  const joint = await seenJoint(page, Math.floor(count / 100));
  const place = (k) => page.evaluate((j) => [...P.session.positions.subarray(3 * j, 3 * j + 3)], k);
  const start = await place(joint);
  const {release} = await drag(page, joint, 70, 50, {steps: 6});
  assert.equal(await page.isVisible('#hint'), true, 'the picture does not jump under the finger');
  await release();
  const end = await place(joint);
  assert.ok(Math.hypot(...end.map((x, c) => x - start[c])) > 0.02);
  assert.equal(await page.isVisible('#hint'), false);
  await openExample(page, 'butane.sdf');
  assert.equal(await page.isVisible('#hint'), false);
  await page.context().close();
});

describe('start scene', () => {
let page;
before(async () => { page = await openPage({viewport: {width: 480, height: 400}, reducedMotion: 'no-preference', wait: 60000}); });
after(() => page.context().close());
const moving = (where) => where.waitForFunction(() => P.stage.history.length >= 3);

test('a hand pulls an atom by steps of the solver, once, and takes them back to the bit', async () => {
  const start = await page.evaluate(() => [...P.stage.frames.at(0).positions]);
  await moving(page);
  assert.equal(await page.isVisible('#demo-hand'), true);
  const during = await page.evaluate(() => ({
    held: P.hand.held?.joint, converged: P.stage.last.converged, residual: P.stage.last.residual,
    moved: Math.max(...P.session.positions.map((x, k) => Math.abs(x - P.stage.frames.at(0).positions[k]))),
  }));
  assert.equal(during.converged, true);
  assert.ok(during.residual <= 1e-6 && during.moved > 0.01, JSON.stringify(during));
  await page.waitForFunction(() => P.demo.isOver && !P.session.strokes.length && P.stage.frames.length === 1);
  assert.equal(await page.isVisible('#demo-hand'), false);
  assert.deepEqual(await page.evaluate(() => [...P.session.positions]), start);
  assert.equal(await page.evaluate(() => P.stage.frames.length), 1);
  assert.equal(await page.isVisible('#hint'), true, 'it is no pull of the user');
  assert.equal(await page.evaluate(() => P.hand.held), null);
});

test('whatever the user does stops it at once', async () => {
  const acts = {
    key: (tab) => tab.keyboard.press('Shift'), press: (tab) => tab.mouse.click(5, 5),
    wheel: async (tab) => { await tab.mouse.move(100, 200); await tab.mouse.wheel(0, 1); },
  };
  for (const [name, act] of Object.entries(acts)) {
    const tab = await openPage({viewport: {width: 480, height: 400}, reducedMotion: 'no-preference', wait: 60000});
    await moving(tab);
    await act(tab);
    await tab.waitForFunction(() => P.demo.isOver && !P.hand.busy);
    assert.equal(await tab.evaluate(() => P.hand.held), null, name);
    const steps = await tab.evaluate(() => P.stage.history.length);
    for (let k = 0; k < 3; ++k) await settle(tab);
    assert.equal(await tab.evaluate(() => P.stage.history.length), steps, name);
    assert.equal(await tab.isVisible('#demo-hand'), false);
    await tab.context().close();
  }
});
});

test('with less motion asked for, nothing moves by itself', async () => {
  const page = await sharedPage();
  assert.equal(await page.evaluate(() => P.demo.isOver && P.demo.joint === undefined), true);
});

test('names of files, not titles of papers', async () => {
  const page = await sharedPage();
  const lines = ['TITLE     SYNTHETIC STRUCTURAL AND BIOLOGICAL STUDIES OF A VERY LONG NAME'];
  lines.push('HETATM    1  C1  EOH A   1       0.000   0.000   0.000  1.00  0.00           C',
    'HETATM    2  C2  EOH A   1       1.540   0.000   0.000  1.00  0.00           C', 'END', '');
  await page.evaluate((text) => P.open.openBytes('ethane.pdb', new TextEncoder().encode(text)), lines.join('\n'));
  assert.match(await page.textContent('#title'), /^ethane\.pdb · 2 joints/);
  assert.match(await page.getAttribute('#title', 'title'), /^SYNTHETIC/i);
  assert.equal(await page.title(), 'ethane.pdb – Pliant play');
});

test('messages never lie over the picture, long notes are folded', async () => {
  const page = await openPage({viewport: SIZES[0]});
  const tell = (text, isNote) => page.evaluate(([words, note]) => P.say(words, note), [text, isNote]);
  for (const viewport of SIZES) {
    await page.setViewportSize(viewport);
    for (const isNote of [true, false]) {
      await tell(`${'A bond was found by distance alone. '.repeat(8)}\nSecond.`, isNote);
      await settle(page);
      const {height, shared} = await overPicture(page, 'message');
      assert.equal(shared, 0);
      assert.ok(height > 20 && height < (isNote ? 60 : 0.4 * viewport.height), `${height}`);
    }
  }
  await tell('one\ntwo', true);
  assert.equal(await page.textContent('#message-more'), '2 notes');
  assert.equal(await page.getAttribute('#message-more', 'aria-expanded'), 'false');
  await page.click('#message-more');
  assert.equal(await page.getAttribute('#message-more', 'aria-expanded'), 'true');
  assert.equal(await message(page), 'one\ntwo');
  await page.click('#message-close');
  assert.equal(await page.isVisible('#message'), false);
  await page.context().close();
});
});
