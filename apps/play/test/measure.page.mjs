// SPDX-License-Identifier: MIT
// Measuring, selecting, and labels over the picture.
import assert from 'node:assert/strict';
import {before, describe, test} from 'node:test';
import {drag, message, openExample, placeOf, seenJoint, sharedPage, settle} from './support/browser.mjs';
import {measured} from '../page/panel/measure.mjs';

describe('measure', () => {
let page;
before(async () => { page = await sharedPage(); });

const tool = (name) => page.check(`[name=tool][value=${name}]`, {force: true});
const list = () => page.$$eval('#measure-list li', (rows) => rows.map((row) => row.textContent.replace(/ ×$/, '')));
const click = async (joint) => {
  const {x, y} = await placeOf(page, joint);
  await page.mouse.click(x, y);
};

test('distances, angles and torsions are those of the textbook', () => {
  const close = (found, expected) => assert.ok(Math.abs(found - expected) < 1e-9, `${found}`);
  close(measured([[0, 0, 0], [3, 4, 0]]), 5);
  close(measured([[1, 0, 0], [0, 0, 0], [0, 2, 0]]), 90);
  close(measured([[1, 0, 0], [0, 0, 0], [0, 0, 1], [1, 0, 1]]), 0);
  close(measured([[1, 0, 0], [0, 0, 0], [0, 0, 1], [-1, 0, 1]]), 180);
  close(measured([[1, 0, 0], [0, 0, 0], [0, 0, -1], [0, 1, -1]]), -measured([[1, 0, 0], [0, 0, 0], [0, 0, -1], [0, -1, -1]]));
  close(measured([[0, 1, 0], [0, 0, 0], [1, 0, 0], [1, 0, 1]]), 90);
});

test('clicks measure; lines and values are over the picture, and follow what moves', async () => {
  await openExample(page, 'butane.sdf');
  await page.evaluate(() => P.session.again('bonds'));
  await tool('measure');
  const joints = [await seenJoint(page, 4), await seenJoint(page, 9)];  // no bar holds two hydrogens
  for (const joint of joints) await click(joint);
  const [row] = await list();
  const names = await page.evaluate((two) => two.map((joint) => P.session.model.nameOf(joint)), joints);
  const far = await page.evaluate(([a, b]) => Math.hypot(...[0, 1, 2].map((c) => P.session.positions[3 * a + c] - P.session.positions[3 * b + c])), joints);
  assert.equal(row, `${far.toFixed(2)} Å ${names.join(' – ')}`);
  await settle(page);
  assert.equal(await page.textContent('#labels text.measure'), `${far.toFixed(2)} Å`);
  assert.equal(await page.$$eval('#labels polyline', (lines) => lines.length), 1);
  assert.equal(await page.evaluate(() => P.stage.history.length), 0, 'a click of Measure pulls nothing');
  await tool('pull');
  const {release} = await drag(page, joints[0], 70, 50, {steps: 4});
  await release();
  await page.waitForFunction(() => !P.hand.busy);
  await settle(page);
  const later = (await list())[0];
  assert.notEqual(later, row);
  assert.equal(await page.textContent('#labels text.measure'), later.split(' Å')[0] + ' Å');
});

test('angles and torsions by clicks, each can be removed', async () => {
  await page.evaluate(() => { P.measure.add([0, 1, 2]); P.measure.add([0, 1, 2, 3]); });
  assert.match((await list())[1], /^[\d.]+° /);
  assert.match((await list())[2], /^-?[\d.]+° /);
  await page.click('#measure-list li:nth-child(2) button');
  assert.equal((await list()).length, 2);
  await page.click('#measure-clear');
  await settle(page);
  assert.equal(await page.$$eval('#labels *', (all) => all.length), 0);
});

test('selection by the words of --select, whole residues, labels', async () => {
  await openExample(page, 'peptide_20.pdb');
  await page.evaluate(() => { document.getElementById('select-panel').open = true; });
  await page.fill('#select-text', 'resid 3-4 and name CA');
  await page.press('#select-text', 'Enter');
  await page.waitForFunction(() => P.select.joints.size === 2);
  assert.equal(await page.textContent('#select-state'), '2 joints of 2 residues selected');
  await page.selectOption('#select-labels', 'atoms');
  await settle(page);
  const names = await page.evaluate(() => [...P.select.joints].map((joint) => P.session.model.nameOf(joint)));
  assert.deepEqual(await page.$$eval('#labels text.name', (all) => all.map((one) => one.textContent)), names);
  await page.check('#select-residues');
  await page.press('#select-text', 'Enter');
  await page.waitForFunction(() => P.select.joints.size > 2);
  await page.selectOption('#select-labels', 'residues');
  await settle(page);
  const residues = await page.$$eval('#labels text.name', (all) => all.map((one) => one.textContent));
  assert.equal(residues.length, 2);
  assert.match(residues[0], /[A-Z]{3}3$/);
  await page.uncheck('#select-residues');
});

test('what the language does not know is told, and the selection stays', async () => {
  const size = await page.evaluate(() => P.select.joints.size);
  await page.fill('#select-text', 'resid three');
  await page.press('#select-text', 'Enter');
  assert.match(await message(page), /three/);
  assert.equal(await page.evaluate(() => P.select.joints.size), size);
  await page.click('#message-close');
});

test('selection by click, pinned as a whole, marked in the picture, and none', async () => {
  await page.click('#select-none');
  await tool('select');
  const joint = await seenJoint(page, 3);
  await click(joint);
  assert.deepEqual(await page.evaluate(() => [...P.select.joints]), [joint]);
  assert.equal(await page.evaluate((j) => P.view.textures.marks.data[2 * j + 1], joint), 255);
  await page.click('#select-pin');
  assert.deepEqual(await page.evaluate(() => [...P.session.pins]), [joint]);
  await click(joint);
  assert.equal(await page.evaluate(() => P.select.joints.size), 0);
  await page.selectOption('#select-labels', 'none');
  await tool('pull');
});
});
