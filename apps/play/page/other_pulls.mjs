// SPDX-License-Identifier: MIT
// What others pull with on the run that this page shows, too: an arrow at each atom, and words.
import {Arrow} from './view/solids.mjs';
import {rgb} from './view/uniforms.mjs';

const LENGTH = 6;  // Angstrom in units of the picture: of a force its direction alone is drawn

export class OtherPulls {
  constructor(session, view, hand) {
    Object.assign(this, {session, view, hand});
    this.rows = [];
    this.arrows = [];
    view.overlays.push(this);
    session.on('step', () => this.stand());
  }

  /** Rows [atom, x, y, z]. */
  show(rows) {
    const wasStill = !this.rows.length;
    this.rows = rows.filter((row) => Math.hypot(...row.slice(1)) > 0);
    while (this.arrows.length < this.rows.length) this.arrows.push(new Arrow(rgb('#7a3f9e')));
    if (this.rows.length && wasStill)
      this.hand.onSay(`Someone else pulls on ${this.session.model.nameOf(this.rows[0][0])}`);
    this.stand();
  }

  stand() {
    this.arrows.forEach((arrow, k) => {
      if (k >= this.rows.length) return arrow.hide();
      const [joint, ...force] = this.rows[k];
      const from = [...this.session.positions.subarray(3 * joint, 3 * joint + 3)];
      const scale = LENGTH * this.view.unit / Math.hypot(...force);
      return arrow.show(from, from.map((x, c) => x + scale * force[c]));
    });
    this.view.stale = true;
  }

  draw(view) {
    for (const arrow of this.arrows) arrow.draw(view);
  }
}
