// SPDX-License-Identifier: MIT
// Where the chunks of a dataset lie, by whichever of HDF5's six indexes.
import {extensibleArray, fixedArray} from './arrays.mjs';
import {Cursor, Outside, expect} from './source.mjs';
import {newTree, oldTree} from './trees.mjs';

const [SINGLE, IMPLICIT, FIXED, EXTENSIBLE, TREE] = [1, 2, 3, 4, 5];
const IS_FILTERED_SINGLE = 2;
const PARAMETERS = {[FIXED]: 1, [EXTENSIBLE]: 5, [TREE]: 6};
const MOST_CHUNKS = 1 << 24;

/** {extents of a chunk, count: of chunks along each axis, index: {...}} of a layout message. */
export function chunkLayout(body, shape, size) {
  const version = body.uint(0, 1);
  if (version === 3) return oldLayout(body, shape, size);
  if (version !== 4 && version !== 5) throw new Outside(`a layout of version ${version}`);
  return newLayout(body, shape, size);
}

function checked(layout, shape, size) {
  const {extents} = layout;
  expect(extents.length === shape.length + 1 && extents.every((extent) => extent > 0));
  extents.pop();
  layout.bytes = extents.reduce((a, b) => a * b, size);
  layout.count = shape.map((extent, k) => Math.ceil(extent / extents[k]));
  layout.total = layout.count.reduce((a, b) => a * b, 1);
  return layout;
}

function oldLayout(body, shape, size) {
  const cursor = new Cursor(body, 2);
  const rank = cursor.uint(1);
  const address = cursor.address();
  const extents = Array.from({length: rank}, () => cursor.uint(4));
  return checked({extents, address, kind: 0}, shape, size);
}

function newLayout(body, shape, size) {
  const cursor = new Cursor(body, 2);
  const [flags, rank, width] = [cursor.uint(1), cursor.uint(1), cursor.uint(1)];
  const extents = Array.from({length: rank}, () => cursor.uint(width));
  const layout = {extents, kind: cursor.uint(1)};
  if (layout.kind === SINGLE && flags & IS_FILTERED_SINGLE) layout.single = {size: cursor.uint(8), mask: cursor.uint(4)};
  cursor.skip(PARAMETERS[layout.kind] ?? 0);
  layout.address = cursor.address();
  return checked(layout, shape, size);
}

/** Map of the number of a chunk, in the order of rows, to {address, size, mask: of filters left out}. */
export function chunksOf(source, layout, isFiltered) {
  const chunks = new Map();
  if (layout.address === null) return chunks;
  const whole = {size: layout.bytes, mask: 0};
  if (layout.kind === 0) oldChunks(source, layout, chunks);
  else if (layout.kind === SINGLE) chunks.set(0, {address: layout.address, ...(layout.single ?? whole)});
  else if (layout.kind === IMPLICIT) implicit(source, layout, chunks, whole);
  else if (layout.kind === TREE) treeChunks(source, layout, chunks, isFiltered);
  else arrayChunks(source, layout, chunks, isFiltered);
  return chunks;
}

function numberOf({count}, along) {
  return along.every((k, axis) => k < count[axis]) ? along.reduce((sum, k, axis) => sum * count[axis] + k, 0) : null;
}

function oldChunks(source, layout, chunks) {
  const rank = layout.extents.length;
  for (const [key, address] of oldTree(source, layout.address, 1, 16 + 8 * rank)) {
    const cursor = new Cursor(source, key);
    const [size, mask] = [cursor.uint(4), cursor.uint(4)];
    const along = layout.extents.map((extent) => Math.floor(cursor.uint(8) / extent));
    const number = numberOf(layout, along);
    if (number !== null) chunks.set(number, {address, size, mask});
  }
}

function implicit(source, layout, chunks, whole) {
  expect(layout.total * layout.bytes <= source.size);
  for (let k = 0; k < layout.total; ++k) chunks.set(k, {address: layout.address + k * layout.bytes, ...whole});
}

/** An element of an index: where a chunk lies, and of one that filters made how large it is. */
function element(source, at, size, {bytes}, isFiltered) {
  const address = source.address(at);
  if (!isFiltered) return {address, size: bytes, mask: 0};
  return {address, size: source.uint(at + 8, size - 12), mask: source.uint(at + size - 4, 4)};
}

function arrayChunks(source, layout, chunks, isFiltered) {
  const walk = {[FIXED]: fixedArray, [EXTENSIBLE]: extensibleArray}[layout.kind];
  if (!walk) throw new Outside(`chunks in an index of kind ${layout.kind}`);
  expect(layout.total < MOST_CHUNKS || layout.total <= source.size);
  const places = [];
  const size = walk(source, layout.address, layout.total, (number, at) => places.push([number, at]));
  for (const [number, at] of places) {
    const chunk = element(source, at, size, layout, isFiltered);
    if (chunk.address !== null) chunks.set(number, chunk);
  }
}

function treeChunks(source, layout, chunks, isFiltered) {
  const {records, recordSize} = newTree(source, layout.address);
  const size = recordSize - 8 * layout.extents.length;
  for (const at of records) {
    const chunk = element(source, at, size, layout, isFiltered);
    const cursor = new Cursor(source, at + size);
    const number = numberOf(layout, layout.extents.map(() => cursor.uint(8)));
    if (number !== null) chunks.set(number, chunk);
  }
}
