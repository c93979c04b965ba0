// SPDX-License-Identifier: MIT
// Which frame comes after which when a recording is played or scrubbed: all in turn, or an order that
// was chosen, forth and back.

const RATE = 30;  // frames a second of a recording at speed 1
const SLOW = 12;  // of frames that are independent: each is to be seen

export class FrameOrder {
  constructor(stage) {
    this.stage = stage;
    this.order = null;
    this.rounds = Infinity;  // of an order that was chosen
    stage.on('began', () => { this.order = null; });
  }

  /** Numbers of frames; null: all in turn. */
  choose(order) {
    this.order = order && order.length > 1 ? order : null;
    this.stage.tell('changed');
  }

  get last() {
    return (this.order ? this.order.length : this.stage.frames.length) - 1;
  }

  get rate() {
    return this.order ? SLOW : RATE;
  }

  frame(place) {
    return this.order ? this.order[Math.min(place, this.last)] : place;
  }

  /** Where a frame comes, -1 where the film leaves it out. */
  placeOf(frame) {
    return this.order ? this.order.indexOf(frame) : frame;
  }

  /** The place after so many steps: there and back again in an order that was chosen. */
  swung(steps) {
    if (!this.order) return Math.min(steps, this.last);
    const round = steps % (2 * this.last);
    return round <= this.last ? round : 2 * this.last - round;
  }

  /** After so many steps playing ends. */
  get end() {
    return this.order ? this.rounds * 2 * this.last : this.last;
  }
}
