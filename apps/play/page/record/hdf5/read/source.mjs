// SPDX-License-Identifier: MIT
// The bytes of an HDF5 file: whatever lies outside them, or is not what it must be, is damage.

export class Damaged extends Error {
  constructor() {
    super('expected an HDF5 file that can be read, found one that is damaged or cut short');
  }
}

/** HDF5 has it, the page does not read it. */
export class Outside extends Error {
  constructor(what) {
    super(`found ${what}, which the page does not read (h5repack -f GZIP=1 writes another file of it)`);
  }
}

const SIGNATURE = [0x89, 0x48, 0x44, 0x46, 0x0d, 0x0a, 0x1a, 0x0a];
const FIRST_PLACES = 8;  // of a signature: 0, 512, 1024, ...

export const isHdf5At = (bytes, at) => SIGNATURE.every((byte, k) => bytes[at + k] === byte);

/** Where the file begins within the bytes: some have a block of their user before it. */
export function beginning(bytes) {
  for (let k = 0, at = 0; k < FIRST_PLACES; ++k, at = at ? 2 * at : 512) if (isHdf5At(bytes, at)) return at;
  throw new Damaged();
}

export function expect(isRight) {
  if (!isRight) throw new Damaged();
}

export class Source {
  constructor(bytes) {
    this.bytes = bytes;
    this.size = bytes.length;
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  }

  /** An unsigned number of so many bytes; those that no number of JavaScript holds are damage. */
  uint(at, size) {
    expect(at >= 0 && at + size <= this.size);
    if (size === 1) return this.bytes[at];
    if (size === 2) return this.view.getUint16(at, true);
    if (size === 4) return this.view.getUint32(at, true);
    let value = 0;
    for (let k = size - 1; k >= 0; --k) value = value * 256 + this.bytes[at + k];
    expect(Number.isSafeInteger(value));
    return value;
  }

  /** An address, or null for that of nothing. */
  address(at) {
    expect(at >= 0 && at + 8 <= this.size);
    if (this.view.getUint32(at, true) === 0xffffffff && this.view.getUint32(at + 4, true) === 0xffffffff) return null;
    return this.uint(at, 8);
  }

  slice(at, size) {
    expect(at !== null && at >= 0 && size >= 0 && at + size <= this.size);
    return this.bytes.subarray(at, at + size);
  }

  sign(at, letters) {
    expect(String.fromCharCode(...this.slice(at, letters.length)) === letters);
    return at + letters.length;
  }
}

/** Reads one field after the other. */
export class Cursor {
  constructor(source, at = 0) {
    Object.assign(this, {source, at});
  }

  uint(size) {
    const value = this.source.uint(this.at, size);
    this.at += size;
    return value;
  }

  address() {
    const value = this.source.address(this.at);
    this.at += 8;
    return value;
  }

  slice(size) {
    const value = this.source.slice(this.at, size);
    this.at += size;
    return value;
  }

  skip(size) {
    this.at += size;
    return this;
  }

  sign(letters) {
    this.at = this.source.sign(this.at, letters);
    return this;
  }
}

const decoder = new TextDecoder();

/** Text to its end or its first zero. */
export function textOf(bytes) {
  const end = bytes.indexOf(0);
  return decoder.decode(end < 0 ? bytes : bytes.subarray(0, end));
}
