// SPDX-License-Identifier: MIT
// The start scene: a drawn hand pulls an atom out and back, once, by real steps of the solver. Then they
// are taken back, and the molecule is the user's. Whatever the user does ends it at once.
import {$} from '../panel/dom.mjs';

const ENDS = ['pointerdown', 'wheel', 'keydown', 'touchstart'];
const WANDER = 24;  // CSS pixels of a pointer over the picture that count as doing something
const OUT = 1500;  // ms in which the hand comes as far as it goes; the same time back
const FAR = 0.2;  // of the shorter edge of the picture
const WAIT = 400;  // ms before it begins
const SLOW = 40;  // ms of the scene that a frame stands for at most: a slow page shows it slower

const still = () => matchMedia('(prefers-reduced-motion: reduce)').matches;
const eased = (share) => share * share * (3 - 2 * share);

export class Demo {
  constructor({session, stage, hand, view, hint}) {
    Object.assign(this, {session, stage, hand, view, hint});
    this.isOver = still();
    this.way = 0;
    this.listening = new AbortController();
    const {signal} = this.listening;
    for (const name of ENDS) addEventListener(name, () => this.stop(), {capture: true, signal});
    $('canvas').addEventListener('pointermove', (event) => this.wandered(event), {signal});
  }

  wandered({movementX, movementY}) {
    this.way += Math.hypot(movementX, movementY);
    if (this.way > WANDER) this.stop();
  }

  /** Pulls this joint along the screen; `way` in shares of the shorter edge. A promise of the end. */
  start(joint, way) {
    if (this.isOver) return this.stop();
    const {width, height} = this.view.orbit.size;
    Object.assign(this, {joint, reach: way.map((x) => x * FAR * Math.min(width, height)), time: -WAIT});
    this.from = this.view.orbit.project(this.hand.positionOf(joint));
    this.hint.isDemo = true;
    return new Promise((done) => { this.finish = done; });
  }

  /** Once a frame of the screen. */
  tick(now) {
    if (this.isOver || this.joint === undefined) return;
    this.time += Math.min(SLOW, now - (this.before ?? now));
    this.before = now;
    const share = this.time / OUT;
    if (share >= 2) return this.end();
    const along = eased(Math.max(0, share <= 1 ? share : 2 - share));
    const at = {x: this.from.x + along * this.reach[0], y: this.from.y + along * this.reach[1]};
    this.draw(at);
    if (share < 0) return;
    if (!this.hand.held) this.hand.grasp(this.joint, this.from);
    this.hand.drag(at);
  }

  draw({x, y}) {
    const drawn = $('demo-hand');
    drawn.removeAttribute('hidden');
    drawn.style.transform = `translate(${x - 12}px, ${y - 4}px)`;
  }

  /** Came to its end by itself: the steps are taken back, to the bit. */
  async end() {
    this.stop();
    while (this.hand.busy) await new Promise(requestAnimationFrame);
    if (this.session.strokes.length === 1 && !this.hand.held) await this.session.undo();
  }

  /** The molecule is left where it is; a later Undo takes the pull back. */
  stop() {
    this.listening.abort();
    $('demo-hand').setAttribute('hidden', '');
    if (!this.isOver && this.hand.held?.joint === this.joint) this.hand.release();
    this.isOver = true;
    this.hint.isDemo = false;
    this.hint.pulled = false;
    this.finish?.();
  }
}
