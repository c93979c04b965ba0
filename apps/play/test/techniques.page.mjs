// SPDX-License-Identifier: MIT
// Techniques that cannot are grey; a step that will not arrive is stopped, taken back and told.
import assert from 'node:assert/strict';
import {before, describe, test} from 'node:test';
import {drag, message, openExample, seenJoint, sharedPage} from './support/browser.mjs';

describe('techniques', () => {
let page;
before(async () => { page = await sharedPage(); });

const options = (id) => page.$$eval(`#${id} option`, (rows) => rows.map((row) => [row.value, row.disabled, row.textContent, row.title]));
const hash = () => page.evaluate(async () => (await P.session.ask('state', {})).hash);

test('what cannot, or is known not to arrive, is grey and says why', async () => {
  await openExample(page, 'peptide_20.pdb');
  await page.evaluate(() => P.session.again('protein'));
  const rows = await options('technique');
  const unfit = await page.evaluate(() => P.session.model.unfit);
  for (const [name, isGrey, text, title] of rows) {
    assert.equal(isGrey, name in unfit, name);
    if (isGrey) assert.ok(text.length > name.length + 8 && title.includes(name), `${name}: ${text}`);
  }
  assert.ok(rows.some(([name, isGrey]) => name === 'auto' && !isGrey));
  assert.match(rows.find(([name]) => name === 'bfs_tree')[2], /trees/);
  assert.match(rows.find(([name]) => name === 'bfs_cycle')[2], /stuck on rigid angles/);
  assert.match(rows.find(([name]) => name === 'newton')[2], /knows no limits/);
  assert.deepEqual((await options('other')).map(([, isGrey]) => isGrey), rows.map(([, isGrey]) => isGrey));
});

test('held by bonds, all but those for trees can be chosen', async () => {
  await page.evaluate(() => P.session.again('bonds'));
  const grey = (await options('technique')).filter(([, isGrey]) => isGrey).map(([name]) => name);
  assert.deepEqual(grey, ['bfs_tree', 'dfs_tree']);
});

test('a step that will not arrive is stopped, told with its worst bar, and taken back', async () => {
  await openExample(page, 'peptide_20.pdb');
  await page.evaluate(async () => {
    await P.session.again('protein');
    await P.session.change({technique: 'bfs_cycle', max_sweeps: 1e9});
    await P.session.limitSteps(1);
    P.gone = [];
    P.session.on('stopped', (step) => P.gone.push(step.stopped));
  });
  const start = await hash();
  const joint = await seenJoint(page, 2);
  await page.evaluate(async (j) => { await P.session.pull([[j, 4000, 0, 0]]); }, joint);
  assert.match(await message(page), /^bfs_cycle did not make all bars whole within 1 ms: the step was stopped after [\d,]+ sweeps and taken back\. Its worst bar then: .+ – .+, .+ % off\./);
  assert.match(await page.textContent('#out-verdict'), /^Stopped after 1 ms, taken back$/);
  assert.equal(await hash(), start);
  const [stopped] = await page.evaluate(() => P.gone);
  assert.ok(stopped.sweeps >= 20 && stopped.residual > 1e-6 && stopped.worst >= 0, JSON.stringify(stopped));
  assert.equal(await page.evaluate(() => P.stage.history.length), 0);
  assert.equal(await page.evaluate(() => P.session.strokes.length), 0);
  assert.doesNotMatch(await page.evaluate(() => P.session.forces()), /step/);
  await page.click('#message-close');
});

test('after it the next technique goes on, and undo takes its drag back alone', async () => {
  await page.evaluate(async () => {
    await P.session.change({technique: 'auto', max_sweeps: 10000});
    await P.session.limitSteps(0);
  });
  const start = await hash();
  const {release} = await drag(page, await seenJoint(page, 2), 40, 30, {steps: 2});
  await release();
  await page.waitForFunction(() => !P.hand.busy);
  assert.equal(await page.textContent('#out-verdict'), 'All bars whole');
  await page.click('#undo');
  await page.waitForFunction(() => P.stage.history.length === 0);
  assert.equal(await hash(), start);
});

test('the time is a setting, and 0 is never', async () => {
  await page.fill('#step-limit', '0');
  await page.press('#step-limit', 'Tab');
  assert.equal(await page.evaluate(() => P.session.stepLimit), 0);
  await page.evaluate(async () => {
    await P.session.change({technique: 'bfs_cycle', max_sweeps: 300});
    await P.session.pull([[2, 4000, 0, 0]]);
  });
  assert.equal(await page.textContent('#out-verdict'), 'Not converged');
  assert.match(await message(page), /^Not all bars are whole after 300 sweeps\. The worst: .+ – .+, .+ % off\.$/);
  await page.click('#message-close');
  await page.evaluate(() => P.session.limitSteps(100));
});

test('a walk that will not arrive ends, and says so', async () => {
  await openExample(page, 'peptide_20.pdb');
  await page.evaluate(async () => {
    await P.session.again('protein');
    await P.session.change({technique: 'bfs_cycle', max_sweeps: 1e9});
    await P.session.limitSteps(1);
    P.wander.toggle(true);
  });
  assert.match(await message(page), /^bfs_cycle did not make all bars whole within 1 ms/);
  await page.waitForFunction(() => !P.wander.isOn && !P.wander.busy);
  assert.equal(await page.evaluate(() => P.session.strokes.length), 0);
  await page.evaluate(() => P.session.limitSteps(100));
  await page.click('#message-close');
});
});
