// SPDX-License-Identifier: MIT
// Zoom to fit a bar: a double click on it, or a key; the bar then lies across the picture.
import {Matrix4, Vector3} from 'three';
import {$, say} from './dom.mjs';

const SHARE = 0.35;  // of the picture's shorter edge that the bar takes

export class FitBar {
  constructor({stage, session, view, hand}) {
    Object.assign(this, {stage, session, view, hand});
    $('canvas').addEventListener('dblclick', (event) => this.clicked(event));
  }

  clicked(event) {
    if (!this.stage.model) return;
    const {x, y} = this.hand.place(event);
    const met = this.view.pick(x, y, 4);
    if (met) this.fit(met.bar ?? this.barAt(met.joint));
  }

  /** The bar of the film, under the pointer, or off the most. */
  byKey() {
    const {view, hand, stage} = this;
    const lit = view.uniforms.litBar.value;
    const joint = view.uniforms.lit.value.x;
    const bar = lit >= 0 ? lit : hand.hoveredBar ?? (joint >= 0 ? this.barAt(joint) : stage.last?.worst ?? 0);
    return this.fit(bar);
  }

  /** The first bar of a joint; -1 if it has none. */
  barAt(joint) {
    const at = this.stage.model.bars.indexOf(joint);
    return at < 0 ? -1 : at >> 1;
  }

  fit(bar) {
    const {model} = this.stage;
    if (!(bar >= 0) || bar >= model.bars.length / 2) return say('There is no bar here to be fitted.', true);
    const x = this.stage.film ? this.view.textures.positions.image.data : null;
    const shown = this.stage.at === null ? this.session.positions : this.stage.frames.at(this.stage.at).positions;
    const point = (joint) => (x ? new Vector3().fromArray(x, 4 * joint) : new Vector3().fromArray(shown, 3 * joint));
    this.look(point(model.bars[2 * bar]), point(model.bars[2 * bar + 1]));
    $('said').textContent = model.barName(bar);
    return undefined;
  }

  look(a, b) {
    const {orbit} = this.view;
    const along = b.clone().sub(a);
    const length = along.length() || this.view.unit;
    const right = along.clone().normalize();
    const back = new Vector3(0, 0, 1).applyQuaternion(orbit.turn);
    if (right.dot(new Vector3(1, 0, 0).applyQuaternion(orbit.turn)) < 0) right.negate();
    back.addScaledVector(right, -back.dot(right));  // the least turn that lays the bar across
    if (back.lengthSq() < 1e-6) back.set(0, 1, 0).applyQuaternion(orbit.turn);
    back.addScaledVector(right, -back.dot(right));
    back.normalize();
    orbit.turn.setFromRotationMatrix(new Matrix4().makeBasis(right, back.clone().cross(right), back));
    orbit.target.addVectors(a, b).multiplyScalar(0.5);
    const {width, height} = orbit.size;
    const pixels = SHARE * Math.min(width, height);
    orbit.distance = length / pixels * height / (2 * Math.tan(orbit.camera.fov * Math.PI / 360));
    orbit.zoom(1);  // within its limits
    this.view.stale = true;
  }
}
