// SPDX-License-Identifier: MIT
// The cartoon of a protein or nucleic acid: what of the model it goes through, once a file is opened.
// Where it runs, the graphics processor finds anew from the positions of each frame.
import {BufferAttribute, BufferGeometry, GLSL3, InstancedBufferGeometry, Mesh, RawShaderMaterial} from 'three';
import {ribbonFragment, ribbonVertex} from './ribbon_shader.mjs';
import {numbers} from './textures.mjs';

export const [COIL, HELIX, STRAND, NUCLEIC] = [0, 1, 2, 3];
const LETTERS = {H: HELIX, E: STRAND};
const FARTHEST = {6: 5, 15: 9};  // Angstrom between two CA or P of a chain; what is farther is a gap
const SIDES = 8;

const less = (a, b) => a.map((x, c) => x - b[c]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const at = (positions, joint) => [...positions.subarray(3 * joint, 3 * joint + 3)];

/** Chains without gaps: lists of CA or P, of two and more. */
export function runsOf(model, positions) {
  const runs = [[]];
  for (const joint of model.trace) {
    const last = runs.at(-1).at(-1);
    const isFar = last !== undefined && joint >= 0 && (model.elements[last] !== model.elements[joint] ||
      Math.hypot(...less(at(positions, last), at(positions, joint))) > FARTHEST[model.elements[joint]]);
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
    const way = less(at(positions, guides[k]), at(positions, joint));
    const isTurned = last && dot(way, last) < 0;
    last = isTurned ? way.map((x) => -x) : way;
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

/** Rings of a strip along x from 0 to 1; one lies close to the first, where an arrow begins. */
function strip(segments) {
  const rings = [0, 0.02, ...Array.from({length: segments}, (_, k) => (k + 1) / segments)];
  const places = rings.flatMap((x) => Array.from({length: SIDES}, (_, side) => [x, side, 0])).flat();
  const index = [];
  for (let ring = 0; ring + 1 < rings.length; ++ring)
    for (let side = 0; side < SIDES; ++side) {
      const [a, b] = [ring * SIDES + side, ring * SIDES + (side + 1) % SIDES];
      index.push(a, b, a + SIDES, b, b + SIDES, a + SIDES);
    }
  const made = new InstancedBufferGeometry();
  made.setAttribute('position', new BufferAttribute(new Float32Array(places), 3));
  made.setIndex(index);
  return made;
}

export class Ribbon {
  /** `shared`: the uniforms of the picture. */
  constructor(shared) {
    this.uniforms = {
      ...shared, pieces: {value: null}, ribbonCount: {value: 1}, sides: {value: SIDES}, ribbonScale: {value: 1},
    };
    const material = new RawShaderMaterial({
      glslVersion: GLSL3, uniforms: this.uniforms, vertexShader: ribbonVertex, fragmentShader: ribbonFragment,
    });
    this.mesh = new Mesh(new BufferGeometry(), material);
    this.mesh.frustumCulled = false;
    this.count = 0;
    this.setSegments(8);
  }

  setSegments(segments) {
    if (segments === this.segments) return;
    this.segments = segments;
    this.mesh.geometry.dispose();
    this.mesh.geometry = strip(segments);
  }

  open(model, positions) {
    const runs = runsOf(model, positions);
    const of = oxygens(model);
    this.runs = runs;
    const rows = runs.flatMap((run) =>
      piecesOf(model, run, run.map((joint) => of[model.residue[joint]] ?? -1), positions));
    this.count = rows.length / 12;
    this.uniforms.pieces.value?.dispose();
    this.uniforms.pieces.value = numbers(rows.length / 4);
    this.uniforms.pieces.value.image.data.set(rows);
    this.uniforms.ribbonCount.value = Math.max(1, this.count);
  }

  show(walkers) {
    this.mesh.visible = this.count > 0 && walkers > 0;
    this.mesh.geometry.instanceCount = this.count * walkers;
  }
}
