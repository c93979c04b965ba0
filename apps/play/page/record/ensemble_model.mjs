// SPDX-License-Identifier: MIT
// The molecule of an H5MD file, opened by the solver as if a frame of it were a file of its own: so it
// has its residues, chains and contacts, and can be pulled on from that frame.
import {symbolOf} from './pdb.mjs';

const COLUMNS = ('group_PDB id type_symbol label_atom_id label_comp_id label_asym_id label_seq_id ' +
  'pdbx_PDB_ins_code Cartn_x Cartn_y Cartn_z auth_seq_id auth_asym_id').split(' ');
const POLYMER = new Set(['CA', 'P']);  // residues with one of these are numbered along their chain

/** A value of CIF 1.1: in quotes where it would be read as something else. */
function cifValue(text, empty) {
  if (!text) return empty;
  if (!/[\s'"]|^[_#$;[\]]|^[.?]$|^(data_|loop_|global_|save_|stop_)/i.test(text)) return text;
  return text.includes('"') ? `'${text}'` : `"${text}"`;
}

/** Text of each residue in the columns before and after the place of its atoms. */
function residueValues({atom_name: atoms, residue_of: of, residue_name: names, ...rest}) {
  const isPolymer = new Set(of.filter((_, atom) => POLYMER.has(atoms[atom])));
  const counts = new Map();
  return names.map((name, k) => {
    const chain = cifValue(rest.chain?.[k], '.');
    const place = (counts.get(chain) ?? 0) + 1;
    if (isPolymer.has(k)) counts.set(chain, place);
    const insertion = cifValue(rest.insertion_code?.[k], '?');
    return {
      group: isPolymer.has(k) ? 'ATOM' : 'HETATM',
      before: `${cifValue(name, 'UNK')} ${chain} ${isPolymer.has(k) ? place : '.'} ${insertion}`,
      after: `${rest.residue_number?.[k] ?? k + 1} ${chain}`,
    };
  });
}

/** A frame (x, y, z of each atom) as the one model of an mmCIF file. */
function cifText({topology, elements}, positions) {
  const residues = residueValues(topology);
  const lines = topology.atom_name.map((name, k) => {
    const {group, before, after} = residues[topology.residue_of[k]];
    const place = [0, 1, 2].map((c) => positions[3 * k + c].toFixed(5)).join(' ');
    const serial = topology.atom_serial?.[k] ?? k + 1;
    return `${group} ${serial} ${symbolOf(elements[k])} ${cifValue(name, 'X')} ${before} ${place} ${after}`;
  });
  return `data_frame\nloop_\n${COLUMNS.map((name) => `_atom_site.${name}\n`).join('')}${lines.join('\n')}\n`;
}

/** Positions with all their digits, and bonds with their orders, as `open` takes them. */
function knownOf({bonds, topology}, positions) {
  const rows = [];
  for (let k = 0; k < bonds.length / 2; ++k)
    rows.push([bonds[2 * k], bonds[2 * k + 1], topology.bond_order?.[k] ?? 0]);
  rows.sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  return {positions: Array.from(positions), bonds: rows.flat()};
}

/** Opens a frame of the file in the session; the model, or null where the solver cannot hold these
 * very joints. `name`: of the frame as a file. */
export async function openFrame(session, name, file, positions) {
  if (!file.topology || file.topology.atom_name.length !== file.joints || !file.bonds.length) return null;
  const bytes = new TextEncoder().encode(cifText(file, positions));
  const known = knownOf(file, positions);
  for (const kind of new Set([file.heldBy || 'auto', 'bonds'])) {
    const model = await session.openFile(name, bytes, kind, known);
    if (model.joints === file.joints) return model;
  }
  return null;
}
