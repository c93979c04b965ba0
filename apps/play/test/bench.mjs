// SPDX-License-Identifier: MIT
// What a frame costs while a joint is dragged: JavaScript of the page, and the solver in its worker.
// node apps/play/test/bench.mjs [PDB [JOINTS...]]. Trees of 10^4 and 10^5 joints by `blocks`, and,
// where a PDB file is given, copies of the protein beside each other: bonds by `blocks`, the model of a
// protein by `froda`. Medians, ms. `script` is all JavaScript of the page, `all` that and the solver;
// painting is the graphics processor's, and is in `shown` alone.
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {openPage, quit, root, settle} from './support/browser.mjs';

const COMMAND = process.env.PLIANT_COMMAND || join(root, '.venv', 'bin', 'pliant');
const STEPS = 40;
const [FRAME, PLOTS] = [1000 / 60, 90];  // ms between frames of a usual screen, and between plots
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

/** What the page does for one frame after the other, ms each: `step` takes a step's reply, `frame` is
 * the rest of JavaScript, in which `draw` gives the picture to the driver and `plots` are drawn, each
 * 90 ms: here, where painting takes longer, with each frame; `solver` is the call in the
 * worker, copies included; `shown` is from one frame of the screen to the next, painting included. */
function drag(page) {
  return page.evaluate(async (steps) => {
    const {session, stage, hand, view, costs} = P;
    stage.recording = false;
    const took = {step: [], draw: [], plots: [], solver: [], shown: []};
    const timed = (object, name, list) => {
      const own = object[name];
      object[name] = function timedOnly(...words) {
        const began = performance.now();
        const result = own.apply(this, words);
        list.push(performance.now() - began);
        return result;
      };
      return () => { object[name] = own; };
    };
    const {client} = session;
    const ask = client.ask;
    client.ask = async function timedAsk(what, request, transfer) {
      const reply = await ask.call(this, what, {...request, timed: true}, transfer);
      if (what === 'pull') took.solver.push(reply.took);
      return reply;
    };
    const undo = [timed(session, 'stand', took.step), timed(view, 'frame', took.draw),
      timed(P.plots, 'tick', took.plots), () => { client.ask = ask; }];
    const joint = Math.floor(session.model.joints / 2);
    hand.grasp(joint, view.orbit.project(hand.positionOf(joint)));
    hand.held.target = hand.positionOf(joint).map((x, c) => x + [3, 2, 0][c] * view.unit);
    hand.held.hasMoved = true;
    costs.length = 0;
    let last = null;
    while (took.step.length < steps) {
      const now = await new Promise(requestAnimationFrame);
      if (last !== null) took.shown.push(now - last);
      last = now;
    }
    hand.release();
    for (const back of undo) back();
    const middle = (list) => [...list].sort((x, y) => x - y)[Math.floor(list.length / 2)] ?? 0;
    const medians = Object.fromEntries(Object.entries({...took, frame: costs}).map(([name, list]) => [name, middle(list)]));
    return {joints: session.model.joints, bars: session.model.bars.length / 2, residual: stage.last.residual, ...medians};
  }, STEPS);
}

async function measure(page, title, technique) {
  await page.evaluate((wanted) => P.session.change({technique: wanted}), technique);
  const found = await drag(page);
  const {step, frame, draw, plots, solver, shown} = found;
  const rest = frame - plots - draw;
  const script = step + frame - plots + plots * FRAME / PLOTS;
  const cell = (value) => value.toFixed(1).padStart(8);
  console.log(`${title.padEnd(24)}${technique.padEnd(8)}${String(found.joints).padStart(7)}${String(found.bars).padStart(8)}` +
    [script, step, rest, draw, plots, solver, script + solver, shown].map(cell).join(''));
}

/** Drawing without a graphics processor: a picture of 1280 x 720 and a pixel read back, ms, the least
 * and the median of 24, at each level of detail. The pictures of `frame` above are drawn by the same. */
async function paint(page, title) {
  const rows = await page.evaluate(async (levels) => {
    const {view, session} = P;
    const {quality, renderer} = view;
    const gl = renderer.gl;
    view.resize(1280, 720, 1);
    quality.isFixed = true;
    const found = [];
    for (let level = 0; level < levels; ++level) {
      quality.use(level);
      const took = [];
      for (let k = 0; k < 24; ++k) {
        const began = performance.now();
        view.setPositions(session.positions);
        view.frame();
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
        took.push(performance.now() - began);
        await new Promise((done) => setTimeout(done, 20));
      }
      took.sort((a, b) => a - b);
      found.push([level, gl.drawingBufferWidth, gl.drawingBufferHeight, took[0], took[12]]);
    }
    quality.isFixed = false;
    return found;
  }, 6);
  for (const [level, width, height, least, median] of rows)
    console.log(`  drawn, ${title}, level ${level}, ${width} x ${height}: least ${least.toFixed(1)}, median ${median.toFixed(1)}`);
}

async function open(page, name, text, model) {
  await page.evaluate(([title, content, held]) =>
    P.open.openBytes(title, new TextEncoder().encode(content), held), [name, text, model]);
  await settle(page);
}

const page = await openPage({viewport: {width: 480, height: 400}});
page.setDefaultTimeout(600000);
const [pdb, ...sizes] = process.argv.slice(2);
const text = pdb && readFileSync(pdb, 'utf8');
const isAsked = (joints) => !sizes.length || sizes.includes(String(joints));
console.log(`${''.padEnd(32)} joints    bars  script    step    rest    draw   plots  solver     all   shown`);
for (const [count, joints] of text ? [[1, 3341], [3, 10000], [30, 100000]] : []) {
  if (!isAsked(joints)) continue;
  await open(page, 'copies.pdb', copies(text, count), 'bonds');
  await measure(page, `bonds of ${count} protein${count > 1 ? 's' : ''}`, 'blocks');
  await paint(page, await page.evaluate(() => P.view.style));
  await open(page, 'copies.pdb', copies(text, count), 'protein');
  await measure(page, `model of ${count} protein${count > 1 ? 's' : ''}`, 'froda');
}
for (const joints of [10000, 100000].filter(isAsked)) {
  const file = `${mkdtempSync('/tmp/pliant-bench-')}/tree.xml`;
  execFileSync(COMMAND, ['structgen', 'tree', '--joints', joints, '--seed', 1, '-o', file].map(String));
  await page.setInputFiles('#file', file);
  await page.waitForFunction((wanted) => P.session.model?.joints === wanted, joints);
  await measure(page, 'tree', 'blocks');
}
await quit();
