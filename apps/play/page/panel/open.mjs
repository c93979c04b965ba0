// SPDX-License-Identifier: MIT
// What is opened: a file by choosing or dropping, an example, a trajectory.
import {$, element, guarded, say} from './dom.mjs';
import {openFrame} from '../record/ensemble_model.mjs';
import {isHdf5, readH5md} from '../record/hdf5.mjs';

const KINDS = {proteins: 'Proteins', molecules: 'Molecules', mechanisms: 'Mechanisms', graph: 'Graphs of the tests and the thesis'};
const DULL = /no_joints|one_joint|one_bar|two_joints|coincident/;  // nothing to be seen or pulled

const titleOf = (name) => {
  const words = name.replace(/\.[a-z]+$/, '').replaceAll('_', ' ');
  return words[0].toUpperCase() + words.slice(1);
};

const begins = (bytes, word) =>
  new RegExp(`^(\\s*(#.*)?\\n)*\\s*${word}\\b`).test(new TextDecoder().decode(bytes.subarray(0, 4000)));

/** A model to be watched, of what an H5MD file holds. */
function replayModel(name, file) {
  const joints = file.joints;
  const labels = file.names.map(String);
  const right = (list) => list.length && list.every((joint) => joint >= 0 && joint < joints);
  const bars = right(file.bars) ? file.bars : new Int32Array(0);
  return {
    title: name, kind: file.elements.some(Boolean) ? 'molecule' : 'graph', model: '', joints, names: labels,
    elements: file.elements.length === joints ? file.elements : new Uint8Array(joints),
    residue: new Int32Array(joints), chain: [''], cluster: new Int32Array(joints).fill(-1),
    trace: new Int32Array(0), bars, bonds: right(file.bonds) ? file.bonds : new Int32Array(0),
    contacts: new Int32Array(0), rest: file.rest, warnings: [],
    nameOf: (joint) => labels[joint] ?? `joint ${joint}`,
    barName: (bar) => `${labels[bars[2 * bar]]} – ${labels[bars[2 * bar + 1]]}`,
  };
}

export class Open {
  constructor(session, stage, hand) {
    Object.assign(this, {session, stage, hand});
    $('file').onchange = () => this.chosen();
    $('examples').onchange = () => this.example();
    stage.on('began', (model) => this.began(model));
    this.acceptDrops();
  }

  /** Examples: files that the page carries, and the graphs that the library makes. */
  fill(facts, files) {
    this.files = new Map(files.map((row) => [row.name, row.text]));
    const graphs = (facts.examples ?? []).filter(({name}) => !DULL.test(name));
    const groups = new Map();
    for (const {kind, name} of [...files, ...graphs]) {
      if (!groups.has(kind)) groups.set(kind, element('optgroup', '', {label: KINDS[kind] ?? kind}));
      groups.get(kind).append(new Option(titleOf(name), name));
    }
    $('examples').append(...groups.values());
  }

  acceptDrops() {
    addEventListener('dragover', (event) => {
      event.preventDefault();
      $('drop').hidden = false;
    });
    addEventListener('dragleave', (event) => { if (!event.relatedTarget) $('drop').hidden = true; });
    addEventListener('drop', (event) => {
      event.preventDefault();
      $('drop').hidden = true;
      const [file] = event.dataTransfer.files;
      if (file) guarded(() => this.openBlob(file));
    });
  }

  chosen() {
    const [file] = $('file').files;
    $('file').value = '';
    return file && guarded(() => this.openBlob(file));
  }

  async openBlob(file) {
    if (this.session.live) throw new Error('This page shows a run: pliant play opens files.');
    return this.openBytes(file.name, new Uint8Array(await file.arrayBuffer()));
  }

  async openBytes(name, bytes, model = $('model').value || 'auto', known = {}) {
    say('');
    if (isHdf5(bytes)) return this.openTrajectory(name, bytes, known.ensemble);
    if (begins(bytes, 'pliant-forces')) return this.forces.open(name, bytes);
    return this.waiting(name, () => this.session.openFile(name, bytes, model, known));
  }

  /** `found`: what pliant play found of the frames. */
  async openTrajectory(name, bytes, found) {
    const file = await this.waiting(name, () => readH5md(name, bytes));
    const opened = await this.waiting(name, () => openFrame(this.session, `${name}.cif`, file, file.frames[0]));
    const frames = file.frames.map((positions, k) => ({
      positions, step: found?.numbers?.[k] ?? k, sweeps: file.sweeps[k], projections: file.projections[k],
      residual: file.residual[k],
    }));
    const model = opened ? Object.assign(opened, {title: name}) : replayModel(name, file);
    this.stage.replay(model, frames);
    this.stage.tell('replayed', {name, file, found, canPull: opened !== null});
    if (frames.length < file.count) say(`${name}: the first ${frames.length} of ${file.count} frames are held.`, true);
  }

  example() {
    const name = $('examples').value;
    $('examples').value = '';
    if (!name) return undefined;
    say('');
    return guarded(() => this.openExample(name));
  }

  openExample(name, model = 'auto') {
    const text = this.files.get(name);
    if (text === undefined) return this.waiting(name, () => this.session.openExample(name));
    return this.openBytes(name, new TextEncoder().encode(text), model);
  }

  /** Says that a file is being read; where it cannot be, what was open stays open. */
  async waiting(name, action) {
    const title = [...$('title').childNodes];
    $('title').textContent = `Reading ${name}…`;
    try {
      return await action();
    } catch (error) {
      $('title').replaceChildren(...title);
      throw error;
    }
  }

  began(model) {
    this.hand.isReplay = this.stage.isReplay;
    if (model.warnings?.length) say(model.warnings.join('\n'), true);
  }
}
