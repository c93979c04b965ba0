// SPDX-License-Identifier: MIT
// A force file: its pushes as a list, repeated on the molecule that is open, step by step, to the bits of
// `pliant run --forces`.
import {$, element, guarded, say, units, whenChosen} from './dom.mjs';

const SLICE = {milliseconds: 30, most: 50};  // of a replay between two frames of the screen
const WORDS = {pull: 'force', wander: 'random push', set: 'set', pin: 'pin', 'hold back': 'hold back', start: 'start'};

const nextFrame = () => new Promise((done) => requestAnimationFrame(done));

/** The model that a header names; bars of a name are a model of that name. */
function modelOf(header, known) {
  const named = header.input.find(({name}) => name === 'model' || name === 'bars');
  if (!named) return null;
  if (!known.includes(named.value))
    throw new Error(`The file was made with ${named.name} ${named.value}, which is not in the page.`);
  return named.value;
}

export class Forces {
  constructor(session, stage) {
    Object.assign(this, {session, stage});
    whenChosen('forces-file', (name, bytes) => this.open(name, bytes));
    $('forces-play').onclick = () => guarded(() => this.play(!this.isPlaying));
    $('forces-step').onclick = () => guarded(() => this.advance(1));
    $('forces-again').onclick = () => guarded(() => this.repeat());
    session.on('open', () => this.left());
    session.on('undone', () => this.left());
    session.on('step', (step) => step.isRepeated || this.left());
    this.show();
  }

  fill(facts) {
    this.facts = facts;
  }

  async open(name, bytes) {
    const {session} = this;
    if (!session.source || this.stage.isReplay)
      throw new Error(`${name} is a force file: open its molecule or graph first.`);
    const header = await session.ask('force_file', {name, bytes});
    const strange = header.input.find((row) => !['model', 'bars'].includes(row.name));
    if (strange) throw new Error(`${name} was made with ${strange.name} ${strange.value}, which the page does not do: pliant run --forces does.`);
    this.header = header;
    this.file = {name, bytes};
    this.model = modelOf(header, this.facts.models.map((row) => row.name));
    await this.begin();
    $('forces-panel').open = true;
    if (!header.input.length && header.joints === undefined && session.model.kind !== 'graph')
      say(`${name} does not say for which model it was made: the one that is open (${session.model.model}) is a guess.`, true);
  }

  /** The molecule from its start, with the file's model, and the file from its first step. */
  async begin() {
    const {session} = this;
    this.isBusy = true;
    try {
      const model = this.model ?? session.source.model;
      await session.begin({...session.source, ...(model === undefined ? {} : {model})});
      this.list = await session.ask('replay', this.file);
    } finally {
      this.isBusy = false;
    }
    this.steps = 0;
    this.next = 0;
    this.isOver = this.list.steps === 0;
    this.isReady = true;
    this.rows();
    this.show();
  }

  /** The session is no longer where the replay has left it. */
  left() {
    if (this.isBusy) return;
    this.isReady = this.isPlaying = false;
    this.show();
  }

  async play(isOn) {
    if (isOn && (!this.isReady || this.isOver)) await this.begin();
    this.isPlaying = isOn;
    this.show();
    while (this.isPlaying && this.isReady && !this.isOver) {
      await this.advance(SLICE.most);
      await nextFrame();
    }
    this.isPlaying = false;
    this.show();
  }

  /** Some steps; where the session stands afterwards is what the command has after them. */
  async advance(most) {
    if (!this.isReady || this.isOver || this.isBusy) return;
    const reply = await this.session.ask('replay_steps', {...SLICE, most});
    this.isBusy = true;
    reply.frames.forEach((frame, k) => this.took(frame, k === reply.frames.length - 1 ? reply : {}));
    await this.session.tookEdits(reply.edits);
    this.isBusy = false;
    this.next = reply.next;
    this.session.settings = reply.settings;
    this.session.tell('settings', reply.settings);
    this.session.pins = new Set([...reply.pins, ...(this.session.model.pinned ?? [])]);
    this.session.tell('pins', this.session.pins);
    this.isOver = reply.over;
    this.show();
  }

  took(frame, {broken, residuals, worst}) {
    const {session} = this;
    this.steps += 1;
    session.strokes.push(1);
    session.stand({...frame, broken, residuals, worst, isRepeated: true});
  }

  async repeat() {
    await this.begin();
    await this.play(true);
  }

  rows() {
    const line = ([what, text, count], k) => {
      const row = element('li', '', {value: k + 1});
      row.append(element('b', WORDS[what] ?? what), ` ${text}${count > 1 ? ` × ${count.toLocaleString('en')}` : ''}`);
      return row;
    };
    $('forces-list').replaceChildren(...this.list.rows.map(line));
    const more = this.list.events - this.list.rows.length;
    if (more > 0) $('forces-list').append(element('li', `and ${more.toLocaleString('en')} more`));
  }

  show() {
    const hasFile = Boolean(this.file);
    for (const id of ['forces-again', 'forces-play']) $(id).disabled = !hasFile;
    $('forces-step').disabled = !this.isReady || this.isOver;
    $('forces-play').textContent = this.isPlaying ? 'Pause' : 'Play';
    $('forces-play').setAttribute('aria-pressed', Boolean(this.isPlaying));
    $('forces-state').textContent = this.told();
    this.mark();
  }

  told() {
    if (!this.file) return 'Drop a force file, or choose one: its pushes are repeated on what is open.';
    const steps = `${this.file.name}: step ${(this.steps ?? 0).toLocaleString('en')} of ${units(this.list.steps, 'step')}`;
    if (!this.isReady) return `${steps}. The session has gone its own way since: Play begins again.`;
    return this.isOver ? `${steps}: all repeated.` : steps;
  }

  mark() {
    const rows = $('forces-list').children;
    for (const row of $('forces-list').querySelectorAll('[aria-current]')) row.removeAttribute('aria-current');
    const row = this.isReady ? rows[Math.min(this.next ?? 0, rows.length - 1)] : null;
    if (!row || this.isOver) return;
    row.setAttribute('aria-current', 'step');
    row.parentElement.scrollTop = row.offsetTop - row.parentElement.offsetTop - 40;
  }
}
