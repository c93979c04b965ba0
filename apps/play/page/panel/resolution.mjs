// SPDX-License-Identifier: MIT
// "Show resolution" of the thesis: the repair of one push in slow motion, bar by bar, with the bar in
// hand, its near and far end, and a wave where the repair has passed.
import {$, guarded, say, units} from './dom.mjs';

const FADE_BARS = 40;  // events after which a joint's wave has faded to a third

export class Resolution {
  constructor(stage, session, view, hand) {
    Object.assign(this, {stage, session, view, hand});
    $('resolution').onchange = () => this.toggle($('resolution').checked);
    $('resolution-skip').onclick = () => this.finish();
    stage.on('began', () => this.forget());
  }

  get isShowing() {
    return Boolean(this.film);
  }

  toggle(isOn) {
    this.hand.onPush = isOn ? (forces) => guarded(() => this.push(forces)) : null;
    if (!isOn) this.finish();
  }

  async push(forces) {
    this.finish();
    const film = await this.session.resolution(forces);
    film.forces = forces;
    if (!film.events) {
      say(film.why || 'This technique does not go bar by bar.', true);
      return this.land(film);
    }
    return this.start(film);
  }

  start(film) {
    const {stage} = this;
    this.film = film;
    this.at = 0;
    this.due = 0;
    this.count = film.events.length / 4;
    this.positions = Float64Array.from(film.pushed ?? stage.session.positions);
    this.wave = new Float32Array(stage.model.joints);
    this.passed = new Float32Array(stage.model.joints).fill(-1);
    stage.holdsStrain = true;
    stage.strain.set(film.broken ?? new Float32Array(stage.strain.length));
    this.view.setStrain(stage.strain);
    this.view.setPositions(this.positions);
    $('resolution-skip').disabled = false;
    this.before = null;
  }

  tick(now) {
    if (!this.film) return;
    const passed = this.before === null ? 0 : Math.min(0.1, (now - this.before) / 1000);
    this.before = now;
    this.due += passed * 10 ** Number($('resolution-speed').value);
    let stepped = false;
    for (; this.due >= 1 && this.at < this.count; --this.due, stepped = true) this.apply(this.at++);
    if (stepped) this.show();
    if (this.at >= this.count && this.due >= 1) this.finish();
  }

  /** One event: the two joints of a bar go where the technique puts them; the bar is whole. */
  apply(index) {
    const {events, moved} = this.film;
    const [bar, near, far] = events.subarray(4 * index, 4 * index + 3);
    this.positions.set(moved.subarray(6 * index, 6 * index + 3), 3 * near);
    this.positions.set(moved.subarray(6 * index + 3, 6 * index + 6), 3 * far);
    this.passed[near] = this.passed[far] = index;
    this.measure(near);
    this.measure(far);
    this.stage.strain[bar] = 0;
    this.view.setLit({bar, near, far});
  }

  /** Bars about a joint are off by what its move did to them. */
  measure(joint) {
    const {model, strain} = this.stage;
    if (!model.rest) return;
    for (const bar of this.barsOf(joint)) {
      const [a, b] = [3 * model.bars[2 * bar], 3 * model.bars[2 * bar + 1]];
      const x = this.positions;
      const length = Math.hypot(x[a] - x[b], x[a + 1] - x[b + 1], x[a + 2] - x[b + 2]);
      strain[bar] = length / model.rest[bar] - 1;
    }
  }

  barsOf(joint) {
    const {model} = this.stage;
    if (this.barsFor !== model.bars) {
      this.barsFor = model.bars;
      this.barLists = Array.from({length: model.joints}, () => []);
      for (let k = 0; k < model.bars.length; ++k) this.barLists[model.bars[k]].push(k >> 1);
    }
    return this.barLists[joint];
  }

  show() {
    for (let joint = 0; joint < this.wave.length; ++joint)
      this.wave[joint] = this.passed[joint] < 0 ? 0 : Math.exp((this.passed[joint] - this.at) / FADE_BARS);
    this.stage.mark(this.wave);
    this.view.setPositions(this.positions);
    this.view.setStrain(this.stage.strain);
    const sweep = this.film.events[4 * Math.max(0, this.at - 1) + 3];
    $('said').textContent = `visit ${this.at} of ${this.count.toLocaleString('en')}, sweep ${sweep + 1}`;
  }

  finish() {
    if (!this.film) return;
    const {film} = this;
    this.forget();
    $('said').textContent = film.whole === false ? 'Shown in part: there were too many visits'
      : `${units(this.count, 'visit')} of bars`;
    this.land(film);
  }

  forget() {
    this.film = null;
    this.stage.holdsStrain = false;
    this.view.setLit({bar: -1, near: -1, far: -1});
    $('resolution-skip').disabled = true;
    this.stage.mark();
  }

  land(film) {
    this.session.stand({...film, broken: film.events ? undefined : film.broken}, film.forces);
  }
}
