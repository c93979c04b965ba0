// SPDX-License-Identifier: MIT
// Colours of joints. The first eight categories are those of Okabe & Ito (2008), the others were chosen
// so that all stay apart for each kind of colour vision (test/support/vision.mjs), the
// scale is cividis (Nunez, Anderton & Renslow 2018): all can be told apart by colour-blind people.

export const hex = (text) => [1, 3, 5].map((k) => parseInt(text.slice(k, k + 2), 16));

// Hues that the field uses, lightness apart: red and blue differ for all who see colours poorly.
const ELEMENTS = {
  0: '#7b93b5', 1: '#eceef0', 3: '#a678c8', 5: '#d9a58c', 6: '#7f8894', 7: '#3f74d1', 8: '#d5482f',
  9: '#7fb069', 11: '#a678c8', 12: '#5f9e4f', 14: '#b59a6b', 15: '#e08a2e', 16: '#e0b92e',
  17: '#5fae57', 19: '#8f5fb8', 20: '#6b8f4f', 26: '#b85c2e', 29: '#b87a4b', 30: '#6d74a8',
  35: '#a04a3a', 53: '#7a3f9e',
};
const OTHER = '#b08aa0';
export const CATEGORIES = [
  '#0072b2', '#e69f00', '#009e73', '#cc79a7', '#56b4e9', '#d55e00', '#f0e442', '#332288',
  '#8020f0', '#802020', '#a8f0a8', '#a8a850', '#a850f0', '#a82080', '#a85020', '#a82050',
].map(hex);
const FLEXIBLE = hex('#c8ced4');
const CIVIDIS = ['#00224e', '#2a3f6d', '#575d6d', '#7d7c78', '#a59c74', '#d2c060', '#fee838'].map(hex);

// Van der Waals radii in Angstrom (Bondi 1964; H: Rowland & Taylor 1996); 0 is a joint of no element.
const RADII = {0: 1.5, 1: 1.1, 6: 1.7, 7: 1.55, 8: 1.52, 9: 1.47, 15: 1.8, 16: 1.8, 17: 1.75};

/** Of a contact: slack, between, at its limit. */
export const TAUTNESS = ['#4393c3', '#f0b400', '#b2182b'].map(hex);
const QUIET = hex('#aeb6be');

export const elementColour = (number) => hex(ELEMENTS[number] ?? OTHER);
export const vanDerWaals = (number) => RADII[number] ?? 1.8;

/** Colour of `share` from 0 to 1 on a scale of colours, cividis where none is given, as [r, g, b] of 255. */
export function scaleColour(share, stops = CIVIDIS) {
  const at = Math.min(Math.max(share, 0), 1) * (stops.length - 1);
  const k = Math.min(Math.floor(at), stops.length - 2);
  return stops[k].map((from, c) => Math.round(from + (stops[k + 1][c] - from) * (at - k)));
}

/** The same for all walkers: of 1e-4 of a length and less, to a tenth of it. */
export const residualShare = (residual) =>
  Math.min(Math.max((Math.log10(Math.abs(residual) + 1e-9) + 4) / 3, 0), 1);

const byElement = (model) => (joint) => elementColour(model.elements[joint]);

/** Of the clusters that have one, the largest first. */
export const clusterColours = (model) => CATEGORIES.slice(0, model.colouredClusters);

/** Small ones, and what is in none, are grey. */
function byCluster(model) {
  return (joint) => {
    const cluster = model.cluster[joint];
    return cluster < 0 || cluster >= model.colouredClusters ? FLEXIBLE : CATEGORIES[cluster];
  };
}

/** Domains of motion, which pliant play finds of many frames; what is in none is grey. */
export const domainColour = (domain) => (domain < 0 ? FLEXIBLE : CATEGORIES[domain % CATEGORIES.length]);

const byDomain = (model) => (joint) => domainColour(model.domain ? model.domain[joint] : -1);

function byChain(model) {
  const names = [...new Set(model.chain)];
  const colours = new Map(names.map((name, k) => [name, CATEGORIES[k % CATEGORIES.length]]));
  return (joint) => colours.get(model.chain[model.residue[joint]]) ?? FLEXIBLE;
}

/** Helices, strands and what is between; in side chains the carbon alone, the rest by element. */
export const SHAPES = {
  H: {title: 'Helix', colour: hex('#d55e00')}, E: {title: 'Strand', colour: hex('#0072b2')},
  '-': {title: 'Coil', colour: hex('#c3c9cf')}, N: {title: 'Nucleic acid', colour: hex('#009e73')},
};

/** H, E or -; N of a nucleotide; nothing of the rest. */
export function shapeLetters(model) {
  const letters = [...model.secondary ?? ''];
  model.atoms?.forEach((name, joint) => { if (name === "C4'") letters[model.residue[joint]] = 'N'; });
  return letters;
}

function bySecondary(model) {
  const letters = shapeLetters(model);
  return (joint) => {
    const shape = SHAPES[letters[model.residue[joint]]];
    const isLine = model.elements[joint] === 6 || model.atoms?.[joint] === 'P';
    return shape && isLine ? shape.colour : elementColour(model.elements[joint]);
  };
}

/** From the start of a chain (dark) to its end (light), by residue, or by joint where none are. */
function bySequence(model) {
  const most = Math.max(1, model.residue.length ? model.residue.at(-1) : 0);
  return (joint) => scaleColour(model.residue[joint] / most);
}

function byResidual(model, {residuals}) {
  const worst = new Float32Array(model.joints);
  for (let bar = 0; bar < (residuals?.length ?? 0); ++bar)
    for (const joint of [model.bars[2 * bar], model.bars[2 * bar + 1]])
      worst[joint] = Math.max(worst[joint], Math.abs(residuals[bar]));
  return (joint) => scaleColour(residualShare(worst[joint]));
}

function byMobility(model, {mobility}) {
  const most = mobility ? mobility.reduce((a, b) => Math.max(a, b), 1e-9) : 1;
  return (joint) => scaleColour(mobility ? mobility[joint] / most : 0);
}

export const COLOURINGS = [
  {name: 'element', title: 'Element', of: byElement},
  {name: 'cluster', title: 'Rigid cluster', of: byCluster},
  {name: 'secondary', title: 'Secondary structure', of: bySecondary},
  {name: 'domain', title: 'Domain that moves', of: byDomain},
  {name: 'chain', title: 'Chain', of: byChain},
  {name: 'sequence', title: 'Place in the chain', of: bySequence},
  {name: 'residual', title: 'Residual of its bars', of: byResidual, live: true},
  {name: 'contacts', title: 'Strain of contacts', of: () => () => QUIET},
  {name: 'mobility', title: 'Mobility (RMSF so far)', of: byMobility, live: true},
];

/** Tells the colour of each joint, [r, g, b] of 255. */
export const colouringOf = (name, model, facts) => COLOURINGS.find((row) => row.name === name).of(model, facts);
