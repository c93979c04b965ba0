// SPDX-License-Identifier: MIT
// A camera about a point: turned by an arcball, moved and brought nearer. Angles in radians,
// distances in Angstrom, places on the screen in CSS pixels.
import {Matrix4, PerspectiveCamera, Quaternion, Vector3} from 'three';
import {eigen} from '../eigen.mjs';

const FIELD = 32;  // degrees, of the shorter edge
const TURN = Math.PI;  // of a drag across the shorter edge

export class Orbit {
  constructor() {
    this.camera = new PerspectiveCamera(FIELD, 1, 0.1, 1000);
    this.target = new Vector3();
    this.turn = new Quaternion();
    this.distance = 10;
    this.radius = 1;
    this.half = new Vector3(1, 1, 1);
    this.size = {width: 1, height: 1};
  }

  /** All joints, their longest axis along the longer edge, their shortest towards the eye. */
  frame(positions, unit) {
    const axes = principalAxes(positions);
    const [right, up] = this.size.width >= this.size.height ? axes : [axes[1], axes[0]];
    const turn = new Matrix4().makeBasis(right, up, new Vector3().crossVectors(right, up));
    this.turn.setFromRotationMatrix(turn);
    this.enclose(positions, unit);
  }

  /** The middle and the extent along the axes of the screen, with room for a ball of 1.2 units. */
  enclose(positions, unit) {
    const back = this.turn.clone().invert();
    const low = new Vector3(Infinity, Infinity, Infinity);
    const high = low.clone().negate();
    const point = new Vector3();
    for (let k = 0; k < positions.length; k += 3) {
      point.fromArray(positions, k).applyQuaternion(back);
      low.min(point);
      high.max(point);
    }
    this.half = high.clone().sub(low).multiplyScalar(0.5).addScalar(1.2 * unit);
    this.target.addVectors(low, high).multiplyScalar(0.5).applyQuaternion(this.turn);
    this.radius = this.half.length();
    this.distance = this.wholeDistance();
    this.update();
  }

  /** From where the box about all joints fills the picture; room above and below for the controls. */
  wholeDistance() {
    const slope = Math.tan(this.camera.fov * Math.PI / 360);
    const {x, y, z} = this.half;
    return 1.08 * Math.max(x / (slope * this.camera.aspect), 1.12 * y / slope) + z;
  }

  resize(width, height) {
    this.size = {width, height};
    const shorter = Math.min(width, height);
    this.camera.aspect = width / height;
    this.camera.fov = 2 * Math.atan(Math.tan(FIELD * Math.PI / 360) * height / shorter) * 180 / Math.PI;
    this.update();
  }

  update() {
    const {camera, distance, radius} = this;
    camera.quaternion.copy(this.turn);
    camera.position.set(0, 0, distance).applyQuaternion(this.turn).add(this.target);
    camera.near = Math.max(distance - 3 * radius, distance * 0.01);
    camera.far = distance + 6 * radius;
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }

  rotate(dx, dy) {
    const shorter = Math.min(this.size.width, this.size.height);
    const length = Math.hypot(dx, dy);
    if (!length) return;
    const axis = new Vector3(-dy / length, -dx / length, 0);
    this.turn.multiply(new Quaternion().setFromAxisAngle(axis, TURN * length / shorter));
    this.update();
  }

  roll(angle) {
    this.turn.multiply(new Quaternion().setFromAxisAngle(new Vector3(0, 0, 1), angle));
    this.update();
  }

  pan(dx, dy) {
    const scale = this.pixel();
    this.target.add(new Vector3(-dx * scale, dy * scale, 0).applyQuaternion(this.turn));
    this.update();
  }

  /** Angstrom a pixel at the target. */
  pixel() {
    return 2 * this.distance * Math.tan(this.camera.fov * Math.PI / 360) / this.size.height;
  }

  zoom(factor) {
    const whole = this.wholeDistance();
    this.distance = Math.min(Math.max(this.distance * factor, whole * 0.02), whole * 8);
    this.update();
  }

  project(point) {
    const v = new Vector3(...point).project(this.camera);
    return {x: (v.x + 1) / 2 * this.size.width, y: (1 - v.y) / 2 * this.size.height, depth: v.z};
  }

  unproject(x, y, depth) {
    const v = new Vector3(x / this.size.width * 2 - 1, 1 - y / this.size.height * 2, depth);
    return v.unproject(this.camera).toArray();
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
  return eigen(spread).slice(0, 2).map(({vector}) => new Vector3(...vector));
}
