// SPDX-License-Identifier: MIT
// Links of a group: {name: address of the object, or the path that it stands for}.
import {fractalHeap} from './fractal_heap.mjs';
import {MESSAGE} from './header.mjs';
import {Cursor, Outside, expect, textOf} from './source.mjs';
import {newTree, oldTree} from './trees.mjs';

const HARD = 0;
const SOFT = 1;
const HASH = 4;  // bytes before the identifier in a record of a tree of names
const CACHED_SOFT = 2;

/** Map of names to {address} or {path}; null of what is no group. */
export function linksOf(source, messages) {
  const links = new Map();
  let isGroup = false;
  for (const {kind, body} of messages) {
    if (kind === MESSAGE.links) tableLinks(source, body, links);
    else if (kind === MESSAGE.link) put(links, body);
    else if (kind === MESSAGE.linkInfo) manyLinks(source, body, links);
    else continue;
    isGroup = true;
  }
  return isGroup ? links : null;
}

/** Of a group of old: a tree of tables, whose names lie in a heap. */
function tableLinks(source, body, links) {
  const heap = new Cursor(source, body.address(8)).sign('HEAP').skip(4);
  const size = heap.uint(8);
  const names = source.slice(heap.skip(8).address(), size);
  for (const [, table] of oldTree(source, body.address(0), 0, 8)) {
    const cursor = new Cursor(source, table).sign('SNOD').skip(2);
    for (let count = cursor.uint(2); count > 0; --count) {
      const [name, address, cache] = [cursor.uint(8), cursor.address(), cursor.uint(4)];
      const path = cursor.skip(4).uint(4);
      cursor.skip(12);
      expect(name < size && (cache !== CACHED_SOFT || path < size));
      links.set(textOf(names.subarray(name)), cache === CACHED_SOFT ? {path: textOf(names.subarray(path))} : {address});
    }
  }
}

function put(links, body) {
  const cursor = new Cursor(body);
  expect(cursor.uint(1) === 1);
  const flags = cursor.uint(1);
  const kind = flags & 8 ? cursor.uint(1) : HARD;
  cursor.skip((flags & 4 ? 8 : 0) + (flags & 16 ? 1 : 0));
  const name = textOf(cursor.slice(cursor.uint(1 << (flags & 3))));
  if (kind === HARD) links.set(name, {address: cursor.address()});
  else if (kind === SOFT) links.set(name, {path: textOf(cursor.slice(cursor.uint(2)))});
  else links.set(name, {isElsewhere: true});
}

/** Of a group with many: a heap, and a tree of their names. */
function manyLinks(source, body, links) {
  const at = body.uint(1, 1) & 1 ? 10 : 2;
  const heap = body.address(at);
  if (heap !== null) for (const link of inHeap(source, heap, body.address(at + 8), HASH)) put(links, link);
}

/** Objects of a fractal heap that the records of a tree name; `before`: bytes ahead of the identifier. */
export function* inHeap(source, heap, tree, before) {
  const object = fractalHeap(source, heap);
  const {records, recordSize} = newTree(source, tree);
  for (const at of records) yield object(source.slice(at + before, recordSize - before));
}

/** A link to another file is not followed. */
export function followed(link, name) {
  if (link.isElsewhere) throw new Outside(`"${name}" in another file`);
  return link;
}
