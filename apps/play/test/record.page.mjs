// SPDX-License-Identifier: MIT
// Recording, replaying, undoing, saving and loading.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {before, describe, test} from 'node:test';
import {drag, message, openExample, saved, seenJoint, sharedPage} from './support/browser.mjs';

describe('record', () => {
let page;
before(async () => {
  page = await sharedPage();
  await openExample(page, 'alanine_dipeptide.pdb');
  const {release} = await drag(page, await seenJoint(page, 3), 70, -50, {steps: 10});
  await release();
  await page.waitForFunction(() => !P.hand.busy);
});

const length = () => page.evaluate(() => P.stage.frames.length);
const drawn = () => page.evaluate(() => [...P.view.textures.positions.data.slice(0, 3)]);

test('the slider shows a frame, Live the walker', async () => {
  const end = await drawn();
  await page.fill('#scrub', '0');
  assert.equal(await page.textContent('#frame'), `0 / ${await length() - 1}`);
  assert.notDeepEqual(await drawn(), end);
  await page.click('#live');
  assert.deepEqual(await drawn(), end);
});

test('what was recorded is played, at another speed', async () => {
  await page.selectOption('#speed', '4');
  await page.click('#play');
  await page.waitForFunction(() => P.stage.at === P.stage.frames.length - 1 && !P.transport.playing);
  await page.click('#live');
});

test('without Record nothing is held, and the plots go on', async () => {
  const before = await length();
  await page.click('#record');
  const {release} = await drag(page, await seenJoint(page, 3), 40, 40, {steps: 4});
  await release();
  await page.waitForFunction(() => !P.hand.busy);
  assert.equal(await length(), before);
  await page.click('#undo');
  await page.waitForFunction(() => P.session.strokes.length === 1);
  await page.click('#record');
});

test('H5MD: frames, bars and rest lengths', async () => {
  const {name, path} = await saved(page, 'h5md');
  assert.match(name, /alanine_dipeptide\.h5md$/);
  const bytes = readFileSync(path);
  assert.equal(bytes.subarray(1, 4).toString(), 'HDF');
  await page.setInputFiles('#file', {name: 'again.h5md', mimeType: '', buffer: bytes});
  await page.waitForFunction(() => P.stage.isReplay);
  const held = await page.evaluate(() => {
    const {model, frames} = P.stage;
    let worst = 0;
    for (const {positions: x} of frames.list)
      for (let b = 0; b < model.bars.length / 2; ++b) {
        const [i, j] = [3 * model.bars[2 * b], 3 * model.bars[2 * b + 1]];
        const far = Math.hypot(x[i] - x[j], x[i + 1] - x[j + 1], x[i + 2] - x[j + 2]);
        worst = Math.max(worst, Math.abs(far / model.rest[b] - 1));
      }
    return {worst, frames: frames.length, title: document.getElementById('title').textContent};
  });
  assert.ok(held.frames > 10);
  assert.ok(held.worst <= 1e-6, `${held.worst}`);
  assert.match(held.title, /again\.h5md · 22 joints/);
});

test('a trajectory from a file is played, not pulled', async () => {
  await page.click('#play');
  await page.waitForFunction(() => P.stage.at === P.stage.frames.length - 1);
  assert.equal(await page.isDisabled('#technique'), true);
  const before = page.complaints.length;
  await page.setInputFiles('#file', {name: 'no.h5md', mimeType: '', buffer: Buffer.from('\x89HDF\r\n\x1a\nno', 'latin1')});
  const damaged = 'expected an HDF5 file that can be read, found one that is damaged or cut short';
  assert.equal(await message(page), `no.h5md: ${damaged}`);
  assert.deepEqual(page.complaints.slice(before), []);
  await openExample(page, 'alanine_dipeptide.pdb');
  assert.equal(await page.isDisabled('#technique'), false);
});

test('undo takes back one drag, whole', async () => {
  const start = await page.evaluate(() => [...P.session.positions]);
  for (const dx of [50, -50]) {
    const {release} = await drag(page, await seenJoint(page, 2), dx, 30, {steps: 3});
    await release();
    await page.waitForFunction(() => !P.hand.busy);
  }
  await page.click('#undo');
  await page.waitForFunction(() => P.session.strokes.length === 1);
  await page.click('#undo');
  await page.waitForFunction(() => P.session.strokes.length === 0);
  await page.waitForFunction(
    (wanted) => P.session.positions.every((x, k) => x === wanted[k]), start);
  assert.deepEqual(await page.evaluate(() => [...P.session.positions]), start);
  assert.equal(await length(), 1);
  assert.equal(await page.isDisabled('#undo'), true);
});

test('PDB: a model a frame, columns as the format has them', async () => {
  const {release} = await drag(page, await seenJoint(page, 2), 50, 30, {steps: 3});
  await release();
  await page.waitForFunction(() => !P.hand.busy);
  const {path} = await saved(page, 'pdb');
  const lines = readFileSync(path, 'utf8').split('\n');
  assert.equal(lines.filter((line) => line.startsWith('MODEL')).length, await length());
  const atom = lines.find((line) => line.slice(12, 16) === ' CA ');
  assert.equal(atom.slice(17, 20), 'ALA');
  assert.equal(atom.slice(76, 78), ' C');
  const x = await page.evaluate((row) => P.stage.frames.at(0).positions[3 * row], Number(atom.slice(6, 11)) - 1);
  assert.equal(Number(atom.slice(30, 38)), Number(x.toFixed(3)));
});

test('PNG: the picture', async () => {
  const {path} = await saved(page, 'png');
  const bytes = readFileSync(path);
  assert.equal(bytes.subarray(1, 4).toString(), 'PNG');
  const [width, height] = [bytes.readUInt32BE(16), bytes.readUInt32BE(20)];
  const box = await page.locator('#canvas').boundingBox();
  assert.ok(width >= box.width - 1 && height >= box.height - 1);
  assert.ok(bytes.length > 5000, 'an empty picture');
});

test('the force file of the session', async () => {
  const {path} = await saved(page, 'forces');
  const text = readFileSync(path, 'utf8');
  assert.match(text, /^pliant-forces 3\nstructure [0-9a-f]{16}\njoints 22\nbars \d+\ninput model /);
});
});
