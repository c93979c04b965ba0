// SPDX-License-Identifier: MIT
// What the atoms of a report may be coloured by, each with its legend.
import {domainColour, elementColour, hex, scaleColour} from './view/colours.mjs';

const RAMP = ['#2f6799', '#7fa5c4', '#dee2e4', '#eeb46e', '#d55e00'].map(hex);  // which all eyes tell apart
const LOOSE = hex('#c3cad1');
const RESTING = hex('#d5dbe1');
/** Of bars: the more the nearer they come to the tolerance, and beyond it. */
export const [STRAINED, BROKEN] = ['#0072b2', '#d55e00'];

const AMOUNTS = [
  ['flexibility', 'flexibility', 'rigid (0)', (top) => `flexible (${top})`],
  ['mobility', 'mobility', 'still', () => 'mobile (RMSF)'],
  ['motion', 'PC1', 'still', () => 'moved by PC1'],
];

const css = (colour) => `rgb(${colour.join(',')})`;
const strip = (colours) => `linear-gradient(90deg, ${colours.join(',')})`;

/** A colour a kind, and grey for the rest; `told`: what the legend says of so many. */
function ofKinds(scene, key, label, colourOf, told) {
  const {units: {[key]: values}, atoms: {unit}} = scene;
  const kinds = [...new Set(values)].filter((kind) => colourOf(kind) !== LOOSE).sort((a, b) => a - b);
  const share = 100 / Math.max(1, kinds.length);
  const parts = kinds.map((kind, k) => `${css(colourOf(kind))} ${k * share}% ${(k + 1) * share}%`);
  return {
    key, label, of: (atom) => (unit[atom] < 0 ? LOOSE : colourOf(values[unit[atom]])),
    legend: ['', told(kinds.length), parts.length ? strip(parts) : css(LOOSE)],
  };
}

function ofAmounts(scene, [key, label, low, high]) {
  const {units: {[key]: values}, atoms: {unit}} = scene;
  const sorted = values.slice().sort((a, b) => a - b);
  const top = scene.tops?.[key] || sorted[Math.floor(0.98 * (values.length - 1))] || 1;
  return {
    key, label, of: (atom) => (unit[atom] < 0 ? LOOSE : scaleColour(values[unit[atom]] / top, RAMP)),
    legend: [low, high(top), strip(RAMP.map(css))],
  };
}

/** Rows {key, label, of: colour of an atom, legend: [left, right, strip]}. */
export function paintings(scene) {
  const {units, atoms, bars, palettes, legends} = scene;
  const rows = [{key: 'element', label: 'element', of: (atom) => elementColour(atoms.elements[atom])}];
  if (units.cluster) {
    const colours = palettes.cluster.map(hex);
    rows.push(ofKinds(scene, 'cluster', 'rigid clusters', (kind) => colours[kind] ?? LOOSE, () => legends.cluster));
  }
  rows.push(...AMOUNTS.filter(([key]) => units[key]).map((row) => ofAmounts(scene, row)));
  if (units.domain)
    rows.push(ofKinds(scene, 'domain', 'domains', (kind) => (kind < 0 ? LOOSE : domainColour(kind)), (count) => `${count} domains; grey: none`));
  if (bars.length) {
    const legend = `${css(RESTING)}, ${STRAINED} 78%, ${BROKEN} 78%`;
    rows.push({key: 'residual', label: 'bar residual', of: () => RESTING, legend: ['bar at rest', 'at tolerance, beyond', strip([legend])]});
  }
  return rows;
}
