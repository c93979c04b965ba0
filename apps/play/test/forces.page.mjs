// SPDX-License-Identifier: MIT
// Force files and ordering files in the page: opened, seen, repeated, and repeated by other techniques.
import assert from 'node:assert/strict';
import {before, describe, test} from 'node:test';
import {drag, message, openExample, seenJoint, sharedPage} from './support/browser.mjs';

describe('forces', () => {
let page;
before(async () => { page = await sharedPage(); });

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

test('repeated with another technique it is counted beside the first', async () => {
  await openExample(page, 'kaleidocycle.xml');
  const forces = await page.evaluate(async () => {
    await P.session.change({technique: 'bfs_cycle'});
    for (let k = 0; k < 6; ++k) await P.session.pull([[k, 400, -200, 100]]);
    return P.session.forces();
  });
  const end = await hash();
  await drop('push.forces', forces);
  await page.click('#forces-play');
  await ended();
  assert.equal(await hash(), end);
  await page.selectOption('#forces-other', 'dfs_cycle');
  await page.click('#forces-with');
  await page.waitForFunction(() => P.forces.runs.length === 2);
  const rows = await page.$$eval('#forces-compared tbody tr', (lines) => lines.map((line) => [...line.cells].map((cell) => cell.textContent)));
  assert.deepEqual(rows.map((row) => row.slice(0, 2)), [['as the file says', '6'], ['dfs_cycle', '6']]);
  assert.ok(rows.every((row) => Number(row[2].replace(',', '')) > 6 && row[4] === '0'), JSON.stringify(rows));
  assert.ok(Number(rows[1][5]) > 0);
  assert.notEqual(await hash(), end);
});

test('and side by side, in step', async () => {
  await page.click('#forces-beside');
  await page.waitForFunction(() => P.forces.runs.length === 3);
  assert.equal(await page.evaluate(() => P.view.split), true);
  const totals = await page.evaluate(() => P.beside.totals.map((total) => [total.steps, total.sweeps]));
  const sums = await page.evaluate(() => P.forces.runs.map((run) => [run.steps, run.sweeps]));
  assert.deepEqual(totals, [sums[0], sums[1]]);
  await page.evaluate(() => P.beside.end());
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

test('an ordering file is a list, is shown bar by bar, and is what input visits', async () => {
  await openExample(page, 'four_bar.xml');
  const lines = ['bar O A tree', 'bar A B tree', 'bar B Q tree', 'bar B C tree', 'bar A C non_tree'];
  await drop('mine.ordering', `pliant-ordering 1\n${lines.join('\n')}\n`);
  assert.equal(await page.inputValue('#technique'), 'input');
  assert.deepEqual(await page.$$eval('#order-list li', (rows) => rows.map((row) => row.textContent)),
    ['O → A', 'A → B', 'B → Q', 'B → C', 'A → C (closes a cycle)']);
  await page.fill('#order-at', '3');
  assert.match(await text('said'), /^visit 3: /);
  const bars = await page.evaluate(async () => {
    const reply = await P.session.ask('resolution', {forces: [[2, 500, 300, 0]], pins: []});
    const {model} = P.session;
    return Array.from({length: 5}, (_, k) => [1, 2].map((end) => model.nameOf(reply.events[4 * k + end])).join(' '));
  });
  assert.deepEqual(bars, ['O A', 'A B', 'B Q', 'B C', 'A C']);
  assert.match(await dropped('bad.ordering', 'pliant-ordering 1\nbar O A tree\n'), /bad\.ordering/);
});

test('the order of a technique is shown, and saved as a file that is read again', async () => {
  await page.evaluate(() => P.session.change({technique: 'dfs_cycle'}));
  await page.click('#order-of');
  await page.waitForFunction(() => document.getElementById('order-state').textContent.includes('dfs_cycle'));
  const rows = await page.$$eval('#order-list li', (found) => found.map((row) => row.textContent));
  const words = await page.evaluate(() => P.order.text);
  await drop('again.ordering', words);
  assert.deepEqual(await page.$$eval('#order-list li', (found) => found.map((row) => row.textContent)), rows);
  await page.evaluate(() => P.session.change({technique: 'newton'}));
  await page.click('#order-of');
  assert.match(await message(page), /^newton has no order of bars/);
  await page.evaluate(async () => { P.session.stepLimit = 100; await P.session.limitSteps(100); });
});
});
