// SPDX-License-Identifier: MIT
// Why does it not move: what holds a pull is named, lit up and cut; what is cut and added is listed,
// taken back, undone and recorded.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {before, describe, test} from 'node:test';
import {placeOf, root, saved, settle, sharedPage} from './support/browser.mjs';

describe('why', () => {
let page;
before(async () => { page = await sharedPage(); });

const HELD = 'LEU8:CG';  // of peptide_20; a hydrogen bond of its residue holds it

async function open(file, model = 'auto') {
  const data = readFileSync(join(root, 'data', 'molecules', file)).toString('base64');
  await page.evaluate(async ([name, text, held]) => {
    await P.open.openBytes(name, Uint8Array.from(atob(text), (c) => c.charCodeAt(0)), held);
  }, [file, data, model]);
  await settle(page);
}

const jointOf = (name) => page.evaluate((end) => P.session.model.names.findIndex((label) => label.endsWith(end)), name);

/** Pulls a joint by the hand, away from the middle, until the box says why it is held; the joint is let
 * go. Returns where it was to go. */
async function pullUntilHeld(joint) {
  const target = await page.evaluate((j) => {
    const {hand, view, session: {positions: x}} = P;
    const middle = [0, 1, 2].map((c) => x.reduce((sum, value, k) => sum + (k % 3 === c ? value : 0), 0) / (x.length / 3));
    const at = hand.positionOf(j);
    const way = at.map((value, c) => value - middle[c]);
    hand.grasp(j, view.orbit.project(at));
    hand.held.target = at.map((value, c) => value + 20 * way[c] / Math.hypot(...way));
    hand.held.hasMoved = true;
    return hand.held.target;
  }, joint);
  await page.waitForSelector('#why:not([hidden])');
  await release();
  return target;
}

async function release() {
  await page.evaluate(() => P.hand.release());
  await page.waitForFunction(() => !P.hand.busy);
}

/** Angstrom that a joint gets towards a place in so many steps from here, which are taken back. */
const wayIn = (joint, target, steps) => page.evaluate(async ([j, to, count]) => {
  const {session, hand} = P;
  const from = hand.positionOf(j);
  const way = to.map((x, c) => x - from[c]);
  const along = (at) => way.reduce((sum, x, c) => sum + x * (at[c] - from[c]), 0) / Math.hypot(...way);
  let best = 0;
  for (let k = 0; k < count; ++k) {
    await session.pull([hand.forceOn({joint: j, target: to})], k === 0);
    best = Math.max(best, along(hand.positionOf(j)));
  }
  await session.undo();
  return best;
}, [joint, target, steps]);

const contacts = () => page.evaluate(() => P.session.model.contacts.length / 2);

test('a joint that follows is not said to be held', async () => {
  await open('butane.sdf');
  await page.evaluate(() => {
    const at = P.view.orbit.project(P.hand.positionOf(0));
    P.hand.grasp(0, at);
    P.hand.drag({x: at.x + 30, y: at.y});
  });
  await page.waitForFunction(() => P.stage.history.length > 20);
  await release();
  assert.equal(await page.isVisible('#why'), false);
});

test('a pinned joint says so, and its pin can be taken out', async () => {
  await open('butane.sdf');
  await page.evaluate(() => P.session.togglePin(0));
  await pullUntilHeld(0);
  assert.match(await page.textContent('#why-said'), /is pinned\.$/);
  await page.click('#why-list button');
  assert.equal(await page.evaluate(() => P.session.pins.size), 0);
  assert.equal(await page.isVisible('#why'), false);
});

test('what holds is named beside the molecule, and its cut lets the joint get further', async () => {
  await open('peptide_20.pdb');
  const joint = await jointOf(HELD);
  const target = await pullUntilHeld(joint);
  const {lines, said, frees} = await page.evaluate(() => P.why.found);
  assert.ok(lines.length > 0, said);
  assert.match(said, / is (part of|at the end|held by)/);
  assert.equal(await page.evaluate(() => P.view.holders.isShown), true);
  const covered = await page.evaluate(() => {
    const [box, canvas] = ['why', 'canvas'].map((id) => document.getElementById(id).getBoundingClientRect());
    return P.why.projected().filter(({x, y}) => {
      const [left, top] = [x + canvas.left, y + canvas.top];
      return left > box.left && left < box.right && top > box.top && top < box.bottom;
    }).length;
  });
  assert.equal(covered, 0, `the box covers ${covered} joints`);
  const cuts = lines.filter(({cut}) => cut);
  assert.ok(cuts.length > 0 && frees, said);
  const held = await wayIn(joint, target, 24);
  const count = await contacts();
  await page.focus('#canvas');
  await page.keyboard.press('x');
  await page.waitForFunction((before) => P.session.model.contacts.length / 2 < before, count);
  const free = await wayIn(joint, target, 24);
  assert.ok(free > held + 0.02, `${held} Angstrom before, ${free} after`);
});

test('cuts are listed, taken back, and undone in their order', async () => {
  await open('peptide_20.pdb');
  const [count, start] = [await contacts(), await page.evaluate(() => [...P.session.positions])];
  await page.evaluate(() => P.constraints.clicked({contact: 0}));
  await page.waitForSelector('#constraints-cut:not([disabled])');
  assert.match(await page.textContent('#constraints-pair'), /(hydrogen bond|hydrophobic contact|salt bridge) .* – .*: [\d.]+ Å/);
  await page.click('#constraints-cut');
  await page.waitForFunction((all) => P.session.model.contacts.length / 2 === all - 1, count);
  assert.equal(await page.locator('#constraints-list li').count(), 1);
  await page.evaluate(() => P.session.pull([[4, 900, 40, -70]]));
  await page.click('#constraints-list button');
  await page.waitForFunction((all) => P.session.model.contacts.length / 2 === all, count);
  assert.equal(await page.locator('#constraints-list li').count(), 0);
  for (const left of [count - 1, count - 1, count]) {
    await page.click('#undo');
    await page.waitForFunction((all) => P.session.model.contacts.length / 2 === all, left);
  }
  await page.waitForFunction(() => !P.session.strokes.length);
  assert.deepEqual(await page.evaluate(() => [...P.session.positions]), start);
});

test('a contact is picked where it is drawn', async () => {
  await page.evaluate(() => P.look.setStyle('balls'));  // a cartoon leaves most contacts out
  const met = await page.evaluate(() => {
    const {view, session} = P;
    const {contacts: list} = session.model;
    for (let k = 0; k < list.length / 2; ++k) {
      const [a, b] = [list[2 * k], list[2 * k + 1]].map((joint) => view.orbit.project(P.hand.positionOf(joint)));
      for (let share = 0.3; share < 0.7; share += 0.02) {
        const at = {x: a.x + share * (b.x - a.x), y: a.y + share * (b.y - a.y)};
        if (view.pick(at.x, at.y, 5)?.contact === k) return {k, ...at};
      }
    }
    return null;
  });
  assert.ok(met, 'none could be picked');
  const box = await page.locator('#canvas').boundingBox();
  await page.mouse.click(box.x + met.x, box.y + met.y);
  await page.waitForSelector('#constraints-cut:not([disabled])');
  const [picked, ends] = await page.evaluate((k) => [P.constraints.picked, [...P.session.model.contacts.subarray(2 * k, 2 * k + 2)]], met.k);
  assert.deepEqual(picked, ends);
});

test('two joints get a bar of a given length, by the keyboard', async () => {
  await open('butane.sdf', 'bonds');
  await page.focus('#canvas');
  for (const key of ['.', 'b', '.', '.', '.', 'b']) await page.keyboard.press(key);
  await page.waitForSelector('#constraints-add:not([disabled])');
  const [a, b] = await page.evaluate(() => { document.getElementById('constraints-panel').open = true; return P.constraints.picked; });
  const bars = await page.evaluate(() => P.session.model.bars.length / 2);
  await page.fill('#constraints-length', '2.75');
  await page.press('#constraints-length', 'Tab');
  await page.keyboard.press('Enter');
  await page.waitForFunction((before) => P.session.model.bars.length / 2 === before + 1, bars);
  await page.evaluate(() => P.session.pull([]));
  const apart = await page.evaluate(([i, j]) => Math.hypot(...[0, 1, 2].map((c) => P.session.positions[3 * i + c] - P.session.positions[3 * j + c])), [a, b]);
  assert.ok(Math.abs(apart - 2.75) < 1e-5, `${apart}`);
  const forces = readFileSync((await saved(page, 'forces')).path, 'utf8');
  assert.match(forces, /^bar \S+ \S+ 2\.75$/m);
  const {parameters} = await page.evaluate(() => P.session.recorded());
  assert.match(parameters.find(([path]) => path === 'run/edits')[2], /^after step 0: bar .*, 2\.75 Angstrom$/);
});

test('an angle is freed in a model that holds it', async () => {
  await open('butane.sdf', 'angles');
  const pair = await page.evaluate(() => {
    const {model} = P.session;
    const k = model.kinds.findIndex((kind) => model.kindNames[kind] === 'angle');
    return [model.bars[2 * k], model.bars[2 * k + 1]];
  });
  const bars = await page.evaluate(() => P.session.model.bars.length / 2);
  for (const joint of pair) await page.evaluate((j) => P.constraints.pick(j), joint);
  await page.waitForSelector('#constraints-cut:not([disabled])', {state: 'attached'});
  assert.equal(await page.textContent('#constraints-cut'), 'Free the angle');
  await page.evaluate(() => { document.getElementById('constraints-panel').open = true; });
  await page.click('#constraints-cut');
  await page.waitForFunction((before) => P.session.model.bars.length / 2 === before - 1, bars);
  assert.match(await page.textContent('#constraints-list'), /^cut: angle /);
});
});
