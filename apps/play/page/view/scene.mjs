// SPDX-License-Identifier: MIT
// The picture: balls in one draw call, sticks in another, of any number of walkers.
import {
  BoxGeometry, ColorManagement, GLSL3, InstancedBufferGeometry, LinearSRGBColorSpace, Mesh,
  PlaneGeometry, RawShaderMaterial, Scene, WebGLRenderTarget, WebGLRenderer,
} from 'three';
import {Arrow} from './arrow.mjs';
import {Orbit} from './camera.mjs';
import {DepthLook} from './depth_look.mjs';
import {Members} from './members.mjs';
import {nearest, numbersSeen} from './picking.mjs';
import {Quality, isSoftware} from './quality.mjs';
import {Ribbon} from './ribbon.mjs';
import {STYLES} from './styles.mjs';
import {Textures} from './textures.mjs';
import {
  ballFragment, ballVertex, stickFragment, stickVertex, traceVertex,
} from './shaders.mjs';
import {rgb, uniformsOf} from './uniforms.mjs';

ColorManagement.enabled = false;  // the shaders write the colours of the screen

const NO_PART = {members: {value: null}, memberCount: {value: 0}};  // all are drawn

export {STYLES};

function instanced(geometry) {
  const made = new InstancedBufferGeometry();
  made.setAttribute('position', geometry.getAttribute('position'));
  made.setIndex(geometry.getIndex());
  made.instanceCount = 0;
  return made;
}

function layer(shape, shared, vertexShader, fragmentShader, smooth, part = NO_PART) {
  const uniforms = {...shared, ...part};
  const material = new RawShaderMaterial({
    glslVersion: GLSL3, uniforms, vertexShader, fragmentShader, alphaToCoverage: smooth,
  });
  const mesh = new Mesh(instanced(shape), material);
  mesh.frustumCulled = false;
  return mesh;
}

export class View {
  constructor(canvas) {
    this.isSmooth = !isSoftware();
    this.renderer = new WebGLRenderer({canvas, antialias: this.isSmooth, powerPreference: 'high-performance'});
    this.renderer.outputColorSpace = LinearSRGBColorSpace;  // no second conversion
    this.orbit = new Orbit();
    this.uniforms = uniformsOf();
    this.scene = new Scene();
    this.members = new Members();
    this.ribbon = new Ribbon(this.uniforms);
    this.balls = layer(new PlaneGeometry(2, 2), this.uniforms, ballVertex, ballFragment, this.isSmooth, this.members.joints);
    const box = new BoxGeometry(2, 2, 2);
    this.sticks = layer(box, this.uniforms, stickVertex, stickFragment, false, this.members.sticks);
    this.trace = layer(box, this.uniforms, traceVertex, stickFragment, false);
    this.arrow = new Arrow();
    this.overlays = [];  // drawn over the picture: {draw(renderer, camera)}
    this.depthLook = new DepthLook(this.uniforms, this.isSmooth ? 4 : 0);
    this.scene.add(this.ribbon.mesh, this.balls, this.sticks, this.trace);
    this.patch = new WebGLRenderTarget(1, 1);
    this.walkers = this.detail = this.ratio = 1;
    this.split = false;
    this.style = 'balls';
    this.showAllBars = false;
    this.showContacts = true;
    this.quality = new Quality(this.renderer.getContext(), this.isSmooth ? 0 : 3, (level) => this.setLevel(level));
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
    this.split = false;
    this.quality.reset();
    this.ribbon.open(model, positions);
    this.allocate(1);
    this.members.open(model, this.ribbon.runs, this.textures);
    this.textures.setPositions(positions);
    this.uniforms.unit.value = this.unit = unitOf(model, positions);
    this.orbit.frame(positions, this.unit);
    this.arrow.setUnit(this.unit);
    this.setStyle(this.style);
  }

  /** The same joints, held by other bars and contacts: the camera stays where it is. */
  reopen(model, positions) {
    this.model = model;
    this.allocate(1);
    this.textures.setPositions(positions);
    this.setStyle(this.style);
  }

  /** Room for `walkers` walkers; what joints and bars looked like is forgotten. */
  allocate(walkers) {
    this.textures?.dispose();
    this.textures = new Textures(this.model, walkers);
    this.walkers = walkers;
    this.second = {};  // values of uniforms that the right of two panes has in place of the left's
    const {textures, uniforms} = this;
    for (const name of ['positions', 'look', 'marks', 'strain', 'bars', 'controls', 'limits'])
      uniforms[name].value = textures[name];
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
    uniforms.kindRadius.value.set(1, this.showAllBars ? 0.35 : 0, this.showContacts ? 0.5 : 0, 0);
    this.stale = true;
  }

  /** Contacts in the colour of how near they are to a limit, also those that a cartoon leaves out. */
  showTautness(isOn) {
    this.uniforms.byTautness.value = Number(isOn);
    this.members.firstContact = isOn ? this.textures.firstContact : Infinity;
  }

  setBackground(text) {
    this.background = text;
    this.uniforms.background.value = rgb(text);
    this.renderer.setClearColor(text, 1);
    this.stale = true;
  }

  /** Numbers of joints and a bar to light up, or -1. */
  setLit({hover, near, far, bar}) {
    const {lit, litBar} = this.uniforms;
    lit.value.set(hover ?? lit.value.x, near ?? lit.value.y, far ?? lit.value.z);
    litBar.value = bar ?? litBar.value;
    this.stale = true;
  }

  resize(width, height, ratio) {
    this.size = {width, height};
    this.ratio = this.isSmooth ? ratio : 1;
    this.scale();
    this.fit();
  }

  /** Pixels of the picture: fewer while something moves. */
  scale() {
    this.renderer.setPixelRatio(this.ratio * this.detail);
    this.renderer.setSize(this.size.width, this.size.height, false);
  }

  /** The camera sees one of two panes, or the whole. */
  fit() {
    const {width, height} = this.size;
    this.orbit.resize(this.split ? width / 2 : width, height);
    this.stale = true;
  }

  count(walkers) {
    const style = STYLES[this.style];
    const {model, textures, balls, sticks, trace, ribbon, members, uniforms} = this;
    if (style.isPart) members.choose(textures, uniforms.lit.value.x, uniforms.litBar.value);
    else members.all();
    ribbon.show(style.ribbon ? walkers : 0);
    balls.geometry.instanceCount = this.style === 'trace' ? 0 : members.jointsOf(model.joints) * walkers;
    sticks.geometry.instanceCount = members.sticksOf(textures.stickCount) * walkers;
    trace.geometry.instanceCount = style.trace ? 5 * textures.pieceCount * walkers : 0;
    trace.visible = trace.geometry.instanceCount > 0;
    balls.visible = balls.geometry.instanceCount > 0;
    sticks.visible = sticks.geometry.instanceCount > 0;
  }

  setFog() {
    const {distance, radius} = this.orbit;
    this.uniforms.fog.value.set(distance - 0.25 * radius, distance + 1.7 * radius);
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
    if (!this.model) return this.renderer.clear();
    this.setFog();
    if (this.split) return this.drawSplit();
    this.uniforms.firstWalker.value = 0;
    this.count(this.walkers);
    this.render();
    for (const overlay of this.overlays) overlay.draw(this.renderer, this.orbit.camera);
    this.holders?.draw(this);
    return this.arrow.draw(this.renderer, this.orbit.camera);
  }

  /** With outlines and shadows, where there is time for them; a surface is nothing without. */
  render() {
    const {renderer, scene, uniforms} = this;
    const {camera} = this.orbit;
    const isSurface = Boolean(STYLES[this.style].isSurface);
    if (!isSurface && !uniforms.rich.value) return renderer.render(scene, camera);
    this.depthLook.draw(renderer, scene, camera, {isSurface, ratio: renderer.getPixelRatio()});
    return undefined;
  }

  /** Two walkers beside each other under one camera. */
  drawSplit() {
    const {width, height} = this.size;
    this.renderer.setScissorTest(true);
    for (const pane of [0, 1]) {
      const box = [pane * width / 2, 0, width / 2, height];
      this.renderer.setViewport(...box);
      this.renderer.setScissor(...box);
      this.uniforms.firstWalker.value = pane;
      this.count(1);
      const first = pane ? this.exchange(this.second) : {};
      this.renderer.render(this.scene, this.orbit.camera);
      this.exchange(first);
    }
    this.renderer.setScissorTest(false);
    this.renderer.setViewport(0, 0, width, height);
  }

  /** Puts these values of uniforms in place; the ones before them. */
  exchange(values) {
    const before = {};
    for (const [name, value] of Object.entries(values)) {
      before[name] = this.uniforms[name].value;
      this.uniforms[name].value = value;
    }
    return before;
  }

  /** What is seen at a place in CSS pixels: {joint} or {bar}, or null. A joint up to `reach` beside
   * it counts too, for fingers and small joints. */
  pick(x, y, reach = 0) {
    if (!this.model) return null;
    const {camera, size} = this.orbit;
    const edge = 2 * Math.round(reach) + 1;
    const corner = [x % size.width - (edge - 1) / 2, y - (edge - 1) / 2];
    camera.setViewOffset(size.width, size.height, ...corner, edge, edge);
    const bytes = numbersSeen(this, edge);
    camera.clearViewOffset();
    return nearest(this, bytes, edge);
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
