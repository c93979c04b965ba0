// SPDX-License-Identifier: MIT
// Axes about which domains turn: a shaft along each, its head where a right-handed turn points to.
// They stand still against one domain and go along with it.
import {superpose} from '../record/superpose.mjs';
import {arrow, drawSolids} from './solids.mjs';
import {dot, less, plus, pointOf, times} from './vectors.mjs';

const BEYOND = 6;  // Angstrom that a shaft is longer than the domain that turns about it
const EDGE = [0.067, 0.094, 0.122, 1];
const HEAD = 2.4;  // Angstrom

function turned([a, b, c, d, e, f, g, h, i], [x, y, z]) {
  return [a * x + b * y + c * z, d * x + e * y + f * z, g * x + h * y + i * z];
}

/** The edge first: a thicker one below. */
function shaft([start, end], colour) {
  const grown = times(less(end, start), 0.07 / Math.hypot(...less(end, start)));
  return [
    ...arrow(start, plus(end, grown), {thick: 0.42, head: HEAD + 0.14, wide: 1.09, paint: EDGE}),
    ...arrow(start, end, {thick: 0.28, head: HEAD, wide: 0.73, paint: [...times(colour, 1 / 255), 1]}),
  ];
}

/** Ends of the shaft: along the axis as far as the joints of the domain go, and some more. */
export function endsOf({point, axis}, joints, positions) {
  let [low, high] = [Infinity, -Infinity];
  for (const joint of joints) {
    const along = dot(less(pointOf(positions, joint), point), axis);
    [low, high] = [Math.min(low, along), Math.max(high, along)];
  }
  return [low - BEYOND, high + BEYOND].map((along) => plus(point, times(axis, along)));
}

export class Hinges {
  /** `place`: the element over which the picture is, for words beside the axes. */
  constructor(view, place) {
    Object.assign(this, {view, place});
    this.rows = [];
    this.isShown = true;
    view.overlays.push(this);
  }

  /** Axes {ends, colour, words} that lie right in the frame `from`, a list of positions for each of them;
   * `core`: joints of the domain that they go along with. */
  set(rows, core) {
    this.core = core;
    for (const {label} of this.rows) label.remove();
    this.rows = rows.map((row) => ({...row, label: this.labelOf(row)}));
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
      row.now = row.ends.map((end) => plus(turned(rotation, less(end, from)), to));
    }
  }

  write({label, now}) {
    label.hidden = !this.isShown;
    const {x, y} = this.view.orbit.project(now[1]);
    label.style.transform = `translate(${Math.round(x + 8)}px, ${Math.round(y - 20)}px)`;
  }

  draw(view) {
    for (const row of this.rows) this.write(row);
    if (this.isShown) drawSolids(view, this.rows.flatMap(({now, colour}) => shaft(now, colour)));
  }
}
