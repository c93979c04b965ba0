// SPDX-License-Identifier: MIT
// Zoom to fit a bar: a double click on it, or a key; the bar then lies across the picture.
import {cross, dot, length, less, plus, pointOf, times} from '../view/vectors.mjs';
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
    const joint = view.uniforms.lit.value[0];
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
    const x = this.stage.film ? this.view.textures.positions.data : null;
    const shown = this.stage.at === null ? this.session.positions : this.stage.frames.at(this.stage.at).positions;
    const point = (joint) => (x ? pointOf(x, joint, 4) : pointOf(shown, joint));
    this.look(point(model.bars[2 * bar]), point(model.bars[2 * bar + 1]));
    $('said').textContent = model.barName(bar);
    return undefined;
  }

  look(a, b) {
    const {orbit} = this.view;
    const along = less(b, a);
    const right = dot(along, orbit.axes[0]) < 0 ? times(along, -1) : along;
    const [, up, back] = orbit.axes;
    // The least turn that lays the bar across; one that points at the eye has none.
    const side = cross(back, right);
    orbit.look(right, length(side) > 1e-3 * length(right) ? side : up);
    orbit.target = times(plus(a, b), 0.5);
    const pixels = SHARE * Math.min(orbit.size.width, orbit.size.height);
    orbit.distance = (length(along) || this.view.unit) / pixels * orbit.size.height / (2 * orbit.slope);
    orbit.zoom(1);  // within its limits
    this.view.stale = true;
  }
}
