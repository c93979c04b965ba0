// SPDX-License-Identifier: MIT
// A density map that the molecule is in, of `pliant play --map`: its surface, and how many of what is
// shown are inside of it.
import {fromBase64} from '../base64.mjs';
import {shell} from '../view/shell.mjs';
import {pointOf} from '../view/vectors.mjs';
import {$, units} from './dom.mjs';

/** Whether a place is inside: by the nearest point of the grid. */
export function isInside({inside, shape, origin, spacing}, place) {
  const at = place.map((x, c) => Math.round((x - origin[c]) / spacing));
  if (at.some((k, c) => k < 0 || k >= shape[c])) return false;
  return inside[(at[0] * shape[1] + at[1]) * shape[2] + at[2]] === 1;
}

export class MapShown {
  constructor({session, stage, view}) {
    Object.assign(this, {session, stage, view});
    stage.on('began', () => this.show());
    stage.on('changed', () => this.tell());
    $('show-map').onchange = () => this.show();
  }

  set({positions, step, triangles, inside, ...grid}) {
    const corners = Float32Array.from(new Int16Array(fromBase64(positions).buffer), (x) => x * step);
    this.shell = shell(corners, Uint32Array.from(new Uint16Array(fromBase64(triangles).buffer)), this.view.uniforms);
    this.grid = {...grid, inside: fromBase64(inside)};
    this.fileName = this.session.fileName;  // of what is in the map
    this.show();
    this.tell();
  }

  get isOn() {
    return this.fileName !== undefined && this.fileName === this.session.fileName;
  }

  show() {
    $('map').hidden = $('show-map-row').hidden = !this.isOn;
    this.view.shell = this.isOn && $('show-map').checked ? this.shell : null;
    this.view.stale = true;
  }

  tell() {
    if (!this.isOn) return;
    const {sites} = this.stage;
    const {data} = this.view.textures.positions;
    const count = sites.filter((joint) => isInside(this.grid, pointOf(data, joint, 4))).length;
    $('out-map').textContent = `${count} of ${units(sites.length, 'residue')} inside`;
  }
}
