// SPDX-License-Identifier: MIT
// The picture: balls in one draw call, sticks in another, of any number of walkers.
import {Orbit} from './camera.mjs';
import {vanDerWaals} from './colours.mjs';
import {DepthLook} from './depth_look.mjs';
import {Mesh, Renderer, Target} from './gl.mjs';
import {Members} from './members.mjs';
import {nearest, numbersSeen} from './picking.mjs';
import {Quality, isSoftware} from './quality.mjs';
import {Ribbon} from './ribbon.mjs';
import {Arrow} from './solids.mjs';
import {STYLES} from './styles.mjs';
import {Textures} from './textures.mjs';
import {
  ballFragment, ballVertex, stickFragment, stickVertex, traceVertex,
} from './shaders.mjs';
import {rgb, uniformsOf} from './uniforms.mjs';

const NO_PART = {members: {value: null}, memberCount: {value: 0}};  // all are drawn

const QUAD = {
  position: new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]), index: new Uint32Array([0, 1, 2, 0, 2, 3]),
};
// Corners by the bits of their numbers; faces seen from outside.
const BOX = {
  position: new Float32Array(Array.from({length: 8}, (_, k) => [2 * (k & 1) - 1, (k & 2) - 1, (k >> 1 & 2) - 1]).flat()),
  index: new Uint32Array([
    [0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5],
  ].flatMap(([a, b, c, d]) => [a, b, c, a, c, d])),
};

export class View {
  /** `options`: of the canvas' context. */
  constructor(canvas, options = {}) {
    this.isSmooth = !isSoftware();
    this.renderer = new Renderer(canvas, {antialias: this.isSmooth, powerPreference: 'high-performance', ...options});
    canvas.addEventListener('webglcontextrestored', () => this.restored());
    this.orbit = new Orbit();
    this.uniforms = uniformsOf();
    this.members = new Members();
    this.ribbon = new Ribbon(this.uniforms);
    const mesh = (shape, vertex, fragment, part, look) => new Mesh(shape, {vertex, fragment}, {...this.uniforms, ...part}, look);
    this.balls = mesh(QUAD, ballVertex, ballFragment, this.members.joints, {isSmooth: this.isSmooth});
    this.sticks = mesh(BOX, stickVertex, stickFragment, this.members.sticks);
    this.trace = mesh(BOX, traceVertex, stickFragment, NO_PART);
    this.arrow = new Arrow();
    this.shell = null;  // a surface that one sees through
    this.overlays = [];  // drawn over the picture: {draw(view)}
    this.depthLook = new DepthLook(this.uniforms, QUAD, this.isSmooth ? 4 : 0);
    this.patch = new Target(1, 1);
    this.walkers = this.detail = this.ratio = 1;
    this.style = 'balls';
    this.showAllBars = false;
    this.showContacts = true;
    this.contactShare = 0.5;  // of the thickness of bonds
    this.quality = new Quality(this.renderer.gl, this.isSmooth ? 0 : 3, (level) => this.setLevel(level));
    this.stale = true;
  }

  /** The browser had lost what the graphics processor kept. */
  restored() {
    this.quality.reset();
    this.stale = true;
  }

  /** As finely as a row of LEVELS says. */
  setLevel({ratio, segments, sides, isRich}) {
    this.ribbon.setDetail(segments, sides);
    this.uniforms.rich.value = Number(isRich);
    this.detail = ratio;
    this.scale();
  }

  /** Draws another model: joints, bars, bonds, contacts, trace; `unit` as in the shaders. */
  open(model, positions) {
    this.model = model;
    this.quality.reset();
    this.ribbon.open(model, positions);
    this.allocate(1);
    this.members.open(model, this.ribbon.runs, this.textures);
    this.textures.setPositions(positions);
    this.uniforms.unit.value = this.unit = unitOf(model, positions);
    this.orbit.frame(positions, this.unit);
    this.arrow.hide();
    this.setStyle(this.style);
  }

  /** The same joints, held by other bars and contacts: the camera stays where it is. */
  reopen(model, positions, walkers = 1) {
    this.model = model;
    this.allocate(walkers);
    this.textures.setPositions(positions);
    this.setStyle(this.style);
  }

  /** Room for `walkers` walkers; what joints and bars looked like is forgotten. */
  allocate(walkers) {
    for (const texture of Object.values(this.textures?.all ?? {})) this.renderer.forget(texture);
    this.textures = new Textures(this.model, walkers);
    this.walkers = walkers;
    const {textures, uniforms} = this;
    for (const [name, texture] of Object.entries(textures.all)) uniforms[name].value = texture;
    uniforms.joints.value = this.model.joints;
    uniforms.barCount.value = Math.max(1, textures.stickCount);
    uniforms.firstContact.value = textures.firstContact;
    uniforms.pieceCount.value = Math.max(1, textures.pieceCount);
    this.stale = true;
  }

  setPositions(positions, walker = 0) {
    this.textures.setPositions(positions, walker);
    this.stale = true;
  }

  setStrain(residuals) {
    this.textures.setStrain(residuals);
    this.stale = true;
  }

  setStyle(name) {
    this.style = name;
    const style = STYLES[name];
    const {uniforms} = this;
    uniforms.ballScale.value = style.ball || style.stick / 1.7;
    uniforms.stickRadius.value = style.stick;
    uniforms.traceRadius.value = style.trace;
    uniforms.kindRadius.value = [1, this.showAllBars ? 0.35 : 0, this.showContacts ? this.contactShare : 0, 0];
    this.stale = true;
  }

  /** Colours of joints, and their radii (in shares of 4 Angstrom) as the style has them. */
  setColours(colourOf) {
    const {model, members} = this;
    const {ribbon, ball} = STYLES[this.style];
    const single = ribbon ? 4 : 1.7;  // what no stick leads to is seen beside a cartoon
    const {look} = this.textures;
    for (let joint = 0; joint < model.joints; ++joint) {
      const [red, green, blue] = colourOf(joint);
      const radius = ball ? vanDerWaals(model.elements[joint]) : members.isAlone[joint] ? single : 1.7;
      look.data[4 * joint] = red;
      look.data[4 * joint + 1] = green;
      look.data[4 * joint + 2] = blue;
      look.data[4 * joint + 3] = Math.round(radius / 4 * 255);
    }
    look.changed();
    this.stale = true;
  }

  /** Contacts in the colour of how near they are to a limit, also those that a cartoon leaves out. */
  showTautness(isOn) {
    this.uniforms.byTautness.value = Number(isOn);
    this.members.firstContact = isOn ? this.textures.firstContact : Infinity;
  }

  setBackground(text) {
    this.background = text;
    this.ground = this.uniforms.background.value = rgb(text);
    this.stale = true;
  }

  /** Numbers of joints and a bar to light up, or -1. */
  setLit({hover, near, far, bar}) {
    const {lit, litBar} = this.uniforms;
    lit.value = [hover, near, far].map((joint, k) => joint ?? lit.value[k]);
    litBar.value = bar ?? litBar.value;
    this.stale = true;
  }

  resize(width, height, ratio) {
    this.size = {width, height};
    this.ratio = this.isSmooth ? ratio : 1;
    this.scale();
    this.orbit.resize(width, height);
    this.stale = true;
  }

  /** Pixels of the picture: fewer while something moves. */
  scale() {
    const {canvas} = this.renderer;
    const ratio = this.ratio * this.detail;
    canvas.width = Math.max(1, Math.floor(this.size.width * ratio));
    canvas.height = Math.max(1, Math.floor(this.size.height * ratio));
  }

  count(walkers) {
    const style = STYLES[this.style];
    const {model, textures, balls, sticks, trace, ribbon, members, uniforms} = this;
    if (style.isPart) members.choose(textures, uniforms.lit.value[0], uniforms.litBar.value);
    else members.all();
    ribbon.show(style.ribbon ? walkers : 0);
    balls.instances = this.style === 'trace' ? 0 : members.jointsOf(model.joints) * walkers;
    sticks.instances = members.sticksOf(textures.stickCount) * walkers;
    trace.instances = style.trace ? 5 * textures.pieceCount * walkers : 0;
  }

  setFog() {
    const {distance, radius} = this.orbit;
    this.uniforms.fog.value = [distance - 0.25 * radius, distance + 1.7 * radius];
  }

  /** A whole picture at once. */
  draw() {
    this.quality.use(0);
    this.frame();
  }

  /** One of many: as finely as there is time for. */
  frame() {
    this.stale = false;
    this.paint();
    this.quality.after(performance.now());
  }

  paint() {
    this.renderer.into(null);
    if (!this.model) return this.renderer.clear(this.ground);
    this.setFog();
    this.count(this.walkers);
    this.render();
    for (const overlay of this.overlays) overlay.draw(this);
    this.holders?.draw(this);
    return this.arrow.draw(this);
  }

  /** With outlines and shadows, where there is time for them; a surface is nothing without. */
  render() {
    const {renderer, uniforms, orbit, ratio, detail} = this;
    const isSurface = Boolean(STYLES[this.style].isSurface);
    if (!isSurface && !uniforms.rich.value) return this.paintAll();
    this.depthLook.draw(renderer, () => this.paintAll(), {isSurface, ratio: ratio * detail, slope: orbit.slope});
    return undefined;
  }

  /** Ribbon, balls, sticks and trace on a ground. */
  paintAll(projection = this.orbit.projectionMatrix, ground = this.ground, opacity = 1) {
    const {renderer, uniforms, ribbon, balls, sticks, trace} = this;
    uniforms.viewMatrix.value = this.orbit.viewMatrix;
    uniforms.projectionMatrix.value = projection;
    renderer.clear(ground, opacity);
    for (const mesh of [ribbon.mesh, balls, sticks, trace]) renderer.draw(mesh);
    if (this.shell && !uniforms.picking.value) renderer.draw(this.shell);
  }

  /** What is seen at a place in CSS pixels: {joint} or {bar}, or null. A joint up to `reach` beside
   * it counts too, for fingers and small joints. */
  pick(x, y, reach = 0) {
    if (!this.model) return null;
    const edge = 2 * Math.round(reach) + 1;
    const corner = [x % this.orbit.size.width - (edge - 1) / 2, y - (edge - 1) / 2];
    return nearest(this, numbersSeen(this, ...corner, edge), edge);
  }
}

/** Length of a usual bar / 1.5 Angstrom: 1 for molecules, more or less for mechanisms. */
export function unitOf(model, positions) {
  if (model.kind !== 'graph' || !model.bars.length) return 1;
  let sum = 0;
  for (let k = 0; k < model.bars.length; k += 2) {
    const [a, b] = [3 * model.bars[k], 3 * model.bars[k + 1]];
    sum += Math.hypot(...[0, 1, 2].map((c) => positions[a + c] - positions[b + c]));
  }
  return sum / (model.bars.length / 2) / 2.2 || 1;
}
