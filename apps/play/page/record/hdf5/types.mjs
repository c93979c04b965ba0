// SPDX-License-Identifier: MIT
// Types and extents of values, as messages of HDF5's object headers have them (HDF5 File Format
// Specification 3.0, IV.A.2).
import {encoded, packed} from './pen.mjs';

const FIXED = 0x10;
const FLOAT = 0x11;
const STRING = 0x13;
const VARIABLE = 0x19;
const SIGNED = 0x08;
const UTF8 = 1;
export const REFERENCE = 16;  // bytes of a text that lies in the heap

const integer = (size, bits) => packed([[1, FIXED], [1, bits], [2, 0], [4, size], [2, 0], [2, 8 * size]]);
const raw = (array) => new Uint8Array(array.buffer, array.byteOffset, array.byteLength);

// IEEE 754: the mantissa's first bit is implied; where sign, exponent and mantissa are.
const DOUBLE = packed([[1, FLOAT], [1, 0x20], [1, 63], [1, 0], [4, 8], [2, 0], [2, 64],
  [1, 52], [1, 11], [1, 0], [1, 52], [4, 1023]]);
const TEXT = packed([[1, VARIABLE], [1, 1], [1, UTF8], [1, 0], [4, REFERENCE], integer(1, 0)]);

const OF_ARRAYS = new Map([
  [Float64Array, DOUBLE], [BigInt64Array, integer(8, SIGNED)], [Int32Array, integer(4, SIGNED)],
  [Uint32Array, integer(4, 0)], [Uint8Array, integer(1, 0)],
]);

/** Numbers: {type, size of one, bytes}. */
export function numbers(array) {
  return {type: OF_ARRAYS.get(array.constructor), size: array.BYTES_PER_ELEMENT, bytes: raw(array)};
}

/** Texts of any length, which the file's heap keeps. */
export const texts = (list) => ({type: TEXT, size: REFERENCE, texts: list.map(encoded)});

/** Texts side by side, as long as the longest. */
export function fixedTexts(list) {
  const each = list.map(encoded);
  const size = each.reduce((most, text) => Math.max(most, text.length), 1);
  const bytes = new Uint8Array(size * each.length);
  each.forEach((text, k) => bytes.set(text, size * k));
  return {type: packed([[1, STRING], [1, 1 | UTF8 << 4], [2, 0], [4, size]]), size, bytes};
}

/** A dataspace; [] is a single value. `most`: extents that it may grow to, null without an end. */
export function space(shape, most = null) {
  const extents = shape.map((extent) => [8, extent]);
  const ends = (most ?? []).map((extent) => [8, extent ?? 0xffffffffffffffffn]);
  return packed([[1, 1], [1, shape.length], [1, most ? 1 : 0], [5, 0], ...extents, ...ends]);
}
