// SPDX-License-Identifier: MIT
// Measured distances over the picture, and how many of them hold while a hand pulls.
import assert from 'node:assert/strict';
import {before, describe, test} from 'node:test';
import {drag, openExample, placeOf, settle, sharedPage} from './support/browser.mjs';
import {offBy, scoreOf} from '../page/panel/distances.mjs';

describe('distances', () => {
let page;
before(async () => {
  page = await sharedPage();
  await openExample(page, 'peptide_20.pdb');
});

const said = () => page.textContent('#out-distances');
const kinds = () => page.$$eval('#labels polyline', (lines) => lines.map((line) => line.getAttribute('class')));

/** The ends of the helix, to be within so many Angstrom of what they are; another that holds; one of no residue. */
const ask = (more) => page.evaluate((longer) => {
  const alphas = [...P.stage.model.trace].filter((joint) => joint >= 0);
  const far = (a, b) => Math.hypot(...[0, 1, 2].map((c) => P.session.positions[3 * a + c] - P.session.positions[3 * b + c]));
  const row = (a, b, off, names = [a, b].map((joint) => P.stage.model.nameOf(joint))) => ({names, low: far(a, b) + off, high: far(a, b) + off + 1});
  const [first, last] = [alphas[0], alphas.at(-1)];
  P.distances.set({holds: 1, rows: [row(first, last, longer), row(first, alphas[4], 0), row(first, last, 0, ['A:1', 'none'])]});
  return last;
}, more);

test('off is counted from the interval, to either side', () => {
  assert.equal(offBy(5, {low: 6, high: 8}), -1);
  assert.equal(offBy(7, {low: 6, high: 8}), 0);
  assert.equal(offBy(10, {low: 6, high: 8}), 2);
  assert.equal(offBy(99, {low: 6, high: null}), 0);
  assert.equal(scoreOf([0, 3, -4, 1], 1), '2 of 4 distances hold, off by 2.5 Å r.m.s.');
});

test('lines are red where a distance is off, and the score follows the hand', async () => {
  const last = await ask(-8);
  await settle(page);
  assert.equal(await said(), '1 of 2 distances hold, off by 4.9 Å r.m.s.');
  assert.deepEqual(await kinds(), ['off', 'holds']);
  assert.equal(await page.textContent('#labels text.off'), '+7.0 Å');
  const {x} = await placeOf(page, last);
  const middle = await page.evaluate(() => document.getElementById('canvas').getBoundingClientRect().width / 2);
  const {release} = await drag(page, last, Math.sign(middle - x) * 120, -60, {steps: 12});
  await release();
  await page.waitForFunction(() => !P.hand.busy);
  await settle(page);
  assert.notEqual(await said(), '1 of 2 distances hold, off by 4.9 Å r.m.s.');
  await page.click('#undo');
  await page.waitForFunction(() => P.stage.history.length === 0);
  assert.equal(await said(), '1 of 2 distances hold, off by 4.9 Å r.m.s.');
});

test('another molecule has none of them', async () => {
  await openExample(page, 'butane.sdf');
  assert.equal(await page.isHidden('#distances'), true);
  assert.deepEqual(await kinds(), []);
  await openExample(page, 'peptide_20.pdb');
  assert.equal(await page.isHidden('#distances'), false);
  await page.evaluate(() => P.distances.set({rows: [], holds: 1}));
});
});
