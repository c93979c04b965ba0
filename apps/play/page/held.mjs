// SPDX-License-Identifier: MIT
// When a pull is held: the pointer is far, and over some steps the joint went hardly any of the way
// that it was to go.

const STEPS = 12;  // looked back on
const SHARE = 0.1;  // of the way wanted, below which it is held
const FAR = 1;  // Angstrom, in units of a usual bar / 1.5, from the pointer

export class HeldWatch {
  constructor() {
    this.begin(-1);
  }

  begin(joint) {
    this.joint = joint;
    this.steps = [];
  }

  /** One step of a joint: where it was and is, the target, and how far a step may go. */
  take({joint, before, now, target, share, furthest}) {
    if (joint !== this.joint) this.begin(joint);
    const way = target.map((x, c) => x - before[c]);
    this.left = Math.hypot(...way);
    const wanted = Math.min(share * this.left, furthest);
    const moved = way.reduce((sum, x, c) => sum + x * (now[c] - before[c]), 0) / (this.left || 1);
    this.steps.push({wanted, moved});
    if (this.steps.length > STEPS) this.steps.shift();
  }

  isHeld(unit) {
    if (this.steps.length < STEPS || this.left < FAR * unit) return false;
    const sum = (name) => this.steps.reduce((all, step) => all + step[name], 0);
    return sum('moved') < SHARE * sum('wanted');
  }
}
