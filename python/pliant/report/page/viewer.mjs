// SPDX-License-Identifier: MIT
// The 3-D view of a report: that of pliant play, which here shows and plays the frames of a trajectory.
import {BROKEN, STRAINED, paintings} from './painting.mjs';
import {Timeline} from './timeline.mjs';
import {View} from './view/scene.mjs';
import {shell} from './view/shell.mjs';
import {STYLES} from './view/styles.mjs';
import {Turner} from './view/turner.mjs';
import {rgb} from './view/uniforms.mjs';

const START = '#dde2e6';  // of the structure that another lies over
const RATE = 12;  // frames a second at 1x
const MOST_BEHIND = 8;  // frames that a slow browser skips at most
const SHAPES = ['balls', 'sticks', 'spheres', 'lines'];
const ICONS = {play: 'M3 1.5v13l11-6.5z', pause: 'M3 1.5h3.6v13H3zM9.4 1.5H13v13H9.4z'};

const $ = (id) => document.getElementById(id);
const facts = document.documentElement.dataset;
const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const bytes = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));

/** As the view takes it. */
function modelOf({atoms, residues, bonds, bars}) {
  const isOfTrace = (joint) => `${atoms.names[joint]} ${atoms.elements[joint]}`.match(/^(CA 6|P 15)$/);
  return {
    kind: atoms.elements.some(Boolean) ? 'molecule' : 'graph', joints: atoms.names.length,
    elements: Uint8Array.from(atoms.elements), atoms: atoms.names, residue: Int32Array.from(atoms.residue),
    secondary: residues.secondary, trace: Int32Array.from([...atoms.names.keys()].filter(isOfTrace)),
    bars: Int32Array.from(bars), bonds: Int32Array.from(bonds), contacts: new Int32Array(0),
  };
}

/** A row of buttons of which one is pressed. */
function choices(id, entries, chosen, choose) {
  const group = document.querySelector(`#${id} .choice`);
  const press = (key) => {
    for (const button of group.children) button.setAttribute('aria-pressed', String(button.dataset.key === key));
    choose(key);
  };
  for (const [key, label] of entries) {
    const button = document.createElement('button');
    Object.assign(button, {type: 'button', textContent: label, onclick: () => press(key)});
    button.dataset.key = key;
    group.append(button);
  }
  $(id).hidden = entries.length < 2;
  if (entries.length) press(chosen);
}

class Viewer {
  constructor(scene) {
    this.scene = scene;
    this.model = modelOf(scene);
    this.positions = new Int16Array(bytes(scene.positions).buffer);
    this.residuals = bytes(scene.residuals);
    this.frame = 0;
    this.view = new View($('canvas'), {preserveDrawingBuffer: true});
    this.view.uniforms.longColour.value = rgb(BROKEN);
    this.view.uniforms.shortColour.value = rgb(STRAINED);
    this.view.setBackground(colour('--view'));
    this.view.uniforms.others.value = [...rgb(START), 1];
    this.view.contactShare = 2;
    this.resize();
    this.view.open(this.model, this.positionsOf(0));
    this.timeline = new Timeline($('chart'), scene, (frame) => { this.play(false); this.show(frame); });
  }

  /** Nothing lies over the start. */
  clear() {
    if (this.isLaid) document.querySelector('#shown [data-key=frames]').click();
  }

  get count() {
    return this.scene.frames.length;
  }

  /** Angstrom; of both structures where one lies over the other. */
  positionsOf(frame) {
    const {overlay, step} = this.scene;
    if (this.isLaid) return Float32Array.from(new Int16Array(bytes(overlay.positions).buffer), (x) => x * overlay.step);
    const size = 3 * this.model.joints;
    return Float32Array.from(this.positions.subarray(frame * size, (frame + 1) * size), (x) => x * step);
  }

  /** Another structure over the start, with its lines, or both in the map; or the frames again. */
  lay(key) {
    const {model, view, scene: {overlay}} = this;
    const isOn = this.isLaid = key !== 'frames';
    this.play(false);
    view.shell = key === 'map' ? this.shell ??= this.surface(overlay.surface) : null;
    const lines = isOn && {
      contacts: Int32Array.from(overlay.lines), contactKinds: overlay.kinds, contactKindColours: overlay.colours,
    };
    view.reopen({...model, ...lines}, this.positionsOf(this.frame), isOn ? 2 : 1);
    view.members.room(view.textures);
    view.members.firstContact = isOn ? view.textures.firstContact : Infinity;
    this.look();
    this.home();
  }

  surface({positions, step, triangles}) {
    const corners = Float32Array.from(new Int16Array(bytes(positions).buffer), (x) => x * step);
    return shell(corners, Uint32Array.from(new Uint16Array(bytes(triangles).buffer)), this.view.uniforms);
  }

  /** By code: below the tolerance negative, which is drawn blue, beyond it positive and orange. */
  strainOf(frame) {
    const bars = this.scene.bars.length / 2;
    const {per_decade: perDecade, lowest} = this.scene.residual_codes;
    return Float32Array.from(this.residuals.subarray(frame * bars, (frame + 1) * bars), (code) => {
      const decades = code / perDecade + lowest;
      return decades > 0 ? 0.1 : decades > -3 ? -(10 ** (decades - 1)) : 0;
    });
  }

  resize() {
    this.view.resize($('view').clientWidth, $('view').clientHeight, Math.min(devicePixelRatio || 1, 2));
  }

  /** Style and colours of what is shown. */
  look() {
    const {view, model, painting} = this;
    const isOfBars = painting.key === 'residual';
    view.showAllBars = isOfBars;
    view.setStyle(isOfBars ? 'sticks' : this.style);
    view.setStrain(isOfBars ? this.strainOf(this.frame) : new Float32Array(model.bars.length / 2));
    view.setColours(painting.of);
    if (view.shell) view.shell.uniforms.tint.value = rgb(colour('--soft'));
    if (facts.viewer) this.draw();
  }

  /** At once as finely as there is time for; at rest it is drawn whole. */
  draw() {
    const {quality} = this.view;
    quality.use(quality.level);
    this.view.frame();
  }

  show(frame) {
    this.clear();
    this.frame = Math.max(0, Math.min(this.count - 1, frame));
    this.view.setPositions(this.positionsOf(this.frame));
    if (this.painting.key === 'residual') this.view.setStrain(this.strainOf(this.frame));
    if (!this.isPlaying) this.draw();
    facts.frame = this.frame;
    $('slider').value = this.frame;
    const {axis: {label, values}, frames} = this.scene;
    const value = `${Number(values[this.frame].toPrecision(6))}${label.includes('ps') ? ' ps' : ''}`;
    $('place').textContent = `frame ${frames[this.frame]}${label === 'frame' ? '' : ` · ${label.split(' (')[0]} ${value}`}`;
    this.timeline.draw(this.series, this.frame);
  }

  play(isOn) {
    this.isPlaying = isOn && this.count > 1;
    this.due = 0;
    $('play').setAttribute('aria-label', this.isPlaying ? 'pause' : 'play');
    $('play').querySelector('path').setAttribute('d', this.isPlaying ? ICONS.pause : ICONS.play);
    facts.playing = String(this.isPlaying);
  }

  /** Once a frame of the screen. A slow browser skips frames rather than falls behind. */
  tick(now) {
    const pause = 1000 / (RATE * Number($('speed').value));
    if (this.isPlaying && now >= this.due) {
      const behind = this.due ? Math.min(MOST_BEHIND, Math.floor((now - this.due) / pause)) : 0;
      this.due = now + pause;
      this.show((this.frame + 1 + behind) % this.count);
    }
    const {view} = this;
    view.stale = view.quality.tick(now, view.stale) || view.stale;
    if (view.stale) view.frame();
    requestAnimationFrame((next) => this.tick(next));
  }

  /** So that the molecule is thinnest along the line of sight. */
  home() {
    this.view.orbit.frame(this.positionsOf(this.frame), this.view.unit);
    this.draw();
  }

  /** Small pictures beside answers: the whole molecule as it is at first, by their colours. */
  copy() {
    this.clear();
    const {painting, view} = this;
    for (const small of document.querySelectorAll('canvas[data-colour]')) {
      this.painting = this.paintings.find(({key}) => key === small.dataset.colour);
      view.resize(small.width, small.height, 1);
      view.orbit.frame(this.positionsOf(this.frame), view.unit);
      this.look();
      view.draw();
      small.getContext('2d').drawImage($('canvas'), 0, 0, small.width, small.height);
    }
    this.painting = painting;
    this.resize();
    this.home();
    this.look();
  }

  legend() {
    const [left, bar, right] = $('legend').children;
    const {legend} = this.painting;
    $('legend').hidden = !legend;
    $('legend').style.display = legend ? 'flex' : 'none';  // the class's display overrides `hidden`
    if (legend) [left.textContent, right.textContent, bar.style.background] = legend;
  }

  controls() {
    const {scene, model} = this;
    const hasChain = model.trace.length > 3;
    const shapes = scene.trace_only ? ['trace', 'spheres'] : SHAPES;
    const styles = hasChain ? ['cartoon', ...shapes] : shapes.filter((name) => name !== 'trace');
    const rows = this.paintings = paintings(scene);
    const wanted = ['cluster', ...hasChain ? ['mobility'] : [], 'element'];
    [this.style, this.painting] = [styles[0], rows[0]];
    choices('styles', styles.map((name) => [name, STYLES[name].title]), styles[0], (key) => {
      this.style = key;
      this.look();
    });
    const first = wanted.find((key) => rows.some((row) => row.key === key));
    choices('colours', rows.map(({key, label}) => [key, label]), first, (key) => {
      this.painting = rows.find((row) => row.key === key);
      this.legend();
      this.look();
    });
    if (scene.overlay) {
      const map = scene.overlay.surface ? [['map', 'both in the map']] : [];
      choices('shown', [['frames', 'frames'], ['overlay', scene.overlay.label], ...map], 'frames', (key) => this.lay(key));
    }
    const series = Object.entries(scene.series).map(([key, {label}]) => [key, label]);
    choices('series', series, series[0]?.[0], (key) => {
      this.series = key;
      this.timeline.draw(this.series, this.frame);
    });
  }

  press(event) {
    if (/^(INPUT|SELECT|BUTTON|SUMMARY)$/.test(event.target.tagName)) return;
    const step = {ArrowLeft: -1, ArrowRight: 1}[event.key];
    if (event.key === ' ') this.play(!this.isPlaying);
    else if (step) this.show(this.frame + step);
    else return;
    event.preventDefault();
  }

  /** The atom under the pointer, in words. */
  nameOf(atom) {
    const {atoms, residues} = this.scene;
    const residue = atoms.residue[atom];
    return [residues.names[residue], residues.numbers[residue], atoms.names[atom], residues.chains[residue]].filter(String).join(' ');
  }

  listen() {
    if (this.count < 2) for (const one of document.querySelectorAll('.timeline, .bar.play')) one.style.display = 'none';
    $('slider').max = this.count - 1;
    $('slider').oninput = () => this.show(Number($('slider').value));
    $('play').onclick = () => this.play(!this.isPlaying);
    $('reset').onclick = () => this.home();
    document.addEventListener('keydown', (event) => this.press(event));
    new Turner($('canvas'), this.view).tell = (atom) => { $('atom').textContent = atom < 0 ? '' : this.nameOf(atom); };
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
      this.view.setBackground(colour('--view'));
      this.copy();
      this.timeline.draw(this.series, this.frame);
    });
    new ResizeObserver(() => {
      this.resize();
      this.timeline.draw(this.series, this.frame);
    }).observe($('view'));
  }

  start() {
    this.controls();
    this.copy();
    this.listen();
    $('message').hidden = true;
    facts.viewer = 'drawn';
    this.show(0);
    requestAnimationFrame((now) => this.tick(now));
  }
}

try {
  new Viewer(JSON.parse($('scene').textContent)).start();
} catch (error) {
  facts.viewer = 'failed';
  $('message').hidden = false;
  const why = String(error?.message ?? error).replace(/\.?$/, '.');
  $('message').textContent = `The 3-D view could not be drawn. ${why} The rest of the page is whole.`;
}
