// SPDX-License-Identifier: MIT
// The cartoon of a protein or nucleic acid: what of the model it goes through, once a file is opened.
// Where it runs, the graphics processor finds anew from the positions of each frame.
import {Mesh} from './gl.mjs';
import {ribbonFragment, ribbonVertex} from './ribbon_shader.mjs';
import {numbers} from './textures.mjs';
import {dot, length, less, pointOf, times} from './vectors.mjs';

const [COIL, HELIX, STRAND, NUCLEIC] = [0, 1, 2, 3];
const LETTERS = {H: HELIX, E: STRAND};
const FARTHEST = {6: 5, 15: 9};  // Angstrom between two CA or P of a chain; what is farther is a gap
/** Of a strip: eight about it, or two edges of a flat one that costs an eighth. */
export const ROUND = 8;
export const FLAT = 2;

/** Chains without gaps: lists of CA or P, of two and more. */
function runsOf(model, positions) {
  const runs = [[]];
  for (const joint of model.trace) {
    const last = runs.at(-1).at(-1);
    const isFar = last !== undefined && joint >= 0 && (model.elements[last] !== model.elements[joint] ||
      length(less(pointOf(positions, last), pointOf(positions, joint))) > FARTHEST[model.elements[joint]]);
    if (joint < 0 || isFar) runs.push([]);
    if (joint >= 0) runs.at(-1).push(joint);
  }
  return runs.filter((run) => run.length > 1);
}

/** The O of each residue's backbone, -1 where there is none. */
function oxygens(model) {
  const found = new Int32Array(model.residue.length ? model.residue.at(-1) + 1 : 0).fill(-1);
  model.atoms?.forEach((name, joint) => {
    if (/^(O|O1|OT1)$/.test(name) && model.elements[joint] === 8) found[model.residue[joint]] = joint;
  });
  return found;
}

/** Strands of one residue are bridges, and drawn as coil. */
function shapesOf(model, run) {
  const letter = (k) => model.elements[run[k]] === 15 ? NUCLEIC : LETTERS[model.secondary?.[model.residue[run[k]]]] ?? COIL;
  const shapes = run.map((_, k) => letter(k));
  return shapes.map((shape, k) =>
    shape !== STRAND || shapes[k - 1] === STRAND || shapes[k + 1] === STRAND ? shape : COIL);
}

/** Which guides are turned about, so that each is at less than a right angle to the one before. */
function turnsOf(run, guides, positions) {
  let last = null;
  return run.map((joint, k) => {
    if (guides[k] < 0) return 0;
    const way = less(pointOf(positions, guides[k]), pointOf(positions, joint));
    const isTurned = last && dot(way, last) < 0;
    last = isTurned ? times(way, -1) : way;
    return Number(Boolean(isTurned));
  });
}

/** Twelve numbers for each two neighbours of a run, as ribbonVertex reads them. */
function piecesOf(model, run, guides, positions) {
  const [shapes, turns] = [shapesOf(model, run), turnsOf(run, guides, positions)];
  const last = run.length - 1;
  const clamp = (k) => Math.min(Math.max(k, 0), last);
  return run.slice(1).flatMap((_, k) => {
    const near = [k - 1, k, k + 1, k + 2].map(clamp);
    let flags = 0;
    near.forEach((j, bit) => { flags |= turns[j] << bit | Number(shapes[j] === STRAND) << bit + 4; });
    const endsStrand = shapes[k] === STRAND && shapes[k - 1] === STRAND && shapes[k + 1] !== STRAND;
    flags |= (endsStrand ? COIL : shapes[k]) << 8 | shapes[k + 1] << 10;
    const isArrow = shapes[k] === STRAND && shapes[k + 1] === STRAND && shapes[k + 2] !== STRAND;
    flags |= Number(isArrow) << 12 | Number(k === 0) << 13 | Number(k + 1 === last) << 14;
    return [...near.map((j) => run[j]), ...near.map((j) => guides[j]), run[clamp(k - 2)], run[clamp(k + 3)], flags, 0];
  });
}

/** Strips of all pieces: x from 0 to 1 along each, side, piece. One ring lies close to the first,
 * where an arrow begins. One mesh and not an instance a piece: software draws each instance by itself. */
function strips(pieces, segments, sides) {
  const rings = [0, 0.02, ...Array.from({length: segments}, (_, k) => (k + 1) / segments)];
  const faces = sides === FLAT ? 1 : sides;
  const position = new Float32Array(3 * pieces * rings.length * sides);
  const index = new Uint32Array(6 * pieces * (rings.length - 1) * faces);
  let place = 0, corner = 0;
  for (let piece = 0; piece < pieces; ++piece)
    rings.forEach((x, ring) => {
      const first = place / 3;
      for (let side = 0; side < sides; ++side) {
        position.set([x, side, piece], place);
        place += 3;
        if (ring + 1 === rings.length || side >= faces) continue;
        const [a, b] = [first + side, first + (side + 1) % sides];
        index.set([a, b, a + sides, b, b + sides, a + sides], corner);
        corner += 6;
      }
    });
  return {position, index};
}

export class Ribbon {
  /** `shared`: the uniforms of the picture. */
  constructor(shared) {
    this.uniforms = {...shared, pieces: {value: null}, sides: {value: ROUND}};
    this.mesh = new Mesh(null, {vertex: ribbonVertex, fragment: ribbonFragment}, this.uniforms, {isVisible: false});
    this.count = 0;
    this.segments = 8;
    this.made = {};  // shapes by detail
  }

  /** How finely: parts of a piece, and ROUND or FLAT. */
  setDetail(segments, sides) {
    if (segments === this.segments && sides === this.uniforms.sides.value) return;
    this.segments = segments;
    this.uniforms.sides.value = sides;
    this.mesh.isTwoSided = sides === FLAT;
    this.make();
  }

  make() {
    const {segments, uniforms} = this;
    const key = `${segments} ${uniforms.sides.value}`;
    this.made[key] ??= strips(this.count, segments, uniforms.sides.value);
    this.mesh.shape = this.made[key];
  }

  open(model, positions) {
    const runs = runsOf(model, positions);
    const of = oxygens(model);
    this.runs = runs;
    const rows = runs.flatMap((run) =>
      piecesOf(model, run, run.map((joint) => of[model.residue[joint]] ?? -1), positions));
    this.count = rows.length / 12;
    this.uniforms.pieces.value = numbers(rows.length / 4);
    this.uniforms.pieces.value.data.set(rows);
    this.made = {};
    this.make();
  }

  show(walkers) {
    this.mesh.isVisible = this.count > 0;
    this.mesh.instances = walkers;
  }
}
