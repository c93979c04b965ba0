// SPDX-License-Identifier: MIT
// The hand: what mouse, finger and keys do on the picture. A joint that is held is drawn towards the
// pointer by a force; the worker makes one step of it after the other, as fast as frames are shown.
import {Turner} from './view/turner.mjs';
import {length, less, plus, pointOf, times} from './view/vectors.mjs';

const STRENGTH = {weak: 0.1, strong: 0.8};  // share of the way to the pointer that a step takes
const FARTHEST = {weak: 0.1, strong: 0.6};  // Angstrom a step, in units of a usual bar / 1.5
const REACH = {mouse: 5, pen: 8, touch: 18};  // CSS pixels about the pointer in which a joint is met
const PER_FORCE = 100;  // Angstrom/ps^2 of 1 kJ/(mol Angstrom) on 1 u

export class Hand extends Turner {
  constructor(canvas, view, session) {
    super(canvas, view);
    this.session = session;
    this.tool = 'pull';
    this.strength = 'strong';
    this.vector = null;  // a force given in numbers, in place of the pointer's; kJ/(mol Angstrom)
    this.held = null;
    this.busy = false;
    this.onPush = null;  // takes a push in place of the steps: bar by bar
    this.onSay = () => {};
    this.takers = {};  // by tool: takes the joint of a click in place of the pull
  }

  positionOf(joint) {
    return pointOf(this.session.positions, joint);
  }

  down(event) {
    const at = super.down(event);
    if (!at) return this.release();
    this.met = null;
    if (event.button !== 0 || event.shiftKey || this.tool === 'turn') return undefined;
    const met = this.met = this.view.pick(at.x, at.y, REACH[event.pointerType] ?? REACH.mouse);
    const mayMeet = !this.isReplay || this.tool in this.takers;
    if (met?.joint !== undefined && mayMeet) this.meet(met.joint, at, event.ctrlKey || event.metaKey);
    return undefined;
  }

  meet(joint, at, withControl) {
    if (this.takers[this.tool] && !withControl) {
      this.action = 'none';
      this.takers[this.tool](joint);
      return;
    }
    if (this.tool === 'pin' || withControl) {
      this.action = 'none';
      this.session.togglePin(joint);
      return;
    }
    this.action = 'pull';
    this.grasp(joint, at);
  }

  grasp(joint, at) {
    const from = this.positionOf(joint);
    const screen = this.view.orbit.project(from);
    this.held = {
      joint, depth: screen.depth, off: {x: screen.x - at.x, y: screen.y - at.y}, target: from,
      isNew: true, hasMoved: Boolean(this.vector),
    };
    if (this.vector) this.showVector();
    this.view.setLit({hover: joint});
    this.onSay(this.describe(joint));
  }

  describe(joint) {
    const pinned = this.session.pins.has(joint) ? ', pinned' : '';
    return `${this.session.model.nameOf(joint)}${pinned}`;
  }

  /** Of a force given in numbers the direction alone is drawn. */
  showVector() {
    const from = this.positionOf(this.held.joint);
    const scale = 2 * this.view.unit / Math.max(length(this.vector), 1e-12);
    this.view.arrow.show(from, plus(from, times(this.vector, scale)));
  }

  drag(at, dx, dy) {
    if (!this.held) super.drag(at, dx, dy);
    else if (!this.vector) this.pullTo(at);
  }

  pullTo(at) {
    const {held} = this;
    const {x, y} = {x: at.x + held.off.x, y: at.y + held.off.y};
    held.target = this.view.orbit.unproject(x, y, held.depth);
    held.hasMoved = true;
    this.view.arrow.show(this.positionOf(held.joint), held.target);
  }

  seen(at) {
    return this.held ? null : super.seen(at);
  }

  hover(...met) {
    if (!this.held) super.hover(...met);
  }

  tell(joint, bar, contact) {
    const {model} = this.session;
    if (contact !== undefined) return this.onSay(model.contactName(contact));
    return this.onSay(joint >= 0 ? this.describe(joint) : bar === undefined ? '' : model.barName(bar));
  }

  up(event) {
    const isClick = super.up(event);
    if (isClick && this.met && this.action !== 'none') this.session.tell('clicked', this.met);
    const {held} = this;
    if (!held) return;
    if (this.onPush && held.hasMoved) this.onPush([this.forceOn(held, 1)]);
    this.release();
  }

  release() {
    if (this.held) this.view.setLit({hover: -1});
    this.held = null;
    this.view.arrow.hide();
    this.view.stale = true;
    this.session.tell('released');
  }

  /** Force that takes a joint a share of the way to the pointer in a step, against its velocity. */
  forceOn(held, share = STRENGTH[this.strength]) {
    if (this.vector) return [held.joint, ...this.vector];
    const now = this.positionOf(held.joint);
    if (this.session.live?.isDynamics) return [held.joint, ...this.session.live.spring(less(held.target, now))];
    const timestep = this.session.settings.timestep || 0.01;
    const given = this.session.model.mass?.[held.joint];
    const mass = given > 0 && given < Infinity ? given : 12;
    const way = less(held.target, now).map((x) => x * share);
    const pace = this.session.live?.pace ?? 1;  // a slow page is to pull as hard as a fast one
    const most = FARTHEST[this.strength] * this.view.unit * (share === 1 ? 4 : pace);
    const scale = Math.min(1, most / Math.max(length(way), 1e-12));
    const effort = this.session.effort(held.joint, way.map((x) => x * scale));
    const factor = mass / (PER_FORCE * timestep * timestep);
    return [held.joint, ...effort.map((x) => x * factor)];
  }

  /** The share of the way, and how far (Angstrom) a step of a pull may go. */
  pace() {
    return {share: STRENGTH[this.strength], furthest: FARTHEST[this.strength] * this.view.unit};
  }

  /** Called for each frame shown: begins a step where one is due. */
  async frame() {
    const {held} = this;
    if (!held?.hasMoved || this.busy || this.onPush) return;
    this.busy = true;
    try {
      const isNew = held.isNew;
      held.isNew = false;
      await this.session.pull([this.forceOn(held)], isNew);
      if (this.held && this.vector) this.showVector();
      else if (this.held) this.view.arrow.show(this.positionOf(held.joint), held.target);
    } catch (error) {
      this.release();
      this.session.tell('error', error);
    } finally {
      this.busy = false;
    }
  }

  /** One step by keys: of this joint along the screen, for those who use no pointer. */
  async nudge(joint, dx, dy) {
    const screen = this.view.orbit.project(this.positionOf(joint));
    const target = this.view.orbit.unproject(screen.x + dx, screen.y + dy, screen.depth);
    const push = this.forceOn({joint, target}, 1);
    if (this.onPush) return this.onPush([push]);
    const step = await this.session.pull([push]);
    if (this.session.live) this.session.tell('released');
    return step;
  }
}
