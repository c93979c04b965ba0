// SPDX-License-Identifier: MIT
// What the colours of the picture mean: names with their colours, or a scale between two ends.
import {$, element, units} from './dom.mjs';
import {CATEGORIES, SHAPES, TAUTNESS, clusterColours, domainColour, elementColour, scaleColour, shapeLetters} from '../view/colours.mjs';
import {symbolOf} from '../record/pdb.mjs';

const MOST = 8;  // names that are listed

const SCALES = {
  residual: ['10⁻⁴', '10⁻¹ of the length'], mobility: ['still', 'most mobile'],
  sequence: ['first', 'last'], contacts: ['slack', 'at its limit'],
};

const LISTS = {
  secondary(model) {
    const letters = new Set(shapeLetters(model));
    return Object.keys(SHAPES).filter((key) => letters.has(key)).map((key) => SHAPES[key]);
  },
  chain({chain}) {
    return [...new Set(chain)].map((name, k) =>
      ({title: name ? `Chain ${name}` : 'no name', colour: CATEGORIES[k % CATEGORIES.length]}));
  },
  domain: ({domain, domains}) => (domain ? Array.from({length: domains}, (_, k) =>
    ({title: `Domain ${k + 1}`, colour: domainColour(k)})) : []),
  /** The most frequent first. */
  element({elements}) {
    const counts = new Map();
    for (const number of elements) counts.set(number, (counts.get(number) ?? 0) + 1);
    return [...counts.keys()].filter((number) => number > 0).sort((a, b) => counts.get(b) - counts.get(a))
      .map((number) => ({title: symbolOf(number), colour: elementColour(number)}));
  },
};

const css = (colour) => `rgb(${colour.join(',')})`;

/** The bar: of so many steps as there are colours, or of a scale. */
function paintBar(colourAt) {
  const {width, height} = $('legend-bar');
  const pen = $('legend-bar').getContext('2d');
  for (let x = 0; x < width; ++x) {
    pen.fillStyle = css(colourAt(x / width));
    pen.fillRect(x, 0, 1, height);
  }
}

function barOf(colouring, model) {
  if (colouring === 'contacts') return paintBar((share) => scaleColour(share, TAUTNESS));
  if (colouring !== 'cluster') return paintBar((share) => scaleColour(share));
  const colours = clusterColours(model);
  return colours.length ? paintBar((share) => colours[Math.floor(share * colours.length)]) : undefined;
}

function clusterWords({rigidClusters, colouredClusters}) {
  return [`${colouredClusters} of ${units(rigidClusters, 'rigid cluster')}`, 'grey: smaller, or flexible'];
}

function row({title, colour}) {
  const made = element('li');
  const mark = element('i');
  mark.style.background = css(colour);
  made.append(mark, title);
  return made;
}

/** Small molecules need no list of elements. */
export function showLegend(colouring, model) {
  const rows = model && model.kind !== 'graph' ? LISTS[colouring]?.(model) ?? [] : [];
  const words = colouring === 'cluster' && model ? clusterWords(model) : SCALES[colouring] ?? ['', ''];
  [$('legend-low').textContent, $('legend-high').textContent] = words;
  const listed = rows.slice(0, MOST).map(row);
  if (rows.length > MOST) listed.push(element('li', `${rows.length - MOST} more`));
  $('legend-list').replaceChildren(...listed);
  $('legend-bar').hidden = rows.length > 0;
  if (words[0]) barOf(colouring, model);
}
