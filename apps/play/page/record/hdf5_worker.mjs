// SPDX-License-Identifier: MIT
// H5MD (de Buyl, Colberg & Hoefling, Comput. Phys. Commun. 185 (2014) 1546) written and read by
// h5wasm, in a worker of its own that is made when first asked for.
import {File, ready} from 'h5wasm';
import {ensembleFields} from './ensemble_fields.mjs';

const CREATOR = 'pliant';
const POSITION = 'particles/trajectory/position';
const MOST_READ = 512 * 1024 * 1024;  // bytes of positions held
const FRAMES_AT_ONCE = 64;

function attribute(item, name, value, shape, type) {
  item.create_attribute(name, value, shape, type);
}

function dataset(file, path, data, shape, dtype, unit) {
  const cut = path.lastIndexOf('/');
  const group = file.get(path.slice(0, cut)) ?? file.create_group(path.slice(0, cut));
  const made = group.create_dataset({name: path.slice(cut + 1), data, shape, dtype});
  if (unit) attribute(made, 'unit', unit);
  return made;
}

function writeHeader(file, version) {
  attribute(file.create_group('h5md'), 'version', new Int32Array([1, 1]), [2], '<i');
  attribute(file.create_group('h5md/author'), 'name', 'unknown');
  const creator = file.create_group('h5md/creator');
  attribute(creator, 'name', CREATOR);
  attribute(creator, 'version', version);
  file.create_group('h5md/modules');
  const units = file.create_group('h5md/modules/units');
  attribute(units, 'version', new Int32Array([1, 0]), [2], '<i');
  attribute(units, 'system', 'SI');
}

function writeTimes(file, folder, frames, timestep) {
  const steps = BigInt64Array.from(frames, (frame) => BigInt(frame.step));
  const times = Float64Array.from(frames, (frame) => frame.step * timestep);
  dataset(file, `${folder}/step`, steps, [frames.length], '<q');
  dataset(file, `${folder}/time`, times, [frames.length], '<d', 'ps');
}

/** A frame a chunk, written one after the other: no second copy of them all is made. */
function writePositions(file, {frames, joints, timestep}) {
  file.create_group(POSITION);
  const shape = [frames.length, joints, 3];
  const value = file.get(POSITION).create_dataset({
    name: 'value', data: frames[0].positions, shape: [1, joints, 3], dtype: '<d',
    chunks: [1, joints, 3], maxshape: [null, joints, 3],
  });
  attribute(value, 'unit', 'Angstrom');
  value.resize(shape);
  frames.forEach((frame, k) => {
    if (k) value.write_slice([[k, k + 1], [0, joints], [0, 3]], frame.positions);
  });
  writeTimes(file, POSITION, frames, timestep);
}

function writeParticles(file, ask) {
  file.create_group('particles');
  file.create_group('particles/trajectory');
  const box = file.create_group('particles/trajectory/box');
  attribute(box, 'dimension', 3, null, '<i');
  attribute(box, 'boundary', ['none', 'none', 'none'], [3]);
  writePositions(file, ask);
  dataset(file, 'particles/trajectory/species', ask.elements, [ask.joints], '<B');
  if (ask.mass?.length) dataset(file, 'particles/trajectory/mass', ask.mass, [ask.joints], '<d', 'u');
}

const NOWHERE = -1;  // root joint of the start
const FORCE = 'kJ mol-1 Angstrom-1';

/** Of all steps; and of those of the page's own solver, which a run that is followed tells less of. */
const OBSERVABLES = {
  sweeps: {of: (f) => f.sweeps, type: '<q'},
  projections: {of: (f) => f.projections, type: '<q'},
  max_residual: {of: (f) => f.residual},
  converged: {of: (f) => (f.converged === false ? 0 : 1), type: '<B'},
};
const OF_THE_SOLVER = {
  rms_residual: {of: (f) => f.rms},
  stop: {of: (f) => f.stopCode, type: '<B'},
  root_joint: {of: (f) => f.root ?? NOWHERE, type: '<q'},
  force_x: {of: (f) => f.force?.[0], unit: FORCE},
  force_y: {of: (f) => f.force?.[1], unit: FORCE},
  force_z: {of: (f) => f.force?.[2], unit: FORCE},
};
const OF_LIMITS = {
  max_limit: {of: (f) => f.limit, unit: 'Angstrom'},
  max_overlap: {of: (f) => f.overlap, unit: 'Angstrom'},
};

function numbersOf(list, type) {
  if (type === '<q') return BigInt64Array.from(list, (value) => BigInt(value ?? 0));
  return (type === '<B' ? Uint8Array : Float64Array).from(list, (value) => value ?? 0);
}

function writeObservables(file, {frames, timestep, recorded}) {
  file.create_group('observables');
  const rows = {
    ...OBSERVABLES, ...(recorded ? OF_THE_SOLVER : {}), ...(recorded && !recorded.barsOnly ? OF_LIMITS : {}),
  };
  for (const [name, {of, type = '<d', unit}] of Object.entries(rows)) {
    dataset(file, `observables/${name}/value`, numbersOf(frames.map(of), type), [frames.length], type, unit);
    writeTimes(file, `observables/${name}`, frames, timestep);
  }
}

/** How a parameter is kept; a text of any length. */
const SCALARS = {
  int64: (value) => ({data: BigInt64Array.of(BigInt(value)), dtype: '<q'}),
  float64: (value) => ({data: Float64Array.of(value), dtype: '<d'}),
  bool: (value) => ({data: Uint8Array.of(value ? 1 : 0), dtype: '<B'}),
  text: (value) => ({data: [value], dtype: 'S'}),
};

/** Rows of path, type and value, as `pliant run` would record them. */
function writeParameters(file, rows) {
  const groups = new Set(rows.map(([path]) => path.split('/')[0]));
  for (const name of groups) file.get(`parameters/${name}`) ?? file.create_group(`parameters/${name}`);
  for (const [path, type, value] of rows) {
    const [group, name] = path.split('/');
    file.get(`parameters/${group}`).create_dataset({name, shape: [], ...SCALARS[type](value)});
  }
}

const encoder = new TextEncoder();

function writeTexts(topology, name, data) {
  const size = data.reduce((most, text) => Math.max(most, encoder.encode(text).length), 1);
  topology.create_dataset({name, data, shape: [data.length], dtype: `S${size}`});
}

/** Atoms, residues and where bonds are from. */
function writeAtoms(topology, {recorded, residue}) {
  const {texts, integers, bondOrigins, bondOrders} = recorded;
  const numbers = (name, data, dtype) => topology.create_dataset({name, data, shape: [data.length], dtype});
  for (const [name, data] of Object.entries(texts)) writeTexts(topology, name, data);
  for (const [name, data] of Object.entries(integers)) numbers(name, numbersOf(data, '<q'), '<q');
  numbers('residue_of', Uint32Array.from(residue), '<I');
  numbers('bond_origin', bondOrigins, '<B');
  numbers('bond_order', bondOrders, '<B');
}

function writeFramework(file, ask) {
  file.create_group('connectivity');
  for (const name of ['bars', 'bonds'])
    if (ask[name].length) dataset(file, `connectivity/${name}`, ask[name], [ask[name].length / 2, 2], '<i');
  file.create_group('parameters');
  file.create_group('parameters/framework');
  if (ask.rest) dataset(file, 'parameters/framework/rest_length', ask.rest, [ask.rest.length], '<d', 'Angstrom');
  dataset(file, 'parameters/framework/pinned', ask.pinned, [ask.joints], '<B');
  const topology = file.create_group('parameters/topology');
  topology.create_dataset({name: 'atomic_number', data: ask.elements, shape: [ask.joints], dtype: '<B'});
  topology.create_dataset({name: 'label', data: ask.labels, shape: [ask.joints], dtype: `S${ask.labelSize}`});
}

function writeRecorded(file, ask) {
  writeParameters(file, ask.recorded.parameters);
  writeAtoms(file.get('parameters/topology'), ask);
}

function write(FS, ask) {
  const name = '/write.h5md';
  const file = new File(name, 'w');
  try {
    writeHeader(file, ask.version);
    writeParticles(file, ask);
    writeObservables(file, ask);
    writeFramework(file, ask);
    if (ask.recorded) writeRecorded(file, ask);
  } finally {
    file.close();
  }
  const bytes = FS.readFile(name).slice();
  FS.unlink(name);
  return {bytes};
}

/** What is wrong with a file that HDF5 can read. */
class NoTrajectory extends Error {}

const numbers = (file, path) => file.get(path)?.value ?? null;

function readFrames(value, [count, joints]) {
  const frames = [];
  const most = Math.max(1, Math.min(count, Math.floor(MOST_READ / (24 * joints))));
  for (let from = 0; from < most; from += FRAMES_AT_ONCE) {
    const to = Math.min(most, from + FRAMES_AT_ONCE);
    const block = Float64Array.from(value.slice([[from, to], [0, joints], [0, 3]]));
    for (let k = 0; k < to - from; ++k) frames.push(block.slice(3 * joints * k, 3 * joints * (k + 1)));
  }
  return frames;
}

function firstGroup(file) {
  const groups = file.get('particles')?.keys() ?? [];
  const found = groups.find((name) => file.get(`particles/${name}/position/value`));
  if (!found) throw new NoTrajectory('expected the positions of an H5MD file, found none');
  return found;
}

function readFile(file) {
  const group = firstGroup(file);
  const value = file.get(`particles/${group}/position/value`);
  const shape = value.shape;
  if (shape.length !== 3 || shape[2] !== 3 || !shape[0] || !shape[1])
    throw new NoTrajectory(`position: expected frames x joints x 3, found ${shape.join(' x ')}`);
  const scale = value.attrs.unit?.value === 'nm' ? 10 : 1;
  const frames = readFrames(value, shape);
  if (scale !== 1) frames.forEach((frame) => frame.forEach((x, k) => { frame[k] = scale * x; }));
  const list = (path) => Array.from(numbers(file, path) ?? [], Number);
  return {
    frames, count: shape[0], joints: shape[1],
    elements: Uint8Array.from(list('parameters/topology/atomic_number')),
    bars: Int32Array.from(list('connectivity/bars')), bonds: Int32Array.from(list('connectivity/bonds')),
    rest: Float64Array.from(list('parameters/framework/rest_length')),
    sweeps: list('observables/sweeps/value'), residual: list('observables/max_residual/value'),
    projections: list('observables/projections/value'),
    ...ensembleFields((path) => numbers(file, path)),
    names: [...(numbers(file, 'parameters/topology/label') ?? numbers(file, 'parameters/topology/atom_name') ?? [])],
  };
}

function read(FS, {bytes}) {
  const name = '/read.h5md';
  FS.writeFile(name, bytes);
  let file;
  try {
    file = new File(name, 'r');
    return readFile(file);
  } catch (error) {
    if (error instanceof NoTrajectory || error instanceof RangeError) throw error;
    throw new Error('expected an HDF5 file that can be read, found one that is damaged or cut short');
  } finally {
    close(file);
    FS.unlink(name);
  }
}

/** Of a damaged file HDF5 may refuse even this. */
function close(file) {
  try {
    file?.close();
  } catch {
    // What was wrong has been told.
  }
}

/** HDF5, which throws what it would print: dozens of lines on the console for a damaged file. */
async function quietHdf5() {
  const module = await ready;
  module.activate_throwing_error_handler();
  return module;
}

self.onmessage = async ({data}) => {
  try {
    const {FS} = await quietHdf5();
    const reply = data.do === 'write' ? write(FS, data) : read(FS, data);
    const buffers = (reply.frames ?? []).map((frame) => frame.buffer);
    self.postMessage({id: data.id, ok: true, ...reply}, reply.bytes ? [reply.bytes.buffer] : buffers);
  } catch (error) {
    self.postMessage({id: data.id, ok: false, error: error.message});
  }
};
