// SPDX-License-Identifier: MIT
// Colours as they are seen with two kinds of cones (Machado, Oliveira & Fernandes 2009, severity 1), and
// how far apart they look: the distance in CIELAB (CIE 1976), 2.3 being just noticeable.

export const SEEN = {
  usual: [1, 0, 0, 0, 1, 0, 0, 0, 1],
  protanopia: [0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998],
  deuteranopia: [0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.01182, 0.04294, 0.968881],
  tritanopia: [1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.3039],
};

const linear = (value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4);
const root = (t) => (t > (6 / 29) ** 3 ? Math.cbrt(t) : t * 841 / 108 + 4 / 29);

/** CIELAB, D65, of linear red, green and blue. */
function lab([r, g, b]) {
  const [x, y, z] = [
    (0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047, 0.2126729 * r + 0.7151522 * g + 0.072175 * b,
    (0.0193339 * r + 0.119192 * g + 0.9503041 * b) / 1.08883,
  ].map(root);
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

function seenAs(text, matrix) {
  const rgb = [1, 3, 5].map((k) => linear(parseInt(text.slice(k, k + 2), 16) / 255));
  const row = (k) => matrix[k] * rgb[0] + matrix[k + 1] * rgb[1] + matrix[k + 2] * rgb[2];
  return lab([0, 3, 6].map((k) => Math.min(1, Math.max(0, row(k)))));
}

/** The two of {meaning: '#rrggbb'} that look most alike, and how far apart they are. */
export function leastApart(colours, seen) {
  const rows = Object.entries(colours).map(([name, text]) => [name, seenAs(text, SEEN[seen])]);
  let found = {apart: Infinity, pair: []};
  rows.forEach(([name, one], k) => rows.slice(0, k).forEach(([other, two]) => {
    const apart = Math.hypot(...one.map((x, c) => x - two[c]));
    if (apart < found.apart) found = {apart, pair: [name, other]};
  }));
  return found;
}
