// SPDX-License-Identifier: MIT
// What holds a pull, lit up over all else: tubes between joints, and spheres about pins.
import {
  CylinderGeometry, DynamicDrawUsage, InstancedMesh, Matrix4, MeshBasicMaterial, Quaternion, Scene,
  SphereGeometry, Vector3,
} from 'three';

const UP = new Vector3(0, 1, 0);
/** Holders, the chain that is taut and the bars that carry the pull; radii in Angstrom. */
const SORTS = {
  holder: {colour: '#d55e00', radius: 0.17, opacity: 1},
  taut: {colour: '#0072b2', radius: 0.13, opacity: 0.9},
  loaded: {colour: '#0072b2', radius: 0.07, opacity: 0.5},
};

function made(geometry, {colour, opacity}, count) {
  const material = new MeshBasicMaterial({
    color: colour, opacity, transparent: opacity < 1, depthTest: false, depthWrite: false,
  });
  const mesh = new InstancedMesh(geometry, material, Math.max(1, count));
  mesh.instanceMatrix.setUsage(DynamicDrawUsage);
  mesh.frustumCulled = false;
  mesh.count = count;
  return mesh;
}

export class Holders {
  constructor() {
    this.scene = new Scene();
    this.layers = [];
    this.pins = [];
  }

  /** Pairs of joints by sort, {holder: [[a, b], ...], ...}; joints of pins. */
  show(pairs, pins = []) {
    this.hide();
    for (const [sort, list] of Object.entries(pairs))
      if (list.length) this.add(new CylinderGeometry(1, 1, 1, 10), SORTS[sort], list);
    if (pins.length) this.add(new SphereGeometry(1, 20, 14), {...SORTS.holder, radius: 0.5, opacity: 0.75}, pins.map((joint) => [joint, joint]));
  }

  add(geometry, sort, list) {
    const mesh = made(geometry, sort, list.length);
    this.layers.push({mesh, sort, list});
    this.scene.add(mesh);
  }

  hide() {
    for (const {mesh} of this.layers) {
      this.scene.remove(mesh);
      mesh.geometry.dispose();
      mesh.material.dispose();
      mesh.dispose();
    }
    this.layers = [];
  }

  get isShown() {
    return this.layers.length > 0;
  }

  /** `positions`: four numbers a joint, as the textures have them. */
  place(positions, unit) {
    const matrix = new Matrix4();
    const turn = new Quaternion();
    const at = (joint) => new Vector3(...positions.subarray(4 * joint, 4 * joint + 3));
    for (const {mesh, sort, list} of this.layers) {
      list.forEach(([a, b], k) => {
        const [from, to] = [at(a), at(b)];
        const way = to.clone().sub(from);
        const length = way.length();
        const radius = sort.radius * unit;
        turn.setFromUnitVectors(UP, length > 1e-9 ? way.divideScalar(length) : UP);
        const size = new Vector3(radius, a === b ? radius : length, radius);
        mesh.setMatrixAt(k, matrix.compose(from.add(to).multiplyScalar(0.5), turn, size));
      });
      mesh.instanceMatrix.needsUpdate = true;
    }
  }

  draw(view) {
    if (!this.isShown) return;
    this.place(view.textures.positions.image.data, view.unit);
    view.renderer.autoClear = false;
    view.renderer.render(this.scene, view.orbit.camera);
    view.renderer.autoClear = true;
  }
}
