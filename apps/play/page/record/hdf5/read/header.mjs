// SPDX-License-Identifier: MIT
// The header of an object: its messages, of both versions of headers (HDF5 File Format
// Specification 3.0, IV.A.1).
import {Cursor, Outside, Source, expect} from './source.mjs';

export const MESSAGE = {
  space: 1, linkInfo: 2, type: 3, oldFill: 4, fill: 5, link: 6, external: 7, layout: 8, filters: 11,
  attribute: 12, more: 16, links: 17, attributeInfo: 21,
};
const SHARED = 2;  // flag of a message whose content lies elsewhere
const MOST_BLOCKS = 10000;

/** Messages {kind, body: Source} of the object at this address. */
export function messagesAt(source, address) {
  expect(address !== null);
  const isNew = source.uint(address, 1) === 0x4f;  // 'O' of OHDR
  const first = isNew ? newStart(source, address) : oldStart(source, address);
  const messages = [];
  const blocks = [first.block];
  for (let k = 0; k < blocks.length; ++k) {
    expect(k < MOST_BLOCKS);
    for (const message of blockMessages(source, blocks[k], first)) {
      if (message.kind === MESSAGE.more) blocks.push(nextBlock(source, message.body, isNew));
      else messages.push(resolved(source, message));
    }
  }
  return messages;
}

function oldStart(source, address) {
  expect(source.uint(address, 1) === 1);
  return {block: {at: address + 16, size: source.uint(address + 8, 4)}, isNew: false};
}

function newStart(source, address) {
  const cursor = new Cursor(source, address).sign('OHDR');
  expect(cursor.uint(1) === 2);
  const flags = cursor.uint(1);
  if (flags & 0x20) cursor.skip(16);
  if (flags & 0x10) cursor.skip(4);
  const size = cursor.uint(1 << (flags & 3));
  return {block: {at: cursor.at, size}, isNew: true, isOrdered: Boolean(flags & 4)};
}

function nextBlock(source, body, isNew) {
  const at = body.address(0);
  const size = body.uint(8, 8);
  if (!isNew) return {at, size};
  return {at: source.sign(at, 'OCHK'), size: size - 8};  // a checksum follows
}

function* blockMessages(source, {at, size}, {isNew, isOrdered}) {
  source.slice(at, size);
  const head = isNew ? (isOrdered ? 6 : 4) : 8;
  let place = at;
  while (place + head <= at + size) {
    const kind = source.uint(place, isNew ? 1 : 2);
    const length = source.uint(place + (isNew ? 1 : 2), 2);
    const flags = source.uint(place + (isNew ? 3 : 4), 1);
    place += head;
    expect(place + length <= at + size);
    yield {kind, flags, body: new Source(source.slice(place, length))};
    place += length;
  }
}

/** A type that has a name of its own lies in another header. */
function resolved(source, {kind, flags, body}) {
  if (!(flags & SHARED)) return {kind, body};
  const version = body.uint(0, 1);
  const isCommitted = version < 3 || body.uint(1, 1) === 2;
  if (kind !== MESSAGE.type || !isCommitted) throw new Outside('header messages that objects share');
  const start = oldOrNewBlock(source, body.address(version === 1 ? 8 : 2));
  for (const message of blockMessages(source, start.block, start))
    if (message.kind === kind && !(message.flags & SHARED)) return {kind, body: message.body};
  throw new Outside('a type that cannot be found');
}

function oldOrNewBlock(source, address) {
  expect(address !== null);
  return source.uint(address, 1) === 0x4f ? newStart(source, address) : oldStart(source, address);
}
