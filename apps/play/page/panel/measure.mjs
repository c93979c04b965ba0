// SPDX-License-Identifier: MIT
// Distances, angles and torsions of what is shown: tool Measure, a click on each of 2, 3 or 4 joints.
import {$, element} from './dom.mjs';

const KINDS = {
  distance: {count: 2, unit: ' Å', digits: 2}, angle: {count: 3, unit: '°', digits: 1},
  torsion: {count: 4, unit: '°', digits: 1},
};

const less = (a, b) => a.map((x, c) => x - b[c]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const degrees = (angle) => angle * 180 / Math.PI;
const angleOf = (a, b) => degrees(Math.atan2(Math.hypot(...cross(a, b)), dot(a, b)));

/** Torsion of a-b-c-d by IUPAC: from -180 to 180, clockwise positive. */
function torsionOf(a, b, c, d) {
  const [first, axis, last] = [less(b, a), less(c, b), less(d, c)];
  const [n1, n2] = [cross(first, axis), cross(axis, last)];
  return degrees(Math.atan2(dot(cross(n1, n2), axis) / Math.hypot(...axis), dot(n1, n2)));
}

/** Angstrom or degrees. */
export function measured(points) {
  if (points.length === 2) return Math.hypot(...less(points[0], points[1]));
  if (points.length === 3) return angleOf(less(points[0], points[1]), less(points[2], points[1]));
  return torsionOf(...points);
}

export class Measure {
  constructor({session, stage, view, hand, labels}) {
    Object.assign(this, {session, stage, view, hand, labels});
    this.list = [];
    this.picked = [];
    hand.takers.measure = (joint) => this.pick(joint);
    $('measure-kind').onchange = () => this.drop();
    $('measure-clear').onclick = () => this.clear();
    stage.on('began', () => this.clear());
    stage.on('changed', () => this.values());
    labels.put('measure', () => this.rows());
  }

  kind() {
    return KINDS[$('measure-kind').value];
  }

  drop() {
    this.picked = [];
    this.note();
  }

  pick(joint) {
    if (this.picked.at(-1) === joint) return;
    this.picked.push(joint);
    if (this.picked.length === this.kind().count) {
      this.add(this.picked);
      this.picked = [];
    }
    this.note();
  }

  /** A measurement of 2, 3 or 4 joints, shown until it is removed. */
  add(joints) {
    const name = Object.keys(KINDS).find((key) => KINDS[key].count === joints.length);
    this.list.push({name, joints: [...joints]});
    $('measure-panel').open = true;
    this.show();
  }

  remove(index) {
    this.list.splice(index, 1);
    this.show();
  }

  clear() {
    this.list = [];
    this.drop();
    this.show();
  }

  point(joint) {
    const {data} = this.view.textures.positions;
    return [data[4 * joint], data[4 * joint + 1], data[4 * joint + 2]];
  }

  text({name, joints}) {
    const {unit, digits} = KINDS[name];
    return measured(joints.map((joint) => this.point(joint))).toFixed(digits) + unit;
  }

  rows() {
    const rows = this.list.map((row) => ({joints: row.joints, text: this.text(row), kind: 'measure'}));
    if (this.picked.length) rows.push({joints: this.picked, text: '…', kind: 'measure'});
    return rows;
  }

  note() {
    this.view.stale = true;
    const {count} = this.kind();
    const names = this.picked.map((joint) => this.session.model.nameOf(joint)).join(', ');
    $('measure-note').textContent = names ? `${names}: ${count - this.picked.length} more`
      : `Choose the tool Measure above the picture, then click ${count} joints.`;
  }

  show() {
    this.view.stale = true;
    const {model} = this.stage;
    $('measure-list').replaceChildren(...this.list.map((row, k) => {
      const line = element('li');
      const remove = element('button', '×', {type: 'button', 'aria-label': `Remove measurement ${k + 1}`});
      remove.onclick = () => this.remove(k);
      line.append(element('output', this.text(row)), ` ${row.joints.map((joint) => model.nameOf(joint)).join(' – ')} `, remove);
      return line;
    }));
    $('measure-clear').disabled = !this.list.length;
  }

  /** Values in the list while things move. */
  values() {
    this.list.forEach((row, k) => {
      $('measure-list').children[k].firstChild.textContent = this.text(row);
    });
  }
}
