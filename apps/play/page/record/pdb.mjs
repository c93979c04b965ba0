// SPDX-License-Identifier: MIT
// The frames as models of a PDB file (format 3.30): one text, columns as the format says.

const SYMBOLS = ('X H He Li Be B C N O F Ne Na Mg Al Si P S Cl Ar K Ca Sc Ti V Cr Mn Fe Co Ni Cu Zn ' +
  'Ga Ge As Se Br Kr Rb Sr Y Zr Nb Mo Tc Ru Rh Pd Ag Cd In Sn Sb Te I').split(' ');
const STANDARD = new Set(('ALA ARG ASN ASP CYS GLN GLU GLY HIS ILE LEU LYS MET PHE PRO SER THR TRP ' +
  'TYR VAL A C G U DA DC DG DT').split(' '));
const MOST_ATOMS = 99999;

export const symbolOf = (number) => SYMBOLS[number] ?? 'X';

/** Name, residue and chain of a joint, from the fields of `open` or from its label. */
export function siteOf(model, joint) {
  const row = model.residues?.[model.residue[joint]];
  const words = (model.names[joint] ?? '').split(/\s+/);
  const atom = model.atoms?.[joint] ?? words.at(-1) ?? 'X';
  return {
    atom: atom || symbolOf(model.elements[joint]), residue: row?.name || 'UNK',
    number: row?.number ?? 1, chain: (row?.chain ?? model.chain?.[model.residue[joint]] ?? '') || 'A',
  };
}

// An element of one letter begins in the second column of the name.
function atomName(atom, symbol) {
  const name = atom.slice(0, 4);
  return symbol.length === 1 && name.length < 4 ? ` ${name}`.padEnd(4) : name.padEnd(4);
}

function coordinate(value) {
  const text = value.toFixed(3);
  if (text.length > 8) throw new Error(`PDB: the coordinate ${text} has no room in its 8 columns`);
  return text.padStart(8);
}

/** The parts of each ATOM line before and after the coordinates. */
function lineEnds(model) {
  return Array.from({length: model.joints}, (_, joint) => {
    const site = siteOf(model, joint);
    const symbol = symbolOf(model.elements[joint]);
    const record = STANDARD.has(site.residue) ? 'ATOM  ' : 'HETATM';
    const number = String(((site.number % 10000) + 10000) % 10000).padStart(4);
    const name = atomName(site.atom, symbol);
    const residue = site.residue.slice(0, 3).padStart(3);
    return [
      `${record}${String(joint + 1).padStart(5)} ${name} ${residue} ${site.chain[0]}${number}    `,
      `  1.00  0.00          ${symbol.toUpperCase().padStart(2)}  `,
    ];
  });
}

function bondLines(model) {
  const partners = new Map();
  const pairs = model.bonds.length ? model.bonds : model.bars;
  for (let k = 0; k < pairs.length; k += 2)
    for (const [a, b] of [[pairs[k], pairs[k + 1]], [pairs[k + 1], pairs[k]]])
      partners.set(a, [...(partners.get(a) ?? []), b]);
  const five = (joint) => String(joint + 1).padStart(5);
  const lines = [];
  for (const [joint, others] of [...partners].sort((a, b) => a[0] - b[0]))
    for (let k = 0; k < others.length; k += 4)
      lines.push(`CONECT${five(joint)}${others.slice(k, k + 4).map(five).join('')}`);
  return lines;
}

/** Frames as pieces of text, for a Blob. Throws Error where the format has no room. */
export function pdbText(model, frames) {
  if (model.joints > MOST_ATOMS)
    throw new Error(`PDB: ${model.joints} joints; a file has room for ${MOST_ATOMS}. Save as H5MD`);
  const ends = lineEnds(model);
  const pieces = [];
  frames.forEach(({positions: x}, index) => {
    const lines = ends.map(([before, after], k) =>
      before + coordinate(x[3 * k]) + coordinate(x[3 * k + 1]) + coordinate(x[3 * k + 2]) + after);
    pieces.push(`MODEL     ${String(index + 1).padStart(4)}\n${lines.join('\n')}\nENDMDL\n`);
  });
  return [...pieces, bondLines(model).map((line) => `${line}\n`).join(''), 'END\n'];
}
