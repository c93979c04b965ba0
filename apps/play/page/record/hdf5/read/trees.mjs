// SPDX-License-Identifier: MIT
// B-trees of both versions, as lists of what they hold. A tree that comes back to itself, or whose
// levels do not go down by one, is damage.
import {Cursor, expect} from './source.mjs';

const MOST_NODES = 1 << 22;

/** Children of a tree of version 1: [cursor at the key, address of the child], leaves only. */
export function* oldTree(source, root, kind, keySize) {
  const waiting = [{address: root, level: null}];
  for (let seen = 0; waiting.length; ++seen) {
    expect(seen < MOST_NODES && seen <= source.size / 24);
    const {address, level} = waiting.pop();
    const cursor = new Cursor(source, address).sign('TREE');
    expect(cursor.uint(1) === kind);
    const own = cursor.uint(1);
    expect(level === null || own === level);
    const count = cursor.uint(2);
    cursor.skip(16);
    const children = [];
    for (let k = 0; k < count; ++k) {
      const key = cursor.at;
      children.push([key, cursor.skip(keySize).address()]);
    }
    if (own === 0) yield* children;
    else for (const [, child] of children.reverse()) waiting.push({address: child, level: own - 1});
  }
}

const sizeOf = (most) => Math.floor(Math.log2(Math.max(most, 1)) / 8) + 1;  // bytes of a number up to it

/** Records of a tree of version 2, each the place of its bytes. */
export function newTree(source, address) {
  const cursor = new Cursor(source, address).sign('BTHD').skip(2);
  const [nodeSize, recordSize, depth] = [cursor.uint(4), cursor.uint(2), cursor.uint(2)];
  const root = cursor.skip(2).address();
  const count = cursor.uint(2);
  expect(recordSize > 0 && nodeSize > 0 && depth < 32);
  const levels = levelSizes(nodeSize, recordSize, depth);
  const found = {source, recordSize, levels, records: []};
  if (root !== null) nodeAt(found, root, count, depth);
  return {records: found.records, recordSize};
}

/** How many bytes tell of records in a child, and of all below it, by level. */
function levelSizes(nodeSize, recordSize, depth) {
  const most = Math.floor((nodeSize - 10) / recordSize);
  const levels = [{count: sizeOf(most), all: 0, most, total: most}];
  for (let level = 1; level <= depth; ++level) {
    const below = levels[level - 1];
    const pointer = 8 + levels[0].count + (level > 1 ? sizeOf(below.total) : 0);
    const here = Math.floor((nodeSize - 10 - pointer) / (recordSize + pointer));
    levels.push({count: levels[0].count, all: level > 1 ? sizeOf(below.total) : 0, total: (here + 1) * below.total + here});
  }
  return levels;
}

function nodeAt(found, address, count, level) {
  const {source, recordSize, levels, records} = found;
  const cursor = new Cursor(source, address).sign(level ? 'BTIN' : 'BTLF').skip(2);
  expect(records.length + count < MOST_NODES && records.length <= source.size);
  for (let k = 0; k < count; ++k) {
    records.push(cursor.at);
    cursor.skip(recordSize);
  }
  for (let k = 0; level && k <= count; ++k) {
    const [child, inside] = [cursor.address(), cursor.uint(levels[level].count)];
    cursor.skip(levels[level].all);
    nodeAt(found, child, inside, level - 1);
  }
}
