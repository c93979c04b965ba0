// SPDX-License-Identifier: MIT
// What holds, to be changed: a contact, a bar or two joints that were clicked, and the list of all
// that was cut and added, each to be taken back.
import {$, element, guarded} from './dom.mjs';

export class Constraints {
  constructor({view, session, stage}) {
    Object.assign(this, {view, session, stage});
    this.picked = [];
    session.on('clicked', (met) => guarded(() => this.clicked(met)));
    session.on('edited', (model) => this.list(model.changes ?? []));
    stage.on('began', () => this.begin());
    stage.on('edited', () => guarded(() => this.look()));
    $('constraints-add').onclick = () => guarded(() => this.act('bar'));
    $('constraints-hold').onclick = () => guarded(() => this.hold());
    $('constraints-cut').onclick = () => guarded(() => this.act('cut'));
    $('constraints-turn').onclick = () => guarded(() => this.act('turn'));
    $('constraints-restore').onclick = () => guarded(() => this.act('restore'));
  }

  begin() {
    this.picked = [];
    this.list([]);
    this.tell(null);
  }

  /** Two joints one after the other, or the two ends of a contact or a bar. */
  clicked({joint, bar, contact}) {
    const {model} = this.session;
    if (this.stage.isReplay || this.session.live) return undefined;
    if (joint !== undefined) return this.pick(joint);
    const [list, k] = contact === undefined ? [model.bars, bar] : [model.contacts, contact];
    this.picked = [list[2 * k], list[2 * k + 1]];
    $('constraints-panel').open = true;
    return this.look();
  }

  pick(joint) {
    this.picked = [...this.picked.filter((other) => other !== joint), joint].slice(-2);
    return this.look();
  }

  async look() {
    const [a, b] = this.picked;
    this.view.setLit({near: a ?? -1, far: b ?? -1});
    if (b === undefined) return this.tell(null);
    this.tell(await this.session.ask('pair', {a, b}));
    return undefined;
  }

  /** What may be done with the two joints. */
  tell(pair) {
    const [a] = this.picked;
    const first = a === undefined ? 'Click a dashed contact, or two joints one after the other.' : `${this.session.model.nameOf(a)}: click a second joint.`;
    $('constraints-pair').textContent = pair ? `${pair.text}: ${pair.distance.toFixed(2)} Å${pair.joined ? '' : ', nothing joins them'}` : first;
    if (pair) $('constraints-length').value = pair.distance.toFixed(2);
    const may = {
      add: pair && !pair.joined, hold: Boolean(pair), cut: pair?.joined, turn: pair?.mayTurn, restore: pair?.isEdited,
    };
    for (const [name, isOn] of Object.entries(may)) $(`constraints-${name}`).disabled = !isOn;
    $('constraints-length').disabled = !pair;
    $('constraints-cut').textContent = pair?.joined === 'angle' ? 'Free the angle' : 'Cut';
  }

  act(word, ...more) {
    return this.session.edit([[word, ...this.picked, ...more]]);
  }

  hold() {
    const length = Number($('constraints-length').value);
    if (!(length > 0)) throw new Error('The length of a bar: a number of Å above 0.');
    return this.act('bar', length);
  }

  list(changes) {
    $('constraints-none').hidden = changes.length > 0;
    $('constraints-list').replaceChildren(...changes.map((change) => this.row(change)));
  }

  row({a, b, text}) {
    const row = element('li');
    const button = element('button', 'Take back', {type: 'button', 'aria-label': `Take back: ${text}`});
    button.onclick = () => guarded(() => this.session.edit([['restore', a, b]]));
    row.append(element('span', text), button);
    return row;
  }
}
