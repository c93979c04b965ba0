// SPDX-License-Identifier: MIT
// Force files in the page: opened, seen and repeated.
import assert from 'node:assert/strict';
import {after, before, describe, test} from 'node:test';
import {drag, message, openExample, seenJoint, sharedPage} from './support/browser.mjs';

describe('forces', () => {
let page;
before(async () => { page = await sharedPage(); });
after(() => page.evaluate(() => P.session.limitSteps(100)));

const text = (id) => page.textContent(`#${id}`);
const hash = () => page.evaluate(async () => (await P.session.ask('state', {})).hash);
const drop = (name, content) => page.evaluate(([file, words]) => P.open.openBytes(file, new TextEncoder().encode(words)), [name, content]);
const dropped = (name, content) => page.evaluate(([file, words]) => P.open.openBytes(file, new TextEncoder().encode(words)).then(() => '', (error) => error.message), [name, content]);
const ended = () => page.waitForFunction(() => P.forces.isOver && !P.forces.isPlaying);

/** A session with pulls, a pin, another technique, wandering and one drag taken back. */
async function recorded() {
  await openExample(page, 'peptide_20.pdb');
  await page.evaluate(async () => { await P.session.limitSteps(0); P.session.stepLimit = 0; });
  const joint = await seenJoint(page, 2);
  for (const [dx, dy] of [[60, 20], [-30, 50]]) {
    const {release} = await drag(page, joint, dx, dy, {steps: 3});
    await release();
    await page.waitForFunction(() => !P.hand.busy);
  }
  await page.evaluate(async (j) => {
    P.session.togglePin((j + 20) % P.session.model.joints);
    await P.session.pull([[j, 300, 0, 0]]);
    await P.session.pull([[j, 0, 900, 0]]);
    await P.session.undo();
    const {frames} = await P.session.wander(3, 1, false);
    P.session.strokes.push(frames.length);
    for (const frame of frames) P.session.stand(frame);
  }, joint);
  return page.evaluate(async () => ({forces: await P.session.forces(), steps: P.stage.history.length}));
}

let session;
test('a force file is a list, and its replay gives the bits of the session', async () => {
  session = await recorded();
  session.end = await hash();
  await openExample(page, 'peptide_20.pdb');
  await page.evaluate(() => P.session.again('bonds'));  // the file says which model it was made for
  await drop('mine.txt', session.forces);
  assert.equal(await page.evaluate(() => P.session.model.model), 'protein');
  const rows = await page.$$eval('#forces-list li', (lines) => lines.map((line) => line.textContent));
  assert.ok(rows.some((row) => row.startsWith('force ')) && rows.some((row) => row.startsWith('pin ')) && rows.some((row) => /^random push .*× 3/.test(row)), rows.join('\n'));
  assert.match(await text('forces-state'), new RegExp(`^mine.txt: step 0 of ${session.steps} steps$`));
  await page.click('#forces-step');
  await page.waitForFunction(() => P.stage.history.length === 1);
  assert.equal(await page.$$eval('#forces-list [aria-current]', (found) => found.length), 1);
  await page.click('#forces-play');
  await ended();
  assert.equal(await page.evaluate(() => P.stage.history.length), session.steps);
  assert.equal(await hash(), session.end);
  assert.deepEqual(await page.evaluate(() => [...P.session.pins].length), 1);
});

test('what was repeated is saved as the same file', async () => {
  assert.equal(await page.evaluate(() => P.session.forces()), session.forces);
});

test('after a pull of one’s own the replay is over, and can begin again', async () => {
  await page.evaluate(() => P.session.pull([[0, 100, 0, 0]]));
  assert.match(await text('forces-state'), /gone its own way/);
  assert.equal(await page.isDisabled('#forces-step'), true);
});

test('a file of pushes alone, and undo of a replayed step', async () => {
  await openExample(page, 'four_bar.xml');
  await drop('push.forces', 'pliant-forces 3\nset timestep 0.01\nset tolerance 1e-6\nset max_sweeps 1000\npush B 200 30 0\npush B 0 100 0\n');
  await page.click('#forces-play');
  await ended();
  assert.equal(await page.evaluate(() => P.stage.history.length), 2);
  await page.click('#undo');
  await page.waitForFunction(() => P.stage.history.length === 1);
});

test('files that do not fit are refused with the reason', async () => {
  assert.match(await dropped('peptide.forces', session.forces.replace(/^input.*\n/m, '')), /peptide\.forces.*327 joints, not 5|joints/);
  assert.match(await dropped('odd.forces', 'pliant-forces 3\nforce B 1 2\nstep\n'), /odd\.forces:2/);
  await openExample(page, 'peptide_20.pdb');
  assert.match(await dropped('other.forces', session.forces.replace(/^structure .*$/m, 'structure 0123456789abcdef')), /was made for another structure/);
  assert.match(await dropped('strange.forces', session.forces.replace(/^input model protein$/m, 'input model nothing')), /model nothing, which is not in the page/);
});
});
