// SPDX-License-Identifier: MIT
// The notices of all that is inside the page, as one text.
import {existsSync, readFileSync} from 'node:fs';
import {join} from 'node:path';

/** Pliant's licence, and those of what the solver is made of: written beside it by its build. */
export function notices(root) {
  const ofSolver = join(root, 'build', 'play', 'notices.txt');
  const files = [join(root, 'LICENSE'), ...existsSync(ofSolver) ? [ofSolver] : []];
  return `Pliant (MIT)\n\n${files.map((file) => readFileSync(file, 'utf8').trim()).join('\n\n----\n\n')}`;
}
