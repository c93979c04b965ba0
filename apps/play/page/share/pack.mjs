// SPDX-License-Identifier: MIT
// Values with arrays of numbers in them as bytes, and back to the same bits: JSON, then the arrays,
// each with the bytes of its numbers taken apart, all packed by gzip.

const TYPES = {Float64Array, Float32Array, Int32Array, Uint32Array, Int16Array, Uint16Array, Int8Array, Uint8Array};
const MARK = '$array';

const through = async (bytes, stream) =>
  new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());

/** First bytes of all numbers, then the second ones...: alike bytes lie together. */
function takenApart(bytes, size) {
  const apart = new Uint8Array(bytes.length);
  const count = bytes.length / size;
  for (let k = 0, at = 0; k < size; ++k) for (let n = 0; n < count; ++n) apart[at++] = bytes[n * size + k];
  return apart;
}

function together(apart, size) {
  const bytes = new Uint8Array(apart.length);
  const count = apart.length / size;
  for (let k = 0, at = 0; k < size; ++k) for (let n = 0; n < count; ++n) bytes[n * size + k] = apart[at++];
  return bytes;
}

const raw = (array) => new Uint8Array(array.buffer, array.byteOffset, array.byteLength);

/** Bytes of a value; its functions are left out. */
export async function packed(value) {
  const arrays = [];
  const text = JSON.stringify(value, (_, inner) => {
    if (typeof inner === 'function') return undefined;
    if (inner instanceof Set) return [...inner];
    if (!ArrayBuffer.isView(inner)) return inner;
    arrays.push(takenApart(raw(inner), inner.BYTES_PER_ELEMENT));
    return {[MARK]: inner.constructor.name, count: inner.length};
  });
  const json = new TextEncoder().encode(text);
  const whole = await new Blob([Uint32Array.of(json.length), json, ...arrays]).arrayBuffer();
  return through(whole, new CompressionStream('gzip'));
}

/** The value of packed() bytes. */
export async function unpacked(bytes) {
  const whole = await through(bytes, new DecompressionStream('gzip'));
  const length = new DataView(whole.buffer).getUint32(0, true);
  let at = 4 + length;
  const arrays = [];
  const value = JSON.parse(new TextDecoder().decode(whole.subarray(4, at)), (_, inner) => {
    if (inner?.[MARK]) arrays.push(inner);
    return inner;
  });
  // JSON.parse meets objects in the order in which stringify wrote them.
  const made = new Map(arrays.map((place) => {
    const Type = TYPES[place[MARK]];
    const size = Type.BYTES_PER_ELEMENT;
    const part = together(whole.subarray(at, at + place.count * size), size);
    at += part.length;
    return [place, new Type(part.buffer)];
  }));
  return filled(value, made);
}

function filled(value, made) {
  if (made.has(value)) return made.get(value);
  if (value && typeof value === 'object')
    for (const [name, inner] of Object.entries(value)) value[name] = filled(inner, made);
  return value;
}

/** Positions of frames one after the other, each as what differs in its bits from the one before. */
export function differences(list) {
  const size = list[0].length * 2;
  const all = new Uint32Array(size * list.length);
  list.forEach((positions, k) => {
    const now = new Uint32Array(positions.buffer, positions.byteOffset, size);
    const before = k ? new Uint32Array(list[k - 1].buffer, list[k - 1].byteOffset, size) : null;
    for (let n = 0; n < size; ++n) all[k * size + n] = before ? now[n] ^ before[n] : now[n];
  });
  return new Float64Array(all.buffer);
}

/** The frames that differences() was made of. */
export function summed(all, count) {
  const bits = new Uint32Array(all.buffer, all.byteOffset, all.length * 2);
  const size = bits.length / count;
  for (let n = size; n < bits.length; ++n) bits[n] ^= bits[n - size];
  return Array.from({length: count}, (_, k) => all.slice(k * size / 2, (k + 1) * size / 2));
}
