// SPDX-License-Identifier: MIT
// What the last step was, in numbers; what is open; what is under the pointer.
import {showRates} from '../live.mjs';
import {$, element, shortNumber, units} from './dom.mjs';

const LONGEST = 160;  // letters of a title that a file may give itself

const shortened = (text = '') => text.length > LONGEST ? `${text.slice(0, LONGEST)}…` : text;

function verdict(step) {
  if (step.converged === false) return ['Not converged', 'bad'];
  return ['All bars whole', 'good'];
}

/** Such a step has been taken back: what is seen is whole. */
const stoppedVerdict = ({milliseconds}) => [`Stopped after ${milliseconds} ms, taken back`, 'bad'];

export class Readout {
  constructor(stage, session, hand) {
    Object.assign(this, {stage, session});
    stage.on('began', (model) => this.began(model));
    stage.on('edited', (model) => this.began(model));
    stage.on('changed', () => this.refresh());
    stage.on('film', () => this.refresh());
    session.on('pins', () => this.pins());
    hand.onSay = (text) => { $('said').textContent = text; };
  }

  began(model) {
    const facts = [units(model.joints, 'joint'), units(model.bars.length / 2, 'bar')];
    if (model.contacts.length) facts.push(units(model.contacts.length / 2, 'contact'));
    if (model.rigidClusters) facts.push(units(model.rigidClusters, 'rigid cluster'));
    const name = this.session.fileName || model.title || 'No name';
    $('title').replaceChildren(element('b', name), ` · ${facts.join(', ')}`);
    $('title').title = shortened(model.title);
    document.title = `${name} – Pliant play`;
    this.pins();
    this.refresh();
  }

  /** The frame that is shown: the last step, or one of the recording. */
  shown() {
    const {stage} = this;
    if (stage.film) return stage.film;
    return stage.at === null ? stage.last ?? stage.frames.at(0) : stage.frames.at(stage.at);
  }

  refresh() {
    const step = this.shown();
    if (!step) return;
    $('out-step').textContent = step.step ?? '–';
    $('out-sweeps').textContent = step.sweeps ?? '–';
    $('out-projections').textContent = step.projections?.toLocaleString('en') ?? '–';
    $('out-residual').textContent = shortNumber(step.residual);
    const worst = step.worst ?? -1;
    $('out-residual').title = worst >= 0 ? this.session.model?.barName(worst) ?? '' : '';
    $('out-time').textContent = step.seconds === undefined ? '–' : `${(step.seconds * 1000).toFixed(2)} ms`;
    if (this.session.live) showRates(this.session.live.rates);
    const [text, kind] = this.state(step);
    $('out-verdict').textContent = text;
    $('out-verdict').className = kind;
  }

  state(step) {
    const {live} = this.session;
    if (live) return [live.state.text, live.state.kind];
    if (this.stage.film) return step.state;
    if (this.stage.isReplay) return ['Replay', ''];
    return this.stage.stop && this.stage.at === null ? stoppedVerdict(this.stage.stop) : verdict(step);
  }

  pins() {
    const {pins} = this.session;
    $('pins').textContent = pins.size ? units(pins.size, 'joint') : 'none';
    $('pins-clear').disabled = !pins.size;
  }
}
