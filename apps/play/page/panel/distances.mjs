// SPDX-License-Identifier: MIT
// Measured distances of what is shown, of `pliant play --distances`: lines over the picture, blue where
// a distance holds and red where it is off, and how well all of them hold.
import {length, less, pointOf} from '../view/vectors.mjs';
import {$, units} from './dom.mjs';

/** Angstrom outside of an interval: below 0 where too short. */
export const offBy = (now, {low, high}) => Math.max(now - (high ?? Infinity), 0) + Math.min(now - low, 0);

/** "7 of 10 distances hold, off by 2.3 Å r.m.s." */
export function scoreOf(off, holds) {
  const count = off.filter((one) => Math.abs(one) <= holds).length;
  const mean = Math.sqrt(off.reduce((sum, one) => sum + one * one, 0) / off.length);
  return `${count} of ${units(off.length, 'distance')} hold, off by ${mean.toFixed(1)} Å r.m.s.`;
}

export class Distances {
  constructor({stage, view, labels}) {
    Object.assign(this, {stage, view, asked: [], rows: []});
    stage.on('began', (model) => this.began(model));
    stage.on('changed', () => this.tell());
    labels.put('distances', () => this.lines());
  }

  /** Rows of two names of joints, low and high; `holds`: Angstrom that a distance may be off. */
  set({rows, holds}) {
    Object.assign(this, {asked: rows, holds});
    this.began(this.stage.model);
    this.tell();
    this.view.stale = true;
  }

  began({names}) {
    this.rows = this.asked.map((row) => ({...row, joints: row.names.map((name) => names.indexOf(name))}))
      .filter(({joints}) => Math.min(...joints) >= 0);
    $('distances').hidden = !this.rows.length;
  }

  off(row) {
    const [one, other] = row.joints.map((joint) => pointOf(this.view.textures.positions.data, joint, 4));
    return offBy(length(less(one, other)), row);
  }

  lines() {
    return this.rows.map((row) => {
      const off = this.off(row);
      const isOff = Math.abs(off) > this.holds;
      return {joints: row.joints, text: isOff ? `${off > 0 ? '+' : '−'}${Math.abs(off).toFixed(1)} Å` : '', kind: isOff ? 'off' : 'holds'};
    });
  }

  tell() {
    if (this.rows.length) $('out-distances').textContent = scoreOf(this.rows.map((row) => this.off(row)), this.holds);
  }
}
