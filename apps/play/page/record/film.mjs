// SPDX-License-Identifier: MIT
// Orders of frames that are independent of each other, for the eye: none is made up between two.
import {Fluctuation, superpose} from './superpose.mjs';

const MOST_SITES = 100;  // that frames are compared by
const MOST_FRAMES = 800;  // that are compared; of more, some evenly
const LEAST_STEPS = 16;  // from one end of a motion to the other, where there are frames for them
const ROUNDS = 60;  // of the power method: the two largest variances may be near each other

/** So many of a list, evenly, its ends among them. */
export function evenly(list, most) {
  if (list.length <= most) return [...list];
  return Array.from({length: most}, (_, k) => list[Math.round(k * (list.length - 1) / (most - 1))]);
}

/** The mean of frames laid on each other, Angstrom, as `pliant analyse` finds it. */
export function meanOf(frames, which) {
  let mean = frames[0];
  for (let round = 0; round < 2; ++round) {
    const found = new Fluctuation(mean, which);
    for (const positions of frames) found.add(positions);
    mean = found.mean;
  }
  return mean;
}

/** A row for each frame: the places of the sites, laid on the mean and less it, Angstrom. */
function rowsOf(frames, mean, sites) {
  return frames.map((positions) => {
    const {rotation: r, centres: [p, q]} = superpose(positions, mean, sites);
    const row = new Float64Array(3 * sites.length);
    sites.forEach((site, n) => {
      const [x, y, z] = [0, 1, 2].map((c) => positions[3 * site + c] - p[c]);
      for (let c = 0; c < 3; ++c)
        row[3 * n + c] = r[3 * c] * x + r[3 * c + 1] * y + r[3 * c + 2] * z + q[c] - mean[3 * site + c];
    });
    return row;
  });
}

const dot = (a, b) => {
  let sum = 0;
  for (let k = 0; k < a.length; ++k) sum += a[k] * b[k];
  return sum;
};

/** The direction of the largest motion by the power method: {along (of each frame), share}. */
function largestMotion(rows) {
  let axis = rows.reduce((most, row) => (dot(row, row) > dot(most, most) ? row : most));
  let along = [];
  for (let round = 0; round < ROUNDS; ++round) {
    const size = Math.sqrt(dot(axis, axis)) || 1;
    const unit = axis.map((x) => x / size);
    along = rows.map((row) => dot(row, unit));
    axis = new Float64Array(axis.length);
    rows.forEach((row, f) => { for (let k = 0; k < axis.length; ++k) axis[k] += along[f] * row[k]; });
  }
  const total = rows.reduce((sum, row) => sum + dot(row, row), 0);
  return {along, share: total > 0 ? dot(along, along) / total : 0};
}

function squaredDistance(a, b) {
  let sum = 0;
  for (let k = 0; k < a.length; ++k) sum += (a[k] - b[k]) ** 2;
  return sum;
}

/** From one end of the largest motion to the other, always onwards and not too far at once, by the
 * least sum of squared steps: frames that lie off the way are left out. */
function onwards(rows, along) {
  const order = along.map((_, f) => f).sort((a, b) => along[a] - along[b]);
  const farthest = (along[order.at(-1)] - along[order[0]]) / LEAST_STEPS;
  const [cost, from] = [[0], [-1]];
  for (let k = 1; k < order.length; ++k) {
    [cost[k], from[k]] = [Infinity, k - 1];
    for (let before = k - 1; before >= 0; --before) {
      const isFar = along[order[k]] - along[order[before]] > farthest;
      if (isFar && before < k - 1) break;
      const sum = cost[before] + squaredDistance(rows[order[before]], rows[order[k]]);
      if (sum < cost[k]) [cost[k], from[k]] = [sum, before];
    }
  }
  const way = [];
  for (let k = order.length - 1; k >= 0; k = from[k]) way.unshift(order[k]);
  return way;
}

/** All frames: after each the nearest of those that are left. */
function nearestNext(rows, first) {
  const left = new Set(rows.keys());
  const way = [first];
  left.delete(first);
  while (left.size) {
    let [best, least] = [-1, Infinity];
    for (const f of left) {
      const far = squaredDistance(rows[way.at(-1)], rows[f]);
      if (far < least) [best, least] = [f, far];
    }
    way.push(best);
    left.delete(best);
  }
  return way;
}

/** Orders of the frames numbered `numbers`: {along, nearest, share of the largest motion}. */
export function filmsOf(frames, numbers, which) {
  const compared = evenly(numbers, MOST_FRAMES);
  const chosen = compared.map((number) => frames[number]);
  const sites = evenly(which, MOST_SITES);
  const rows = rowsOf(chosen, meanOf(chosen, sites), sites);
  const {along, share} = largestMotion(rows);
  const way = onwards(rows, along);
  const named = (list) => list.map((k) => compared[k]);
  return {along: named(way), nearest: named(nearestNext(rows, way[0])), share};
}
