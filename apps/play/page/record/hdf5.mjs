// SPDX-License-Identifier: MIT
// H5MD files, by a worker that is unpacked when the first is saved or opened.
import {workerInside} from '../inside.mjs';

const SIGNATURE = [0x89, 0x48, 0x44, 0x46, 0x0d, 0x0a, 0x1a, 0x0a];
let starting = null;

const worker = () => (starting ??= workerInside('hdf5-worker'));

export const isHdf5 = (bytes) => SIGNATURE.every((byte, k) => bytes[k] === byte);

/** Bytes of an H5MD file of these frames. `recorded`: what the solver says of its session besides
 * them, or null where the frames are not its. Throws Error if HDF5 does. */
export async function h5mdBytes(model, frames, timestep, recorded) {
  const labels = Array.from({length: model.joints}, (_, joint) => model.nameOf(joint));
  const labelSize = labels.reduce((most, text) => Math.max(most, new TextEncoder().encode(text).length), 1);
  const {joints, elements, bars, bonds, rest, residue} = model;
  const {mass} = recorded ?? model;
  const pinned = new Uint8Array(joints);
  for (const joint of model.pinned ?? []) pinned[joint] = 1;
  const plain = frames.map(({broken, ...frame}, k) => ({...frame, step: frame.step ?? k}));
  const reply = await (await worker()).ask('write', {
    version: PLIANT_VERSION, frames: plain, timestep, labels, labelSize, joints, elements, bars,
    bonds, mass, rest, residue, pinned, recorded,
  });
  return reply.bytes;
}

/** Frames and bars of an H5MD file. Throws Error naming the file. */
export async function readH5md(name, bytes) {
  try {
    return await (await worker()).ask('read', {bytes});
  } catch (error) {
    throw new Error(`${name}: ${error.message}`);
  }
}

/** Datasets, and names and attributes of groups, of an HDF5 file: {path: {shape, data, attributes},
 * or {names, attributes}, or null where there is none}. Throws Error naming the file. */
export async function readDatasets(name, bytes, paths) {
  try {
    return (await (await worker()).ask('datasets', {bytes, paths})).values;
  } catch (error) {
    throw new Error(`${name}: ${error.message}`);
  }
}
