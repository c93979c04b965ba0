// SPDX-License-Identifier: MIT
// Eigenvectors of small symmetric matrices by Jacobi rotations (Golub & Van Loan, section 8.5).

const ROUNDS = 12;  // of all pairs; 4 x 4 is exact to rounding after about 6

function rotatePair(m, v, p, q) {
  if (Math.abs(m[p][q]) < 1e-300) return;
  const theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
  const t = Math.sign(theta || 1) / (Math.abs(theta) + Math.hypot(theta, 1));
  const c = 1 / Math.hypot(t, 1);
  const s = t * c;
  for (const row of m) [row[p], row[q]] = [c * row[p] - s * row[q], s * row[p] + c * row[q]];
  const [one, other] = [[...m[p]], [...m[q]]];
  m[p] = one.map((x, k) => c * x - s * other[k]);
  m[q] = one.map((x, k) => s * x + c * other[k]);
  for (const row of v) [row[p], row[q]] = [c * row[p] - s * row[q], s * row[p] + c * row[q]];
}

/** Pairs {value, vector} of a symmetric matrix (list of rows), the largest value first. */
export function eigen(matrix) {
  const m = matrix.map((row) => [...row]);
  const v = m.map((_, i) => m.map((__, j) => (i === j ? 1 : 0)));
  for (let round = 0; round < ROUNDS; ++round)
    for (let p = 0; p < m.length - 1; ++p) for (let q = p + 1; q < m.length; ++q) rotatePair(m, v, p, q);
  const pairs = m.map((row, k) => ({value: row[k], vector: v.map((line) => line[k])}));
  return pairs.sort((a, b) => b.value - a.value);
}
