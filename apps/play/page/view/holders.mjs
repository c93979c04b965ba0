// SPDX-License-Identifier: MIT
// What holds a pull, lit up over all else: tubes between joints, and balls about pins.
import {ball, drawSolids, rod} from './solids.mjs';
import {rgb} from './uniforms.mjs';
import {pointOf} from './vectors.mjs';

/** Holders, the chain that is taut and the bars that carry the pull; radii in Angstrom. */
const SORTS = {
  holder: {paint: [...rgb('#d55e00'), 1], radius: 0.17},
  taut: {paint: [...rgb('#0072b2'), 0.9], radius: 0.13},
  loaded: {paint: [...rgb('#0072b2'), 0.5], radius: 0.07},
};
const PIN = {paint: [...rgb('#d55e00'), 0.75], radius: 0.5};

export class Holders {
  constructor() {
    this.hide();
  }

  /** Pairs of joints by sort, {holder: [[a, b], ...], ...}; joints of pins. */
  show(pairs, pins = []) {
    this.pairs = pairs;
    this.pins = pins;
  }

  hide() {
    this.show({});
  }

  get isShown() {
    return this.pins.length > 0 || Object.values(this.pairs).some((list) => list.length > 0);
  }

  draw(view) {
    if (!this.isShown) return;
    const place = (joint) => pointOf(view.textures.positions.data, joint, 4);
    const rods = Object.entries(this.pairs).flatMap(([sort, list]) => {
      const {radius, paint} = SORTS[sort];
      return list.map(([a, b]) => rod(place(a), place(b), radius * view.unit, paint));
    });
    drawSolids(view, [...rods, ...this.pins.map((joint) => ball(place(joint), PIN.radius * view.unit, PIN.paint))]);
  }
}
