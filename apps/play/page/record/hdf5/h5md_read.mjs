// SPDX-License-Identifier: MIT
// The trajectory of an H5MD file: frames, and what Pliant keeps beside them.
import {ENSEMBLE_PATHS, ensembleFields} from '../ensemble_fields.mjs';
import {Hdf5File} from './read/file.mjs';
import {Damaged, Outside} from './read/source.mjs';

const MOST_READ = 512 * 1024 * 1024;  // bytes of positions held
const FRAMES_AT_ONCE = 64;

/** What is wrong with a file that can be read, or cannot. */
const told = (error) =>
  (error instanceof Damaged || error instanceof Outside || error instanceof NoTrajectory ? error : new Damaged());

class NoTrajectory extends Error {}

/** Numbers of a dataset as a list; [] where there is none. */
async function list(file, path) {
  const dataset = file.get(path);
  return dataset?.read ? Array.from(await dataset.read(), Number) : [];
}

async function texts(file, paths) {
  for (const path of paths) {
    const dataset = file.get(path);
    if (dataset?.read) return (await dataset.read()).map(String);
  }
  return [];
}

async function readFrames(value, joints, scale) {
  const most = Math.min(value.rowsThere(), Math.max(1, Math.floor(MOST_READ / (24 * joints))));
  const frames = [];
  for (let from = 0; from < most; from += FRAMES_AT_ONCE) {
    const to = Math.min(most, from + FRAMES_AT_ONCE);
    const block = Float64Array.from(await value.read(from, to));
    if (scale !== 1) block.forEach((x, k) => { block[k] = scale * x; });
    for (let k = 0; k < to - from; ++k) frames.push(block.slice(3 * joints * k, 3 * joints * (k + 1)));
  }
  return frames;
}

function positionsOf(file) {
  for (const name of file.get('particles')?.names?.() ?? []) {
    const found = file.get(`particles/${name}/position/value`);
    if (found) return found;
  }
  throw new NoTrajectory('expected the positions of an H5MD file, found none');
}

async function trajectory(file) {
  const value = positionsOf(file);
  const {shape} = value;
  if (shape?.length !== 3 || shape[2] !== 3 || !shape[0] || !shape[1])
    throw new NoTrajectory(`position: expected frames x joints x 3, found ${(shape ?? []).join(' x ')}`);
  const frames = await readFrames(value, shape[1], value.attribute('unit') === 'nm' ? 10 : 1);
  if (!frames.length) throw new Damaged();
  return {
    frames, count: shape[0], joints: shape[1],
    elements: Uint8Array.from(await list(file, 'parameters/topology/atomic_number')),
    bars: Int32Array.from(await list(file, 'connectivity/bars')),
    bonds: Int32Array.from(await list(file, 'connectivity/bonds')),
    rest: Float64Array.from(await list(file, 'parameters/framework/rest_length')),
    sweeps: await list(file, 'observables/sweeps/value'),
    residual: await list(file, 'observables/max_residual/value'),
    projections: await list(file, 'observables/projections/value'),
    ...await ensembleOf(file),
    names: await texts(file, ['parameters/topology/label', 'parameters/topology/atom_name']),
  };
}

/** What the page needs to open the molecule of the frames by itself. */
async function ensembleOf(file) {
  const values = new Map();
  for (const path of ENSEMBLE_PATHS) values.set(path, await file.get(path)?.read?.() ?? null);
  return ensembleFields((path) => values.get(path) ?? null);
}

/** Frames and framework of a file of these bytes. */
export async function readTrajectory(bytes) {
  try {
    return await trajectory(new Hdf5File(bytes));
  } catch (error) {
    throw told(error);
  }
}

/** {values: {path: {shape, data, attributes}, or null where there is none}} of the datasets asked for. */
export async function readDatasets(bytes, paths) {
  try {
    const file = new Hdf5File(bytes);
    const values = {};
    for (const path of paths) values[path] = await datasetAt(file.get(path));
    return {values};
  } catch (error) {
    throw told(error);
  }
}

async function datasetAt(item) {
  if (!item) return null;
  const attributes = Object.fromEntries(item.attributeNames().map((name) => [name, item.attribute(name)]));
  if (item.kind === 'group') return {names: item.names(), attributes};
  return {shape: item.shape, data: await item.read(), attributes};
}
