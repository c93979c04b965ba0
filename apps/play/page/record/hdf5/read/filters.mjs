// SPDX-License-Identifier: MIT
// What was done to the bytes of a chunk, undone: gzip, shuffle, and the checksum of Fletcher.
import {Cursor, Damaged, Outside, expect} from './source.mjs';

const [DEFLATE, SHUFFLE, FLETCHER] = [1, 2, 3];
const NAMES = {4: 'szip', 5: 'nbit', 6: 'scale-offset', 32000: 'LZF', 32001: 'Blosc', 32004: 'LZ4', 32015: 'Zstandard'};

/** Numbers of the filters, in the order in which they were applied. */
export function filtersOf(body) {
  const version = body.uint(0, 1);
  const cursor = new Cursor(body, version === 1 ? 8 : 2);
  return Array.from({length: body.uint(1, 1)}, () => {
    const number = cursor.uint(2);
    const nameSize = version === 1 || number >= 256 ? cursor.uint(2) : 0;
    const values = cursor.skip(2).uint(2);
    cursor.skip(nameSize + 4 * values + (version === 1 && values % 2 ? 4 : 0));
    return number;
  });
}

/** The bytes that a chunk was made from. Throws Damaged if they are not `size` bytes. */
export async function unfiltered(bytes, filters, mask, size, elementSize) {
  let now = bytes;
  for (let k = filters.length - 1; k >= 0; --k) {
    if (mask & (1 << k)) continue;
    now = await undone(filters[k], now, size, elementSize);
  }
  expect(now.length === size);
  return now;
}

function undone(filter, bytes, size, elementSize) {
  if (filter === DEFLATE) return inflated(bytes, size);
  if (filter === SHUFFLE) return unshuffled(bytes, elementSize);
  if (filter === FLETCHER) return bytes.subarray(0, Math.max(0, bytes.length - 4));
  throw new Outside(`chunks packed by ${NAMES[filter] ?? `filter ${filter}`}`);
}

/** No more than a chunk and its checksum can hold: a damaged one must not fill the memory. */
async function inflated(bytes, size) {
  const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate')).getReader();
  const whole = new Uint8Array(size + 4);
  let at = 0;
  try {
    for (let {done, value} = await reader.read(); !done; {done, value} = await reader.read()) {
      whole.set(value, at);
      at += value.length;
    }
  } catch {
    reader.cancel().catch(() => {});
    throw new Damaged();
  }
  return whole.subarray(0, at);
}

/** Bytes of a number lie together again; what is left over is as it was. */
function unshuffled(bytes, size) {
  const count = Math.floor(bytes.length / size);
  const together = bytes.slice();
  for (let byte = 0, from = 0; byte < size; ++byte)
    for (let k = 0; k < count; ++k) together[k * size + byte] = bytes[from++];
  return together;
}
