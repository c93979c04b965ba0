// SPDX-License-Identifier: MIT
// What is drawn of a model, and how thick.

/** Ball and stick sizes of the styles; radii of sticks in Angstrom. `ribbon`: the cartoon, `isPart`:
 * with few of the atoms. */
export const STYLES = {
  cartoon: {title: 'Cartoon', ball: 0, stick: 0.17, trace: 0, ribbon: 1, isPart: true},
  'cartoon-sticks': {title: 'Cartoon and sticks', ball: 0, stick: 0.1, trace: 0, ribbon: 1},
  balls: {title: 'Ball and stick', ball: 0.24, stick: 0.13, trace: 0},
  sticks: {title: 'Sticks', ball: 0, stick: 0.17, trace: 0},
  lines: {title: 'Lines', ball: 0, stick: 0.05, trace: 0},
  spheres: {title: 'Spheres', ball: 1, stick: 0, trace: 0},
  surface: {title: 'Surface', ball: 1.2, stick: 0, trace: 0, isSurface: true},
  trace: {title: 'Trace', ball: 0, stick: 0.0, trace: 0.55},
  'trace-lines': {title: 'Trace and lines', ball: 0, stick: 0.06, trace: 0.4},
};

/** Whether a style needs a chain to go along. */
export const needsTrace = (name) => STYLES[name].trace > 0 || Boolean(STYLES[name].ribbon);
