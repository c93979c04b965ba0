// SPDX-License-Identifier: MIT
// What an H5MD file holds (de Buyl, Colberg & Hoefling, Comput. Phys. Commun. 185 (2014) 1546): the
// frames of a session, and all else that `pliant run` records of one.
import {fixedTexts, numbers, texts} from './types.mjs';
import {Hdf5Writer} from './writer.mjs';

const CREATOR = 'pliant';
const POSITION = 'particles/trajectory/position';

const text = (value) => texts([value]);
const whole = (...values) => numbers(Int32Array.from(values));
const real = (item, unit) => (unit ? item.attribute('unit', text(unit)) : item);

function dataset(file, path, value, shape, unit) {
  return real(file.dataset(path, value, shape), unit);
}

function writeHeader(file, version) {
  file.group('h5md').attribute('version', whole(1, 1), [2]);
  file.group('h5md/author').attribute('name', text('unknown'));
  file.group('h5md/creator').attribute('name', text(CREATOR)).attribute('version', text(version));
  file.group('h5md/modules/units').attribute('version', whole(1, 0), [2]).attribute('system', text('SI'));
}

function writeTimes(file, folder, frames, timestep) {
  const steps = BigInt64Array.from(frames, (frame) => BigInt(frame.step));
  const times = Float64Array.from(frames, (frame) => frame.step * timestep);
  dataset(file, `${folder}/step`, numbers(steps), [frames.length]);
  dataset(file, `${folder}/time`, numbers(times), [frames.length], 'ps');
}

function writeParticles(file, {frames, joints, timestep, elements, mass}) {
  file.group('particles/trajectory/box').attribute('dimension', whole(3))
    .attribute('boundary', texts(['none', 'none', 'none']), [3]);
  const rows = frames.map(({positions}) => numbers(positions));
  real(file.rows(`${POSITION}/value`, rows, [joints, 3]), 'Angstrom');
  writeTimes(file, POSITION, frames, timestep);
  dataset(file, 'particles/trajectory/species', numbers(elements), [joints]);
  if (mass?.length) dataset(file, 'particles/trajectory/mass', numbers(mass), [joints], 'u');
}

const NOWHERE = -1;  // root joint of the start
const FORCE = 'kJ mol-1 Angstrom-1';
const count = (list) => numbers(BigInt64Array.from(list, (value) => BigInt(value ?? 0)));
const small = (list) => numbers(Uint8Array.from(list, (value) => value ?? 0));
const reals = (list) => numbers(Float64Array.from(list, (value) => value ?? 0));

/** Of all steps; and of those of the page's own solver, which a run that is followed tells less of. */
const OBSERVABLES = {
  sweeps: {of: (f) => f.sweeps, as: count},
  projections: {of: (f) => f.projections, as: count},
  max_residual: {of: (f) => f.residual},
  converged: {of: (f) => (f.converged === false ? 0 : 1), as: small},
};
const OF_THE_SOLVER = {
  rms_residual: {of: (f) => f.rms},
  stop: {of: (f) => f.stopCode, as: small},
  root_joint: {of: (f) => f.root ?? NOWHERE, as: count},
  force_x: {of: (f) => f.force?.[0], unit: FORCE},
  force_y: {of: (f) => f.force?.[1], unit: FORCE},
  force_z: {of: (f) => f.force?.[2], unit: FORCE},
};
const OF_LIMITS = {
  max_limit: {of: (f) => f.limit, unit: 'Angstrom'},
  max_overlap: {of: (f) => f.overlap, unit: 'Angstrom'},
};

function writeObservables(file, {frames, timestep, recorded}) {
  const rows = {
    ...OBSERVABLES, ...(recorded ? OF_THE_SOLVER : {}), ...(recorded && !recorded.barsOnly ? OF_LIMITS : {}),
  };
  for (const [name, {of, as = reals, unit}] of Object.entries(rows)) {
    dataset(file, `observables/${name}/value`, as(frames.map(of)), [frames.length], unit);
    writeTimes(file, `observables/${name}`, frames, timestep);
  }
}

/** How a parameter is kept. */
const SCALARS = {
  int64: (value) => count([value]), float64: (value) => reals([value]),
  bool: (value) => small([value ? 1 : 0]), text,
};

/** Atoms, residues and where bonds are from. */
function writeAtoms(file, {recorded, residue}) {
  const put = (name, value, list) => file.dataset(`parameters/topology/${name}`, value, [list.length]);
  for (const [name, list] of Object.entries(recorded.texts)) put(name, fixedTexts(list), list);
  for (const [name, list] of Object.entries(recorded.integers)) put(name, count(list), list);
  put('residue_of', numbers(Uint32Array.from(residue)), residue);
  put('bond_origin', numbers(recorded.bondOrigins), recorded.bondOrigins);
  put('bond_order', numbers(recorded.bondOrders), recorded.bondOrders);
}

function writeFramework(file, {bars, bonds, rest, pinned, elements, labels, joints}) {
  file.group('connectivity');
  for (const [name, pairs] of Object.entries({bars, bonds}))
    if (pairs.length) file.dataset(`connectivity/${name}`, numbers(pairs), [pairs.length / 2, 2]);
  const folder = 'parameters/framework';
  if (rest) dataset(file, `${folder}/rest_length`, numbers(rest), [rest.length], 'Angstrom');
  file.dataset(`${folder}/pinned`, numbers(pinned), [joints]);
  file.dataset('parameters/topology/atomic_number', numbers(elements), [joints]);
  file.dataset('parameters/topology/label', fixedTexts(labels), [joints]);
}

/** Bytes of a file of these frames; rows of `recorded.parameters` are path, type and value. */
export function h5mdFile(ask) {
  const file = new Hdf5Writer();
  writeHeader(file, ask.version);
  writeParticles(file, ask);
  writeObservables(file, ask);
  writeFramework(file, ask);
  for (const [path, type, value] of ask.recorded?.parameters ?? [])
    file.dataset(`parameters/${path}`, SCALARS[type](value), []);
  if (ask.recorded) writeAtoms(file, ask);
  return file.bytes();
}
