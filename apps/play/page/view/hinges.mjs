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
  parts.flatMap(({shaft, head}) => [shaft, head]).forEach((mesh, k) => {
    mesh.renderOrder = k;  // the edge first
    group.add(mesh);
  });
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
  /** `place`: the element over which the picture is, for words beside the axes. */
  constructor(view, place) {
    Object.assign(this, {view, place});
    this.scene = new Scene();
    this.rows = [];
    this.isShown = true;
    view.overlays.push(this);
  }

  /** Axes {ends, colour, words} that lie right in the frame `from`, a list of positions for each of them;
   * `core`: joints of the domain that they go along with. */
  set(rows, core) {
    this.scene.clear();
    this.core = core;
    for (const {label} of this.rows) label.remove();
    this.rows = rows.map((row) => ({...row, ...shaftOf(row.colour), label: this.labelOf(row)}));
    for (const {group} of this.rows) this.scene.add(group);
  }

  labelOf({words}) {
    const made = document.createElement('span');
    made.className = 'ensemble-angle';
    made.textContent = words;
    this.place.append(made);
    return made;
  }

  /** Where the axes are in a frame. */
  stand(positions) {
    for (const row of this.rows) {
      const {rotation, centres: [from, to]} = superpose(row.from, positions, this.core);
      row.now = row.ends.map((end) => turned(rotation, less(end, from)).map((x, c) => x + to[c]));
      this.lay(row);
    }
  }

  lay({group, parts, now: [start, end]}) {
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

  write({label, now}, isSeen) {
    label.hidden = !isSeen;
    const {x, y} = this.view.orbit.project(now[1]);
    label.style.transform = `translate(${Math.round(x + 8)}px, ${Math.round(y - 20)}px)`;
  }

  draw(renderer, camera) {
    const isSeen = this.isShown && !this.view.split;
    for (const row of this.rows) this.write(row, isSeen);
    if (!isSeen || !this.rows.length) return;
    renderer.autoClear = false;
    renderer.render(this.scene, camera);
    renderer.autoClear = true;
  }
}
