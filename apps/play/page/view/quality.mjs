// SPDX-License-Identifier: MIT
// How finely is drawn while something moves, by the time that the last pictures took: a processor
// without a graphics unit draws fewer pixels and a flatter ribbon. At rest all is drawn whole.
import {FLAT, ROUND} from './ribbon.mjs';

/** From the finest; `ratio`: pixels of the picture by those of the screen, along each edge. */
export const LEVELS = [
  {ratio: 1, segments: 8, sides: ROUND, isRich: true},
  {ratio: 1, segments: 6, sides: ROUND, isRich: false},
  {ratio: 0.75, segments: 4, sides: ROUND, isRich: false},
  {ratio: 0.66, segments: 4, sides: FLAT, isRich: false},
  {ratio: 0.5, segments: 3, sides: FLAT, isRich: false},
  {ratio: 0.33, segments: 3, sides: FLAT, isRich: false},
];
const [SLOW, FAST] = [40, 20];  // ms a picture: above the one coarser, below the other finer
const [FEW, MANY] = [3, 30];  // pictures in a row that say so
const REST = 250;  // ms without a change
const LONG = 400;  // ms of a picture at rest: the next is drawn without outlines
const AGAIN = 8000;  // ms after which a level that was too slow is tried once more; doubled each time

/** Whether the browser draws without a graphics processor: then with fewer samples. */
export function isSoftware() {
  const gl = document.createElement('canvas').getContext('webgl2');
  const facts = gl?.getExtension('WEBGL_debug_renderer_info');
  const name = facts ? gl.getParameter(facts.UNMASKED_RENDERER_WEBGL) : '';
  gl?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

export class Quality {
  /** `apply` is told the level that the next picture is to have. */
  constructor(gl, level, apply) {
    Object.assign(this, {gl, level, apply});
    this.now = 0;  // the level in force
    this.isFixed = false;
    this.reset();
  }

  /** Another model costs another time. */
  reset() {
    this.whole = 0;  // the level of a picture at rest
    this.slow = this.fast = 0;
    this.barred = LEVELS.map(() => ({until: 0, pause: AGAIN}));
    this.drawn = -Infinity;
    this.waiting = null;
  }

  use(level) {
    if (level === this.now) return;
    this.now = level;
    this.apply(LEVELS[level]);
  }

  /** Once a frame of the screen. Returns whether a picture at rest is due. */
  tick(time, isStale) {
    this.look(time);
    if (this.isFixed) return false;
    if (isStale) this.use(this.level);
    else if (this.now > this.whole && time - this.drawn > REST) {
      this.use(this.whole);
      this.isResting = true;
      return true;
    }
    return false;
  }

  /** After a picture has been handed to the driver. */
  after(time) {
    const {gl} = this;
    this.drawn = time;
    const {isResting} = this;
    this.isResting = false;
    if (this.waiting || document.hidden || this.isFixed) return;
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (fence) this.waiting = {fence, time, level: this.now, isResting};  // none where the browser has lost the picture
    gl.flush();
  }

  look(time) {
    const {gl, waiting} = this;
    if (!waiting || gl.getSyncParameter(waiting.fence, gl.SYNC_STATUS) !== gl.SIGNALED) return;
    gl.deleteSync(waiting.fence);
    this.waiting = null;
    if (waiting.isResting) this.whole = time - waiting.time > LONG ? 1 : 0;
    else if (waiting.level === this.level) this.took(time - waiting.time, time);
  }

  took(ms, time) {
    this.slow = ms > SLOW ? this.slow + 1 : 0;
    this.fast = ms < FAST ? this.fast + 1 : 0;
    if (this.slow >= FEW && this.level + 1 < LEVELS.length) {
      const row = this.barred[this.level];
      row.until = time + row.pause;
      row.pause *= 2;
      this.change(1);
    } else if (this.fast >= MANY && this.level > 0 && this.barred[this.level - 1].until < time) {
      this.change(-1);
    }
  }

  change(by) {
    this.level += by;
    this.slow = this.fast = 0;
  }
}
