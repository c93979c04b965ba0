// SPDX-License-Identifier: MIT
// One push as it is resolved, visit by visit: where the joints are at the film's moment, which bars are
// broken then, and which is the worst. Plays back what the worker recorded.

const FADE_BARS = 40;  // visits after which a joint's wave has faded to a third

/** Joint to its bars, made once for a list of bars: an edit makes another. */
const lists = new WeakMap();
function barsOf(model) {
  if (!lists.has(model.bars)) {
    const bars = Array.from({length: model.joints}, () => []);
    for (let k = 0; k < model.bars.length; ++k) bars[model.bars[k]].push(k >> 1);
    lists.set(model.bars, bars);
  }
  return lists.get(model.bars);
}

export class Film {
  /** `reply` of `resolution`; `tolerance` relative, or a length in Angstrom where that is above 0. */
  constructor(reply, model, {tolerance = 1e-6, tolerance_length: length = 0}) {
    Object.assign(this, {reply, model});
    this.bars = barsOf(model);
    this.count = reply.events.length / 4;
    this.within = (bar) => (length > 0 ? length / model.rest[bar] : tolerance);
    this.rewind();
  }

  rewind() {
    this.at = 0;
    this.broken = 0;
    this.positions = Float64Array.from(this.reply.pushed);
    this.off = new Float64Array(this.model.bars.length / 2);
    this.passed = new Int32Array(this.model.joints).fill(-1);
    for (let bar = 0; bar < this.off.length; ++bar) this.measure(bar);
  }

  measure(bar) {
    const {model: {bars, rest}, positions: x, off} = this;
    const [a, b] = [3 * bars[2 * bar], 3 * bars[2 * bar + 1]];
    const was = Math.abs(off[bar]) > this.within(bar);
    off[bar] = Math.hypot(x[a] - x[b], x[a + 1] - x[b + 1], x[a + 2] - x[b + 2]) / rest[bar] - 1;
    this.broken += (Math.abs(off[bar]) > this.within(bar)) - was;
  }

  /** One visit: the two joints of a bar go where the technique puts them. */
  next() {
    if (this.isOver) return;
    const {events, moved} = this.reply;
    const k = this.at++;
    for (const [end, joint] of [[0, events[4 * k + 1]], [1, events[4 * k + 2]]]) {
      this.positions.set(moved.subarray(6 * k + 3 * end, 6 * k + 3 * end + 3), 3 * joint);
      this.passed[joint] = k;
      for (const bar of this.bars[joint]) this.measure(bar);
    }
  }

  goTo(visit) {
    if (visit < this.at) this.rewind();
    while (this.at < visit && !this.isOver) this.next();
  }

  get isOver() {
    return this.at >= this.count;
  }

  /** The bar in hand with its near and far joint; -1 before the first. */
  get lit() {
    if (!this.at) return {bar: -1, near: -1, far: -1};
    const [bar, near, far] = this.reply.events.subarray(4 * this.at - 4, 4 * this.at - 1);
    return {bar, near, far};
  }

  /** From 1; 0 before the first visit. */
  get sweep() {
    return this.at ? this.reply.events[4 * this.at - 1] + 1 : 0;
  }

  /** The bar that is off the most; -1 if there is none. */
  worst() {
    let worst = -1;
    for (let bar = 0; bar < this.off.length; ++bar)
      if (worst < 0 || Math.abs(this.off[bar]) > Math.abs(this.off[worst])) worst = bar;
    return worst;
  }

  /** Shares of 1 by joint: where the repair has been. */
  wave() {
    return Float32Array.from(this.passed, (k) => (k < 0 ? 0 : Math.exp((k - this.at) / FADE_BARS)));
  }
}
