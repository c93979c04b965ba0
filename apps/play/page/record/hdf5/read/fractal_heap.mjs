// SPDX-License-Identifier: MIT
// The heap of groups and attributes that are many (HDF5 File Format Specification 3.0, III.G): where
// the object of an identifier lies.
import {Cursor, Outside, Source, expect} from './source.mjs';

const bytesOfBits = (bits) => Math.ceil(bits / 8);
const bytesUpTo = (most) => bytesOfBits(Math.floor(Math.log2(most)) + 1);

export function fractalHeap(source, address) {
  const cursor = new Cursor(source, address).sign('FRHP').skip(3);
  if (cursor.uint(2)) throw new Outside('links in a compressed heap');
  const mostManaged = cursor.skip(1).uint(4);
  const width = cursor.skip(12 * 8).uint(2);
  const [start, mostDirect, bits] = [cursor.uint(8), cursor.uint(8), cursor.uint(2)];
  const root = cursor.skip(2).address();
  const rows = cursor.uint(2);
  expect(width > 0 && start > 0 && mostDirect >= start && bits <= 64);
  const heap = {source, width, start, mostDirect, offsetSize: bytesOfBits(bits), root, rows,
    lengthSize: Math.min(bytesUpTo(mostDirect), bytesUpTo(Math.max(mostManaged, 1)))};
  return (identifier) => objectOf(heap, identifier);
}

function objectOf(heap, identifier) {
  if (identifier[0] >> 4 & 3) throw new Outside('a link or attribute too large for its heap');
  const cursor = new Cursor(new Source(identifier), 1);
  const offset = cursor.uint(heap.offsetSize);
  const length = cursor.uint(heap.lengthSize);
  const block = heap.rows ? blockWith(heap, heap.root, heap.rows, offset, 0) : {at: heap.root, start: 0};
  return new Source(heap.source.slice(block.at + offset - block.start, length));
}

const rowSize = (heap, row) => heap.start * 2 ** Math.max(0, row - 1);

/** The direct block that holds an offset, below an indirect one that begins at `begin`. */
function blockWith(heap, address, rows, offset, begin) {
  const cursor = new Cursor(heap.source, address).sign('FHIB').skip(9 + heap.offsetSize);
  let start = begin;
  for (let row = 0; row < rows; ++row) {
    const size = rowSize(heap, row);
    const column = Math.floor((offset - start) / size);
    if (column < heap.width) {
      const child = heap.source.address(cursor.at + 8 * (row * heap.width + column));
      const childStart = start + column * size;
      if (size <= heap.mostDirect) return {at: child, start: childStart};
      const below = Math.log2(size / (heap.start * heap.width)) + 1;
      expect(below < rows);
      return blockWith(heap, child, below, offset, childStart);
    }
    start += heap.width * size;
  }
  return expect(false);
}
