// SPDX-License-Identifier: MIT
// The frames as records of an SD file (BIOVIA CTfile formats 2020): V2000, or V3000 where a molecule
// has more atoms or bonds than its columns have room for.
import {symbolOf} from '../record/pdb.mjs';

const MOST_OF_V2000 = 999;
const AROMATIC = 4;

const right = (value, width) => String(value).padStart(width);

function fixed(value) {
  const text = value.toFixed(4);
  if (text.length > 10) throw new Error(`SDF: the coordinate ${text} has no room in its 10 columns`);
  return text.padStart(10);
}

/** What all records share: symbols, and rows of bonds [first, second, order], from 1. */
function tableOf(model, orders, charges) {
  const symbols = Array.from(model.elements, (number) => (number ? symbolOf(number) : '*'));
  const rows = [];
  for (let k = 0; k < model.bonds.length / 2; ++k)
    rows.push([model.bonds[2 * k] + 1, model.bonds[2 * k + 1] + 1, orderOf(orders?.[k])]);
  return {symbols, rows, charges: charges ?? []};
}

const orderOf = (order) => (order >= 1 && order <= AROMATIC ? order : 1);

function oldTable({symbols, rows, charges}, x) {
  const atoms = symbols.map((symbol, k) =>
    `${fixed(x[3 * k])}${fixed(x[3 * k + 1])}${fixed(x[3 * k + 2])} ${symbol.padEnd(3)} 0  0  0  0  0  0  0  0  0  0  0  0`);
  const bonds = rows.map(([a, b, order]) => `${right(a, 3)}${right(b, 3)}${right(order, 3)}  0  0  0  0`);
  const charged = symbols.flatMap((_, k) => (charges[k] ? [`M  CHG  1 ${right(k + 1, 3)} ${right(charges[k], 3)}`] : []));
  return [`${right(symbols.length, 3)}${right(rows.length, 3)}  0  0  0  0  0  0  0  0999 V2000`, ...atoms, ...bonds, ...charged];
}

function newTable({symbols, rows, charges}, x) {
  const place = (value) => value.toFixed(4);
  const atoms = symbols.map((symbol, k) => `${k + 1} ${symbol} ${place(x[3 * k])} ${place(x[3 * k + 1])} ` +
    `${place(x[3 * k + 2])} 0${charges[k] ? ` CHG=${charges[k]}` : ''}`);
  const bonds = rows.map(([a, b, order], k) => `${k + 1} ${order} ${a} ${b}`);
  const block = (name, lines) => (lines.length ? [`BEGIN ${name}`, ...lines, `END ${name}`] : []);
  const inside = ['BEGIN CTAB', `COUNTS ${symbols.length} ${rows.length} 0 0 0`, ...block('ATOM', atoms),
    ...block('BOND', bonds), 'END CTAB'];
  return ['  0  0  0     0  0            999 V3000', ...inside.map((line) => `M  V30 ${line}`)];
}

/** Frames as pieces of text, for a Blob. `orders` and `charges`: of bonds and atoms, where known. */
export function sdfText(model, frames, title, {orders, charges} = {}) {
  if (!model.bonds.length || !model.elements.some(Boolean))
    throw new Error('SDF: expected a molecule with bonds, found none. Save as H5MD');
  const table = tableOf(model, orders, charges);
  const isOld = table.symbols.length <= MOST_OF_V2000 && table.rows.length <= MOST_OF_V2000;
  const write = isOld ? oldTable : newTable;
  const name = title.replace(/[\r\n]/g, ' ').slice(0, 80);
  return frames.map(({positions, step}) =>
    [name, '  Pliant            3D', '', ...write(table, positions), 'M  END', '>  <step>', step ?? 0, '', '$$$$', ''].join('\n'));
}
