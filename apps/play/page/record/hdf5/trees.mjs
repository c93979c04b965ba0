// SPDX-License-Identifier: MIT
// B-trees of version 1 (HDF5 File Format Specification III.A.1): of the links of a group, and of the
// chunks of a dataset. All entries are known, so a tree is made from its leaves up, full nodes first.
import {UNDEFINED, encoded, packed} from './pen.mjs';

export const LINKS = {kind: 0, most: 32, leaf: 8};  // most children of a node; links of a leaf
const CHUNKS = {kind: 1, most: 64};

const sliced = (list, most) =>
  Array.from({length: Math.ceil(list.length / most)}, (_, k) => list.slice(most * k, most * (k + 1)));

/** Children {key, address} under one another, `last`: the key after them all. Returns the address. */
function tree(pen, {kind, most}, children, last, level = 0) {
  const groups = sliced(children, most);
  const keySize = last.length;
  const size = 24 + most * 8 + (most + 1) * keySize;
  const start = pen.size;
  const place = (k) => (k < 0 || k >= groups.length ? UNDEFINED : start + size * k);
  const above = groups.map((group, k) => {
    const pairs = group.flatMap(({key, address}) => [key, [8, address]]);
    const end = groups[k + 1]?.[0].key ?? last;
    const used = packed([encoded('TREE'), [1, kind], [1, level], [2, group.length],
      [8, place(k - 1)], [8, place(k + 1)], ...pairs, end]);
    return {key: group[0].key, address: pen.add(packed([used, [size - used.length, 0]]))};
  });
  return above.length === 1 ? above[0].address : tree(pen, {kind, most}, above, last, level + 1);
}

function leaf(links) {
  const entries = links.flatMap(({place, header}) => [[8, place], [8, header], [24, 0]]);
  const used = packed([encoded('SNOD'), [1, 1], [1, 0], [2, links.length], ...entries]);
  return packed([used, [8 + 40 * LINKS.leaf - used.length, 0]]);
}

/** The links of a group, {place of the name in the heap, address of the header}, sorted by name. */
export function linkTree(pen, links) {
  const leaves = sliced(links, LINKS.leaf);
  const key = (place) => packed([[8, place]]);
  let before = 0;  // the empty name, before all others
  const children = leaves.map((some) => {
    const child = {key: key(before), address: pen.add(leaf(some))};
    before = some.at(-1).place;
    return child;
  });
  if (!children.length) children.push({key: key(0), address: pen.add(leaf([]))});
  return tree(pen, LINKS, children, key(before));
}

/** Chunks {at: first element, size, address} in their order. */
export function chunkTree(pen, chunks, end) {
  const key = (at, size) => packed([[4, size], [4, 0], ...at.map((x) => [8, x]), [8, 0]]);
  return tree(pen, CHUNKS, chunks.map(({at, size, address}) => ({key: key(at, size), address})), key(end, 0));
}
