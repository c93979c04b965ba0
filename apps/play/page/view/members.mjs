// SPDX-License-Identifier: MIT
// Which atoms and sticks stand beside a cartoon: what no ribbon goes through, what is marked or
// pinned, and side chains near the atom that was last under the pointer.
import {numbers} from './textures.mjs';

const NEAR = 6;  // Angstrom about that atom; a residue with one atom within it is shown
const BACKBONE = new Set(['N', 'C', 'O', 'OXT', 'OT1', 'OT2', 'H', 'HA', 'HA2', 'HA3', 'P', 'OP1', 'OP2', 'O1P', 'O2P']);

const NO_ONE = -1;  // in place of a count: 0 stands for all
const countOf = ({memberCount}, all) => memberCount.value === NO_ONE ? 0 : memberCount.value || all;

export class Members {
  constructor() {
    this.joints = {members: {value: null}, memberCount: {value: 0}};
    this.sticks = {members: {value: null}, memberCount: {value: 0}};
  }

  /** `runs`: the CA and P that the ribbon goes through. Of a nucleic acid it leaves bases and sugars out. */
  open(model, runs, textures) {
    this.model = model;
    this.centre = -1;
    this.firstContact = Infinity;
    this.seen = '';
    const inRibbon = new Set(runs.flat().map((joint) => model.residue[joint]));
    const hasSugar = new Set();
    model.atoms?.forEach((name, joint) => name === "C4'" && hasSugar.add(model.residue[joint]));
    this.isAlways = Uint8Array.from({length: model.joints}, (_, joint) => {
      const residue = model.residue[joint];
      return Number(!inRibbon.has(residue) || hasSugar.has(residue) && !BACKBONE.has(model.atoms[joint]));
    });
    this.isAlone = new Uint8Array(model.joints).fill(1);
    for (const joint of model.bonds) this.isAlone[joint] = 0;
    this.room(textures);
  }

  room(textures) {
    for (const [part, count] of [[this.joints, this.model.joints], [this.sticks, textures.stickCount]]) {
      part.members.value = numbers(count);
    }
    this.seen = '';
  }

  /** All of them, in the styles without a ribbon. */
  all() {
    this.joints.memberCount.value = this.sticks.memberCount.value = 0;
    this.seen = '';
  }

  /** Looks again where something else is under the pointer, marked or held. */
  choose(textures, centre, bar) {
    if (centre >= 0) this.centre = centre;
    const now = [this.centre, bar, this.firstContact, textures.marks.version, textures.stickCount].join();
    if (now === this.seen) return;
    this.seen = now;
    const isShown = this.shown(textures);
    const ends = textures.bars.data;
    const joints = [], sticks = [];
    for (let joint = 0; joint < isShown.length; ++joint) if (isShown[joint]) joints.push(joint);
    for (let k = 0; k < textures.stickCount; ++k)
      if (k === bar || k >= this.firstContact || isShown[ends[4 * k]] && isShown[ends[4 * k + 1]]) sticks.push(k);
    this.put(this.joints, joints);
    this.put(this.sticks, sticks);
  }

  put({members, memberCount}, list) {
    list.forEach((number, k) => { members.value.data[4 * k] = number; });
    members.value.changed();
    memberCount.value = list.length || NO_ONE;
  }

  jointsOf(all) {
    return countOf(this.joints, all);
  }

  sticksOf(all) {
    return countOf(this.sticks, all);
  }

  shown(textures) {
    const isShown = this.isAlways.slice();
    const {data} = textures.marks;
    for (let joint = 0; joint < isShown.length; ++joint)
      if (data[2 * joint] || data[2 * joint + 1]) isShown[joint] = 1;
    if (this.centre >= 0) this.addNear(isShown, textures.positions.data);
    return isShown;
  }

  addNear(isShown, places) {
    const {model, centre} = this;
    const near = new Set();
    for (let joint = 0; joint < model.joints; ++joint) {
      const far = Math.hypot(...[0, 1, 2].map((c) => places[4 * joint + c] - places[4 * centre + c]));
      if (far <= NEAR) near.add(model.residue[joint]);
    }
    for (let joint = 0; joint < model.joints; ++joint)
      if (near.has(model.residue[joint]) && !BACKBONE.has(model.atoms?.[joint])) isShown[joint] = 1;
    isShown[centre] = 1;
  }
}
