// SPDX-License-Identifier: MIT
// The session: what is open, where it is, what has been done. It asks the worker, one request after
// the other, and tells whoever listens; it knows no element of the page.
import {bytesInside, unzipped, workerInside} from './inside.mjs';

/** Fields that a reply of `open` may leave out. */
function completed(reply) {
  const joints = reply.joints;
  const model = {
    title: '', kind: 'graph', model: '', names: [], warnings: [], kindNames: [], chain: [],
    rigidClusters: 0, colouredClusters: 0, unfit: {},
    ...reply,
  };
  model.elements ??= new Uint8Array(joints);
  model.residue ??= new Int32Array(joints);
  model.cluster ??= new Int32Array(joints).fill(-1);
  for (const name of ['trace', 'bars', 'bonds', 'contacts']) model[name] ??= new Int32Array(0);
  model.nameOf = (joint) => model.names[joint] ?? `joint ${joint}`;
  model.barName = (bar) => `${model.nameOf(model.bars[2 * bar])} – ${model.nameOf(model.bars[2 * bar + 1])}`;
  model.contactName = (contact) => {
    const [a, b] = [model.contacts[2 * contact], model.contacts[2 * contact + 1]];
    const kind = (model.contactKindNames?.[model.contactKinds[contact]] ?? 'contact').replaceAll('_', ' ');
    return `${kind} ${model.nameOf(a)} – ${model.nameOf(b)}`;
  };
  return model;
}

const OPENS = new Set(['open', 'example', 'path']);
/** Calls after which all is as it was. */
const QUESTIONS = new Set([
  'boot', 'again', 'forces', 'recorded', 'state', 'path_steps', 'why', 'pair', 'edited', 'select',
  'force_file', 'step_limit',
]);
const FOREVER = 1e9;  // ms

/** Of a replay that goes on by the clock: the steps that it made. */
const slice = (what, reply) => (what === 'replay_steps' ? {milliseconds: FOREVER, most: reply.frames.length + Number(reply.over)} : {});

export class Session extends EventTarget {
  constructor() {
    super();
    this.model = null;
    this.positions = null;
    this.settings = {};
    this.pins = new Set();
    this.source = null;  // what was opened, to open it again with another model
    this.strokes = [];  // numbers of pulls of each drag or push, for undo
    this.queue = Promise.resolve();
    this.asked = [];  // of the solver, since it was opened
    this.live = null;  // the run that is shown, in place of the solver
    this.stepLimit = 100;  // ms after which a step is ended and taken back; 0: never
  }

  tell(name, detail) {
    this.dispatchEvent(new CustomEvent(name, {detail}));
  }

  on(name, action) {
    this.addEventListener(name, (event) => action(event.detail));
  }

  /** Starts the solver; the reply of `boot` tells what it can do. */
  async boot() {
    this.client = await workerInside('solver-worker');
    const wasm = await bytesInside('solver-wasm');
    this.facts = await this.client.ask('boot', {wasm}, [wasm.buffer]);
    return this.facts;
  }

  /** One request after the other: a reply never belongs to a session that is no more. */
  ask(what, request, transfer) {
    const reply = this.queue.then(() => this.client.ask(what, request, transfer));
    this.queue = reply.then((done) => this.remember(what, request, done), () => {});
    return reply;
  }

  /** What changed the session, in its order: it can be done once more, to the same bits. */
  remember(what, request, reply) {
    if (OPENS.has(what)) this.asked = [];
    else if (!QUESTIONS.has(what) && !reply.stopped) this.asked.push({do: what, ...request, ...slice(what, reply)});
  }

  /** Does again what another session was asked for, and stands where it stood. */
  async repeat(asked, {strokes, pins}) {
    let reply = null;
    const limit = this.stepLimit;
    await this.limitSteps(0);  // whatever was done arrived, and does so here however slow this is
    for (const {do: what, ...request} of asked) {
      const {id, ok, ...done} = await this.ask(what, request);
      if (what === 'settings') this.settings = done.settings ?? done;
      else reply = done.frames?.at(-1) ?? done;
      if (reply?.positions) [this.positions, this.step] = [reply.positions, reply.step];
    }
    await this.limitSteps(limit);
    this.before = null;
    this.strokes = strokes;
    this.pins = new Set(pins);
    if (asked.some(({do: what}) => what === 'edit' || what === 'replay_steps'))
      this.tell('edited', this.takeEdited(await this.ask('edited', {})));
    this.tell('settings', this.settings);
    this.tell('pins', this.pins);
  }

  /** `known`: positions and bonds that a program knows better than the text of the file. */
  async openFile(name, bytes, model = 'auto', known = {}) {
    const file = await unzipped(name, bytes);
    return this.begin({do: 'open', name: file.name, bytes: file.bytes, model, ...known});
  }

  openExample(name, model = 'auto') {
    return this.begin({do: 'example', name, model});
  }

  /** What is open, from its start, with another model. */
  again(model) {
    return this.begin({...this.source, model});
  }

  async begin(source) {
    const {do: what, ...request} = source;
    const reply = await this.ask(what, request);
    this.source = source;
    this.fileName = source.name ?? '';
    this.model = completed(reply);
    this.positions = reply.positions;
    this.before = null;
    this.pins = new Set(reply.pinned ?? []);
    this.strokes = [];
    if (reply.settings) this.settings = reply.settings;
    this.isNewStroke = true;
    this.tell('open', this.model);
    await this.change({});
    await this.limitSteps(this.stepLimit);
    return this.model;
  }

  /** Any subset of the settings; the reply tells those in force. */
  async change(settings) {
    const {id, ok, ...all} = await this.ask('settings', settings);
    this.settings = all.settings ?? all;
    this.tell('settings', this.settings);
  }

  /** A step that takes longer is ended and taken back; 0: none is. */
  async limitSteps(milliseconds) {
    await this.ask('step_limit', {milliseconds});
    this.stepLimit = milliseconds;
  }

  /** One step; `forces` as [[joint, x, y, z], ...], kJ/(mol Angstrom). */
  async pull(forces, isNewStroke = true) {
    if (this.live) return this.live.pull(forces);
    const step = await this.ask('pull', {forces, pins: [...this.pins]});
    this.isNewStroke ||= isNewStroke || this.isSealed || !this.strokes.length;
    this.isSealed = false;
    if (step.stopped) return this.stop(step);
    if (this.isNewStroke) this.strokes.push(0);
    this.isNewStroke = false;
    this.strokes[this.strokes.length - 1] += 1;
    return this.stand(step, forces);
  }

  /** The push bar by bar; afterwards the walker stands where pull() would have left it. */
  async resolution(forces) {
    const shown = await this.ask('resolution', {forces, pins: [...this.pins]});
    if (!shown.stopped) this.strokes.push(1);
    return shown;
  }

  /** Angstrom by which a force has to move a joint to bring it `way` further: against its velocity,
   * since Verlet goes on as in the last step. */
  effort(joint, way) {
    const [now, before] = [this.positions, this.before ?? this.positions];
    const moved = [0, 1, 2].map((c) => now[3 * joint + c] - before[3 * joint + c]);
    if (this.live) return this.live.effort(way, moved);
    const share = 1 - (this.settings.damping ?? 0);
    return way.map((x, c) => x - share * moved[c]);
  }

  /** A step that did not arrive in time: it has been taken back, and all stands where it was. */
  stop(step) {
    this.tell('stopped', step);
    return step;
  }

  stand(step, forces = []) {
    this.before = this.positions;
    this.positions = step.positions;
    this.tell('step', {...step, forces});
    return step;
  }

  /** {frames} of the session's walker, or {walkers}: where each of several is after so many steps. */
  wander(steps, walkers, goOn) {
    return this.ask('wander', {steps, walkers, pins: [...this.pins], go_on: goOn});
  }

  compare(technique, weighting) {
    return this.ask('again', {technique, weighting});
  }

  /** Takes the last drag back. Returns the number of steps that went. */
  async undo() {
    const steps = this.strokes.pop() ?? 0;
    if (!steps) return 0;
    const before = await this.ask('undo', {steps});
    this.positions = before.positions;
    this.before = null;
    if (before.edited) this.tell('edited', this.takeEdited(await this.ask('edited', {})));
    this.tell('undone', {...before, steps});
    return steps;
  }

  /** Rows of a word (cut, bar, restore, turn), two joints and perhaps a length: one stroke for undo. */
  async edit(edits) {
    const model = await this.ask('edit', {edits});
    this.strokes.push(1);
    this.isSealed = true;  // pulls that go on are no part of it
    this.tell('edited', this.takeEdited(model));
  }

  /** Edits that a force file has made: each is a stroke of its own. */
  async tookEdits(count) {
    if (!count) return;
    for (let k = 0; k < count; ++k) this.strokes.push(1);
    this.tell('edited', this.takeEdited(await this.ask('edited', {})));
  }

  /** What is there after edits takes the place of what was; the model stays the same object. */
  takeEdited(reply) {
    Object.assign(this.model, completed(reply));
    this.positions = reply.positions;
    return this.model;
  }

  async forces() {
    return (await this.ask('forces', {})).text;
  }

  /** What a file of the session says besides its frames. */
  recorded() {
    return this.ask('recorded', {name: this.fileName});
  }

  togglePin(joint) {
    if (this.live) return this.tell('error', new Error('A run is pinned where it is started: pliant run --pin.'));
    if (!this.pins.delete(joint)) this.pins.add(joint);
    return this.tell('pins', this.pins);
  }

  clearPins() {
    this.pins.clear();
    this.tell('pins', this.pins);
  }
}
