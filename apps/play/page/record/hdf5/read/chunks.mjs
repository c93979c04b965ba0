// SPDX-License-Identifier: MIT
// Where the chunks of a dataset lie: by a tree, as all write it but who asks for the newest format.
import {Cursor, Outside, expect} from './source.mjs';
import {oldTree} from './trees.mjs';

/** {extents of a chunk, count: of chunks along each axis, address: of the tree} of a layout message. */
export function chunkLayout(body, shape, size) {
  if (body.uint(0, 1) !== 3) throw new Outside('chunks in the newest format of HDF5 (libver="latest")');
  const cursor = new Cursor(body, 2);
  const rank = cursor.uint(1);
  const address = cursor.address();
  const extents = Array.from({length: rank}, () => cursor.uint(4));
  expect(extents.length === shape.length + 1 && extents.every((extent) => extent > 0));
  extents.pop();
  const count = shape.map((extent, k) => Math.ceil(extent / extents[k]));
  return {extents, address, bytes: extents.reduce((a, b) => a * b, size), count};
}

/** Map of the number of a chunk, in the order of rows, to {address, size, mask: of filters left out}. */
export function chunksOf(source, layout) {
  const chunks = new Map();
  if (layout.address === null) return chunks;
  const rank = layout.extents.length;
  for (const [key, address] of oldTree(source, layout.address, 1, 16 + 8 * rank)) {
    const cursor = new Cursor(source, key);
    const [size, mask] = [cursor.uint(4), cursor.uint(4)];
    const along = layout.extents.map((extent) => Math.floor(cursor.uint(8) / extent));
    const number = numberOf(layout, along);
    if (number !== null) chunks.set(number, {address, size, mask});
  }
  return chunks;
}

function numberOf({count}, along) {
  return along.every((k, axis) => k < count[axis]) ? along.reduce((sum, k, axis) => sum * count[axis] + k, 0) : null;
}
