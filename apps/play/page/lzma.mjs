// SPDX-License-Identifier: MIT
// Unpacks LZMA (Pavlov's specification of 2015, LZMA SDK 9.35), which the solver is packed by: two
// thirds of what gzip leaves of it. One stream of known length, read once.

const [LITERAL_STATES, BITS, HALF, SHIFT] = [7, 11, 1024, 5];
const LEAST_MATCH = 2;
const [ALIGN_BITS, FIRST_MODEL, LAST_MODEL] = [4, 4, 14];

const halves = (count) => new Uint16Array(count).fill(HALF);

/** Bits of the stream, each by a probability that follows them. */
class Range {
  constructor(bytes, at) {
    Object.assign(this, {bytes, at: at + 5, range: 0xffffffff, code: 0});
    for (let k = at + 1; k < at + 5; ++k) this.code = (this.code << 8 | bytes[k]) >>> 0;
  }

  more() {
    if (this.range >= 0x1000000) return;
    if (this.at >= this.bytes.length) throw new Error('what is packed in this page is cut short');
    this.range = (this.range << 8) >>> 0;
    this.code = (this.code << 8 | this.bytes[this.at++]) >>> 0;
  }

  bit(odds, k) {
    const bound = Math.imul(this.range >>> BITS, odds[k]) >>> 0;
    const isOne = this.code >= bound;
    if (isOne) {
      this.code -= bound;
      this.range -= bound;
      odds[k] -= odds[k] >> SHIFT;
    } else {
      this.range = bound;
      odds[k] += (2048 - odds[k]) >> SHIFT;
    }
    this.more();
    return isOne ? 1 : 0;
  }

  direct(count) {
    let value = 0;
    for (let k = 0; k < count; ++k) {
      this.range >>>= 1;
      const isOne = this.code >= this.range;
      if (isOne) this.code -= this.range;
      value = value << 1 | (isOne ? 1 : 0);
      this.more();
    }
    return value;
  }

  /** A number of so many bits by a tree of odds that begins at `from`. */
  tree(odds, from, count) {
    let node = 1;
    for (let k = 0; k < count; ++k) node = node << 1 | this.bit(odds, from + node);
    return node - (1 << count);
  }

  /** The same, its lowest bit first. */
  reverse(odds, from, count) {
    let [node, value] = [1, 0];
    for (let k = 0; k < count; ++k) {
      const bit = this.bit(odds, from + node);
      node = node << 1 | bit;
      value |= bit << k;
    }
    return value;
  }
}

/** Lengths of matches: short, middle and long ones. */
class Lengths {
  constructor() {
    Object.assign(this, {choice: halves(2), low: halves(16 << 3), middle: halves(16 << 3), high: halves(256)});
  }

  next(range, place) {
    if (!range.bit(this.choice, 0)) return range.tree(this.low, place << 3, 3);
    if (!range.bit(this.choice, 1)) return 8 + range.tree(this.middle, place << 3, 3);
    return 16 + range.tree(this.high, 0, 8);
  }
}

class Decoder {
  constructor(bytes) {
    const view = new DataView(bytes.buffer, bytes.byteOffset);
    const props = bytes[0];
    this.lc = props % 9;
    this.lp = Math.floor(props / 9) % 5;
    this.pb = Math.floor(props / 45);
    this.out = new Uint8Array(view.getUint32(5, true));
    this.range = new Range(bytes, 13);
    this.literals = halves(0x300 << (this.lc + this.lp));
    Object.assign(this, {
      isMatch: halves(12 << 4), isRep: halves(12), isRep0: halves(12), isRep0Long: halves(12 << 4),
      isRep1: halves(12), isRep2: halves(12), slots: halves(4 << 6), special: halves(128), align: halves(16),
      lengths: new Lengths(), repLengths: new Lengths(), state: 0, at: 0, reps: [0, 0, 0, 0],
    });
  }

  all() {
    const {out, range} = this;
    while (this.at < out.length) {
      const place = this.at & ((1 << this.pb) - 1);
      if (!range.bit(this.isMatch, (this.state << 4) + place)) this.literal();
      else this.copy(this.match(place));
    }
    return out;
  }

  literal() {
    const {out, range, literals, at} = this;
    const before = at ? out[at - 1] : 0;
    const kind = ((at & ((1 << this.lp) - 1)) << this.lc) + (before >> (8 - this.lc));
    const from = 0x300 * kind;
    let symbol = 1;
    if (this.state >= LITERAL_STATES) {
      let other = out[at - this.reps[0] - 1];
      do {
        const bit = other >> 7 & 1;
        other <<= 1;
        const found = range.bit(literals, from + ((1 + bit) << 8) + symbol);
        symbol = symbol << 1 | found;
        if (bit !== found) break;
      } while (symbol < 0x100);
    }
    while (symbol < 0x100) symbol = symbol << 1 | range.bit(literals, from + symbol);
    out[this.at++] = symbol;
    this.state = this.state < 4 ? 0 : this.state - (this.state < 10 ? 3 : 6);
  }

  /** Length of a match; its distance becomes the first of those held. */
  match(place) {
    const {range, reps} = this;
    const wasLiteral = this.state < LITERAL_STATES;
    if (!range.bit(this.isRep, this.state)) {
      reps.pop();
      const length = this.lengths.next(range, place);
      reps.unshift(this.distance(length));
      this.state = wasLiteral ? 7 : 10;
      return length + LEAST_MATCH;
    }
    if (!range.bit(this.isRep0, this.state)) {
      if (!range.bit(this.isRep0Long, (this.state << 4) + place)) {
        this.state = wasLiteral ? 9 : 11;
        return 1;
      }
    } else {
      const which = !range.bit(this.isRep1, this.state) ? 1 : range.bit(this.isRep2, this.state) ? 3 : 2;
      reps.unshift(...reps.splice(which, 1));
    }
    const length = this.repLengths.next(range, place);
    this.state = wasLiteral ? 8 : 11;
    return length + LEAST_MATCH;
  }

  distance(length) {
    const {range} = this;
    const slot = range.tree(this.slots, Math.min(length, 3) << 6, 6);
    if (slot < FIRST_MODEL) return slot;
    const bits = (slot >> 1) - 1;
    const base = (2 | slot & 1) << bits;
    if (slot < LAST_MODEL) return base + range.reverse(this.special, base - slot, bits);
    return base + (range.direct(bits - ALIGN_BITS) << ALIGN_BITS) + range.reverse(this.align, 0, ALIGN_BITS);
  }

  copy(length) {
    const {out} = this;
    const far = this.reps[0] + 1;
    if (far > this.at || this.at + length > out.length) throw new Error('what is packed in this page is damaged');
    for (let k = 0; k < length; ++k, ++this.at) out[this.at] = out[this.at - far];
  }
}

/** Bytes of a stream with a header of 13 bytes: properties, size of the dictionary, length. */
export const unpacked = (bytes) => new Decoder(bytes).all();
