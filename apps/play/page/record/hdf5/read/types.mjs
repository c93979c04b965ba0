// SPDX-License-Identifier: MIT
// Types and extents, and values of them. What has no place in an array of JavaScript is not read.
import {Cursor, Damaged, Outside, Source, expect, textOf} from './source.mjs';

const CLASSES = ['integers', 'floats', 'times', 'texts', 'bit fields', 'opaque values', 'compounds',
  'references', 'enumerations', 'sequences of any length', 'arrays'];
const MOST_RANK = 32;

/** Extents of a dataspace: [] of a single value, null where there is none. */
export function shapeOf(body) {
  const version = body.uint(0, 1);
  const rank = body.uint(1, 1);
  expect((version === 1 || version === 2) && rank <= MOST_RANK);
  if (version === 2 && body.uint(3, 1) === 2) return null;
  const cursor = new Cursor(body, version === 1 ? 8 : 4);
  return Array.from({length: rank}, () => cursor.uint(8));
}

const INTEGERS = {1: [Int8Array, Uint8Array], 2: [Int16Array, Uint16Array], 4: [Int32Array, Uint32Array],
  8: [BigInt64Array, BigUint64Array]};
const FLOATS = {4: Float32Array, 8: Float64Array};

/** {name, size, array | isText, ...}; reading values of an unknown kind throws Outside. */
export function typeOf(body) {
  const kind = body.uint(0, 1) & 15;
  const bits = body.uint(1, 1);
  const size = body.uint(4, 4);
  expect(size > 0);
  const type = {kind, size, name: CLASSES[kind] ?? 'values of an unknown type', isBig: Boolean(bits & 1)};
  if (kind === 0) return {...type, array: INTEGERS[size]?.[bits & 8 ? 0 : 1]};
  if (kind === 1) return {...type, array: FLOATS[size]};
  if (kind === 3) return {...type, isBig: false, isText: true, isSpaced: (bits & 15) === 2};
  if (kind === 7) return {...type, isBig: false, array: size === 8 ? BigUint64Array : undefined};
  if (kind === 8) return {...typeOf(new Source(body.slice(8, body.size - 8))), isEnumeration: true};
  if (kind === 9 && (bits & 15) === 1) return {...type, isBig: false, isText: true, isVariable: true};
  return type;
}

function swapped(bytes, size) {
  const turned = new Uint8Array(bytes.length);
  for (let k = 0; k < bytes.length; ++k) turned[k] = bytes[k - k % size + size - 1 - k % size];
  return turned;
}

/** An array of numbers, or of texts, of the bytes of `count` values. */
export function valuesOf(type, bytes, count, heap) {
  expect(bytes.length >= count * type.size);
  if (type.isText) return Array.from({length: count}, (_, k) => textAt(type, bytes.subarray(k * type.size, (k + 1) * type.size), heap));
  if (!type.array) throw new Outside(`${type.name} of ${type.size} bytes`);
  const used = bytes.subarray(0, count * type.size);
  const own = type.isBig && type.size > 1 ? swapped(used, type.size) : used.slice();
  return new type.array(own.buffer, 0, count);
}

function textAt(type, bytes, heap) {
  if (type.isVariable) return heap(bytes);
  const text = textOf(bytes);
  return type.isSpaced ? text.trimEnd() : text;
}

/** Texts of any length, by their references: from the collections of the file's heap. */
export function heapOf(source) {
  const collections = new Map();
  return (reference) => {
    const cursor = new Cursor(new Source(reference));
    const [length, address, number] = [cursor.uint(4), cursor.address(), cursor.uint(4)];
    if (!length || !address) return '';
    if (!collections.has(address)) collections.set(address, collectionAt(source, address));
    const found = collections.get(address).get(number);
    if (!found || found.length < length) throw new Damaged();
    return textOf(found.subarray(0, length));
  };
}

function collectionAt(source, address) {
  const cursor = new Cursor(source, address).sign('GCOL').skip(4);
  const end = address + cursor.uint(8);
  const objects = new Map();
  while (cursor.at + 16 <= end) {
    const number = cursor.uint(2);
    const size = cursor.skip(6).uint(8);
    if (number === 0) break;  // what is left is free
    objects.set(number, cursor.slice(size));
    cursor.at += -size & 7;
  }
  return objects;
}
