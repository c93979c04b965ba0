// SPDX-License-Identifier: MIT
// Animated PNG (W3C PNG, third edition): frames of equal size, of each what differs from the one before.

const CRCS = Uint32Array.from({length: 256}, (_, number) => {
  let value = number;
  for (let k = 0; k < 8; ++k) value = value & 1 ? 0xedb88320 ^ (value >>> 1) : value >>> 1;
  return value;
});

function crc(bytes) {
  let value = 0xffffffff;
  for (const byte of bytes) value = CRCS[(value ^ byte) & 255] ^ (value >>> 8);
  return ~value >>> 0;
}

/** Numbers as the format has them: [bytes, value], the highest byte first. */
function fields(rows) {
  const bytes = rows.flatMap(([size, value]) => Array.from({length: size}, (_, k) => value / 2 ** (8 * (size - 1 - k)) & 255));
  return Uint8Array.from(bytes);
}

function chunk(name, ...parts) {
  const length = parts.reduce((sum, part) => sum + part.length, 0);
  const bytes = new Uint8Array(12 + length);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, length);
  for (let k = 0; k < 4; ++k) bytes[4 + k] = name.charCodeAt(k);
  let at = 8;
  for (const part of parts) {
    bytes.set(part, at);
    at += part.length;
  }
  view.setUint32(8 + length, crc(bytes.subarray(4, 8 + length)));
  return bytes;
}

/** The part of a picture that differs from the one before: {x, y, width, height}, at least a pixel. */
export function changed(now, before, width, height) {
  const [a, b] = [new Uint32Array(now.buffer), new Uint32Array(before.buffer)];
  let [left, top, right, bottom] = [width, height, -1, -1];
  for (let y = 0, k = 0; y < height; ++y)
    for (let x = 0; x < width; ++x, ++k) {
      if (a[k] === b[k]) continue;
      [left, right] = [Math.min(left, x), Math.max(right, x)];
      [top, bottom] = [Math.min(top, y), y];
    }
  return right < 0 ? {x: 0, y: 0, width: 1, height: 1} : {x: left, y: top, width: right - left + 1, height: bottom - top + 1};
}

/** Rows of RGB, each as what differs from the row above. */
async function deflated(pixels, fullWidth, {x, y, width, height}) {
  const rows = new Uint8Array(height * (1 + 3 * width));
  let at = 0;
  for (let row = 0; row < height; ++row) {
    rows[at++] = row ? 2 : 0;
    for (let column = 0; column < width; ++column) {
      const k = 4 * ((y + row) * fullWidth + x + column);
      for (let c = 0; c < 3; ++c) rows[at++] = pixels[k + c] - (row ? pixels[k - 4 * fullWidth + c] : 0);
    }
  }
  const stream = new Blob([rows]).stream().pipeThrough(new CompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** A Blob of frames (RGBA by rows), which are shown for ever, each so many milliseconds. */
export async function animated(frames, width, height, milliseconds) {
  const parts = [Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a),
    chunk('IHDR', fields([[4, width], [4, height], [1, 8], [1, 2], [1, 0], [1, 0], [1, 0]])),
    chunk('acTL', fields([[4, frames.length], [4, 0]]))];
  let number = 0;
  for (const [k, frame] of frames.entries()) {
    const box = k ? changed(frame, frames[k - 1], width, height) : {x: 0, y: 0, width, height};
    parts.push(chunk('fcTL', fields([[4, number++], [4, box.width], [4, box.height], [4, box.x], [4, box.y],
      [2, milliseconds], [2, 1000], [1, 0], [1, 0]])));
    const bytes = await deflated(frame, width, box);
    parts.push(k ? chunk('fdAT', fields([[4, number++]]), bytes) : chunk('IDAT', bytes));
  }
  return new Blob([...parts, chunk('IEND')], {type: 'image/png'});
}
