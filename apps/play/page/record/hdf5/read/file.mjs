// SPDX-License-Identifier: MIT
// An HDF5 file in memory: groups, datasets and attributes by their paths. Superblocks 0 to 3.
import {Dataset} from './dataset.mjs';
import {MESSAGE, messagesAt} from './header.mjs';
import {followed, inHeap, linksOf} from './links.mjs';
import {Cursor, Outside, Source, beginning, expect, textOf} from './source.mjs';
import {heapOf, shapeOf, typeOf, valuesOf} from './types.mjs';

const MOST_LINKS = 32;  // of links that stand for links
const padded = (size) => (size + 7) & ~7;

function rootOf(source) {
  const version = source.uint(8, 1);
  expect(version <= 3);
  const widths = version < 2 ? [13, 14] : [9, 10];
  if (widths.some((at) => source.uint(at, 1) !== 8)) throw new Outside('addresses that are not of 8 bytes');
  if (version >= 2) return source.address(36);
  return source.address(24 + (version === 1 ? 4 : 0) + 32 + 8);
}

/** A group, or what attributes share of all objects. */
class Item {
  constructor(file, messages) {
    Object.assign(this, {file, messages});
  }

  /** Value of an attribute: a text, a number or a list of them; undefined if there is none. */
  attribute(name) {
    const body = this.#attributes().get(name);
    return body && attributeValue(this.file, body);
  }

  attributeNames() {
    return [...this.#attributes().keys()];
  }

  #attributes() {
    if (this.known) return this.known;
    this.known = new Map();
    for (const {kind, body} of this.messages) {
      if (kind === MESSAGE.attribute) this.known.set(attributeName(body), body);
      else if (kind === MESSAGE.attributeInfo) this.#many(body);
    }
    return this.known;
  }

  #many(body) {
    const at = body.uint(1, 1) & 1 ? 4 : 2;
    const heap = body.address(at);
    if (heap === null) return;
    for (const one of inHeap(this.file.source, heap, body.address(at + 8), 0)) this.known.set(attributeName(one), one);
  }
}

class Group extends Item {
  constructor(file, messages, links) {
    super(file, messages);
    Object.assign(this, {kind: 'group', links});
  }

  names() {
    return [...this.links.keys()].sort();
  }
}

function attributeParts(body) {
  const cursor = new Cursor(body);
  const version = cursor.uint(1);
  expect(version >= 1 && version <= 3);
  if (version > 1 && body.uint(1, 1)) throw new Outside('an attribute of a type that has a name');
  cursor.skip(1);
  const sizes = [cursor.uint(2), cursor.uint(2), cursor.uint(2)];
  if (version === 3) cursor.skip(1);
  const [name, type, space] = sizes.map((size) => {
    const part = cursor.slice(size);
    if (version === 1) cursor.skip(padded(size) - size);
    return part;
  });
  return {name: textOf(name), type, space, rest: cursor.at};
}

/** Its name alone: an attribute of a strange type harms those only that ask for it. */
function attributeName(body) {
  const version = body.uint(0, 1);
  return textOf(body.slice(version === 3 ? 9 : 8, body.uint(2, 2)));
}

function attributeValue(file, body) {
  const {type: typeBytes, space, rest} = attributeParts(body);
  const type = typeOf(new Source(typeBytes));
  const shape = shapeOf(new Source(space));
  if (shape === null) return [];
  const count = shape.reduce((a, b) => a * b, 1);
  expect(count * type.size <= body.size);
  const values = valuesOf(type, body.slice(rest, count * type.size), count, file.heap);
  return shape.length ? values : values[0];
}

export class Hdf5File {
  constructor(bytes) {
    this.source = new Source(bytes.subarray(beginning(bytes)));
    this.heap = heapOf(this.source);
    this.root = rootOf(this.source);
  }

  /** Group {kind, names()} or dataset {kind, shape, read()} of this path, or null; all have
   * attribute(name). Throws Error for what is damaged or not read. */
  get(path) {
    const address = this.#addressOf(path.split('/').filter(Boolean));
    return address === null ? null : this.#at(address);
  }

  #at(address) {
    const messages = messagesAt(this.source, address);
    const links = linksOf(this.source, messages);
    if (links) return new Group(this, messages, links);
    const item = new Item(this, messages);
    if (!messages.some(({kind}) => kind === MESSAGE.space)) return Object.assign(item, {kind: 'type'});
    const dataset = new Dataset(this, messages);
    dataset.attribute = (name) => item.attribute(name);
    dataset.attributeNames = () => item.attributeNames();
    return dataset;
  }

  #addressOf(names) {
    let [address, above, followedLinks] = [this.root, [], 0];
    const left = [...names];
    while (left.length) {
      const name = left.shift();
      const link = this.#links(address)?.get(name);
      if (!link) return null;
      const {path} = followed(link, name);
      if (path === undefined) {
        address = link.address;
        above.push(name);
        continue;
      }
      expect(++followedLinks < MOST_LINKS);
      left.unshift(...(path.startsWith('/') ? [] : above), ...path.split('/').filter((part) => part && part !== '.'));
      [address, above] = [this.root, []];
    }
    return address;
  }

  #links(address) {
    this.groups ??= new Map();
    if (!this.groups.has(address)) this.groups.set(address, linksOf(this.source, messagesAt(this.source, address)));
    return this.groups.get(address);
  }
}
