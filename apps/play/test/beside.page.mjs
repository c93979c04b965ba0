// SPDX-License-Identifier: MIT
// Two techniques side by side, in step: counts, who is whole first, how far apart they end.
import assert from 'node:assert/strict';
import {before, describe, test} from 'node:test';
import {drag, openExample, seenJoint, sharedPage, settle} from './support/browser.mjs';

describe('beside', () => {
let page;
before(async () => { page = await sharedPage(); });

const text = (id) => page.textContent(`#${id}`);
const totals = () => page.evaluate(() => P.beside.totals.map((total) => ({...total})));
const right = () => page.evaluate(() => [...P.beside.positions]);
const idle = () => page.evaluate(() => P.session.queue.then(() => new Promise((done) => setTimeout(done, 0))));

async function opened(technique = 'bfs_cycle') {
  await openExample(page, 'kaleidocycle.xml');
  await page.evaluate(async (wanted) => {
    P.session.stepLimit = 0;
    await P.session.limitSteps(0);
    await P.session.change({technique: wanted});
    for (const box of document.querySelectorAll('details')) box.open ||= box.textContent.startsWith('Compare');
  }, technique);
}

test('each next push is made by both, and the counts are those of each technique alone', async () => {
  await opened();
  const joint = await seenJoint(page, 1);
  const first = await drag(page, joint, 50, 30, {steps: 2});
  await first.release();
  await page.waitForFunction(() => !P.hand.busy);
  await page.selectOption('#other', 'dfs_reverse');
  await page.click('#compare');
  await page.waitForFunction(() => P.view.split);
  const {release} = await drag(page, joint, 40, -30, {steps: 4});
  await release();
  await page.waitForFunction(() => !P.hand.busy);
  await idle();
  assert.equal(await page.evaluate(() => P.view.split), true);
  const [own, other] = await totals();
  assert.ok(own.steps >= 5, `${own.steps}`);
  assert.equal(own.steps, other.steps);
  assert.match(await text('pane-left'), new RegExp(`^bfs_cycle: ${own.sweeps.toLocaleString('en')} sweeps?, `));
  assert.match(await text('pane-right'), new RegExp(`^dfs_reverse: ${other.sweeps.toLocaleString('en')} sweeps?, `));
  assert.match(await text('pane-difference'), /^Apart by .+ Å \(RMS\), at most .+ Å at /);
  const end = await right();
  const alone = await page.evaluate(async () => {
    const forces = P.stage.frames.list.slice(1).map((frame) => [frame.root, ...frame.force]);
    const last = forces.slice(-P.beside.totals[1].steps);
    const before = forces.slice(0, -last.length);
    await P.open.openExample('kaleidocycle.xml');
    await P.session.change({technique: 'bfs_cycle'});
    for (const force of before) await P.session.pull([force]);
    await P.session.change({technique: 'dfs_reverse'});
    for (const force of last) await P.session.pull([force]);
    return [...P.session.positions];
  });
  assert.deepEqual(alone, end);
});

test('labels are seen: nothing lies over them', async () => {
  await opened();
  await page.evaluate(() => P.session.pull([[0, 4000, 0, 0]]));
  await page.click('#compare');
  await page.waitForFunction(() => P.view.split);
  await page.evaluate(() => { document.getElementById('said').textContent = 'joint 7, pinned'; });
  const boxes = await page.evaluate(() => ['pane-left', 'pane-right', 'pane-difference', 'said', 'tools', 'readout'].map((id) => {
    const {left, right: end, top, bottom} = document.getElementById(id).getBoundingClientRect();
    return [id, left, end, top, bottom];
  }));
  for (const one of boxes.slice(0, 3))
    for (const other of boxes.slice(3))
      assert.ok(one[2] <= other[1] || one[1] >= other[2] || one[4] <= other[3] || one[3] >= other[4], `${one} ${other}`);
  await page.uncheck('#split');
  await idle();
  assert.equal(await page.evaluate(() => P.view.split), false);
});

test('both films run together, visit by visit', async () => {
  await opened('bfs_cycle');
  await page.selectOption('#other', 'random');
  await page.check('#split');
  await page.waitForFunction(() => P.view.split);
  assert.equal(await text('pane-difference'), 'Both stand alike');
  await page.evaluate(async () => {
    for (const box of document.querySelectorAll('details')) box.open ||= box.textContent.startsWith('Bar by bar');
    document.getElementById('resolution').click();
    document.getElementById('resolution-speed').value = 0;
    await P.hand.onPush([[0, 4000, 2000, 0]]);
    P.resolution.pause(true);
    P.resolution.goTo(7);
  });
  assert.deepEqual(await page.evaluate(() => P.resolution.films.map((film) => film.at)), [7, 7]);
  assert.match(await text('pane-left'), /^bfs_cycle: visit 7, sweep 1, \d+ bars? broken$/);
  assert.match(await text('pane-right'), /^random: visit 7, sweep 1, \d+ bars? broken$/);
  const counts = await page.evaluate(() => P.resolution.films.map((film) => film.count));
  await page.evaluate((visit) => P.resolution.goTo(visit), Math.min(...counts));
  const firstOver = counts[0] <= counts[1] ? 'pane-left' : 'pane-right';
  assert.match(await text(firstOver), /: whole after [\d,]+ visits, first$/);
  await page.evaluate(() => P.resolution.finish());
  await idle();
  const [own, other] = await totals();
  assert.deepEqual([own.projections, other.projections], counts);
  assert.equal(own.steps, 1);
  await page.evaluate(() => document.getElementById('resolution').click());
});

test('undo takes the right pane along', async () => {
  await page.click('#undo');
  await page.waitForFunction(() => P.beside.totals[0].steps === 0);
  await settle(page);
  assert.deepEqual(await right(), await page.evaluate(() => [...P.session.positions]));
  await page.uncheck('#split');
  await page.evaluate(async () => { P.session.stepLimit = 100; await P.session.limitSteps(100); });
});
});
