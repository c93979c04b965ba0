// SPDX-License-Identifier: MIT
// "Show resolution" of the thesis: the repair of one push in slow motion, bar by bar, with the bar in
// hand, its near and far end, and a wave where the repair has passed.
import {$, guarded, say, units} from './dom.mjs';
import {Film} from './film.mjs';
import {offerExample} from './resolution_offer.mjs';

const LONG = 60;  // seconds; a film that takes longer offers to be quicker
const SHORT = 20;  // seconds that it then takes

function duration(seconds) {
  if (seconds < 90) return units(Math.max(1, Math.round(seconds)), 'second');
  return seconds < 5400 ? units(Math.round(seconds / 60), 'minute') : units(Math.round(seconds / 3600), 'hour');
}

export class Resolution {
  constructor(stage, session, view, hand) {
    Object.assign(this, {stage, session, view, hand});
    $('resolution').onchange = () => this.toggle($('resolution').checked);
    $('resolution-skip').onclick = () => this.finish();
    $('film-skip').onclick = () => this.finish();
    $('film-pause').onclick = () => this.pause(!this.isPaused);
    $('film-back').onclick = () => this.stepBy(-1);
    $('film-next').onclick = () => this.stepBy(1);
    $('film-quick').onclick = () => this.hurry();
    $('resolution-speed').oninput = () => this.film && this.show();
    stage.on('began', () => this.forget());
    for (const what of ['settings', 'open']) session.on(what, () => $('resolution').checked && this.offer());
  }

  get perSecond() {
    return 10 ** Number($('resolution-speed').value);
  }

  toggle(isOn) {
    this.hand.onPush = isOn ? (forces) => guarded(() => this.push(forces)) : null;
    if (isOn) this.offer();
    else this.finish();
    $('resolution-offer').hidden = !isOn || !$('resolution-offer').textContent;
  }

  offer() {
    offerExample(this.session, this.stage);
  }

  async push(forces) {
    this.finish();
    const reply = await this.session.resolution(forces);
    reply.forces = forces;
    if (!reply.events) {
      this.offer();
      say(`${this.session.settings.technique} places many joints at once: the push has been resolved as a whole. ` +
        'Panel Bar by bar offers what can be shown.', true);
      return this.land(reply);
    }
    return this.start(reply);
  }

  start(reply) {
    const {stage, session} = this;
    this.film = new Film(reply, stage.model, session.settings);
    this.due = 0;
    this.before = null;
    this.isPaused = false;
    stage.holdsStrain = true;
    document.body.classList.add('filming');
    $('film').hidden = false;
    $('resolution-skip').disabled = false;
    this.show();
  }

  tick(now) {
    if (!this.film) return;
    const passed = this.before === null ? 0 : Math.min(0.1, (now - this.before) / 1000);
    this.before = now;
    if (this.isPaused) return;
    this.due += passed * this.perSecond;
    const visits = Math.floor(this.due);
    this.due -= visits;
    if (visits) this.goTo(this.film.at + visits);
    if (this.film.isOver && this.due > 0.5) this.finish();
  }

  goTo(visit) {
    this.film.goTo(Math.max(0, visit));
    this.show();
  }

  pause(isOn) {
    if (!this.film) return;
    this.isPaused = isOn;
    this.show();
  }

  /** One visit further or back; a film that runs stops there. */
  stepBy(visits) {
    if (!this.film) return;
    this.isPaused = true;
    this.goTo(Math.min(this.film.count, this.film.at + visits));
  }

  hurry() {
    if (!this.film) return;
    const speed = Math.log10(Math.max(1, (this.film.count - this.film.at) / SHORT));
    $('resolution-speed').value = Math.min(Number($('resolution-speed').max), Math.ceil(speed * 10) / 10);
    this.pause(false);
  }

  show() {
    const {stage, view, film} = this;
    stage.strain.set(film.off);
    view.setStrain(stage.strain);
    view.setPositions(film.positions);
    view.setLit(film.lit);
    stage.mark(film.wave());
    stage.film = this.state(film);
    stage.tell('film');
    this.say(film);
  }

  /** What the readout shows: the film's moment, not the end of the push. */
  state(film) {
    const worst = film.worst();
    const bars = film.off.length;
    const isWhole = film.broken === 0;
    return {
      step: film.reply.step, sweeps: film.sweep, projections: film.at, worst,
      residual: worst < 0 ? 0 : Math.abs(film.off[worst]),
      state: isWhole ? ['All bars whole', 'good'] : [`${film.broken.toLocaleString('en')} of ${units(bars, 'bar')} broken`, 'bad'],
    };
  }

  say(film) {
    const left = (film.count - film.at) / this.perSecond;
    const visits = `visit ${film.at.toLocaleString('en')} of ${film.count.toLocaleString('en')}, sweep ${film.sweep}`;
    $('film-text').textContent = `${visits} · ${this.isPaused ? 'paused' : `${duration(left)} left`}`;
    $('film-pause').textContent = this.isPaused ? 'Go on' : 'Pause';
    $('film-pause').setAttribute('aria-pressed', this.isPaused);
    $('film-quick').hidden = left < LONG;
    $('film-back').disabled = film.at === 0;
    $('said').textContent = this.isPaused ? visits : '';  // spoken where it stands, not on the way
  }

  finish() {
    if (!this.film) return;
    const {count, reply} = this.film;
    const part = reply.whole === false ? ', shown in part: there were more' : '';
    this.forget();
    $('said').textContent = `${units(count, 'visit')} of bars${part}`;
    this.land(reply);
  }

  forget() {
    this.film = null;
    this.stage.holdsStrain = false;
    this.stage.fading = true;
    this.stage.film = null;
    this.view.setLit({bar: -1, near: -1, far: -1});
    $('film').hidden = true;
    document.body.classList.remove('filming');
    $('resolution-skip').disabled = true;
    this.stage.mark();
  }

  /** The end of the push: what the solver says of it. */
  land(reply) {
    const step = {...reply, broken: reply.events ? undefined : reply.broken};
    if (reply.stopped) this.session.stop(step);
    else this.session.stand(step, reply.forces);
  }
}
