// SPDX-License-Identifier: MIT
// How mouse, pen and fingers turn, move and bring near what is seen, and what is under the pointer.

const CLICK = 4;  // CSS pixels; less is no drag

export class Turner {
  constructor(canvas, view) {
    Object.assign(this, {canvas, view});
    this.pointers = new Map();
    this.hovered = -1;
    this.nextLook = 0;
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

  wheel(event) {
    event.preventDefault();
    this.view.orbit.zoom(Math.exp(Math.max(-60, Math.min(60, event.deltaY)) * 0.0035));
    this.view.stale = true;
  }

  /** Where it is; null where another finger is down already, or nothing is open. */
  down(event) {
    if (!this.view.model) return null;
    this.canvas.setPointerCapture(event.pointerId);
    const at = this.place(event);
    this.pointers.set(event.pointerId, {...at, start: at, moved: false});
    this.action = event.button === 2 || event.shiftKey ? 'pan' : 'turn';
    return this.pointers.size > 1 ? null : at;
  }

  move(event) {
    const at = this.place(event);
    const pointer = this.pointers.get(event.pointerId);
    if (!pointer) return this.look(at);
    pointer.moved ||= Math.hypot(at.x - pointer.start.x, at.y - pointer.start.y) > CLICK;
    if (this.pointers.size > 1) this.pinch(event.pointerId, at);
    else this.drag(at, at.x - pointer.x, at.y - pointer.y);
    Object.assign(pointer, at);
    this.view.stale = true;
  }

  /** By one pointer, so many pixels. */
  drag(at, dx, dy) {
    if (this.action === 'pan') this.view.orbit.pan(dx, dy);
    else if (this.action === 'turn') this.view.orbit.rotate(dx, dy);
  }

  /** Two fingers: nearer, about, and along. */
  pinch(id, at) {
    const [one, other] = [...this.pointers.entries()];
    const fixed = one[0] === id ? other[1] : one[1];
    const was = this.pointers.get(id);
    const [before, after] = [[was.x - fixed.x, was.y - fixed.y], [at.x - fixed.x, at.y - fixed.y]];
    const angle = Math.atan2(after[1], after[0]) - Math.atan2(before[1], before[0]);
    this.view.orbit.zoom(Math.hypot(...before) / Math.max(Math.hypot(...after), 1));
    this.view.orbit.roll(Math.atan2(Math.sin(angle), Math.cos(angle)));
    this.view.orbit.pan((at.x - was.x) / 2, (at.y - was.y) / 2);
  }

  /** Whether it was a click. */
  up(event) {
    const isClick = this.pointers.get(event.pointerId)?.moved === false && event.type === 'pointerup';
    this.pointers.delete(event.pointerId);
    return isClick;
  }

  /** What is under the pointer: seldom, where looking is slow. */
  look(at) {
    if (this.looking || !this.view.model || performance.now() < this.nextLook) return;
    this.looking = true;
    requestAnimationFrame(() => {
      const began = performance.now();
      this.looking = false;
      const met = this.seen(at);
      this.hover(met?.joint ?? -1, met?.bar, met?.contact);
      this.nextLook = performance.now() + 4 * (performance.now() - began);
    });
  }

  seen({x, y}) {
    return this.view.pick(x, y);
  }

  hover(joint, bar, contact) {
    if (joint === this.hovered && bar === this.hoveredBar && contact === this.hoveredContact) return;
    [this.hovered, this.hoveredBar, this.hoveredContact] = [joint, bar, contact];
    this.view.setLit({hover: joint});
    this.canvas.classList.toggle('over-joint', joint >= 0 || contact !== undefined);
    this.tell(joint, bar, contact);
  }
}
