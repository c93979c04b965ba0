// SPDX-License-Identifier: MIT
// A camera about a point: turned by an arcball, moved and brought nearer. Angles in radians,
// distances in Angstrom, places on the screen in CSS pixels.
import {eigen} from './eigen.mjs';
import {cross, dot, length, less, plus, times, turnedAbout, unitary} from './vectors.mjs';

const FIELD = 32 * Math.PI / 180;  // of the shorter edge
const TURN = Math.PI;  // of a drag across the shorter edge

export class Orbit {
  constructor() {
    this.axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];  // to the right, up and towards the eye
    this.target = [0, 0, 0];
    this.distance = 10;
    this.radius = 1;
    this.half = [1, 1, 1];
    this.resize(1, 1);
  }

  /** All joints, their longest axis along the longer edge, their shortest towards the eye. */
  frame(positions, unit) {
    const axes = principalAxes(positions);
    const [right, up] = this.size.width >= this.size.height ? axes : [axes[1], axes[0]];
    this.look(right, up);
    this.enclose(positions, unit);
  }

  /** Which directions are to the right and up; `up` is made to be at a right angle. */
  look(right, up) {
    const back = unitary(cross(right, up));
    this.axes = [unitary(right), cross(back, unitary(right)), back];
  }

  /** The middle and the extent along the axes of the screen, with room for a ball of 1.2 units. */
  enclose(positions, unit) {
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    for (let k = 0; k < positions.length; k += 3)
      this.axes.forEach(([x, y, z], c) => {
        const along = x * positions[k] + y * positions[k + 1] + z * positions[k + 2];
        low[c] = Math.min(low[c], along);
        high[c] = Math.max(high[c], along);
      });
    this.half = times(less(high, low), 0.5).map((x) => x + 1.2 * unit);
    this.target = this.along(times(plus(low, high), 0.5));
    this.radius = length(this.half);
    this.distance = this.wholeDistance();
    this.update();
  }

  /** A direction of the screen (right, up, towards the eye) in space. */
  along([x, y, z]) {
    const [right, up, back] = this.axes;
    return plus(plus(times(right, x), times(up, y)), times(back, z));
  }

  /** From where the box about all joints fills the picture; room above and below for the controls. */
  wholeDistance() {
    const [x, y, z] = this.half;
    return 1.08 * Math.max(x / (this.slope * this.aspect), 1.12 * y / this.slope) + z;
  }

  resize(width, height) {
    this.size = {width, height};
    this.aspect = width / height;
    this.slope = Math.tan(FIELD / 2) * height / Math.min(width, height);  // half the height by the distance
    this.update();
  }

  /** What shaders are told: columns of matrices. */
  update() {
    const {distance, radius, aspect, slope, axes} = this;
    const near = Math.max(distance - 3 * radius, distance * 0.01);
    const far = distance + 6 * radius;
    this.eye = plus(this.target, times(axes[2], distance));
    const turn = [0, 1, 2].flatMap((c) => [...axes.map((axis) => axis[c]), 0]);
    this.viewMatrix = [...turn, ...axes.map((axis) => -dot(axis, this.eye)), 1];
    this.projectionMatrix = [
      1 / (slope * aspect), 0, 0, 0, 0, 1 / slope, 0, 0,
      0, 0, (far + near) / (near - far), -1, 0, 0, 2 * far * near / (near - far), 0,
    ];
  }

  /** The projection of a part of the picture alone. */
  projectionOf(x, y, width, height) {
    const {size, projectionMatrix} = this;
    const [wide, high] = [size.width / width, size.height / height];
    const [right, up] = [(2 * x + width) / size.width - 1, 1 - (2 * y + height) / size.height];
    const part = [...projectionMatrix];
    part[0] *= wide;
    part[5] *= high;
    part[8] = wide * right;
    part[9] = high * up;
    return part;
  }

  rotate(dx, dy) {
    const shorter = Math.min(this.size.width, this.size.height);
    const way = Math.hypot(dx, dy);
    if (!way) return;
    this.turn(this.along([-dy / way, -dx / way, 0]), TURN * way / shorter);
  }

  roll(angle) {
    this.turn(this.axes[2], angle);
  }

  turn(axis, angle) {
    this.look(...this.axes.slice(0, 2).map((side) => turnedAbout(side, axis, angle)));
    this.update();
  }

  pan(dx, dy) {
    const scale = this.pixel();
    this.target = plus(this.target, this.along([-dx * scale, dy * scale, 0]));
    this.update();
  }

  /** Angstrom a pixel at the target. */
  pixel() {
    return 2 * this.distance * this.slope / this.size.height;
  }

  zoom(factor) {
    const whole = this.wholeDistance();
    this.distance = Math.min(Math.max(this.distance * factor, whole * 0.02), whole * 8);
    this.update();
  }

  /** Where a point is seen; depth from -1 (near) to 1. */
  project(point) {
    const [x, y, z] = this.axes.map((axis) => dot(axis, less(point, this.eye)));
    const {size, slope, aspect, projectionMatrix: m} = this;
    return {
      x: (1 + x / (-z * slope * aspect)) / 2 * size.width, y: (1 - y / (-z * slope)) / 2 * size.height,
      depth: (m[10] * z + m[14]) / -z,
    };
  }

  unproject(x, y, depth) {
    const {size, slope, aspect, projectionMatrix: m} = this;
    const z = -m[14] / (depth + m[10]);
    const [across, up] = [x / size.width * 2 - 1, 1 - y / size.height * 2];
    return plus(this.eye, this.along([across * -z * slope * aspect, up * -z * slope, z]));
  }
}

/** Longest and middle principal axis of joints, of unit length. */
function principalAxes(positions) {
  const count = positions.length / 3;
  const mean = [0, 1, 2].map((c) => {
    let sum = 0;
    for (let k = c; k < positions.length; k += 3) sum += positions[k];
    return sum / count;
  });
  const spread = [[0, 0, 0], [0, 0, 0], [0, 0, 0]];
  for (let k = 0; k < positions.length; k += 3)
    for (let i = 0; i < 3; ++i)
      for (let j = 0; j < 3; ++j)
        spread[i][j] += (positions[k + i] - mean[i]) * (positions[k + j] - mean[j]);
  return eigen(spread).slice(0, 2).map(({vector}) => vector);
}
