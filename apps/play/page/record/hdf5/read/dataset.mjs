// SPDX-License-Identifier: MIT
// The values of a dataset, whole or some of its rows.
import {chunkLayout, chunksOf} from './chunks.mjs';
import {filtersOf, unfiltered} from './filters.mjs';
import {MESSAGE} from './header.mjs';
import {Cursor, Outside, expect} from './source.mjs';
import {shapeOf, typeOf, valuesOf} from './types.mjs';

const MOST_READ = 1024 * 1024 * 1024;  // bytes at once
const product = (shape) => shape.reduce((a, b) => a * b, 1);

export class Dataset {
  constructor(file, messages) {
    Object.assign(this, {file, kind: 'dataset'});
    const find = (kind) => messages.find((message) => message.kind === kind)?.body;
    this.shape = shapeOf(find(MESSAGE.space));
    this.type = typeOf(find(MESSAGE.type));
    this.find = find;
    if (find(MESSAGE.external)) throw new Outside('values in another file');
    const layout = find(MESSAGE.layout);
    expect(layout);
    this.layoutClass = layout.uint(1, 1);
    if (layout.uint(0, 1) < 3) throw new Outside('a layout of HDF5 before 1.6');
  }

  /** How many rows, from the first, were written. */
  rowsThere() {
    if (!this.shape?.length) return 0;
    if (this.layoutClass !== 2) return this.shape[0];
    const {chunks, extents, count} = this.#chunked();
    const across = product(count.slice(1));
    let number = 0;
    while (number < count[0] * across && chunks.has(number)) ++number;
    return Math.min(this.shape[0], Math.floor(number / across) * extents[0]);
  }

  #chunked() {
    if (this.chunking) return this.chunking;
    const layout = chunkLayout(this.find(MESSAGE.layout), this.shape, this.type.size);
    const pipeline = this.find(MESSAGE.filters);
    const filters = pipeline ? filtersOf(pipeline) : [];
    return this.chunking = {...layout, filters, chunks: chunksOf(this.file.source, layout)};
  }

  /** Rows from..to of all, as a typed array or a list of texts; of a single value: it alone. */
  async read(from = 0, to = this.shape?.[0] ?? 1) {
    if (this.shape === null) return [];
    const count = this.shape.length ? product([to - from, ...this.shape.slice(1)]) : 1;
    expect(count >= 0 && count * this.type.size <= MOST_READ);
    const bytes = count ? await this.#bytes(from, to, count * this.type.size) : new Uint8Array();
    return valuesOf(this.type, bytes, count, this.file.heap);
  }

  #bytes(from, to, size) {
    const layout = this.find(MESSAGE.layout);
    if (this.layoutClass === 2) return this.#gathered(from, to, size);
    const at = size / Math.max(1, to - from) * from;
    if (this.layoutClass === 0) return layout.slice(4 + at, size);
    if (this.layoutClass !== 1) throw new Outside('a dataset made of others');
    const address = layout.address(2);
    return address === null ? this.#filled(size) : this.file.source.slice(address + at, size);
  }

  async #gathered(from, to, size) {
    const {chunks, extents, count, filters, bytes} = this.#chunked();
    expect(bytes <= MOST_READ);
    const out = this.#filled(size);
    const across = product(count.slice(1));
    const last = Math.ceil(to / extents[0]) * across;
    for (let number = Math.floor(from / extents[0]) * across; number < last; ++number) {
      const chunk = chunks.get(number);
      if (!chunk) continue;
      const raw = this.file.source.slice(chunk.address, chunk.size);
      const whole = await unfiltered(raw, filters, chunk.mask, bytes, this.type.size);
      this.#place(out, whole, number, from, to);
    }
    return out;
  }

  /** Copies of a chunk what lies within rows from..to and within the dataset. */
  #place(out, chunk, number, from, to) {
    const {extents, count} = this.chunking;
    const {shape, type: {size}} = this;
    const rank = shape.length;
    const start = Array(rank);
    for (let axis = rank - 1, rest = number; axis >= 0; --axis) {
      start[axis] = rest % count[axis] * extents[axis];
      rest = Math.floor(rest / count[axis]);
    }
    const low = start.map((first, axis) => (axis ? 0 : Math.max(0, from - first)));
    const high = start.map((first, axis) => Math.min(extents[axis], (axis ? shape[axis] : to) - first));
    const line = (axis, inside, outside) => {
      if (axis === rank - 1) {
        const here = (inside * extents[axis] + low[axis]) * size;
        const there = (outside * shape[axis] + start[axis] + low[axis] - (axis ? 0 : from)) * size;
        out.set(chunk.subarray(here, here + (high[axis] - low[axis]) * size), there);
        return;
      }
      for (let k = low[axis]; k < high[axis]; ++k)
        line(axis + 1, inside * extents[axis] + k, outside * shape[axis] + start[axis] + k - (axis ? 0 : from));
    };
    line(0, 0, 0);
  }

  /** What was never written has the value of the fill message. */
  #filled(size) {
    const out = new Uint8Array(size);
    const value = fillValue(this.find(MESSAGE.fill), this.type.size);
    if (value?.some(Boolean)) for (let at = 0; at < size; at += value.length) out.set(value, at);
    return out;
  }
}

function fillValue(body, size) {
  if (!body) return null;
  const version = body.uint(0, 1);
  const cursor = new Cursor(body, version === 3 ? 2 : 4);
  const isGiven = version === 3 ? body.uint(1, 1) & 0x20 : version === 1 || body.uint(3, 1);
  if (!isGiven || cursor.at + 4 > body.size || cursor.uint(4) !== size) return null;
  return cursor.slice(size);
}
