// SPDX-License-Identifier: MIT
// Axes about which domains turn: a shaft along each, its head where a right-handed turn points to.
// They stand still against one domain and go along with it.
import {ConeGeometry, CylinderGeometry, Group, Mesh, MeshBasicMaterial, Scene, Vector3} from 'three';
import {superpose} from '../record/superpose.mjs';

const UP = new Vector3(0, 1, 0);
const THICK = 0.28;  // Angstrom
const BEYOND = 6;  // Angstrom that a shaft is longer than the domain that turns about it

const less = (a, b) => a.map((x, c) => x - b[c]);
const dot = (a, b) => a.reduce((sum, x, c) => sum + x * b[c], 0);

function turned([a, b, c, d, e, f, g, h, i], [x, y, z]) {
  return [a * x + b * y + c * z, d * x + e * y + f * z, g * x + h * y + i * z];
}

function shaftOf(colour) {
  const material = new MeshBasicMaterial({color: `rgb(${colour.join(',')})`, depthTest: false, depthWrite: false});
  const edge = new MeshBasicMaterial({color: '#11181f', depthTest: false, depthWrite: false});
  const group = new Group();
  const parts = [edge, material].map((paint, k) => ({
    shaft: new Mesh(new CylinderGeometry(1, 1, 1, 12).translate(0, 0.5, 0), paint),
    head: new Mesh(new ConeGeometry(1, 1, 20).translate(0, 0.5, 0), paint),
    grown: k ? 1 : 1.5,
  }));
  for (const {shaft, head} of parts) group.add(shaft, head);
  return {group, parts};
}

/** Ends of the shaft: along the axis as far as the joints of the domain go, and some more. */
export function endsOf({point, axis}, joints, positions) {
  let [low, high] = [Infinity, -Infinity];
  for (const joint of joints) {
    const along = dot(less([...positions.subarray(3 * joint, 3 * joint + 3)], point), axis);
    [low, high] = [Math.min(low, along), Math.max(high, along)];
  }
  return [low - BEYOND, high + BEYOND].map((along) => point.map((x, c) => x + along * axis[c]));
}

export class Hinges {
  constructor(view) {
    this.view = view;
    this.scene = new Scene();
    this.rows = [];
    this.isShown = true;
    view.overlays.push(this);
  }

  /** Axes {ends, colour} that lie right in the frame `from`, a list of positions for each of them;
   * `core`: joints of the domain that they go along with. */
  set(rows, core) {
    this.scene.clear();
    this.core = core;
    this.rows = rows.map((row) => ({...row, ...shaftOf(row.colour)}));
    for (const {group} of this.rows) this.scene.add(group);
  }

  /** Where the axes are in a frame. */
  stand(positions) {
    for (const row of this.rows) {
      const {rotation, centres: [from, to]} = superpose(row.from, positions, this.core);
      row.now = row.ends.map((end) => turned(rotation, less(end, from)).map((x, c) => x + to[c]));
      this.place(row);
    }
  }

  place({group, parts, now: [start, end]}) {
    const way = new Vector3(...less(end, start));
    const length = way.length();
    group.position.set(...start);
    group.quaternion.setFromUnitVectors(UP, way.divideScalar(length));
    for (const {shaft, head, grown} of parts) {
      const thick = THICK * grown;
      const more = 0.14 * (grown - 1);
      shaft.scale.set(thick, length - 2, thick);
      head.scale.set(2.6 * thick, 2.4 + more, 2.6 * thick);
      head.position.set(0, length - 2.2 - more / 2, 0);
    }
  }

  draw(renderer, camera) {
    if (!this.isShown || !this.rows.length || this.view.split) return;
    renderer.autoClear = false;
    renderer.render(this.scene, camera);
    renderer.autoClear = true;
  }
}
