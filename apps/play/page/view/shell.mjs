// SPDX-License-Identifier: MIT
// A surface that one sees through, as of a density map. It is of one colour, and hides the more the
// more it is seen from the side: so it does not matter which of its triangles is drawn first.
import {Mesh} from './gl.mjs';
import {cross, less, plus, pointOf} from './vectors.mjs';

const vertex = /* glsl */`
precision highp float;
in vec3 position, normal;
uniform mat4 viewMatrix, projectionMatrix;
out vec3 hit, outward;
void main() {
  hit = (viewMatrix * vec4(position, 1.)).xyz;
  outward = mat3(viewMatrix) * normal;
  gl_Position = projectionMatrix * vec4(hit, 1.);
}`;

const fragment = /* glsl */`
precision highp float;
uniform vec3 tint;
in vec3 hit, outward;
layout(location = 0) out vec4 pixel;
void main() {
  float facing = abs(dot(normalize(outward), normalize(hit)));
  pixel = vec4(tint, mix(.06, .55, pow(1. - facing, 2.5)));
}`;

/** Directions at the corners: sums of those of the triangles about them, by their areas. */
function normalsOf(position, index) {
  const sums = new Float32Array(position.length);
  for (let k = 0; k < index.length; k += 3) {
    const [a, b, c] = [0, 1, 2].map((corner) => pointOf(position, index[k + corner]));
    const way = cross(less(b, a), less(c, a));
    for (const joint of index.subarray(k, k + 3)) sums.set(plus(pointOf(sums, joint), way), 3 * joint);
  }
  return sums;
}

/** Corners (three numbers each, Angstrom) and triangles of them; `uniforms`: of the picture. */
export function shell(position, index, uniforms) {
  const shape = {position, index, normal: normalsOf(position, index)};
  return new Mesh(shape, {vertex, fragment}, {...uniforms, tint: {value: [0.5, 0.5, 0.5]}}, {isClear: true, isTwoSided: true});
}
