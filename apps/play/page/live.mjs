// SPDX-License-Identifier: MIT
// A run that goes on elsewhere, of `pliant play --connect`: its frames are shown, drags pull on it.
// The page asks for a frame once it has drawn the last, and is given the newest one.
import {Gain} from './gain.mjs';
import {OtherPulls} from './other_pulls.mjs';
import {$, say} from './panel/dom.mjs';

const NUMBERS = 6;  // 64-bit floats before the positions: see python/pliant/play/bridge.py
const SILENT = 2000;  // ms without a frame after which the page says so
const SPRING = 5;  // kJ/(mol Angstrom^2)
const STRONGEST = 60;  // kJ/(mol Angstrom): 1 nN, as when proteins are unfolded by pulling
const PACE = 0.1;  // share of the newest in frames and steps a second

/** Step, time, residual and so on, and positions in Angstrom, of a message of the bridge. */
function unpacked(data) {
  const [step, time, residual, , sweeps, missed] = new Float64Array(data, 0, NUMBERS);
  const positions = Float64Array.from(new Float32Array(data, 8 * NUMBERS));
  return {step, time, residual, sweeps: sweeps || 0, converged: !(missed > 0), projections: 0, positions};
}

export class Live {
  constructor({session, stage, hand, look, view}) {
    Object.assign(this, {session, stage, hand});
    look.allow('residual', false);  // a run tells of its worst bar alone
    this.state = {text: 'Connecting', kind: ''};
    this.steps = 1;  // of the run, between the last two frames
    this.seconds = 0;  // between the last two frames
    this.gain = new Gain();
    this.rates = {frames: 0, steps: 0};
    this.waiting = [];
    this.isPulling = false;
    this.others = new OtherPulls(session, view, hand);
    session.on('released', () => this.release());
  }

  /** Opens the connection; a promise of the first frame. */
  start(address) {
    this.session.live = this;
    document.body.classList.add('live');
    this.socket = new WebSocket(address);
    this.socket.binaryType = 'arraybuffer';
    this.socket.onmessage = ({data}) => this.take(data);
    this.socket.onclose = ({reason}) => this.stop(
      `The connection to pliant play is lost${reason ? `: ${reason}` : ''}.`);
    return this.next();
  }

  next() {
    return new Promise((done) => { this.waiting.push(done); });
  }

  send(said) {
    if (this.socket.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(said));
  }

  /** Once a frame of the screen, after it was drawn. */
  tick(now) {
    if (this.isOver || this.socket.readyState !== WebSocket.OPEN) return;
    if (!this.isAsked) {
      this.isAsked = true;
      this.askedAt = now;
      this.send({do: 'next'});
    }
    if (now - this.askedAt > SILENT) this.tell('Waiting for the run', '');
  }

  take(data) {
    if (typeof data === 'string') {
      const said = JSON.parse(data);
      return said.pulls ? this.others.show(said.pulls) : this.end(said);
    }
    this.isAsked = false;
    const frame = unpacked(data);
    if (frame.positions.length !== this.session.positions.length)
      return this.stop(`The run has ${frame.positions.length / 3} joints, the file ${this.session.positions.length / 3}.`);
    this.measure(frame);
    this.isDynamics = Number.isNaN(frame.residual);  // GROMACS or NAMD, which tell of no bars
    this.state = frame.converged ? {text: 'Live', kind: 'good'} : {text: 'Live, not converged', kind: 'bad'};
    this.session.stand(frame);
    for (const done of this.waiting.splice(0)) done();
    return undefined;
  }

  /** How many frames and steps a second there are, and how many steps a frame. */
  measure({step, time}) {
    const now = performance.now();
    const seconds = (now - (this.cameAt ?? now)) / 1000;
    if (seconds > 0 && step >= this.step) {
      this.steps += 0.4 * (Math.max(1, step - this.step) - this.steps);
      const blend = (name, value) => { this.rates[name] += (this.rates[name] ? PACE : 1) * (value - this.rates[name]); };
      blend('frames', 1 / seconds);
      blend('steps', (step - this.step) / seconds);
    }
    [this.cameAt, this.step, this.seconds] = [now, step, seconds];
    if (time > 0 && step > 0) this.session.settings.timestep = time / step;
  }

  end({over, ended}) {
    this.stop(ended ? 'The run has ended. What was recorded can be replayed and saved.'
      : `${over[0].toUpperCase()}${over.slice(1)}.`, ended);
  }

  /** No more frames; the first reason counts. */
  stop(text, hasEnded = false) {
    if (this.isOver) return;
    this.isOver = true;
    this.hand.release();
    this.others.show([]);
    this.hand.isReplay = true;
    for (const done of this.waiting.splice(0)) done();
    this.tell(hasEnded ? 'The run has ended' : 'Connection lost', hasEnded ? '' : 'bad');
    say(text, hasEnded);
    this.socket.close();
  }

  tell(text, kind) {
    if (this.state.text === text) return;
    this.state = {text, kind};
    this.stage.tell('changed');
  }

  /** These forces act until others come; a promise of the next frame. */
  pull(forces) {
    if (this.stage.at !== null) this.stage.live();
    this.isPulling = forces.length > 0;
    this.send({do: 'pull', forces});
    return this.next();
  }

  release() {
    this.gain.release();
    if (this.isPulling) this.send({do: 'pull', forces: []});
    this.isPulling = false;
  }

  /** How many times as far a frame has to take a joint as on a page that is fast enough. */
  get pace() {
    return Gain.pace(this.seconds);
  }

  /** The force of a spring to the pointer, kJ/(mol Angstrom), for a run of molecular dynamics: its atoms
   * have masses and velocities of their own, and what is too strong tears bonds. */
  spring(way) {
    const far = Math.max(Math.hypot(...way), 1e-12);
    return way.map((x) => x / far * Math.min(SPRING * far, STRONGEST));
  }

  /** Angstrom by which a force has to move a joint in each step to bring it `way` further until the
   * next frame. */
  effort(way, moved) {
    return this.gain.effort(way, moved, this.steps, this.seconds);
  }
}

/** Numbers of the status line that a run has and the page's own solver has not. */
export function showRates({frames, steps}) {
  $('out-rate').textContent = frames.toFixed(0);
  $('out-pace').textContent = Number(steps.toPrecision(3)).toLocaleString('en');
}
