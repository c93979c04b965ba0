// SPDX-License-Identifier: MIT
// Points and directions as [x, y, z].

export const plus = (a, b) => a.map((x, c) => x + b[c]);
export const less = (a, b) => a.map((x, c) => x - b[c]);
export const times = (a, factor) => a.map((x) => factor * x);
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];
export const length = (a) => Math.hypot(...a);
export const unitary = (a) => times(a, 1 / (length(a) || 1));

/** Place of a joint in an array of positions. */
export const pointOf = (positions, joint, stride = 3) => [...positions.subarray(stride * joint, stride * joint + 3)];

/** A direction turned about an axis of length 1 (Rodrigues). */
export function turnedAbout(direction, axis, angle) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const along = times(axis, dot(axis, direction) * (1 - c));
  return plus(plus(times(direction, c), times(cross(axis, direction), s)), along);
}
