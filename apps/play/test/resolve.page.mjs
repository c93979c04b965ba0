// SPDX-License-Identifier: MIT
// Techniques and settings; the same push again; bar by bar; wandering.
import assert from 'node:assert/strict';
import {before, describe, test} from 'node:test';
import {drag, message, openExample, placeOf, seenJoint, sharedPage, settle} from './support/browser.mjs';

describe('resolve', () => {
let page;
before(async () => { page = await sharedPage(); });

const setting = (name) => page.evaluate((field) => P.session.settings[field], name);
const show = (title) => page.evaluate((text) => {
  for (const box of document.querySelectorAll('details')) box.open ||= box.textContent.startsWith(text);
}, title);

async function pushed(name, technique = 'bfs_cycle') {
  await openExample(page, name);
  await page.selectOption('#technique', technique);
  await page.waitForFunction((wanted) => P.session.settings.technique === wanted, technique);
  const {release} = await drag(page, await seenJoint(page, 1), 60, 40, {steps: 2});
  await release();
  await page.waitForFunction(() => !P.hand.busy);
}

test('settings are at once in force', async () => {
  await openExample(page, 'butane.sdf');
  await page.evaluate(() => P.session.again('bonds'));
  await page.selectOption('#technique', 'newton');
  await page.waitForFunction(() => P.session.settings.technique === 'newton');
  assert.match(await page.textContent('#technique-title'), /nearest whole positions/);
  assert.equal(await page.isDisabled('#weighting'), true);
  for (const [id, field, value] of [['tolerance', 'tolerance', 1e-4], ['max-sweeps', 'max_sweeps', 50], ['timestep', 'timestep', 0.02]]) {
    await page.fill(`#${id}`, String(value));
    await page.press(`#${id}`, 'Tab');
    await page.waitForFunction(([name, wanted]) => P.session.settings[name] === wanted, [field, value]);
  }
  const {release} = await drag(page, await seenJoint(page, 2), 60, 40, {steps: 2});
  await release();
  assert.ok(await page.evaluate(() => P.stage.last.residual) <= 1e-4);
});

test('a setting that cannot be is told, and the one before stays', async () => {
  await page.fill('#tolerance', 'small');
  await page.press('#tolerance', 'Tab');
  assert.equal(await message(page), 'tolerance: expected a number, found "small"');
  assert.equal(await page.inputValue('#tolerance'), '1e-4');
  await page.fill('#max-sweeps', '0');
  await page.press('#max-sweeps', 'Tab');
  await page.waitForFunction(() => document.getElementById('message-text').textContent.includes('max'));
  assert.equal(await setting('max_sweeps'), 50);
});

test('a step that does not converge is told', async () => {
  await openExample(page, 'peptide_20.pdb');
  await page.evaluate(() => P.session.again('bonds'));
  await page.selectOption('#technique', 'bfs_cycle');
  await page.fill('#max-sweeps', '1');
  await page.press('#max-sweeps', 'Tab');
  await page.waitForFunction(() => P.session.settings.max_sweeps === 1);
  const {release} = await drag(page, await seenJoint(page, 2), 60, 40, {steps: 1});
  await release();
  await page.waitForFunction(() => document.getElementById('out-verdict').textContent === 'Not converged');
});

test('the last push again, with another technique', async () => {
  await pushed('kaleidocycle.xml');
  await show('Compare');
  const before = await page.evaluate(() => [...P.session.positions]);
  await page.selectOption('#other', 'newton');
  await page.click('#compare');
  await page.waitForFunction(() => document.querySelectorAll('#compared tbody tr').length === 2);
  const cells = await page.$$eval('#compared tbody tr', (rows) => rows.map((row) => [...row.cells].map((cell) => cell.textContent)));
  assert.deepEqual(cells.map((row) => row[0]), ['bfs_cycle (done)', 'newton']);
  assert.ok(Number(cells[0][1]) >= 1 && Number(cells[1][1]) >= 1);
  assert.deepEqual(await page.evaluate(() => [...P.session.positions]), before);
});

test('with all techniques: what one cannot do is said', async () => {
  await page.click('#compare-all');
  const rows = await page.evaluate(() => P.facts.techniques.length);
  await page.waitForFunction((count) => document.querySelectorAll('#compared tbody tr').length === count, rows);
  const tree = await page.$$eval('#compared tbody tr', (lines) => lines.map((line) => line.textContent).find((text) => text.startsWith('bfs_tree')));
  assert.match(tree, /cannot/);
});

test('bar by bar: the bar in hand is lit, and the walker ends where a pull would leave it', async () => {
  await openExample(page, 'kaleidocycle.xml');
  await page.selectOption('#technique', 'bfs_cycle');
  await page.waitForFunction(() => P.session.settings.technique === 'bfs_cycle');
  await show('Bar by bar');
  await page.check('#resolution');
  const joint = await seenJoint(page, 1);
  const from = await placeOf(page, joint);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 50, from.y + 30, {steps: 2});
  await page.mouse.up();
  await page.waitForFunction(() => P.resolution.film?.at > 3);
  const lit = await page.evaluate(() => ({bar: P.view.uniforms.litBar.value, ends: P.view.uniforms.lit.value}));
  assert.ok(lit.bar >= 0 && lit.ends[1] >= 0 && lit.ends[2] >= 0, JSON.stringify(lit));
  const push = await page.evaluate(() => P.resolution.film.reply.forces);
  await page.click('#resolution-skip');
  await page.waitForFunction(() => !P.resolution.film);
  const end = await page.evaluate(() => [...P.session.positions]);
  await page.uncheck('#resolution');
  await page.evaluate(async (forces) => {
    await P.open.openExample('kaleidocycle.xml');
    await P.session.change({technique: 'bfs_cycle'});
    await P.session.pull(forces);
  }, push);
  assert.deepEqual(await page.evaluate(() => [...P.session.positions]), end);
});

test('bar by bar: what does not go so is said', async () => {
  await openExample(page, 'kaleidocycle.xml');
  await page.selectOption('#technique', 'newton');
  await page.waitForFunction(() => P.session.settings.technique === 'newton');
  await page.check('#resolution');
  await page.evaluate(() => P.hand.onPush([[0, 100, 0, 0]]));
  assert.match(await message(page), /newton|bar by bar/);
  await page.uncheck('#resolution');
  await page.click('#message-close');
});

test('it wanders by itself, and stops', async () => {
  await openExample(page, 'butane.sdf');
  await show('Wander');
  await page.click('#wander');
  await page.waitForFunction(() => P.stage.history.length > 5);
  await page.click('#wander');
  await page.waitForFunction(() => !P.wander.busy);
  const steps = await page.evaluate(() => P.stage.history.length);
  await settle(page);
  assert.equal(await page.evaluate(() => P.stage.history.length), steps);
  await page.click('#undo');
  await page.waitForFunction(() => P.stage.history.length === 0);
});

test('several walkers lie over each other', async () => {
  await page.fill('#walkers', '4');
  await page.click('#wander');
  await page.waitForFunction(() => {
    const {data} = P.view.textures.positions;
    const {joints} = P.stage.model;
    return P.view.walkers === 4 && data[4 * joints] !== data[8 * joints];
  });
  await page.click('#wander');
  assert.equal(await page.evaluate(() => P.view.walkers), 1);
});
});
