// SPDX-License-Identifier: MIT
// Which techniques arrive: a usual drag (0.3 Å a step, 5 steps) of three joints of each model, with each
// technique that the page lets a person choose. Ends with 1 if a step was not whole and the page did
// not stop it. node apps/play/test/techniques.mjs [--all] [FILE...]   (--all: the grey ones, too)
import {readFileSync, readdirSync} from 'node:fs';
import {basename, join} from 'node:path';
import {WasmModule} from '../page/wasm_module.mjs';
import {wasmOfBuild} from './from_python/ask_worker.mjs';

const root = new URL('../../../', import.meta.url).pathname;
const STEP = 0.3;  // Angstrom
const STEPS = 5;
const MODELS = ['bonds', 'angles', 'molecule', 'protein'];

const solver = await WasmModule.start(wasmOfBuild());
const call = (what, fields = {}, bytes) => {
  const reply = solver.call({do: what, ...fields}, bytes);
  if (!reply.ok) throw new Error(reply.error);
  return reply;
};
const facts = call('boot');

/** What can be opened: [name, () => the reply of `open`]. */
function* documents(files) {
  for (const file of files) {
    const bytes = new Uint8Array(readFileSync(file));
    for (const model of MODELS)
      yield [`${basename(file)} ${model}`, () => call('open', {name: basename(file), model}, bytes)];
  }
}

function* graphs() {
  const folder = join(root, 'data', 'mechanisms');
  for (const name of readdirSync(folder).sort())
    yield [name, () => call('open', {name}, new Uint8Array(readFileSync(join(folder, name))))];
  for (const {name} of facts.examples) yield [name, () => call('example', {name})];
  for (const {name} of facts.classes) yield [`a ${name}`, () => call('structgen', {options: {class: name, seed: 1}})];
}

/** The force that takes a joint one step along x, against its velocity, as the hand does. */
function pull(model, joint, now, before) {
  const way = [0, 1, 2].map((c) => (c === 0 ? STEP : 0) - (now[3 * joint + c] - before[3 * joint + c]));
  const mass = Number.isFinite(model.mass[joint]) ? model.mass[joint] : 12;
  return [joint, ...way.map((x) => x * mass / (100 * 0.01 * 0.01))];
}

/** Milliseconds of the processor: other work on the machine does not count. */
function cpuSince(began) {
  const {user, system} = process.cpuUsage(began);
  return (user + system) / 1000;
}

/** The slowest step of the drag and the state of the worst: whole, stopped or broken. */
function drag(open, technique, joint) {
  const model = open();
  call('settings', {technique});
  call('step_limit', {milliseconds: 100});
  let [now, before] = [model.positions, model.positions];
  const found = {slowest: 0, sweeps: 0, broken: 0, stopped: 0};
  for (let k = 0; k < STEPS; ++k) {
    const began = process.cpuUsage();
    const step = call('pull', {forces: [pull(model, joint, now, before)]});
    found.slowest = Math.max(found.slowest, cpuSince(began));
    found.sweeps = Math.max(found.sweeps, step.sweeps);
    if (step.stop === 'stopped_by_caller') found.stopped += 1;
    else if (!step.converged) found.broken += 1;
    [before, now] = [now, step.positions];
  }
  return found;
}

function look(name, open, technique) {
  const {joints} = open();
  const all = {slowest: 0, sweeps: 0, broken: 0, stopped: 0};
  for (const joint of new Set([0, joints >> 1, joints - 1])) {
    const one = drag(open, technique, joint);
    for (const field of ['slowest', 'sweeps']) all[field] = Math.max(all[field], one[field]);
    for (const field of ['broken', 'stopped']) all[field] += one[field];
  }
  return all;
}

const withAll = process.argv.includes('--all');
const given = process.argv.slice(2).filter((word) => !word.startsWith('--'));
const molecules = ['caffeine.sdf', 'peptide_20.pdb', 'alanine_dipeptide.pdb'].map((name) => join(root, 'data', 'molecules', name));
let failed = 0;
for (const [name, open] of given.length ? documents(given) : [...documents(molecules), ...graphs()]) {
  let model;
  try {
    model = open();
  } catch (error) {
    console.log(`${name}: ${error.message}`);
    continue;
  }
  if (!model.joints) continue;
  const rows = facts.techniques.map(({name: technique}) => technique);
  const grey = rows.filter((row) => model.unfit[row]?.refused || (model.unfit[row] && model.kind !== 'graph'));
  const refused = rows.filter((row) => model.unfit[row]?.refused);
  const tried = rows.filter((row) => !refused.includes(row) && (withAll || !grey.includes(row)));
  const bad = [];
  const good = [];
  for (const technique of tried) {
    const found = look(name, open, technique);
    if (!found.broken && !found.stopped && found.slowest <= 100) good.push(technique);
    else bad.push(`${technique}${grey.includes(technique) ? ' (grey)' : ''} ${found.broken} broken ${found.stopped} stopped ${found.sweeps} sweeps ${found.slowest.toFixed(0)} ms`);
    failed += found.broken;
  }
  console.log(`${name}: ${tried.length} can be chosen, ${good.length} of them arrive within 100 ms; ${grey.length} grey${bad.map((row) => `\n    ${row}`).join('')}`);
}
process.exitCode = failed ? 1 : 0;
