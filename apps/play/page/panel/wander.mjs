// SPDX-License-Identifier: MIT
// Random pushes, one after the other, of one walker or of several over each other.
import {$, say} from './dom.mjs';

export class Wander {
  constructor(stage, session, view) {
    Object.assign(this, {stage, session, view});
    this.isOn = false;
    this.busy = false;
    $('wander').onclick = () => this.toggle(!this.isOn);
    stage.on('began', () => this.toggle(false));
  }

  toggle(isOn) {
    if (isOn && (!this.stage.model || this.stage.isReplay || this.session.live)) {
      say('Open a structure first: neither a trajectory from a file nor a run wanders here.', true);
      return;
    }
    this.isOn = isOn;
    this.hasBegun = false;
    if (isOn) this.session.strokes.push(0);
    else if (!this.busy) this.ended();
    $('wander').setAttribute('aria-pressed', isOn);
    $('wander').textContent = isOn ? 'Stop' : 'Wander';
    $('walkers').disabled = isOn;
    if (isOn) this.room(Math.round(Number($('walkers').value)) || 1);
    else if (this.view.walkers > 1) {
      this.room(1);
      this.stage.live();
    }
  }

  /** A walk of no step is none. The step under way when it was stopped still belongs to it. */
  ended() {
    if (this.session.strokes.at(-1) === 0) this.session.strokes.pop();
  }

  room(walkers) {
    this.walkers = Math.min(16, Math.max(1, walkers));
    $('walkers').value = this.walkers;
    if (!this.stage.model || this.view.walkers === this.walkers) return;
    this.view.allocate(this.walkers);
    for (let k = 0; k < this.walkers; ++k) this.view.setPositions(this.session.positions, k);
    this.stage.look();
    this.stage.mark();
  }

  /** Once a frame of the screen: one step, if the last has come back. */
  async tick() {
    if (!this.isOn || this.busy) return;
    this.busy = true;
    try {
      this.take(await this.asked());
    } catch (error) {
      this.toggle(false);
      say(error.message);
    } finally {
      this.busy = false;
      if (!this.isOn) this.ended();
    }
  }

  /** The session's walker goes on. Several begin where it is and are seen, but leave it there. */
  asked() {
    return this.session.wander(1, this.walkers, this.hasBegun);
  }

  take({frames, walkers, stopped}) {
    this.hasBegun = true;
    const {session} = this;
    if (stopped) {  // the same draw would not arrive the next time either
      this.toggle(false);
      session.stop({stopped});
    }
    for (const step of frames ?? []) {
      session.strokes[session.strokes.length - 1] += 1;
      session.stand(step);
    }
    if (this.isOn) walkers?.forEach((step, k) => k < this.view.walkers && this.view.setPositions(step.positions, k));
  }
}
