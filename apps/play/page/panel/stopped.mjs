// SPDX-License-Identifier: MIT
// What is said of a step that the clock has ended, or that ended with broken bars: once a drag.
import {$, say, shortNumber} from './dom.mjs';

const percent = (residual) => `${shortNumber(100 * Math.abs(residual))} %`;

export class Stopped {
  constructor(session, stage) {
    Object.assign(this, {session, stage});
    this.isSaid = false;
    $('step-limit').onchange = () => this.limit();
    session.on('stopped', (step) => this.tell(step));
    session.on('released', () => { this.isSaid = false; });
    session.on('settings', () => { this.isSaid = false; });
    session.on('step', (step) => this.arrived(step));
  }

  limit() {
    const value = Number($('step-limit').value);
    if (!(value >= 0)) {
      $('step-limit').value = this.session.stepLimit;
      return say(`Stop a step after: expected milliseconds, or 0 for never, found "${value}"`);
    }
    return this.session.limitSteps(value).catch((error) => say(error.message));
  }

  worstOf(bar, residual) {
    const name = this.session.model.barName(bar);
    return residual > 0 ? `Its worst bar then: ${name}, ${percent(residual)} off.` : '';
  }

  tell({stopped}) {
    if (this.isSaid) return;
    this.isSaid = true;
    const {technique} = this.session.settings;
    const {sweeps, worst, residual, milliseconds} = stopped;
    say(`${technique} did not make all bars whole within ${milliseconds} ms: the step was stopped after ` +
      `${sweeps.toLocaleString('en')} sweeps and taken back. ${this.worstOf(worst, residual)} ` +
      'Choose another technique (auto takes what fits), pull less far, or allow more time under Resolve.', true);
  }

  /** The limit of sweeps that a person has set leaves bars broken: the worst is named. */
  arrived(step) {
    if (step.converged !== false || this.isSaid || this.session.live || step.worst === undefined) return;
    this.isSaid = true;
    say(`Not all bars are whole after ${step.sweeps.toLocaleString('en')} sweeps. The worst: ` +
      `${this.session.model.barName(step.worst)}, ${percent(step.residual)} off.`, true);
  }
}
