// SPDX-License-Identifier: MIT
// The hand: what mouse, finger and keys do on the picture. A joint that is held is drawn towards the
// pointer by a force; the worker makes one step of it after the other, as fast as frames are shown.

const STRENGTH = {weak: 0.1, strong: 0.8};  // share of the way to the pointer that a step takes
const FARTHEST = {weak: 0.1, strong: 0.6};  // Angstrom a step, in units of a usual bar / 1.5
const REACH = {mouse: 5, pen: 8, touch: 18};  // CSS pixels about the pointer in which a joint is met
const CLICK = 4;  // CSS pixels; less is no drag
const PER_FORCE = 100;  // Angstrom/ps^2 of 1 kJ/(mol Angstrom) on 1 u

const less = (a, b) => a.map((x, c) => x - b[c]);
const length = (v) => Math.hypot(...v);

export class Hand {
  constructor(canvas, view, session) {
    Object.assign(this, {canvas, view, session});
    this.tool = 'pull';
    this.strength = 'strong';
    this.pointers = new Map();
    this.vector = null;  // a force given in numbers, in place of the pointer's; kJ/(mol Angstrom)
    this.held = null;
    this.hovered = -1;
    this.busy = false;
    this.nextLook = 0;
    this.onPush = null;  // takes a push in place of the steps: bar by bar
    this.onSay = () => {};
    this.takers = {};  // by tool: takes the joint of a click in place of the pull
    this.listen();
  }

  listen() {
    const {canvas} = this;
    canvas.addEventListener('pointerdown', (event) => this.down(event));
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('pointerup', (event) => this.up(event));
    canvas.addEventListener('pointercancel', (event) => this.up(event));
    canvas.addEventListener('pointerleave', () => this.hover(-1));
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('wheel', (event) => this.wheel(event), {passive: false});
  }

  place(event) {
    const box = this.canvas.getBoundingClientRect();
    return {x: event.clientX - box.left, y: event.clientY - box.top};
  }

  positionOf(joint) {
    return [...this.session.positions.subarray(3 * joint, 3 * joint + 3)];
  }

  wheel(event) {
    event.preventDefault();
    this.view.orbit.zoom(Math.exp(Math.max(-60, Math.min(60, event.deltaY)) * 0.0035));
    this.view.stale = true;
  }

  down(event) {
    if (!this.view.model) return;
    this.canvas.setPointerCapture(event.pointerId);
    const at = this.place(event);
    this.pointers.set(event.pointerId, {...at, start: at, moved: false});
    if (this.pointers.size > 1) return this.release();
    this.action = event.button === 2 || event.shiftKey ? 'pan' : 'turn';
    this.met = null;
    if (event.button !== 0 || event.shiftKey || this.tool === 'turn') return;
    const met = this.met = this.view.pick(at.x, at.y, REACH[event.pointerType] ?? REACH.mouse);
    const mayMeet = !this.isReplay || this.tool in this.takers;
    if (met?.joint !== undefined && mayMeet) this.meet(met.joint, at, event.ctrlKey || event.metaKey);
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

  move(event) {
    const at = this.place(event);
    const pointer = this.pointers.get(event.pointerId);
    if (!pointer) return this.look(at);
    const [dx, dy] = [at.x - pointer.x, at.y - pointer.y];
    const far = Math.hypot(at.x - pointer.start.x, at.y - pointer.start.y);
    pointer.moved ||= far > CLICK;
    if (this.pointers.size > 1) this.pinch(event.pointerId, at);
    else if (this.held) this.drag(at);
    else if (this.action === 'pan') this.view.orbit.pan(dx, dy);
    else if (this.action === 'turn') this.view.orbit.rotate(dx, dy);
    Object.assign(pointer, at);
    this.view.stale = true;
  }

  /** Two fingers: nearer, about, and along. */
  pinch(id, at) {
    const [one, other] = [...this.pointers.entries()];
    const fixed = one[0] === id ? other[1] : one[1];
    const was = this.pointers.get(id);
    const [before, after] = [[was.x - fixed.x, was.y - fixed.y], [at.x - fixed.x, at.y - fixed.y]];
    const ratio = length(before) / Math.max(length(after), 1);
    const angle = Math.atan2(after[1], after[0]) - Math.atan2(before[1], before[0]);
    this.view.orbit.zoom(ratio);
    this.view.orbit.roll(Math.atan2(Math.sin(angle), Math.cos(angle)));
    this.view.orbit.pan((at.x - was.x) / 2, (at.y - was.y) / 2);
  }

  /** Of a force given in numbers the direction alone is drawn. */
  showVector() {
    const from = this.positionOf(this.held.joint);
    const scale = 2 * this.view.unit / Math.max(length(this.vector), 1e-12);
    this.view.arrow.show(from, from.map((x, c) => x + scale * this.vector[c]));
  }

  drag(at) {
    if (this.vector) return;
    const {held} = this;
    const {x, y} = {x: at.x + held.off.x, y: at.y + held.off.y};
    held.target = this.view.orbit.unproject(x, y, held.depth);
    held.hasMoved = true;
    this.view.arrow.show(this.positionOf(held.joint), held.target);
  }

  /** What is under the pointer: seldom, where looking is slow. */
  look(at) {
    if (this.looking || !this.view.model || performance.now() < this.nextLook) return;
    this.looking = true;
    requestAnimationFrame(() => {
      const began = performance.now();
      this.looking = false;
      const met = this.held ? null : this.view.pick(at.x, at.y);
      this.hover(met?.joint ?? -1, met?.bar, met?.contact);
      this.nextLook = performance.now() + 4 * (performance.now() - began);
    });
  }

  hover(joint, bar, contact) {
    if (this.held) return;
    if (joint === this.hovered && bar === this.hoveredBar && contact === this.hoveredContact) return;
    [this.hovered, this.hoveredBar, this.hoveredContact] = [joint, bar, contact];
    this.view.setLit({hover: joint});
    this.canvas.classList.toggle('over-joint', joint >= 0 || contact !== undefined);
    const {model} = this.session;
    if (contact !== undefined) return this.onSay(model.contactName(contact));
    this.onSay(joint >= 0 ? this.describe(joint) : bar === undefined ? '' : model.barName(bar));
  }

  up(event) {
    const isClick = this.pointers.get(event.pointerId)?.moved === false && event.type === 'pointerup';
    this.pointers.delete(event.pointerId);
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
