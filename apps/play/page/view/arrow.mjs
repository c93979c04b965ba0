// SPDX-License-Identifier: MIT
// The force of the hand: a shaft and a head from the joint to where the hand is, over all else.
import {ConeGeometry, CylinderGeometry, Group, Mesh, MeshBasicMaterial, Scene, Vector3} from 'three';

const UP = new Vector3(0, 1, 0);

export class Arrow {
  constructor(colour = '#f28c00') {
    const material = new MeshBasicMaterial({color: colour, depthTest: false, depthWrite: false});
    this.shaft = new Mesh(new CylinderGeometry(1, 1, 1, 12).translate(0, 0.5, 0), material);
    this.head = new Mesh(new ConeGeometry(1, 1, 16).translate(0, 0.5, 0), material);
    this.group = new Group();
    this.group.add(this.shaft, this.head);
    this.scene = new Scene();
    this.scene.add(this.group);
    this.group.visible = false;
    this.unit = 1;
  }

  setUnit(unit) {
    this.unit = unit;
    this.hide();
  }

  /** From one point to another, Angstrom. */
  show(from, to) {
    const start = new Vector3(...from);
    const way = new Vector3(...to).sub(start);
    const length = way.length();
    this.group.visible = length > 1e-9;
    if (!this.group.visible) return;
    const thick = 0.09 * this.unit;
    const head = Math.min(0.55 * this.unit, length * 0.5);
    this.group.position.copy(start);
    this.group.quaternion.setFromUnitVectors(UP, way.divideScalar(length));
    this.shaft.scale.set(thick, length - head, thick);
    this.head.scale.set(2.4 * thick, head, 2.4 * thick);
    this.head.position.set(0, length - head, 0);
  }

  hide() {
    this.group.visible = false;
  }

  draw(renderer, camera) {
    if (!this.group.visible) return;
    renderer.autoClear = false;
    renderer.render(this.scene, camera);
    renderer.autoClear = true;
  }
}
