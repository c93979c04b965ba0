// SPDX-License-Identifier: MIT
// How hard a hand has to pull on a run that goes on elsewhere. Of the run it sees a frame now and
// then, and between two frames many steps, in all of which its force acts.

const FRAME = 1 / 30;  // seconds between the frames of a page that is fast enough
const GOOD = 0.8;  // share of what was asked for; no change between 0.5 and 1
const MOST = 5;  // doublings from one frame to the next, however long that took

/** A gain found by trial. Bars and damping hold a joint back, nobody here knows how much: the gain is
 * doubled while too little comes of it, and halved where more than was asked for does, forth or
 * back. Each 1/30 s counts as much as any other: who sees few frames goes further in each. */
export class Gain {
  constructor() {
    this.value = 1;
    this.asked = null;
  }

  /** How many frames of a fast page a frame stands for that took so many seconds. */
  static pace(seconds) {
    return Math.max(1, seconds / FRAME);
  }

  /** The next pull may be of a lighter part. */
  release() {
    this.value = Math.max(1, this.value / 8);
    this.asked = null;
  }

  /** Angstrom by which a force has to move a joint in each of `steps` steps to bring it `way` further
   * until the next frame. `moved`: how far it came since the last one, `seconds` ago. A force that
   * acts in many steps goes with their number squared. */
  effort(way, moved, steps, seconds) {
    const pace = Gain.pace(seconds);
    this.change(this.came(moved), 2 ** Math.min(MOST, pace));
    this.value = Math.max(1, Math.min(this.value, steps ** 2));
    this.asked = way;
    // Of its velocity a joint keeps the less, the more steps a frame stands for.
    return way.map((x, c) => (x - moved[c] / pace) * this.value / steps ** 2);
  }

  /** The share of what was asked for that came of it. */
  came(moved) {
    if (!this.asked) return GOOD;
    const along = (v) => v.reduce((sum, x, c) => sum + x * this.asked[c], 0);
    return along(moved) / Math.max(along(this.asked), 1e-12);
  }

  /** By a factor of `most` at most, and by 2 at least unless that is more than `most`. */
  change(share, most) {
    const factor = Math.min(most, Math.max(2, share > 0.5 ? share / GOOD : GOOD / Math.max(share, 1e-12)));
    if (Math.abs(share) > 1) this.value /= factor;
    else if (share < 0.5) this.value *= factor;
  }
}
