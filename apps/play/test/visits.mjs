// SPDX-License-Identifier: MIT
// How many visits to bars a film of Bar by bar has: for each ordering that fits, pulls of 0.24 to 1.4 Å of
// each joint along each axis. node apps/play/test/visits.mjs [NAME MODEL]...; NAME is a file of data/ or an example.
import {existsSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {WasmModule} from '../page/wasm_module.mjs';
import {wasmOfBuild} from './from_python/ask_worker.mjs';

const root = new URL('../../../', import.meta.url).pathname;
export const PULLS = [0.24, 0.6, 1, 1.4];  // Angstrom
export const ORDERINGS = ['random', 'bfs_tree', 'dfs_tree', 'bfs_cycle', 'dfs_cycle', 'bfs_reverse', 'dfs_reverse',
  'bfs_adapt', 'bfs_random', 'input'];

export async function counter() {
  const solver = await WasmModule.start(wasmOfBuild());
  const call = (what, fields = {}, bytes) => {
    const reply = solver.call({do: what, ...fields}, bytes);
    if (!reply.ok) throw new Error(reply.error);
    return reply;
  };
  const open = (name, model) => {
    const path = ['molecules', 'mechanisms'].map((kind) => join(root, 'data', kind, name)).find(existsSync);
    return path ? call('open', {name, model}, new Uint8Array(readFileSync(path))) : call('example', {name});
  };
  /** Visits of all pulls with an ordering: {most, broken, why}. */
  return (name, model, technique) => {
    const found = {most: 0, sweeps: 0, broken: 0};
    const start = open(name, model);
    try {
      call('settings', {technique});
    } catch (error) {
      return {...found, why: error.message};
    }
    for (let joint = 0; joint < start.joints; ++joint) {
      const mass = Number.isFinite(start.mass[joint]) ? start.mass[joint] : 12;
      for (const way of PULLS)
        for (const axis of [0, 1, 2]) {
          const force = [0, 0, 0];
          force[axis] = way * mass / (100 * 0.01 * 0.01);
          const reply = call('resolution', {forces: [[joint, ...force]], pins: []});
          found.most = Math.max(found.most, reply.projections);
          found.sweeps = Math.max(found.sweeps, reply.sweeps);
          if (!reply.converged) found.broken += 1;
          call('undo', {steps: 1});
        }
    }
    return found;
  };
}

const CANDIDATES = [['butane.sdf', 'bonds'], ['ethane.xyz', 'bonds'], ['four_bar.xml', 'auto'], ['kaleidocycle.xml', 'auto'],
  ['peaucellier.xml', 'auto'], ['slider_crank.xml', 'auto'], ['benzene.sdf', 'bonds'], ['alanine_dipeptide.pdb', 'bonds'], ['caffeine.sdf', 'bonds']];

if (process.argv[1] === new URL(import.meta.url).pathname) {
  const count = await counter();
  const words = process.argv.slice(2);
  const asked = words.length ? Array.from({length: words.length / 2}, (_, k) => words.slice(2 * k, 2 * k + 2)) : CANDIDATES;
  for (const [name, model] of asked)
    for (const technique of ORDERINGS) {
      const {most, sweeps, broken, why} = count(name, model, technique);
      console.log(`${name} ${model} ${technique}: ${why ?? `${most} visits, ${sweeps} sweeps at most, ${broken} not whole`}`);
    }
}
