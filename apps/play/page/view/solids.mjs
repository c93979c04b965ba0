// SPDX-License-Identifier: MIT
// Shafts, heads and balls of one colour, drawn over all else: arrows of forces, axes, what holds a pull.
import {Mesh} from './gl.mjs';
import {less, length, plus, times, unitary} from './vectors.mjs';

const [SIDES, RINGS] = [20, 14];

// Rings along z from 0 to 1, with a lid at each end; x is the angle, y the share of the radius.
const shape = (() => {
  const rings = [[0, 0], ...Array.from({length: RINGS + 1}, (_, k) => [k / RINGS, 1]), [1, 0]];
  const position = rings.flatMap(([along, share]) => Array.from({length: SIDES}, (_, k) => [2 * Math.PI * k / SIDES, share, along]).flat());
  const index = rings.slice(1).flatMap((_, ring) => Array.from({length: SIDES}, (__, k) => {
    const [a, b] = [ring * SIDES + k, ring * SIDES + (k + 1) % SIDES];
    return [a, b, a + SIDES, b, b + SIDES, a + SIDES];
  }).flat());
  return {position: new Float32Array(position), index: new Uint32Array(index)};
})();

const shader = {
  vertex: /* glsl */`
precision highp float;
in vec3 position;
uniform mat4 viewMatrix, projectionMatrix;
uniform vec3 from, to, radii;  // radii: at both ends, and 1 where it is a ball
void main() {
  vec3 way = to - from, along = normalize(way);
  vec3 side = normalize(cross(along, abs(along.y) < .9 ? vec3(0., 1., 0.) : vec3(1., 0., 0.)));
  float off = 2. * position.z - 1., round = mix(1., sqrt(max(0., 1. - off * off)), radii.z);
  float radius = position.y * round * mix(radii.x, radii.y, position.z);
  vec3 place = from + position.z * way + radius * (cos(position.x) * side + sin(position.x) * cross(along, side));
  gl_Position = projectionMatrix * (viewMatrix * vec4(place, 1.));
}`,
  fragment: /* glsl */`
precision highp float;
uniform vec4 paint;
layout(location = 0) out vec4 pixel;
void main() { pixel = paint; }`,
};

/** An arrow: its head is `head` long. */
export function arrow(from, to, {thick, head, wide, paint}) {
  const way = less(to, from);
  const neck = plus(from, times(unitary(way), length(way) - head));
  return [{from, to: neck, radii: [thick, thick, 0], paint}, {from: neck, to, radii: [wide, 0, 0], paint}];
}

export const rod = (from, to, radius, paint) => ({from, to, radii: [radius, radius, 0], paint});

export function ball(centre, radius, paint) {
  const up = [0, radius, 0];
  return {from: less(centre, up), to: plus(centre, up), radii: [radius, radius, 1], paint};
}

/** Draws them, the first below the others. */
export function drawSolids(view, solids) {
  const {viewMatrix, projectionMatrix} = view.uniforms;
  for (const {paint, ...solid} of solids) {
    const values = {...solid, paint};
    const uniforms = Object.fromEntries(Object.entries(values).map(([name, value]) => [name, {value}]));
    view.renderer.draw(new Mesh(shape, shader, {...uniforms, viewMatrix, projectionMatrix}, {
      isOver: true, isTwoSided: true, isClear: paint[3] < 1,
    }));
  }
}

/** Forces of hands, from joints to where they are to go; one in this colour. */
export class Arrow {
  constructor(colour = [0.949, 0.549, 0]) {
    this.paint = [...colour, 1];
    this.hide();
  }

  /** From one point to another, Angstrom. */
  show(from, to) {
    this.ends = [from, to];
  }

  hide() {
    this.ends = null;
  }

  get isShown() {
    return Boolean(this.ends) && length(less(...this.ends)) > 1e-9;
  }

  draw(view) {
    if (!this.isShown) return;
    const thick = 0.09 * view.unit;
    const head = Math.min(0.55 * view.unit, length(less(...this.ends)) * 0.5);
    drawSolids(view, arrow(...this.ends, {thick, head, wide: 2.4 * thick, paint: this.paint}));
  }
}
