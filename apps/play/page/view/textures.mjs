// SPDX-License-Identifier: MIT
// What the shaders read: joints, bars and the trace of one model as textures of WIDTH texels a row.
import {Texture} from './gl.mjs';

export const WIDTH = 1024;
const rows = (count) => Math.max(1, Math.ceil(count / WIDTH));

function texture(Numbers, channels, format) {
  return (count) => new Texture(format, WIDTH, rows(count), new Numbers(channels * WIDTH * rows(count)));
}

const floats = texture(Float32Array, 4, 'floats');
const shares = texture(Float32Array, 1, 'float');
const bytes = texture(Uint8Array, 4, 'bytes');
const pairs = texture(Uint8Array, 2, 'pair');
export const numbers = texture(Int32Array, 4, 'ints');

/** Kinds of sticks: bonds, other bars, contacts. */
export const BOND = 0;
export const OTHER_BAR = 1;
export const CONTACT = 2;

function pairKey(a, b) {
  return a < b ? `${a} ${b}` : `${b} ${a}`;
}

/** Bars first, so that a bar's number is its stick's; then bonds that no bar holds; then contacts. */
export function sticksOf(model) {
  const bonds = new Set();
  const areAllBonds = !model.bonds.length;
  for (let k = 0; k < model.bonds.length; k += 2) bonds.add(pairKey(model.bonds[k], model.bonds[k + 1]));
  const sticks = [];
  for (let k = 0; k < model.bars.length; k += 2) {
    const [a, b] = [model.bars[k], model.bars[k + 1]];
    const isBond = areAllBonds || bonds.delete(pairKey(a, b));
    sticks.push([a, b, isBond ? BOND : OTHER_BAR]);
  }
  for (const key of bonds) sticks.push([...key.split(' ').map(Number), BOND]);
  const colours = (model.contactKindColours ?? []).map((text) => parseInt(text.slice(1), 16));
  for (let k = 0; k < model.contacts.length / 2; ++k)
    sticks.push([model.contacts[2 * k], model.contacts[2 * k + 1], CONTACT, colours[model.contactKinds[k]]]);
  return sticks;
}

/** Joints of each piece of the trace with the neighbours that bend it; ends stand for themselves. */
export function piecesOf(trace) {
  const pieces = [];
  for (let k = 0; k + 1 < trace.length; ++k) {
    const [a, b] = [trace[k], trace[k + 1]];
    if (a < 0 || b < 0) continue;
    const before = k > 0 && trace[k - 1] >= 0 ? trace[k - 1] : a;
    const after = k + 2 < trace.length && trace[k + 2] >= 0 ? trace[k + 2] : b;
    pieces.push([before, a, b, after]);
  }
  return pieces;
}

function fill(target, lists) {
  lists.forEach((list, k) => target.data.set(list, 4 * k));
}

export class Textures {
  constructor(model, walkers) {
    const sticks = sticksOf(model);
    const pieces = piecesOf(model.trace);
    this.model = model;
    this.stickCount = sticks.length;
    this.pieceCount = pieces.length;
    this.positions = floats(model.joints * walkers);
    this.look = bytes(model.joints);
    this.marks = pairs(model.joints);
    this.strain = shares(sticks.length);
    this.bars = numbers(sticks.length);
    this.controls = numbers(pieces.length);
    this.firstContact = sticks.length - model.contacts.length / 2;
    this.limits = floats(model.contacts.length / 2);
    (model.contactLimits ?? []).forEach((length, k) => { this.limits.data[4 * Math.floor(k / 3) + k % 3] = length; });
    fill(this.bars, sticks);
    fill(this.controls, pieces);
  }

  /** Positions of one walker: 3 numbers a joint, Angstrom. */
  setPositions(positions, walker = 0) {
    const {data} = this.positions;
    for (let at = 4 * walker * this.model.joints, k = 0; k < positions.length; at += 4, k += 3) {
      data[at] = positions[k];
      data[at + 1] = positions[k + 1];
      data[at + 2] = positions[k + 2];
    }
    this.positions.changed();
  }

  setStrain(residuals) {
    this.strain.data.set(residuals);
    this.strain.changed();
  }

  /** By the names that they have in shaders. */
  get all() {
    const {positions, look, marks, strain, bars, controls, limits} = this;
    return {positions, look, marks, strain, bars, controls, limits};
  }
}
