// SPDX-License-Identifier: MIT
// RMSD, RMSF and eigenvectors against cases whose answer is known.
import assert from 'node:assert/strict';
import {describe, test} from 'node:test';
import {eigen} from '../page/view/eigen.mjs';
import {Fluctuation, superpose} from '../page/record/superpose.mjs';

const START = Float64Array.from([0, 0, 0, 1.5, 0, 0, 1.5, 2, 0, -1, 0.5, 3, 0.2, -2, 1]);
const ALL = [0, 1, 2, 3, 4];
const near = (a, b, most = 1e-12) => assert.ok(Math.abs(a - b) <= most, `${a} and ${b}`);

/** Turned by an angle about z, then x, and moved. */
function turned(x, angle) {
  const out = new Float64Array(x.length);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  for (let k = 0; k < x.length; k += 3) {
    const [a, b] = [c * x[k] - s * x[k + 1], s * x[k] + c * x[k + 1]];
    out.set([a + 7, c * b - s * x[k + 2] - 3, s * b + c * x[k + 2] + 0.5], k);
  }
  return out;
}

describe('numbers', () => {
test('a body that was only turned and moved has RMSD 0', () => {
  for (const angle of [0.3, 1.7, 3.1]) near(superpose(turned(START, angle), START, ALL).rmsd, 0, 1e-7);
});

test('the rotation lays the one on the other', () => {
  const from = turned(START, 0.8);
  const {rotation: r, centres: [p, q]} = superpose(from, START, ALL);
  for (let k = 0; k < START.length; k += 3)
    for (let c = 0; c < 3; ++c) {
      const laid = [0, 1, 2].reduce((sum, d) => sum + r[3 * c + d] * (from[k + d] - p[d]), q[c]);
      near(laid, START[k + c], 1e-10);
    }
});

test('two joints further apart by 2 d about their middle have RMSD d', () => {
  const [two, apart] = [Float64Array.from([0, 0, 0, 4, 0, 0]), Float64Array.from([0, 0, 0, 0, 5, 0])];
  near(superpose(two, apart, [0, 1]).rmsd, 0.5);
});

test('a mirror image is no rotation', () => {
  const mirrored = START.map((x, k) => (k % 3 === 2 ? -x : x));
  assert.ok(superpose(mirrored, START, ALL).rmsd > 0.5);
});

test('a joint that swings by d to either side, on a body at rest, has RMSF d', () => {
  const still = [0, 1, 2, 3];
  const fluctuation = new Fluctuation(START, still);
  for (const d of [0.2, -0.2, 0.2, -0.2]) {
    const frame = START.slice();
    frame[12] += d;
    near(fluctuation.add(turned(frame, d)), 0, 1e-7);
  }
  const each = fluctuation.each();
  near(each[4], 0.2, 1e-7);
  near(each[0], 0, 1e-7);
});

test('eigenvectors of a matrix of known ones', () => {
  const [first, second, third] = eigen([[2, 1, 0], [1, 2, 0], [0, 0, -5]]);
  near(first.value, 3);
  near(second.value, 1);
  near(third.value, -5);
  near(Math.abs(first.vector[0]), Math.SQRT1_2);
  near(Math.abs(third.vector[2]), 1);
});
});
