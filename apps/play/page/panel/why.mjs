// SPDX-License-Identifier: MIT
// "Why does it not move?": a pull that is held lights up what holds it, and a box beside the molecule
// says it in words. Each line can be cut.
import {HeldWatch} from '../held.mjs';
import {Holders} from '../view/holders.mjs';
import {$, element, guarded, say} from './dom.mjs';

const ASK_AGAIN = 0.5;  // Angstrom that a held joint goes before it is asked for anew
const MOST_LINES = 8;
const GAP = 10;  // CSS pixels from the edges of the picture

export class Why {
  constructor({view, session, stage, hand}) {
    Object.assign(this, {view, session, stage, hand});
    this.watch = new HeldWatch();
    view.holders = this.holders = new Holders();
    session.on('step', () => this.step());
    session.on('released', () => { this.asked = null; });
    session.on('edited', () => this.close());
    session.on('undone', () => this.close());
    stage.on('began', () => this.close());
    $('why-close').onclick = () => this.close();
    $('why-cut').onclick = () => guarded(() => this.cut(this.lines.filter(({cut}) => cut)));
    $('why').addEventListener('keydown', (event) => event.key === 'Escape' && this.close());
  }

  /** After each step of the solver: whether the hand's pull is held. */
  step() {
    const {hand, session, view} = this;
    const {held} = hand;
    if (!held || hand.vector || session.live) return this.watch.begin(-1);
    const {joint, target} = held;
    const place = (positions) => [...positions.subarray(3 * joint, 3 * joint + 3)];
    const [before, now] = [place(session.before), place(session.positions)];
    const pull = {joint, target, ...hand.pace()};
    this.watch.take({...pull, before, now});
    if (this.asked?.joint !== joint && this.isOpen) this.close();
    if (!this.watch.isHeld(view.unit)) return undefined;
    const far = this.asked ? Math.hypot(...now.map((x, c) => x - this.asked.now[c])) : Infinity;
    if (far < ASK_AGAIN * view.unit || this.asking) return undefined;
    this.asked = {joint, now};
    return guarded(() => this.ask(pull, false));
  }

  /** For the joint that is held or chosen, along the last pull: by a key. */
  askOf(joint, target) {
    return guarded(() => this.ask({joint, target, ...this.hand.pace()}));
  }

  /** A joint that was slow but is not held is told of where a person has asked. */
  async ask(pull, isAsked = true) {
    this.asking = true;
    try {
      const {id, ok, ...found} = await this.session.ask('why', pull);
      if (isAsked || found.isHeld) this.show(pull.joint, found);
    } finally {
      this.asking = false;
    }
  }

  get isOpen() {
    return !$('why').hidden;
  }

  show(joint, found) {
    this.found = found;
    this.lines = found.lines;
    $('why-said').textContent = found.said;
    $('why-list').replaceChildren(...this.lines.slice(0, MOST_LINES).map((line) => this.row(line)));
    const more = this.lines.length - MOST_LINES;
    if (more > 0) $('why-list').append(element('li', `and ${more} more`));
    const cuts = this.lines.filter(({cut}) => cut).length;
    $('why-cut').hidden = cuts < 2;
    $('why-cut').textContent = `Cut all ${cuts}`;
    $('why').hidden = false;
    this.light(found);
    this.place();
    this.session.tell('why', found);
  }

  light({lines, loaded, taut}) {
    const {bars} = this.session.model;
    const pairs = (list) => list.map(({a, b}) => [a, b]);
    const chain = taut?.joints ?? [];
    this.holders.show({
      loaded: [...loaded].map((bar) => [bars[2 * bar], bars[2 * bar + 1]]),
      taut: chain.slice(1).map((joint, k) => [chain[k], joint]),
      holder: pairs(lines.filter(({what}) => what !== 'pin')),
    }, lines.filter(({what}) => what === 'pin').map(({a}) => a));
    this.view.stale = true;
  }

  row(line) {
    const row = element('li');
    row.append(element('span', line.text));
    const share = `${Math.round(100 * line.load)} %`;
    row.append(element('small', share, {title: 'share of the pull'}));
    const act = this.actOn(line);
    if (!act) return row;
    const button = element('button', act.word, {type: 'button', 'aria-label': `${act.word}: ${line.text}`});
    button.onclick = () => guarded(act.run);
    row.append(button);
    return row;
  }

  actOn(line) {
    if (line.cut) return {word: 'Cut', run: () => this.cut([line])};
    if (line.what === 'pin') return {word: 'Take out', run: () => { this.session.togglePin(line.a); this.close(); }};
    return null;
  }

  async cut(lines) {
    if (!lines.length) return;
    await this.session.edit(lines.map(({a, b}) => ['cut', a, b]));
    say(`${lines.length === 1 ? `Cut: ${lines[0].text}.` : `${lines.length} contacts cut.`} Z or Undo puts ${lines.length === 1 ? 'it' : 'them'} back.`, true);
  }

  close() {
    $('why').hidden = true;
    this.lines = [];
    this.asked = null;
    this.holders.hide();
    this.view.stale = true;
  }

  /** In a corner of the picture where it covers no joint; where there is none, beside the picture. */
  place() {
    const box = $('why');
    $('stage').append(box);
    box.classList.remove('beside');
    const {width, height} = this.view.size;
    const [w, h] = [box.offsetWidth, box.offsetHeight];
    const below = $('readout').offsetHeight + 2 * GAP;
    const top = 80;
    const corners = [[GAP, top], [width - w - GAP, top], [GAP, height - h - below], [width - w - GAP, height - h - below]];
    const seen = this.projected();
    const covered = corners.map(([x, y]) => seen.filter((at) => at.x > x && at.x < x + w && at.y > y && at.y < y + h).length);
    const least = Math.min(...covered);
    const best = corners[covered.indexOf(least)];
    if (least > 0 && this.moveBeside(box)) return;
    box.style.left = `${Math.max(0, best[0])}px`;
    box.style.top = `${Math.max(0, best[1])}px`;
  }

  /** Where the panel is below the picture, between the two; false where it is hidden. */
  moveBeside(box) {
    const isNarrow = matchMedia('(max-width: 900px)').matches;
    if (!isNarrow && document.body.classList.contains('wide')) return false;
    if (isNarrow) $('stage').after(box);
    else $('side').prepend(box);
    box.classList.add('beside');
    if (!isNarrow) $('side').scrollTop = 0;
    return true;
  }

  projected() {
    const {session: {positions}, view: {orbit}} = this;
    const seen = [];
    for (let at = 0; at < positions.length; at += 3) seen.push(orbit.project([...positions.subarray(at, at + 3)]));
    return seen;
  }
}
