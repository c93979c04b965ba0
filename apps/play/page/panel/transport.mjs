// SPDX-License-Identifier: MIT
// Record, stop, scrub, replay, undo and save.
import {$, guarded, say} from './dom.mjs';
import {FrameOrder} from './frame_order.mjs';
import {h5mdBytes} from '../record/hdf5.mjs';
import {pdbText} from '../record/pdb.mjs';
import {SAVES} from '../share/save.mjs';

/** Hands a file to the browser. */
export function download(parts, name, type) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob(parts, {type}));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

const stemOf = (title) => (title || 'pliant').split(/[\\/]/).pop().replace(/\.[a-z0-9]+$/i, '').replace(/[^\w.-]+/g, '_') || 'pliant';

export class Transport {
  constructor(stage, session, view) {
    Object.assign(this, {stage, session, view});
    this.playing = false;
    this.film = new FrameOrder(stage);
    $('record').onclick = () => this.record(!stage.recording);
    $('play').onclick = () => this.play(!this.playing);
    $('live').onclick = () => this.goLive();
    $('scrub').oninput = () => this.scrub();
    $('undo').onclick = () => guarded(() => this.undo());
    $('save').onchange = () => this.chosen();
    $('share').onclick = () => guarded(() => this.save('share'));
    stage.on('changed', () => this.refresh());
    stage.on('full', () => say('The recording is full (768 MB) and has stopped: save it, or undo.', true));
    session.on('step', () => session.live || this.play(false));
  }

  record(isOn) {
    this.stage.recording = isOn;
    this.refresh();
  }

  play(isOn) {
    if (isOn === this.playing) return;
    this.playing = isOn && this.stage.frames.length > 1;
    const {film, stage} = this;
    const isAtEnd = !film.order && stage.at === film.last;
    if (this.playing && (stage.at === null || isAtEnd)) stage.show(film.frame(0));
    this.place = Math.max(0, film.placeOf(stage.at ?? 0));
    this.before = null;
    this.refresh();
  }

  goLive() {
    this.play(false);
    this.stage.live();
  }

  scrub() {
    this.playing = false;
    this.stage.show(this.film.frame(Number($('scrub').value)));
  }

  async undo() {
    this.play(false);
    if (this.stage.isReplay) return say('What is replayed has nothing to undo.', true);
    const steps = await this.session.undo();
    if (!steps) say('There is nothing to undo.', true);
    return undefined;
  }

  tick(now) {
    if (!this.playing) return;
    const passed = this.before === null ? 0 : (now - this.before) / 1000;
    this.before = now;
    const {film, stage} = this;
    this.place += passed * film.rate * Number($('speed').value);
    const frame = film.frame(Math.floor(film.swung(this.place)));
    if (frame !== stage.at) stage.show(frame);
    if (this.place >= film.end) this.play(false);
  }

  refresh() {
    const {stage} = this;
    const last = Math.max(0, stage.frames.length - 1);
    const at = stage.at ?? last;
    $('scrub').max = Math.max(0, this.film.last);
    $('scrub').value = Math.max(0, this.film.placeOf(at));
    $('frame').textContent = `${at} / ${last}`;
    $('record').setAttribute('aria-pressed', stage.recording);
    $('play').setAttribute('aria-pressed', this.playing);
    $('play').textContent = this.playing ? '❚❚' : '▶';
    $('play').disabled = last < 1;
    $('scrub').disabled = last < 1;
    $('live').disabled = stage.at === null || stage.isReplay;
    $('undo').disabled = !this.session.strokes.length || stage.isReplay;
  }

  chosen() {
    const kind = $('save').value;
    $('save').value = '';
    return guarded(() => this.save(kind));
  }

  async save(kind) {
    const {stage, session} = this;
    if (!stage.model) throw new Error('Nothing is open that could be saved.');
    const stem = stemOf(session.fileName || stage.model.title);
    if (SAVES[kind]) return this.saveBeside(SAVES[kind], stem);
    if (kind === 'forces') return this.saveForces(stem);
    if (kind === 'png') return this.savePicture(stem);
    if (kind === 'pdb')
      return download(pdbText(stage.model, stage.frames.list), `${stem}.pdb`, 'chemical/x-pdb');
    const timestep = session.settings.timestep || 0.01;
    const isOwn = !session.live && !stage.isReplay;
    const recorded = isOwn ? await session.recorded() : null;
    const bytes = await h5mdBytes(stage.model, stage.frames.list, timestep, recorded);
    return download([bytes], `${stem}.h5md`, 'application/x-hdf5');
  }

  async saveBeside({make, ending, type}, stem) {
    say('Making the file…', true);
    download(await make(this.parts), `${stem}.${ending}`, type);
    say('');
  }

  async saveForces(stem) {
    if (this.session.live) throw new Error('A run keeps its forces itself, in OUT.forces: pliant run --record-forces.');
    if (this.stage.isReplay) throw new Error('What is replayed was made without forces of this page.');
    download([await this.session.forces()], `${stem}.forces.txt`, 'text/plain');
  }

  async savePicture(stem) {
    this.view.draw();
    const blob = await new Promise((resolve) => this.view.renderer.canvas.toBlob(resolve, 'image/png'));
    download([blob], `${stem}.png`, 'image/png');
  }
}
