// SPDX-License-Identifier: MIT
// The order in which a sweep visits the bars (the thesis' constraint file): of a file, or of a technique;
// shown bar after bar, and saved.
import {$, element, guarded, say, units, whenChosen} from './dom.mjs';
import {download} from './transport.mjs';

const MOST_ROWS = 2000;

export class Order {
  constructor(session, stage, view) {
    Object.assign(this, {session, stage, view});
    this.visits = null;
    whenChosen('order-file', (name, bytes) => this.open(name, bytes));
    $('order-of').onclick = () => guarded(() => this.ofTechnique());
    $('order-save').onclick = () => guarded(() => this.save());
    $('order-at').oninput = () => this.light(Number($('order-at').value));
    stage.on('began', () => this.clear());
    session.on('step', () => this.visits && this.light(0));
  }

  /** From now on technique `input` visits the bars by the file. */
  async open(name, bytes) {
    const {session} = this;
    if (!session.source || this.stage.isReplay)
      throw new Error(`${name} is an ordering file: open its molecule or graph first.`);
    const reply = await session.ask('ordering_file', {name, bytes});
    session.settings = reply.settings;
    session.tell('settings', reply.settings);
    $('order-panel').open = true;
    this.list(reply.visits, `${name}: technique input visits ${units(reply.visits.length / 4, 'bar')} in this order.`);
    if (session.model.unfit.input) say(session.model.unfit.input.why, true);
  }

  /** Its first sweep, from the joint that was pushed last, or the first. */
  async ofTechnique() {
    const {session, stage} = this;
    const {technique} = session.settings;
    const row = session.facts.techniques.find(({name}) => name === technique);
    if (!row.watched) throw new Error(`${technique} has no order of bars: the orderings (bfs_cycle and its kin) have.`);
    const root = Math.max(0, stage.last?.root ?? 0);
    const reply = await session.ask('ordering', {technique, root});
    this.text = reply.text;
    this.list(reply.visits, `The first sweep of ${technique} from ${session.model.nameOf(root)}: ${units(reply.visits.length / 4, 'bar')}.`);
  }

  list(visits, title) {
    this.visits = visits;
    const {model} = this.session;
    const count = visits.length / 4;
    const rows = Array.from({length: Math.min(count, MOST_ROWS)}, (_, k) => {
      const [, near, far, isTree] = visits.subarray(4 * k, 4 * k + 4);
      return element('li', `${model.nameOf(near)} → ${model.nameOf(far)}${isTree ? '' : ' (closes a cycle)'}`);
    });
    $('order-list').replaceChildren(...rows);
    $('order-state').textContent = title;
    $('order-at').max = count;
    $('order-at').disabled = !count;
    $('order-save').disabled = !this.text;
    this.light(0);
  }

  /** The bar of a visit, from 1; 0: none. */
  light(number) {
    $('order-at').value = number;
    for (const row of $('order-list').querySelectorAll('[aria-current]')) row.removeAttribute('aria-current');
    if (!number) return this.view.setLit({bar: -1, near: -1, far: -1});
    const [bar, near, far] = this.visits.subarray(4 * number - 4, 4 * number - 1);
    this.view.setLit({bar, near, far});
    const row = $('order-list').children[number - 1];
    row?.setAttribute('aria-current', 'step');
    if (row) row.parentElement.scrollTop = row.offsetTop - row.parentElement.offsetTop - 40;
    $('said').textContent = `visit ${number}: ${this.session.model.barName(bar)}`;
    return undefined;
  }

  save() {
    const stem = (this.session.fileName || 'pliant').replace(/\.[a-z0-9]+$/i, '');
    download([this.text], `${stem}.ordering.txt`, 'text/plain');
  }

  clear() {
    this.visits = this.text = null;
    $('order-list').replaceChildren();
    $('order-state').textContent = 'The thesis’ constraint file: which bar a sweep visits first, second, … Drop an ordering file, or choose one.';
    $('order-at').disabled = $('order-save').disabled = true;
  }
}
