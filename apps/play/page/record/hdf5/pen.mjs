// SPDX-License-Identifier: MIT
// Bytes of a file that grows at its end: pieces one after the other, each at a multiple of eight.

export const UNDEFINED = 0xffffffffffffffffn;  // the address of what is nowhere

const encoder = new TextEncoder();
export const encoded = (text) => encoder.encode(text);
export const aligned = (size) => (size + 7) & ~7;

/** [number of bytes, value] one after the other, little-endian, or bytes as they are. */
export function packed(fields) {
  const size = fields.reduce((sum, field) => sum + (ArrayBuffer.isView(field) ? field.length : field[0]), 0);
  const bytes = new Uint8Array(size);
  const view = new DataView(bytes.buffer);
  let at = 0;
  for (const field of fields) at += put(view, bytes, at, field);
  return bytes;
}

function put(view, bytes, at, field) {
  if (ArrayBuffer.isView(field)) {
    bytes.set(field, at);
    return field.length;
  }
  const [size, value] = field;
  if (size === 1) view.setUint8(at, Number(value));
  else if (size === 2) view.setUint16(at, Number(value), true);
  else if (size === 4) view.setUint32(at, Number(value), true);
  else if (size === 8) view.setBigUint64(at, BigInt(value), true);
  return size;  // any other: zeros
}

/** The same bytes, longer by zeros. */
export function padded(bytes, size = aligned(bytes.length)) {
  if (bytes.length === size) return bytes;
  const longer = new Uint8Array(size);
  longer.set(bytes);
  return longer;
}

export class Pen {
  constructor() {
    this.pieces = [];
    this.size = 0;
  }

  /** Appends; returns the address. The bytes are not copied before all() is asked for. */
  add(bytes) {
    const address = this.size;
    this.pieces.push(bytes);
    this.size += aligned(bytes.length);
    return address;
  }

  all() {
    const whole = new Uint8Array(this.size);
    let at = 0;
    for (const piece of this.pieces) {
      whole.set(piece, at);
      at += aligned(piece.length);
    }
    return whole;
  }
}
