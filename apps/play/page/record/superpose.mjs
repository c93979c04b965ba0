// SPDX-License-Identifier: MIT
// RMSD after superposition, and the rotation for it, by quaternions (Horn, J. Opt. Soc. Am. A 4
// (1987) 629): the largest eigenvector of a symmetric 4 x 4 matrix.
import {eigen} from '../view/eigen.mjs';

/** Centre of the joints `which` (indices), Angstrom. */
export function centreOf(positions, which) {
  let [x, y, z] = [0, 0, 0];
  for (let n = 0; n < which.length; ++n) {
    const k = 3 * which[n];
    x += positions[k];
    y += positions[k + 1];
    z += positions[k + 2];
  }
  return [x / which.length, y / which.length, z / which.length];
}

// Written out: it is done for each frame, over all joints where there is no trace.
function correlation(from, to, which, [p, q]) {
  let [xx, xy, xz, yx, yy, yz, zx, zy, zz, spread] = [0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
  const [px, py, pz] = p;
  const [qx, qy, qz] = q;
  for (let n = 0; n < which.length; ++n) {
    const k = 3 * which[n];
    const ax = from[k] - px;
    const ay = from[k + 1] - py;
    const az = from[k + 2] - pz;
    const bx = to[k] - qx;
    const by = to[k + 1] - qy;
    const bz = to[k + 2] - qz;
    xx += ax * bx; xy += ax * by; xz += ax * bz;
    yx += ay * bx; yy += ay * by; yz += ay * bz;
    zx += az * bx; zy += az * by; zz += az * bz;
    spread += ax * ax + ay * ay + az * az + bx * bx + by * by + bz * bz;
  }
  return {s: [xx, xy, xz, yx, yy, yz, zx, zy, zz], spread};
}

function quaternionMatrix([xx, xy, xz, yx, yy, yz, zx, zy, zz]) {
  return [
    [xx + yy + zz, yz - zy, zx - xz, xy - yx],
    [yz - zy, xx - yy - zz, xy + yx, zx + xz],
    [zx - xz, xy + yx, yy - xx - zz, yz + zy],
    [xy - yx, zx + xz, yz + zy, zz - xx - yy],
  ];
}

function rotationOf([w, x, y, z]) {
  return [
    w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),
    2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),
    2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z,
  ];
}

/** Lays `from` on `to` by the joints `which`: {rmsd, rotation (9, by rows), centres: [from, to]}. */
export function superpose(from, to, which) {
  const centres = [centreOf(from, which), centreOf(to, which)];
  const {s, spread} = correlation(from, to, which, centres);
  const [{value, vector}] = eigen(quaternionMatrix(s));
  const rmsd = Math.sqrt(Math.max(0, (spread - 2 * value) / which.length));
  return {rmsd, rotation: rotationOf(vector), centres};
}

/** Running root mean square fluctuation of joints about their mean, each frame laid on the start. */
export class Fluctuation {
  constructor(start, which) {
    this.start = start;
    this.which = which;
    this.count = 0;
    this.mean = new Float64Array(start.length);
    this.square = new Float64Array(start.length / 3);
  }

  /** One more frame (Welford's sums); returns its RMSD from the start, Angstrom. */
  add(positions) {
    const {rmsd, rotation: r, centres: [p, q]} = superpose(positions, this.start, this.which);
    this.count += 1;
    const {mean, square, count} = this;
    const [px, py, pz] = p;
    for (let joint = 0, k = 0; k < positions.length; ++joint, k += 3) {
      const [x, y, z] = [positions[k] - px, positions[k + 1] - py, positions[k + 2] - pz];
      const lx = r[0] * x + r[1] * y + r[2] * z + q[0];
      const ly = r[3] * x + r[4] * y + r[5] * z + q[1];
      const lz = r[6] * x + r[7] * y + r[8] * z + q[2];
      const [dx, dy, dz] = [lx - mean[k], ly - mean[k + 1], lz - mean[k + 2]];
      mean[k] += dx / count;
      mean[k + 1] += dy / count;
      mean[k + 2] += dz / count;
      square[joint] += dx * (lx - mean[k]) + dy * (ly - mean[k + 1]) + dz * (lz - mean[k + 2]);
    }
    return rmsd;
  }

  /** RMSF of each joint, Angstrom. */
  each() {
    return this.square.map((sum) => Math.sqrt(Math.max(0, sum) / Math.max(1, this.count)));
  }
}
