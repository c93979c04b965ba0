// SPDX-License-Identifier: MIT
// Words and lines over the picture: an SVG in CSS pixels, drawn anew whenever the picture is. What it
// stands at is what is shown: the texture of positions of the first walker.
import {pointOf} from './vectors.mjs';

const SVG = 'http://www.w3.org/2000/svg';

export class Labels {
  constructor(view, element) {
    Object.assign(this, {view, element});
    this.groups = new Map();  // name of who draws: a function that returns [{joints, text, kind}]
  }

  /** `rows()`: {joints: [...], text, kind}; lines from joint to joint, the text at their middle. */
  put(name, rows) {
    this.groups.set(name, rows);
    this.view.stale = true;
  }

  place(joint) {
    return this.view.orbit.project(pointOf(this.view.textures.positions.data, joint, 4));
  }

  /** After each drawing of the picture. */
  draw() {
    const {view, element} = this;
    const rows = view.model ? [...this.groups.values()].flatMap((rowsOf) => rowsOf()) : [];
    if (!rows.length && !element.firstChild) return;
    element.replaceChildren(...rows.flatMap((row) => this.shapes(row)));
  }

  shapes({joints, text, kind}) {
    const places = joints.map((joint) => this.place(joint));
    if (places.some(({depth}) => depth < -1 || depth > 1)) return [];
    const shapes = [];
    if (places.length > 1) {
      const line = document.createElementNS(SVG, 'polyline');
      line.setAttribute('points', places.map(({x, y}) => `${x.toFixed(1)},${y.toFixed(1)}`).join(' '));
      shapes.push(line);
    }
    const word = document.createElementNS(SVG, 'text');
    const mean = (axis) => places.reduce((sum, place) => sum + place[axis], 0) / places.length;
    word.setAttribute('x', mean('x').toFixed(1));
    word.setAttribute('y', (mean('y') - 7).toFixed(1));
    word.textContent = text;
    shapes.push(word);
    for (const shape of shapes) shape.setAttribute('class', kind);
    return shapes;
  }
}
