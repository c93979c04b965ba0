// SPDX-License-Identifier: MIT
// What a frame costs while a joint is dragged: JavaScript of the page, and the solver in its worker.
// node apps/play/test/bench.mjs [PDB]. Trees of 10^4 and 10^5 joints by `blocks`, and copies of a
// protein beside each other, bonds by `blocks`, where a PDB file is given. Medians, ms; drawing itself
// is the graphics processor's and is not in it.
import {readFileSync} from 'node:fs';
import {openPage, quit, settle} from './browser.mjs';

const STEPS = 40;
const APART = 90;  // Angstrom between two copies

/** So many copies of the ATOM lines, each a chain of its own letter, beside each other. */
function copies(text, count) {
  const lines = text.split('\n').filter((line) => line.startsWith('ATOM'));
  const letters = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz';
  const parts = [];
  for (let k = 0; k < count; ++k) {
    const [dx, dy] = [APART * (k % 6), APART * Math.floor(k / 6)];
    for (const line of lines) {
      const x = (Number(line.slice(30, 38)) + dx).toFixed(3).padStart(8);
      const y = (Number(line.slice(38, 46)) + dy).toFixed(3).padStart(8);
      parts.push(line.slice(0, 21) + letters[k] + line.slice(22, 30) + x + y + line.slice(46));
    }
    parts.push('TER');
  }
  return `${parts.join('\n')}\nEND\n`;
}

async function measure(page, title) {
  const found = await page.evaluate(async (steps) => {
    const {session, stage, hand, view, costs} = P;
    await session.change({technique: 'blocks'});
    stage.recording = false;
    const took = [];
    const own = session.stand;
    session.stand = function stand(...words) {
      const began = performance.now();
      const reply = own.apply(this, words);
      took.push(performance.now() - began);
      return reply;
    };
    const joint = Math.floor(session.model.joints / 2);
    hand.grasp(joint, view.orbit.project(hand.positionOf(joint)));
    hand.held.target = hand.positionOf(joint).map((x, c) => x + [3, 2, 0][c] * view.unit);
    hand.held.hasMoved = true;
    costs.length = 0;
    const solver = [];
    session.on('step', (step) => solver.push(step.seconds * 1000));
    while (took.length < steps) await new Promise(requestAnimationFrame);
    hand.release();
    session.stand = own;
    const median = (list) => [...list].sort((a, b) => a - b)[Math.floor(list.length / 2)];
    return {joints: session.model.joints, bars: session.model.bars.length / 2, step: median(took),
      loop: median(costs), solver: median(solver), frames: costs.length};
  }, STEPS);
  const script = found.step + found.loop;
  console.log(`${title.padEnd(22)} ${found.joints} joints ${found.bars} bars: script ${script.toFixed(2)} ` +
    `(step ${found.step.toFixed(2)}, frame ${found.loop.toFixed(2)}), solver ${found.solver.toFixed(2)} ms`);
}

async function open(page, name, text, model) {
  await page.evaluate(([title, content, held]) =>
    P.open.openBytes(title, new TextEncoder().encode(content), held), [name, text, model]);
  await settle(page);
}

const page = await openPage({viewport: {width: 480, height: 400}});
page.setDefaultTimeout(300000);
const [pdb] = process.argv.slice(2);
const text = pdb && readFileSync(pdb, 'utf8');
for (const count of text ? [1, 3, 30] : []) {
  await open(page, 'copies.pdb', copies(text, count), 'bonds');
  await measure(page, `${count} of a protein`);
}
for (const joints of [10000, 100000]) {
  await page.evaluate((wanted) => P.session.generate({class: 'tree', joints: wanted, seed: 1}), joints);
  await measure(page, 'tree');
}
await quit();
