// SPDX-License-Identifier: MIT
// The keyboard, and the dialogs that tell about it.
import {$, guarded, say, units} from './dom.mjs';
import {helpRow} from './look.mjs';
import {textInside} from '../inside.mjs';

const STEP = 24;  // CSS pixels of a turn, a shift or a pull by a key

const HELP = [
  [['drag a joint'], 'pull it; the arrow is the force'],
  [['drag beside it'], 'turn the picture'],
  [['Shift', 'drag'], 'move the picture; the right button does so too'],
  [['wheel'], 'nearer or farther; two fingers on a touch screen'],
  [['Ctrl', 'click'], 'pin a joint, or take the pin out'],
  [['←', '→', '↑', '↓'], 'turn the picture'],
  [['Alt', '←→↑↓'], 'move the picture'],
  [[',', '.'], 'choose the joint before or after'],
  [['Shift', '←→↑↓'], 'pull the chosen joint'],
  [['+', '−'], 'nearer, farther'],
  [['P'], 'pin the chosen joint'],
  [['Space'], 'play or stop the recording'],
  [['R'], 'record, or stop recording'],
  [['Z'], 'undo the last pull, cut or bar'],
  [['Y'], 'why the chosen joint does not follow a pull away from the middle'],
  [['X'], 'cut all that is said to hold it'],
  [['B'], 'take the chosen joint as one of two, to be joined or cut'],
  [['F'], 'see all of it'],
  [['G'], 'zoom to fit a bar: the one in hand, or under the pointer; or a double click'],
  [['K'], 'film of a repair: pause, go on'],
  [['J', 'L'], 'film: one bar back, one further'],
  [['Esc'], 'film: skip to the end'],
  [['W'], 'wander, or stop'],
  [['T'], 'dark or light'],
  [['?'], 'this help'],
];

const ARROWS = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
const TYPING = /^(INPUT|SELECT|TEXTAREA|BUTTON|SUMMARY)$/;

export class Keys {
  constructor(parts) {
    Object.assign(this, parts);
    this.chosen = -1;
    $('help-rows').replaceChildren(...HELP.map(([keys, meaning]) => helpRow(keys, meaning)));
    $('help-open').onclick = () => $('help').showModal();
    $('about-open').onclick = () => this.about();
    addEventListener('keydown', (event) => this.press(event));
    this.stage.on('began', () => { this.chosen = -1; });
    this.session.on('undone', ({steps}) => { $('said').textContent = `${units(steps, 'step')} taken back`; });
    this.letters = {
      p: () => this.pin(), r: () => $('record').click(), z: () => $('undo').click(),
      f: () => this.fit(), w: () => $('wander').click(), t: () => $('theme').click(),
      '?': () => $('help').showModal(), ' ': () => $('play').click(),
      y: () => this.askWhy(), x: () => $('why-cut').hidden ? $('why-list').querySelector('button')?.click() : $('why-cut').click(),
      b: () => this.chosen >= 0 && this.constraints.pick(this.chosen),
      ',': () => this.choose(-1), '.': () => this.choose(1),
      g: () => this.fitBar.byKey(), k: () => this.resolution.pause(!this.resolution.isPaused),
      j: () => this.resolution.stepBy(-1), l: () => this.resolution.stepBy(1),
      escape: () => this.resolution.finish(),
      '+': () => this.zoom(0.85), '=': () => this.zoom(0.85), '-': () => this.zoom(1 / 0.85),
    };
  }

  async about() {
    $('about-text').textContent = `Pliant ${PLIANT_VERSION}: molecular flexibility by geometric ` +
      'constraints. The solver is the same C++ library as the command’s, as WebAssembly. Nothing that ' +
      'you open leaves this page.';
    $('about-notices').textContent = await textInside('notices');
    $('about').showModal();
  }

  press(event) {
    const {target, key} = event;
    const isTyping = TYPING.test(target.tagName) || document.querySelector('dialog[open]');
    if (isTyping || event.ctrlKey || event.metaKey || (event.altKey && !ARROWS[event.key])) return;
    const arrow = ARROWS[key];
    const action = arrow ? () => this.arrow(arrow, event) : this.letters[key.toLowerCase()];
    if (!action || !this.stage.model) return;
    event.preventDefault();
    guarded(action);
  }

  arrow([dx, dy], {shiftKey, altKey}) {
    if (shiftKey) return this.pull(dx, dy);
    if (altKey) this.view.orbit.pan(dx * STEP, dy * STEP);
    else this.view.orbit.rotate(dx * STEP, dy * STEP);
    this.view.stale = true;
    return undefined;
  }

  pull(dx, dy) {
    if (this.chosen < 0) return say('Choose a joint first, by the keys , and .', true);
    return this.hand.isReplay ? undefined : this.nudge(dx * STEP, dy * STEP);
  }

  /** The step, and in words how far it came. */
  async nudge(dx, dy) {
    const {chosen, hand} = this;
    const before = hand.positionOf(chosen);
    await hand.nudge(chosen, dx, dy);
    const far = Math.hypot(...hand.positionOf(chosen).map((x, c) => x - before[c]));
    $('said').textContent = `${hand.describe(chosen)} moved ${far.toFixed(2)} Å`;
  }

  choose(way) {
    const {joints} = this.stage.model;
    this.chosen = (this.chosen + way + joints) % joints;
    this.view.setLit({hover: this.chosen});
    $('said').textContent = this.hand.describe(this.chosen);
  }

  /** Of a pull straight away from the middle of all joints. */
  askWhy() {
    const joint = this.chosen >= 0 ? this.chosen : this.hand.hovered;
    if (joint < 0) return say('Choose a joint first, by the keys , and .', true);
    const {positions} = this.session;
    const middle = [0, 1, 2].map((c) => positions.reduce((sum, x, k) => sum + (k % 3 === c ? x : 0), 0) / (positions.length / 3));
    const now = this.hand.positionOf(joint);
    return this.why.askOf(joint, now.map((x, c) => x + 10 * (x - middle[c])));
  }

  pin() {
    const joint = this.chosen >= 0 ? this.chosen : this.hand.hovered;
    if (joint < 0) return;
    this.session.togglePin(joint);
    $('said').textContent = this.hand.describe(joint);
  }

  zoom(factor) {
    this.view.orbit.zoom(factor);
    this.view.stale = true;
  }

  fit() {
    $('fit').click();
  }
}
