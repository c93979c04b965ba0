// SPDX-License-Identifier: MIT
// What the page reads of an HDF5 file, and what it makes of damaged copies of it, without a page.
//   node apps/play/test/from_python/hdf5_values.mjs values FILE    all groups and datasets, as JSON
//   node apps/play/test/from_python/hdf5_values.mjs damage FILE N  of N copies: what their errors were called
//   node apps/play/test/from_python/hdf5_values.mjs write FILE N   writes a trajectory of N frames
import {createHash} from 'node:crypto';
import {readFileSync, writeFileSync} from 'node:fs';
import {readDatasets, readTrajectory} from '../../page/record/hdf5/h5md_read.mjs';
import {h5mdFile} from '../../page/record/hdf5/h5md_write.mjs';
import {Hdf5File} from '../../page/record/hdf5/read/file.mjs';

const sha1 = (array) =>
  createHash('sha1').update(new Uint8Array(array.buffer, array.byteOffset, array.byteLength)).digest('hex');
const plain = (value) => {
  if (typeof value === 'bigint') return Number(value);
  return ArrayBuffer.isView(value) ? Array.from(value, Number) : value;
};

async function described(item) {
  const attributes = Object.fromEntries(item.attributeNames().map((name) => [name, plain(item.attribute(name))]));
  if (item.kind !== 'dataset') return {names: item.names?.() ?? [], attributes};
  const data = await item.read();
  return {shape: item.shape, attributes, data: Array.isArray(data) ? data : sha1(data)};
}

async function values(bytes) {
  const file = new Hdf5File(bytes);
  const found = {};
  const walk = async (path) => {
    found[path] = await described(file.get(path));
    for (const name of found[path].names ?? []) await walk(`${path === '/' ? '' : path}/${name}`);
  };
  await walk('/');
  return found;
}

/** Always the same, so that a failure can be looked at. */
function* numbers() {
  for (let state = 7; ;) yield (state = (state * 1103515245 + 12345) % 2147483648) / 2147483648;
}

function damagedCopy(bytes, k, random) {
  const place = (power) => Math.floor(random.next().value ** power * bytes.length);
  if (k % 4 === 0) return bytes.slice(0, place(1));
  const copy = bytes.slice();
  for (let n = 0; n < 3; ++n) copy[place(k % 2 ? 4 : 1)] = [0, 255, 1 << n, place(1)][(k + n) % 4];
  return copy;
}

async function damage(bytes, count) {
  const random = numbers();
  const told = {};
  const paths = ['chunks/gzip', 'chunks/fixed', 'chunks/two', 'many', 'types/text', 'particles/trajectory/position/value'];
  for (let k = 0; k < count; ++k) {
    const copy = damagedCopy(bytes, k, random);
    for (const read of [() => readTrajectory(copy), () => readDatasets(copy, paths)]) {
      const name = await read().then(() => 'fine', (error) => error.constructor.name);
      told[name] = (told[name] ?? 0) + 1;
    }
  }
  return told;
}

function write(name, count) {
  const joints = 5;
  const frames = Array.from({length: count}, (_, step) =>
    ({step, positions: Float64Array.from({length: 3 * joints}, (_, k) => step + k / 100)}));
  const parameters = Array.from({length: 300}, (_, k) => [`many/p${k}`, 'int64', k - 5]);
  parameters.push(['run/text', 'text', 'Å, and more'], ['run/none', 'text', ''], ['run/real', 'float64', 0.1], ['run/is', 'bool', true]);
  const recorded = {barsOnly: true, parameters, texts: {chain: ['A', 'Å']}, integers: {number: [1, -2]},
    bondOrigins: new Uint8Array(1), bondOrders: Uint8Array.of(2)};
  writeFileSync(name, h5mdFile({
    version: '1', frames, timestep: 0.5, joints, labels: ['a', 'b', 'c', 'd', 'e'], recorded, mass: null, rest: Float64Array.of(1.5),
    elements: new Uint8Array(joints), pinned: new Uint8Array(joints), residue: [0, 0, 0, 1, 1],
    bars: Int32Array.of(0, 1), bonds: Int32Array.of(0, 1),
  }));
  return {};
}

const [what, name, count] = process.argv.slice(2);
const bytes = what === 'write' ? null : new Uint8Array(readFileSync(name));
const reply = {values: () => values(bytes), damage: () => damage(bytes, Number(count)), write: () => write(name, Number(count))};
console.log(JSON.stringify(await reply[what]()));
