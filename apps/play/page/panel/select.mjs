// SPDX-License-Identifier: MIT
// Selection: by the words of `pliant run --select`, by residue and by click; labels of what is selected.
import {$, guarded, say, units} from './dom.mjs';

const MOST_LABELS = 300;

export class Select {
  constructor({session, stage, view, hand, labels}) {
    Object.assign(this, {session, stage, view, hand});
    this.joints = new Set();
    hand.takers.select = (joint) => this.toggle(joint);
    $('select-form').onsubmit = (event) => {
      event.preventDefault();
      return guarded(() => this.byWords($('select-text').value));
    };
    $('select-none').onclick = () => this.set([]);
    $('select-pin').onclick = () => this.pin();
    $('select-fit').onclick = () => this.fit();
    $('select-labels').onchange = () => { view.stale = true; };
    stage.on('began', () => this.set([]));
    labels.put('select', () => this.rows());
  }

  async byWords(text) {
    if (this.stage.isReplay) throw new Error('What is replayed from a file has no atoms to select by words.');
    const {joints} = await this.session.ask('select', {text});
    if (!joints.length) say(`"${text}" selects nothing.`, true);
    this.set(this.whole(joints));
  }

  /** With all of their residues, if that is wanted. */
  whole(joints) {
    if (!$('select-residues').checked) return joints;
    const {residue} = this.stage.model;
    const wanted = new Set(Array.from(joints, (joint) => residue[joint]));
    return Array.from({length: this.stage.model.joints}, (_, k) => k).filter((joint) => wanted.has(residue[joint]));
  }

  toggle(joint) {
    const wasIn = this.joints.has(joint);
    const all = new Set(this.joints);
    for (const one of this.whole([joint])) wasIn ? all.delete(one) : all.add(one);
    this.set(all);
  }

  set(joints) {
    this.joints = new Set(joints);
    const {stage} = this;
    const {model} = stage;
    stage.selected = this.joints.size ? Float32Array.from({length: model.joints}, (_, k) => Number(this.joints.has(k))) : null;
    stage.mark();
    const residues = new Set(Array.from(this.joints, (joint) => model?.residue[joint])).size;
    $('select-state').textContent = this.joints.size
      ? `${units(this.joints.size, 'joint')} of ${units(residues, 'residue')} selected` : 'Nothing is selected.';
    for (const id of ['select-none', 'select-pin', 'select-fit']) $(id).disabled = !this.joints.size;
  }

  pin() {
    const {session} = this;
    for (const joint of this.joints) if (!session.pins.has(joint)) session.togglePin(joint);
  }

  fit() {
    const shown = this.stage.at === null ? this.session.positions : this.stage.frames.at(this.stage.at).positions;
    const some = Float64Array.from([...this.joints].flatMap((joint) => [...shown.subarray(3 * joint, 3 * joint + 3)]));
    const {orbit, unit} = this.view;
    const {half, radius} = orbit;
    orbit.enclose(some, unit);
    Object.assign(orbit, {half, radius});  // the limits of zoom and the fog are those of all
    orbit.update();
    this.view.stale = true;
  }

  /** Names over the picture: of atoms, or of residues at their CA, P or first selected atom. */
  rows() {
    const what = $('select-labels').value;
    const {model} = this.stage;
    if (what === 'none' || !this.joints.size) return [];
    if (what === 'atoms')
      return [...this.joints].slice(0, MOST_LABELS).map((joint) => ({joints: [joint], text: model.nameOf(joint), kind: 'name'}));
    const at = new Map();
    for (const joint of this.joints) if (!at.has(model.residue[joint])) at.set(model.residue[joint], joint);
    for (const joint of model.trace) if (this.joints.has(joint)) at.set(model.residue[joint], joint);
    return [...at].slice(0, MOST_LABELS).map(([residue, joint]) => ({joints: [joint], text: this.residueName(residue, joint), kind: 'name'}));
  }

  residueName(residue, joint) {
    const row = this.stage.model.residues?.[residue];
    return row?.name ? `${row.chain?.trim() ?? ''}${row.chain?.trim() ? ':' : ''}${row.name}${row.number}` : this.stage.model.nameOf(joint);
  }
}
