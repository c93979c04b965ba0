// SPDX-License-Identifier: MIT
// Many frames of one molecule: played in an order for the eye, coloured by what moves, with the
// domains that turn and the shapes that pliant play found, and pulled on from any of them.
import {openFrame} from '../record/ensemble_model.mjs';
import {filmsOf, meanOf} from '../record/film.mjs';
import {Fluctuation} from '../record/superpose.mjs';
import {Domains} from './domains.mjs';
import {$, guarded, units} from './dom.mjs';
import {Shapes} from './shapes.mjs';
import {STYLES} from '../view/styles.mjs';

const LEAST = 4;  // frames; fewer are shown one by one
const LACKS = 'pliant play FILE finds domains and shapes, too, which the page alone does not.';
const INDEPENDENT = 'Frames are independent: the order is for the eye and tells nothing of time. Each is a frame of the file, none is made up between two.';

const stemOf = (name) => name.replace(/\.(h5md|h5)$/i, '');
const isEnsemble = ({sampler, isPath}) => Boolean(sampler) && !isPath;

export class Ensemble {
  constructor({session, stage, look, transport, view}) {
    Object.assign(this, {session, stage, look, view, transport});
    this.domains = new Domains(stage, view, look);
    this.shapes = new Shapes(stage, view, (index) => this.show(index));
    $('ensemble-order').onchange = () => this.order($('ensemble-order').value);
    $('ensemble-drag').onclick = () => guarded(() => this.drag());
    $('ensemble-back').onclick = () => guarded(() => this.back());
    stage.on('began', () => this.isOwn || this.close());
    stage.on('replayed', (told) => guarded(() => this.opened(told)));
    stage.on('changed', () => this.refresh());
  }

  close() {
    this.of = null;
    $('ensemble-panel').hidden = true;
    this.domains.close();
  }

  async opened({name, file, found = {}, canPull}) {
    const {stage} = this;
    const frames = stage.frames.list;
    if (frames.length < 2) return;
    const near = [...frames.keys()].filter((k) => !file.reaches[this.numberOf(k, found)]);
    this.of = {
      name, file, found, canPull, frames: [...frames], model: stage.model,
      near: near.length < 2 ? [...frames.keys()] : near, isEnsemble: isEnsemble(file),
    };
    $('ensemble-panel').hidden = false;
    $('ensemble-title').textContent = this.of.isEnsemble ? 'Ensemble' : 'Frames';
    $('ensemble-note').textContent = this.note();
    const {of} = this;
    await new Promise((drawn) => requestAnimationFrame(() => setTimeout(drawn)));
    if (this.of === of) this.measure();
  }

  numberOf(index, found = this.of.found) {
    return found.numbers?.[index] ?? index;
  }

  note() {
    const {frames, file, found, isEnsemble: isOne} = this.of;
    const all = found.frames ?? file.count;
    const said = [all > frames.length
      ? `${frames.length.toLocaleString('en')} of ${units(all, 'frame')}, taken evenly: all would be too large for a page.`
      : `${units(all, 'frame')}.`];
    if (isOne) said.push(INDEPENDENT);
    if (found.meaning && !isOne) said.push(found.meaning);
    if (!found.frames) said.push(LACKS);
    return [...said, ...(found.notes ?? [])].join('\n');
  }

  /** What takes a moment: mobility, orders and small pictures. */
  measure() {
    const {of, stage} = this;
    const which = stage.measured();
    const near = of.near.map((k) => of.frames[k].positions);
    of.fluctuation = new Fluctuation(meanOf(near, which), which);
    for (const positions of near) of.fluctuation.add(positions);
    of.films = of.isEnsemble && near.length >= LEAST
      ? filmsOf(of.frames.map((frame) => frame.positions), of.near, Array.from(which)) : null;
    this.begin();
    this.shapes.open(of.found.shapes, (number) => this.indexOf(number));
    if (of.films && !matchMedia('(prefers-reduced-motion: reduce)').matches) this.playOnce();
  }

  /** The frames are there, to be looked at. */
  begin() {
    const {of, stage} = this;
    stage.fluctuation = of.fluctuation;
    this.domains.open(of.found, (number) => this.indexOf(number), (index) => this.show(index));
    if (!this.domains.count && !this.look.ownColouring) this.look.setColouring('mobility');
    this.drawChain();
    stage.look();
    this.order(of.films ? 'along' : 'file');
  }

  /** Of many atoms that all move the chain alone is followed by the eye. */
  drawChain() {
    const {model} = this.stage;
    if (this.view.style === 'balls' && model.trace.length > 2) this.look.setStyle(STYLES.cartoon ? 'cartoon' : 'trace');
  }

  indexOf(number) {
    const {numbers} = this.of.found;
    return numbers ? numbers.indexOf(number) : number;
  }

  order(name) {
    const {films, frames} = this.of;
    $('ensemble-order').value = name;
    $('ensemble-order').disabled = !films;
    this.transport.play(false);
    this.transport.film.choose(films?.[name] ?? null);
    const shown = films?.[name];
    $('ensemble-order-note').textContent = !shown ? '' : name === 'along'
      ? `${shown.length} of ${units(frames.length, 'frame')}, from one end of the largest motion (${Math.round(100 * films.share)} % of all) to the other.`
      : `${units(shown.length, 'frame')}.`;
    if (shown && !this.isPulled) this.stage.show(shown[0]);
  }

  /** There and back, so that it is seen what moves; then it stands still. */
  playOnce() {
    const {film} = this.transport;
    film.rounds = 1;
    this.transport.play(true);
    film.rounds = Infinity;
  }

  show(index) {
    this.transport.play(false);
    if (this.isPulled) return guarded(async () => { await this.back(); this.stage.show(index); });
    return this.stage.show(index);
  }

  refresh() {
    if (!this.of) return;
    const {at} = this.stage;
    $('ensemble-drag').disabled = this.isPulled || !this.of.canPull || at === null;
    $('ensemble-back').hidden = !this.isPulled;
    if (!this.isPulled) $('ensemble-drag-note').textContent = this.of.canPull ? ''
      : 'No frame can be pulled on: the file does not name its atoms and bonds.';
    this.shapes.mark(this.isPulled ? -1 : at);
    this.domains.stand();
  }

  get isPulled() {
    return Boolean(this.of) && !this.stage.isReplay;
  }

  /** A session that begins where the frame is. */
  async drag() {
    const {of, stage, session} = this;
    this.transport.play(false);
    const {positions} = stage.frames.at(stage.at);
    of.at = stage.at;
    const number = this.numberOf(of.at);
    await this.asOwn(() => openFrame(session, `${stemOf(of.name)}_frame_${number}.cif`, of.file, positions));
    this.domains.colour(of.found);
    if (this.view.style === 'trace') this.look.setStyle('trace-lines');  // of a trace alone no atom can be met
    const held = stage.model.contacts.length ? ' with the contacts that this frame has' : '';
    $('ensemble-drag-note').textContent = `From frame ${number}, held by the model ${stage.model.model}${held}: drag any atom.`;
  }

  async back() {
    const {of, stage} = this;
    this.transport.play(false);
    await this.asOwn(() => stage.replay(of.model, of.frames));
    this.begin();
    stage.show(of.at);
  }

  /** What is begun meanwhile is no other molecule. */
  async asOwn(action) {
    this.isOwn = true;
    try {
      await action();
    } finally {
      this.isOwn = false;
      this.refresh();
    }
  }
}
