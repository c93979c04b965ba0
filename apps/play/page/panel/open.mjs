// SPDX-License-Identifier: MIT
// What is opened: a file by choosing or dropping, an example, a random graph, a trajectory.
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
    $('generate-open').onclick = () => $('generate').showModal();
    $('generate').onclose = () => this.generated();
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
    this.fillGenerate(facts.classes ?? []);
  }

  fillGenerate(classes) {
    const select = element('select', '', {id: 'generate-class'});
    for (const {name} of classes) select.append(new Option(name, name));
    const note = () => {
      $('generate-note').textContent = classes.find(({name}) => name === select.value)?.title ?? '';
    };
    select.onchange = note;
    const rows = [element('label', 'Class', {for: 'generate-class'}), select];
    for (const [name, title, least, value] of SIZES) {
      rows.push(element('label', title, {for: `generate-${name}`}),
        element('input', '', {id: `generate-${name}`, type: 'number', min: least, value, step: 1}));
    }
    $('generate-rows').replaceChildren(...rows);
    if (classes.length) note();
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
    if (begins(bytes, 'pliant-ordering')) return this.order.open(name, bytes);
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

  generated() {
    if ($('generate').returnValue !== 'make') return undefined;
    $('generate').returnValue = '';
    const options = {class: $('generate-class').value};
    for (const [name] of SIZES) options[name] = Number($(`generate-${name}`).value);
    say('');
    return guarded(() => this.waiting(options.class, () => this.session.generate(options)));
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

// Name in `structgen`, title, least value, default.
const SIZES = [
  ['seed', 'Seed', 0, 1], ['joints', 'Joints of a tree (0: by depth)', 0, 0],
  ['depth', 'Levels of a tree', 1, 4], ['children', 'Most children', 1, 3],
  ['ring', 'Most joints of a ring', 3, 8], ['cycles', 'Cycles of an n-cycle', 0, 3],
];
