// SPDX-License-Identifier: MIT
// What is shown: the walker where it stands, or a frame of the recording; and what has been
// recorded. The picture, the plots and the save menu all look here.
import {Frames} from './record/frames.mjs';
import {Fluctuation} from './record/superpose.mjs';
import {colouringOf} from './view/colours.mjs';

/** What is held of a step; an H5MD file has it, and the bars that were broken are shown again. */
const KEPT = ['positions', 'broken', 'step', 'sweeps', 'projections', 'residual', 'rms', 'converged',
  'stopCode', 'limit', 'overlap', 'root', 'force'];
const FADE = 0.86;  // of the red of a broken bar, per frame shown
const MANY = 30000;  // joints; from here on RMSD is taken every eighth step
const LIVE_LOOK = 200;  // ms between two looks at colours that change by themselves

export class Stage extends EventTarget {
  constructor(view, session) {
    super();
    Object.assign(this, {view, session});
    this.frames = new Frames();
    this.history = [];
    this.recording = true;
    this.at = null;  // index of the frame shown; null: live
    this.isReplay = false;
    this.colouring = 'element';
    this.showStrain = true;
    this.selected = null;  // shares of 1 by joint, marked as the wave is
    session.on('open', (model) => this.begin(model, session.positions));
    session.on('step', (step) => this.take(step));
    session.on('undone', (before) => this.undone(before));
    session.on('stopped', (step) => this.stopped(step));
    session.on('pins', () => this.mark());
    session.on('edited', (model) => this.edited(model));
  }

  tell(name, detail) {
    this.dispatchEvent(new CustomEvent(name, {detail}));
  }

  on(name, action) {
    this.addEventListener(name, (event) => action(event.detail));
  }

  begin(model, positions) {
    this.model = model;
    this.isReplay = false;
    this.frames.clear();
    this.history = [];
    this.at = this.film = this.stop = this.last = null;
    this.strain = new Float32Array(model.bars.length / 2);
    this.fading = false;
    this.residuals = null;
    this.sites = model.trace.filter((joint) => joint >= 0);
    this.fluctuation = new Fluctuation(positions, this.measured());
    this.view.open(model, positions);
    this.look();
    this.mark();
    this.frames.add({sweeps: 0, projections: 0, residual: 0, converged: true, ...model.start, positions: positions.slice(), step: 0});
    this.tell('began', model);
    this.tell('changed');
  }

  /** Other bars and contacts hold the same joints: what was measured of the old ones is forgotten. */
  edited(model) {
    this.strain = new Float32Array(model.bars.length / 2);
    this.fading = false;
    this.residuals = null;
    if (this.last) this.last = {...this.last, broken: null, worst: -1};
    this.at = null;
    this.view.reopen(model, this.session.positions);
    this.look();
    this.mark();
    this.tell('edited', model);
    this.tell('changed');
  }

  /** Joints that RMSD is taken of: CA and P where there are any. */
  measured() {
    return this.sites.length > 2 ? this.sites : Int32Array.from({length: this.model.joints}, (_, k) => k);
  }

  /** A trajectory from a file, to be watched. */
  replay(model, frames) {
    this.begin(model, frames[0].positions);
    this.isReplay = true;
    this.session.fileName = model.title;
    this.frames.clear();
    for (const frame of frames) {
      if (!this.frames.add(frame)) break;
      this.remember(frame);
    }
    this.show(0);
    this.tell('began', model);
  }

  /** What was recorded before, in place of what is held. */
  restore(frames, at) {
    this.frames.clear();
    this.history = [];
    this.fluctuation = new Fluctuation(frames[0].positions, this.measured());
    for (const frame of frames) {
      if (!this.frames.add(frame)) break;
      this.remember(frame);
    }
    this.last = this.frames.at(-1);
    if (at === null) this.live();
    else this.show(at);
  }

  /** One step of the walker. */
  take(step) {
    const isSeen = this.at === null || !this.session.live;  // a run goes on while its past is looked at
    if (isSeen) this.at = null;
    this.stop = null;
    const frame = Object.fromEntries(KEPT.map((name) => [name, step[name]]));
    this.remember(frame);
    if (this.recording && !this.frames.add(frame)) this.stopFull();
    this.residuals = step.residuals ?? null;
    if (isSeen) this.paint(frame);
    this.last = step;
    this.tell('stepped', step);
    this.tell('changed');
  }

  /** A step that was taken back: nothing has moved; red is what the push had broken. */
  stopped(step) {
    this.at = null;
    this.stop = step.stopped;
    this.paint({positions: this.session.positions, broken: step.broken});
    this.tell('changed');
  }

  stopFull() {
    this.recording = false;
    this.tell('full');
  }

  remember(frame) {
    const skip = this.model.joints > MANY && this.history.length % 8;
    const rmsd = skip ? this.history.at(-1).rmsd : this.fluctuation.add(frame.positions);
    const {step, sweeps, residual} = frame;
    this.history.push({step, sweeps, residual, rmsd});
  }

  /** Steps that went, recorded or not. */
  undone({positions, step}) {
    while (this.history.length && this.history.at(-1).step > step) this.history.pop();
    this.frames.dropAfter(step);
    this.last = this.frames.at(-1);
    this.at = this.stop = null;
    this.fluctuation = new Fluctuation(this.frames.at(0).positions, this.measured());
    for (const frame of this.frames.list.slice(1)) this.fluctuation.add(frame.positions);
    this.paint({positions});
    this.tell('changed');
  }

  /** Positions, and the bars that were broken before the repair in red. */
  paint({positions, broken}) {
    this.view.setPositions(positions);
    if (broken && this.showStrain && broken.length === this.strain.length) {
      this.strain.set(broken);
      this.view.setStrain(this.strain);
      this.fading = true;
    }
  }

  show(index) {
    if (!this.frames.length) return;
    this.at = Math.min(Math.max(index, 0), this.frames.length - 1);
    this.paint(this.frames.at(this.at));
    this.tell('changed');
  }

  live() {
    if (this.isReplay || !this.model) return;
    this.at = null;
    this.paint({positions: this.session.positions});
    this.tell('changed');
  }

  /** Once a frame of the screen. */
  tick(now) {
    if (!this.model) return;
    if (this.fading && !this.holdsStrain) this.fade();
    const row = this.colouring === 'residual' || this.colouring === 'mobility';
    if (row && now - (this.looked ?? 0) > LIVE_LOOK && this.last) this.look(now);
  }

  fade() {
    let most = 0;
    for (let k = 0; k < this.strain.length; ++k) {
      const value = (this.strain[k] *= FADE);
      if (value > most || -value > most) most = Math.abs(value);
    }
    this.fading = most > 1e-5;
    if (!this.fading) this.strain.fill(0);
    this.view.setStrain(this.strain);
  }

  /** Colours and sizes of joints. */
  look(now = 0) {
    this.looked = now;
    const {model, view} = this;
    if (!model) return;
    const mobility = this.colouring === 'mobility' ? this.fluctuation.each() : null;
    view.showTautness(this.colouring === 'contacts');
    const residuals = this.residuals ?? this.last?.broken;
    view.setColours(colouringOf(this.colouring, model, {mobility, residuals}));
  }

  /** Pins, and the wave of the repair: shares of 1 by joint. */
  mark(wave = this.selected) {
    if (!this.model) return;
    const {marks} = this.view.textures;
    for (let joint = 0; joint < this.model.joints; ++joint) {
      marks.data[2 * joint] = this.session.pins.has(joint) ? 255 : 0;
      marks.data[2 * joint + 1] = wave ? Math.round(255 * wave[joint]) : 0;
    }
    marks.changed();
    this.view.stale = true;
  }

  /** RMSF by residue of the trace, Angstrom. */
  rmsf() {
    const each = this.fluctuation.each();
    return Array.from(this.sites, (joint) => each[joint]);
  }
}
