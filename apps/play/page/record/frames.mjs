// SPDX-License-Identifier: MIT
// The frames that are held: what was seen, to be shown again and saved.

const MOST_BYTES = 768 * 1024 * 1024;

/** A frame: positions (Float64Array, Angstrom), broken (Float32Array, before the repair), sweeps... */
export class Frames {
  constructor() {
    this.clear();
  }

  clear() {
    this.list = [];
    this.bytes = 0;
    this.isFull = false;
  }

  get length() {
    return this.list.length;
  }

  at(index) {
    return this.list.at(index);
  }

  /** False if there is no room for more. */
  add(frame) {
    const size = frame.positions.byteLength + (frame.broken?.byteLength ?? 0);
    this.isFull = this.bytes + size > MOST_BYTES;
    if (this.isFull) return false;
    this.list.push(frame);
    this.bytes += size;
    return true;
  }

  /** Takes those after a step away; the first, the start, stays. */
  dropAfter(step) {
    while (this.list.length > 1 && this.list.at(-1).step > step) {
      const frame = this.list.pop();
      this.bytes -= frame.positions.byteLength + (frame.broken?.byteLength ?? 0);
    }
  }
}
