// SPDX-License-Identifier: MIT
// Writes an HDF5 file in one go, in the oldest of its formats, which all that reads HDF5 reads:
// superblock 0, headers of version 1, B-trees. HDF5 File Format Specification 3.0.
import {Pen, UNDEFINED, aligned, encoded, packed, padded} from './pen.mjs';
import {LINKS, chunkTree, linkTree} from './trees.mjs';
import {REFERENCE, space} from './types.mjs';

const SUPERBLOCK = 96;
const LEAST_HEAP = 4096;
const NO_FREE_BLOCK = 1;
const MESSAGE = {space: 1, type: 3, fill: 5, layout: 8, attribute: 12, links: 17};
const WRITE_IF_SET = 2;
const [LATE, AS_IT_GROWS] = [2, 3];

class Item {
  constructor(fields = {}) {
    Object.assign(this, {attributes: []}, fields);
  }

  /** `shape` []: a single value. */
  attribute(name, value, shape = []) {
    this.attributes.push({name, value, shape});
    return this;
  }
}

/** Texts of any length: all of a file in one collection of its global heap. */
class Heap {
  constructor() {
    this.texts = [];
  }

  /** References to these; their address is where the heap will lie. */
  references(texts) {
    return packed(texts.flatMap((text) => {
      if (!text.length) return [[4, 0], [8, 0], [4, 0]];
      this.texts.push(text);
      return [[4, text.length], [8, SUPERBLOCK], [4, this.texts.length]];
    }));
  }

  bytes() {
    const objects = this.texts.flatMap((text, k) => [[2, k + 1], [2, 1], [4, 0], [8, text.length], padded(text)]);
    const used = 16 + this.texts.reduce((sum, text) => sum + 16 + aligned(text.length), 0);
    const size = Math.max(LEAST_HEAP, used + 16);
    const left = [[2, 0], [2, 0], [4, 0], [8, size - used]];
    return padded(packed([encoded('GCOL'), [1, 1], [3, 0], [8, size], ...objects, ...left]), size);
  }
}

const bytesOf = (value) => value.bytes ?? value.references;
const product = (shape) => shape.reduce((a, b) => a * b, 1);
/** By bytes, as the trees of groups are sorted. */
const byName = ([a], [b]) => (a < b ? -1 : Number(a > b));

export class Hdf5Writer {
  constructor() {
    this.root = new Item({children: new Map()});
    this.heap = new Heap();
  }

  /** The group of this path; made, with those above it, where it is missing. */
  group(path) {
    let group = this.root;
    for (const name of path.split('/').filter(Boolean)) {
      if (!group.children.has(name)) group.children.set(name, new Item({children: new Map()}));
      group = group.children.get(name);
    }
    return group;
  }

  #put(path, item) {
    const cut = path.lastIndexOf('/');
    const group = this.group(path.slice(0, Math.max(cut, 0)));
    const name = path.slice(cut + 1);
    if (group.children.has(name)) throw new Error(`${path} would be written twice`);
    group.children.set(name, item);
    return item;
  }

  /** Values of one of `numbers`, `texts`, `fixedTexts`; `shape` []: a single one. */
  dataset(path, value, shape) {
    return this.#put(path, new Item({value, shape}));
  }

  /** A dataset of rows that may grow: each row, of extents `row`, is a chunk. */
  rows(path, values, row) {
    return this.#put(path, new Item({chunks: values, shape: [values.length, ...row]}));
  }

  bytes() {
    this.#refer(this.root);
    const pen = new Pen();
    pen.add(new Uint8Array(SUPERBLOCK));
    pen.add(this.heap.bytes());
    const root = place(pen, this.root);
    pen.pieces[0] = superblock(root, pen.size);
    return pen.all();
  }

  /** Texts go into the heap first: it lies before all that refers to it. */
  #refer(item) {
    for (const {value} of [item, ...item.attributes])
      if (value?.texts) value.references = this.heap.references(value.texts);
    for (const child of item.children?.values() ?? []) this.#refer(child);
  }
}

function superblock({header, tree, heap}, end) {
  return packed([new Uint8Array([0x89, 0x48, 0x44, 0x46, 0x0d, 0x0a, 0x1a, 0x0a]),
    [5, 0], [1, 8], [1, 8], [1, 0], [2, LINKS.leaf / 2], [2, LINKS.most / 2], [4, 0],
    [8, 0], [8, UNDEFINED], [8, end], [8, UNDEFINED],
    [8, 0], [8, header], [4, 1], [4, 0], [8, tree], [8, heap]]);
}

/** Writes an item and all below it; {header} is its address. */
function place(pen, item) {
  return item.children ? placeGroup(pen, item) : {header: placeDataset(pen, item)};
}

function placeGroup(pen, {children, attributes}) {
  const sorted = [...children].map(([name, child]) => [name, place(pen, child)]).sort(byName);
  let size = 8;  // the empty name
  const names = [];
  const links = sorted.map(([name, {header}]) => {
    names.push(padded(encoded(`${name}\0`)));
    const link = {place: size, header};
    size += names.at(-1).length;
    return link;
  });
  const tree = linkTree(pen, links);
  const data = pen.add(packed([[8, 0], ...names]));
  const heap = pen.add(packed([encoded('HEAP'), [4, 0], [8, size], [8, NO_FREE_BLOCK], [8, data]]));
  const header = pen.add(objectHeader([[MESSAGE.links, packed([[8, tree], [8, heap]])]], attributes));
  return {header, tree, heap};
}

function placeDataset(pen, {value, chunks, shape, attributes}) {
  const kind = value ?? chunks[0];
  const layout = chunks ? placeChunks(pen, chunks, shape) : placeWhole(pen, bytesOf(value));
  const most = chunks ? [null, ...shape.slice(1)] : null;
  const fill = packed([[1, 2], [1, chunks ? AS_IT_GROWS : LATE], [1, WRITE_IF_SET], [1, 1], [4, 0]]);
  return pen.add(objectHeader([
    [MESSAGE.space, space(shape, most)], [MESSAGE.type, kind.type], [MESSAGE.fill, fill], [MESSAGE.layout, layout],
  ], attributes));
}

function placeWhole(pen, bytes) {
  return packed([[1, 3], [1, 1], [8, bytes.length ? pen.add(bytes) : UNDEFINED], [8, bytes.length]]);
}

function placeChunks(pen, rows, [count, ...row]) {
  const still = row.map(() => 0);
  const chunks = rows.map(({bytes}, k) => ({at: [k, ...still], size: bytes.length, address: pen.add(bytes)}));
  const tree = chunkTree(pen, chunks, [count, ...still]);
  const extents = [1, ...row, rows[0].size].map((extent) => [4, extent]);
  return packed([[1, 3], [1, 2], [1, row.length + 2], [8, tree], ...extents]);
}

function attributeMessage({name, value, shape}) {
  const text = encoded(`${name}\0`);
  const extent = space(shape);
  return packed([[1, 1], [1, 0], [2, text.length], [2, value.type.length], [2, extent.length],
    padded(text), padded(value.type), padded(extent), bytesOf(value)]);
}

function objectHeader(messages, attributes) {
  const all = [...messages, ...attributes.map((one) => [MESSAGE.attribute, attributeMessage(one)])];
  const parts = all.map(([kind, bytes]) => {
    const body = padded(bytes);
    return packed([[2, kind], [2, body.length], [4, 0], body]);
  });
  const size = parts.reduce((sum, part) => sum + part.length, 0);
  return packed([[1, 1], [1, 0], [2, all.length], [4, 1], [4, size], [4, 0], ...parts]);
}

/** Whether the values fit the shape: a mistake of the caller. */
export function fits({size, bytes, texts}, shape) {
  return product(shape) === (texts ? texts.length : bytes.length / size);
}

export {REFERENCE};
