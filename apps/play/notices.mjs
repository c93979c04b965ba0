// SPDX-License-Identifier: MIT
// The notices of all that is inside the page, as one text.
import {existsSync, readFileSync, readdirSync} from 'node:fs';
import {join} from 'node:path';

const PACKAGES = ['three'];  // what is inside the bundle, of what npm installs

function licenceOf(folder) {
  const name = readdirSync(folder).find((file) => /^licen[cs]e/i.test(file));
  return name ? readFileSync(join(folder, name), 'utf8').trim() : '';
}

function ofPackage(modules, name) {
  const folder = join(modules, name);
  const {version, license} = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  return [`${name} ${version} (${license})`, licenceOf(folder)];
}

// What is compiled into the WebAssembly: written beside it by its build, where there is one.
function ofSolver(root) {
  const file = join(root, 'build', 'play', 'notices.txt');
  return existsSync(file) ? [readFileSync(file, 'utf8').trim()] : [];
}

/** Pliant's licence, those of the npm packages inside, and those of what the solver is made of. */
export function notices(modules, root) {
  const own = ['Pliant (MIT)', readFileSync(join(root, 'LICENSE'), 'utf8').trim()];
  const parts = [own, ...PACKAGES.map((name) => ofPackage(modules, name)), ofSolver(root)];
  return parts.filter((part) => part.length).map((part) => part.join('\n\n')).join('\n\n----\n\n');
}
