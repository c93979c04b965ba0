// SPDX-License-Identifier: MIT
// Bytes as text.

const AT_ONCE = 1 << 15;  // arguments of a call

export function toBase64(bytes) {
  let letters = '';
  for (let k = 0; k < bytes.length; k += AT_ONCE) letters += String.fromCharCode(...bytes.subarray(k, k + AT_ONCE));
  return btoa(letters);
}

export function fromBase64(text) {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let k = 0; k < letters.length; ++k) bytes[k] = letters.charCodeAt(k);
  return bytes;
}
