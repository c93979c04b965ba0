// SPDX-License-Identifier: MIT
// What an H5MD file says of the molecule, as far as the page needs it to open the molecule itself.
// `get` gives the numbers or texts of a dataset, null where there is none.

const TEXTS = ['atom_name', 'residue_name', 'chain', 'insertion_code'];
const NUMBERS = ['residue_of', 'residue_number', 'atom_serial', 'bond_order'];
const AROUND_START = 1;  // `sampler` of a frame up to which it was drawn around the start

const texts = (list) => list && [...list].map((text) => String(text).trimEnd());
const numbers = (list) => list && Array.from(list, Number);

/** Of atoms and residues; null where the file does not name them. */
function topologyOf(get) {
  const found = {};
  for (const name of TEXTS) found[name] = texts(get(`parameters/topology/${name}`));
  for (const name of NUMBERS) found[name] = numbers(get(`parameters/topology/${name}`));
  return found.atom_name && found.residue_of && found.residue_name ? found : null;
}

const textOf = (value) => (value === null ? '' : String(Array.isArray(value) ? value[0] : value));

export function ensembleFields(get) {
  const drawnBy = numbers(get('observables/sampler/value'));
  return {
    topology: topologyOf(get),
    heldBy: textOf(get('parameters/model/kind')),
    sampler: textOf(get('parameters/sample/sampler')),
    isPath: get('parameters/path/end') !== null,
    reaches: drawnBy ? drawnBy.map((kind) => kind > AROUND_START) : [],
  };
}
