// SPDX-License-Identifier: MIT
// How far the gain of a hand brings a joint that it pulls on in a run, without run and page. Prints as
// JSON, for each number of frames a second, how far it came and how far it went beyond.
//   node apps/play/test/from_python/gain.mjs
import {Gain} from '../../page/gain.mjs';

const [SECONDS, TARGET, FARTHEST, SHARE, CAP] = [8, 30, 0.9, 0.8, 0.2];

/** A joint that each step takes `mobility` of the way that a force would, and that keeps `kept` of
 * its velocity. */
function pulled(framesPerSecond, stepsPerSecond, mobility, kept) {
  const gain = new Gain();
  const seconds = 1 / framesPerSecond;
  const steps = Math.round(stepsPerSecond * seconds);
  let [x, before, velocity, farthest] = [0, 0, 0, 0];
  for (let time = 0; time < SECONDS; time += seconds) {
    const most = FARTHEST * Gain.pace(seconds);
    const way = Math.max(-most, Math.min(most, SHARE * (TARGET - x)));
    const [force] = gain.effort([way], [x - before], steps, seconds);
    before = x;
    for (let step = 0; step < steps; ++step) {
      velocity = kept * velocity + mobility * Math.max(-CAP, Math.min(CAP, force));
      x += velocity;
    }
    farthest = Math.max(farthest, x);
  }
  return {frames_per_second: framesPerSecond, x, farthest};
}

const rates = [1, 2, 3, 6, 30];
console.log(JSON.stringify({
  damped: rates.map((rate) => pulled(rate, 300_000, 1, 0)),
  held_back: rates.map((rate) => pulled(rate, 300_000, 0.01, 0)),
  slow_run: rates.map((rate) => pulled(rate, 3000, 0.1, 0)),
  free: rates.map((rate) => pulled(rate, 300, 1, 0.9)),
}, null, 1));
