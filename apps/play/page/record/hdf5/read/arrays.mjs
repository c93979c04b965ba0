// SPDX-License-Identifier: MIT
// Where the chunks of newer files are told of: fixed and extensible arrays (HDF5 File Format
// Specification 3.0, VII.C and VII.D). Elements in the order of chunks, as places of their bytes.
import {Cursor, expect} from './source.mjs';

const CHECKSUM = 4;
const HEAD = 6;  // signature, version, client

/** Calls take(place of an element) for each of an array whose number of chunks never grows. */
export function fixedArray(source, address, most, take) {
  const cursor = new Cursor(source, address).sign('FAHD').skip(2);
  const [size, pageBits, count] = [cursor.uint(1), cursor.uint(1), cursor.uint(8)];
  const block = cursor.address();
  if (block === null) return size;
  source.sign(block, 'FADB');
  const wanted = Math.min(count, most);
  const perPage = 2 ** pageBits;
  if (count <= perPage) {
    eachOf(source, block + HEAD + 8, size, wanted, take);
    return size;
  }
  const pages = Math.ceil(count / perPage);
  const flags = block + HEAD + 8;
  let at = flags + Math.ceil(pages / 8) + CHECKSUM;
  for (let page = 0; page < pages && page * perPage < wanted; ++page) {
    const here = Math.min(perPage, count - page * perPage);
    if (isSet(source, flags, page)) eachOf(source, at, size, Math.min(here, wanted - page * perPage), take, page * perPage);
    at += here * size + CHECKSUM;
  }
  return size;
}

const isSet = (source, flags, k) => Boolean(source.uint(flags + (k >> 3), 1) & (0x80 >> (k & 7)));

function eachOf(source, at, size, count, take, first = 0) {
  source.slice(at, size * count);
  for (let k = 0; k < count; ++k) take(first + k, at + k * size);
}

/** The same of an array that grows at its end: block after block, each as large as told or twice. */
export function extensibleArray(source, address, most, take) {
  const array = extensibleHeader(source, address);
  if (array.index !== null) new Walk(source, array, most, take).all();
  return array.size;
}

function extensibleHeader(source, address) {
  const cursor = new Cursor(source, address).sign('EAHD').skip(2);
  const array = {
    size: cursor.uint(1), bits: cursor.uint(1), inIndex: cursor.uint(1), least: cursor.uint(1),
    pointers: cursor.uint(1), pageBits: cursor.uint(1),
  };
  array.index = cursor.skip(48).address();
  array.offsetSize = Math.ceil(array.bits / 8);
  expect(array.size > 0 && array.least > 0 && array.pointers > 0);
  return array;
}

class Walk {
  constructor(source, array, most, take) {
    Object.assign(this, {source, array, most, take, number: 0});
  }

  all() {
    const {source, array} = this;
    const cursor = new Cursor(source, array.index).sign('EAIB').skip(10);
    this.elements(cursor.at, array.inIndex);
    cursor.skip(array.inIndex * array.size);
    const direct = 2 * Math.log2(array.pointers);  // super blocks whose data blocks are named here
    for (let level = 0; level < direct; ++level)
      for (let k = 0; k < 2 ** (level >> 1); ++k) this.data(cursor.address(), this.length(level));
    for (let level = direct; this.number < this.most; ++level) this.above(cursor.address(), level);
  }

  /** Elements of each data block of a super block. */
  length(level) {
    return this.array.least * 2 ** ((level + 1) >> 1);
  }

  above(address, level) {
    const [blocks, length] = [2 ** (level >> 1), this.length(level)];
    expect(level < 64);
    if (address === null) {
      this.number += blocks * length;
      return;
    }
    const {source, array} = this;
    const cursor = new Cursor(source, address).sign('EASB').skip(10 + array.offsetSize);
    const pages = length / 2 ** array.pageBits;
    const flags = cursor.at;
    if (pages > 1) cursor.skip(blocks * Math.ceil(pages / 8));
    for (let k = 0; k < blocks && this.number < this.most; ++k)
      this.data(cursor.address(), length, flags + k * Math.ceil(pages / 8));
  }

  data(address, length, flags) {
    if (address === null || this.number >= this.most) {
      this.number += length;
      return;
    }
    const {source, array} = this;
    const at = source.sign(address, 'EADB') + 10 + array.offsetSize;
    const perPage = 2 ** array.pageBits;
    if (length <= perPage) this.elements(at, length);
    else this.pages(at + CHECKSUM, length, perPage, flags);
  }

  pages(at, length, perPage, flags) {
    for (let page = 0; page < length / perPage; ++page) {
      if (isSet(this.source, flags, page)) this.elements(at + page * (perPage * this.array.size + CHECKSUM), perPage);
      else this.number += perPage;
    }
  }

  elements(at, count) {
    const wanted = Math.max(0, Math.min(count, this.most - this.number));
    eachOf(this.source, at, this.array.size, wanted, this.take, this.number);
    this.number += count;
  }
}
