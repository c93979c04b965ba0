// SPDX-License-Identifier: MIT
// Bytes as text: 13 bits in two characters, where base64 has 12. No character that HTML, JSON or a
// template would write in another way. The number of bytes stands before them.

const LETTERS = Array.from({length: 95}, (_, k) => String.fromCharCode(32 + k))
  .filter((letter) => !'"&<\\'.includes(letter));
const [BASE, BITS] = [LETTERS.length, 13];
const AT_ONCE = 4096;

export function toDense(bytes) {
  const parts = [`${bytes.length}:`];
  let [held, count, row] = [0, 0, ''];
  const put = () => {
    const value = held & ((1 << BITS) - 1);
    row += LETTERS[value % BASE] + LETTERS[Math.floor(value / BASE)];
    held >>>= BITS;
    count -= BITS;
    if (row.length < AT_ONCE) return;
    parts.push(row);
    row = '';
  };
  for (const byte of bytes) {
    held |= byte << count;
    count += 8;
    if (count >= BITS) put();
  }
  if (count > 0) put();
  return [...parts, row].join('');
}

export function fromDense(text) {
  const digits = new Uint8Array(128);
  LETTERS.forEach((letter, k) => { digits[letter.charCodeAt(0)] = k; });
  const from = text.indexOf(':') + 1;
  const bytes = new Uint8Array(from ? Number(text.slice(0, from - 1)) : 0);
  let [held, count, at] = [0, 0, 0];
  for (let k = from; k < text.length && at < bytes.length; k += 2) {
    held |= (digits[text.charCodeAt(k)] + BASE * digits[text.charCodeAt(k + 1)]) << count;
    count += BITS;
    while (count >= 8 && at < bytes.length) {
      bytes[at++] = held & 255;
      held >>>= 8;
      count -= 8;
    }
  }
  return bytes;
}
