// SPDX-License-Identifier: MIT
// What an H5MD file says of the molecule, as far as the page needs it to open the molecule itself.
// `get` gives the numbers or texts of a dataset, null where there is none.

const TEXTS = ['atom_name', 'residue_name', 'chain', 'insertion_code'];
const NUMBERS = ['residue_of', 'residue_number', 'atom_serial', 'bond_order'];
const KINDS = {
  drawnBy: 'observables/sampler/value', heldBy: 'parameters/model/kind',
  sampler: 'parameters/sample/sampler', end: 'parameters/path/end',
};
const AROUND_START = 1;  // `sampler` of a frame up to which it was drawn around the start

const inTopology = (name) => `parameters/topology/${name}`;

/** All datasets that are asked for. */
export const ENSEMBLE_PATHS = [...[...TEXTS, ...NUMBERS].map(inTopology), ...Object.values(KINDS)];

const texts = (list) => list && [...list].map((text) => String(text).trimEnd());
const numbers = (list) => list && Array.from(list, Number);

/** Of atoms and residues; null where the file does not name them. */
function topologyOf(get) {
  const found = {};
  for (const name of TEXTS) found[name] = texts(get(inTopology(name)));
  for (const name of NUMBERS) found[name] = numbers(get(inTopology(name)));
  return found.atom_name && found.residue_of && found.residue_name ? found : null;
}

const textOf = (value) => (value === null ? '' : String(Array.isArray(value) ? value[0] : value));

export function ensembleFields(get) {
  const drawnBy = numbers(get(KINDS.drawnBy));
  return {
    topology: topologyOf(get),
    heldBy: textOf(get(KINDS.heldBy)),
    sampler: textOf(get(KINDS.sampler)),
    isPath: get(KINDS.end) !== null,
    reaches: drawnBy ? drawnBy.map((kind) => kind > AROUND_START) : [],
  };
}
