// SPDX-License-Identifier: MIT
// Two techniques side by side, in step: the right pane makes every push of the left with another
// technique. Counts of both, which was whole first, and how far apart they end.
import {$, guarded, shortNumber, units} from './dom.mjs';
import {scaleColour} from '../view/colours.mjs';
import {Texture} from '../view/gl.mjs';

const like = ({format, width, height, data}) => new Texture(format, width, height, data.slice());

const none = () => ({steps: 0, sweeps: 0, projections: 0, broken: 0});

/** Adds a step to the counts of a pane. */
function count(total, step) {
  total.steps += 1;
  total.sweeps += step.sweeps;
  total.projections += step.projections;
  if (step.converged === false) total.broken += 1;
}

export class Beside {
  constructor(stage, session, view, resolution) {
    Object.assign(this, {stage, session, view, resolution});
    resolution.beside = this;
    this.isOn = false;
    $('split').onchange = () => guarded(() => this.toggle($('split').checked));
    session.on('step', (step) => this.stepped(step));
    session.on('stopped', (step) => this.stepped(step));
    session.on('undone', () => this.isOn && guarded(() => this.begin(this.asked)));
    stage.on('began', () => this.leave());
    stage.on('changed', () => this.isOn && this.follow());
  }

  toggle(isOn) {
    return isOn ? this.begin(this.chosen()) : this.end();
  }

  chosen() {
    return {technique: $('other').value, weighting: Number($('other-weighting').value)};
  }

  /** Begins where the session stands; `last`: with its last push, which both have then made. */
  async begin(asked, last = false) {
    const reply = await this.session.ask('twin', {...asked, last});
    this.asked = asked;
    this.name = asked.technique;
    this.totals = [none(), none()];
    this.room();
    this.take(last ? reply : {...reply, isStart: true});
    if (last) count(this.totals[0], this.stage.last);
    this.label();
    return reply;
  }

  async end() {
    this.leave();
    if (this.session.model) await this.session.ask('twin_end', {});
  }

  leave() {
    if (!this.isOn) return;
    this.isOn = false;
    this.panes(1);
  }

  room() {
    this.isOn = true;
    this.panes(2);
    const {strain, look} = this.view.textures;
    this.strain = like(strain);
    this.strain.data.fill(0);
    this.look = like(look);
    this.view.second = {strain: this.strain, look: this.look};
  }

  panes(number) {
    const {view, stage} = this;
    $('split').checked = number === 2;
    $('panes').hidden = number === 1;
    view.split = false;
    view.allocate(number);
    view.second = {};
    view.split = number === 2;
    stage.look();
    stage.mark();
    this.follow();
    view.fit();
  }

  /** The push that the session has just made, or tried to make. */
  async stepped(step) {
    if (!this.isOn || this.isBusy || step.isRepeated) return;
    if (!step.stopped) count(this.totals[0], step);
    await guarded(async () => {
      const reply = await this.session.ask('twin_step', {});
      if (this.isOn) this.take(reply);
    });
  }

  /** The same push as a film. */
  film() {
    return this.session.ask('twin_step', {watched: true});
  }

  show(film) {
    this.view.setPositions(film.positions, 1);
    this.setStrain(film.off);
    const {bar, near, far} = film.lit;
    const {lit} = this.view.uniforms;
    this.view.second.lit = [lit.value[0], near, far];
    this.view.second.litBar = bar;
    const [own, other] = this.resolution.films;
    const moment = (one, other) => {
      if (!one.isOver) return `visit ${one.at.toLocaleString('en')}, sweep ${one.sweep}, ${units(one.broken, 'bar')} broken`;
      const first = !other || one.count < other.count ? ', first' : '';
      return `${one.verdict} after ${units(one.count, 'visit')}${one.verdict === 'whole' ? first : ''}`;
    };
    $('pane-left').textContent = `${this.session.settings.technique}: ${moment(own, other)}`;
    $('pane-right').textContent = `${this.name}: ${moment(other, own)}`;
    for (const id of ['pane-left', 'pane-right']) $(id).classList.remove('first');
    $('pane-difference').textContent = '';
  }

  setStrain(off) {
    this.strain.data.set(off);
    this.strain.changed();
    this.view.stale = true;
  }

  /** The film is over: both ends. */
  land(reply) {
    delete this.view.second.lit;
    delete this.view.second.litBar;
    count(this.totals[0], this.stage.last);
    this.take(reply);
  }

  /** A step of the right pane. */
  take(reply) {
    if (reply.sweeps !== undefined && !reply.isStart && !reply.stopped) count(this.totals[1], reply);
    this.reply = reply;
    this.stopped = reply.stopped;
    this.positions = reply.positions;
    this.apart = reply.apart;
    this.colour(reply.aparts);
    this.setStrain(reply.residuals ?? new Float32Array(this.stage.strain.length));
    this.follow();
    this.label();
  }

  /** Joints of the right pane by their distance from those of the left. */
  colour(aparts) {
    const {data} = this.look;
    data.set(this.view.textures.look.data);
    const most = Math.max(this.apart.most, 1e-9);
    if ($('split-colour').checked && this.apart.most > 1e-4)
      aparts.forEach((far, joint) => data.set(scaleColour(far / most), 4 * joint));
    this.look.changed();
  }

  /** A replay has made its steps on both sides. */
  repeated(frames, {twin, apart, aparts}) {
    for (const frame of frames) {
      count(this.totals[0], frame);
      if (frame.twin) count(this.totals[1], frame.twin);
    }
    this.take({positions: twin, apart, aparts, isStart: true});
  }

  follow() {
    if (!this.stage.model || !this.isOn || this.stage.film) return;
    const {stage, view} = this;
    const frame = stage.at === null ? stage.session.positions : stage.frames.at(stage.at).positions;
    if (frame) view.setPositions(frame, 0);
    if (this.positions) view.setPositions(this.positions, 1);
  }

  label() {
    const [own, other] = this.totals;
    const told = (total, name, stopped) => {
      const broken = total.broken ? `, ${units(total.broken, 'step')} not whole` : '';
      return `${name}: ${units(total.sweeps, 'sweep')}, ${units(total.projections, 'visit')}${broken}${stopped ? ', the last stopped' : ''}`;
    };
    const isFirst = (one, another) => one.projections < another.projections && !one.broken;
    const panes = [['pane-left', own, other, this.session.settings.technique, this.stage.stop],
      ['pane-right', other, own, this.name, this.stopped]];
    for (const [id, one, another, name, stopped] of panes) {
      $(id).textContent = told(one, name, stopped) + (isFirst(one, another) ? ', fewer' : '');
      $(id).classList.toggle('first', isFirst(one, another));
    }
    const {rms, most, joint} = this.apart ?? {};
    $('pane-difference').textContent = !(most > 0) ? `Both stand alike${own.steps ? ` after ${units(own.steps, 'push', 'pushes')}` : ''}`
      : `Apart by ${shortNumber(rms)} Å (RMS), at most ${shortNumber(most)} Å at ${this.session.model.nameOf(joint)}`;
  }
}
