// SPDX-License-Identifier: MIT
// The last push again, with other techniques, counted.
import {$, element, fillSelect, guarded, shortNumber} from './dom.mjs';

const SKIPPED = new Set(['auto']);

export class Compare {
  constructor(stage, session, view) {
    Object.assign(this, {stage, session, view});
    this.rows = [];
    $('compare').onclick = () => guarded(() => this.repeat($('other').value));
    $('compare-all').onclick = () => guarded(() => this.repeatAll());
    session.on('step', () => this.clear());
    stage.on('began', () => this.clear());
  }

  fill(facts) {
    this.techniques = facts.techniques;
    fillSelect($('other'), facts.techniques.map(({name}) => ({name})), 'bfs_cycle');
  }

  clear() {
    this.rows = [];
    $('compared').tBodies[0].replaceChildren();
  }

  get weighting() {
    return Number($('other-weighting').value);
  }

  own() {
    const {last} = this.stage;
    if (!last) throw new Error('Push something first: then the same push can be repeated.');
    return {...last, technique: this.session.settings.technique, isOwn: true};
  }

  async repeat(technique) {
    const own = this.own();
    const row = {...await this.session.compare(technique, this.weighting), technique};
    if (!this.rows.length) this.rows.push(own);
    this.rows.push(row);
    this.show();
  }

  async repeatAll() {
    const own = this.own();
    this.rows = [own];
    for (const {name} of this.techniques)
      if (!SKIPPED.has(name)) this.rows.push(await this.tried(name));
    this.show();
  }

  /** What a technique cannot do (a tree's alone on a graph with cycles) is said in its row. */
  async tried(technique) {
    try {
      return {...await this.session.compare(technique, this.weighting), technique};
    } catch (error) {
      return {technique, why: error.message};
    }
  }

  show() {
    const whole = this.rows.filter((row) => !row.why && row.converged !== false);
    const fewest = Math.min(...whole.map((row) => row.projections));
    $('compared').tBodies[0].replaceChildren(...this.rows.map((row) => this.line(row, fewest)));
  }

  line(row, fewest) {
    const line = element('tr');
    line.append(element('td', row.technique + (row.isOwn ? ' (done)' : '')));
    if (row.why) {
      line.append(element('td', 'cannot', {colspan: 3, title: row.why}));
      return line;
    }
    const worst = row.converged === false ? 'not whole' : shortNumber(row.residual);
    for (const value of [row.sweeps, row.projections?.toLocaleString('en'), worst])
      line.append(element('td', String(value ?? '–')));
    line.classList.toggle('best', row.projections === fewest);
    return line;
  }
}
