// SPDX-License-Identifier: MIT
// The last push again, with other techniques, counted and side by side.
import {$, element, fillSelect, guarded, shortNumber} from './dom.mjs';

const SKIPPED = new Set(['auto']);

export class Compare {
  constructor(stage, session, view) {
    Object.assign(this, {stage, session, view});
    this.rows = [];
    $('compare').onclick = () => guarded(() => this.repeat($('other').value));
    $('compare-all').onclick = () => guarded(() => this.repeatAll());
    $('split').onchange = () => this.split($('split').checked);
    session.on('step', () => this.clear());
    stage.on('began', () => this.clear());
    stage.on('changed', () => view.split && this.follow());
  }

  fill(facts) {
    this.techniques = facts.techniques;
    fillSelect($('other'), facts.techniques.map(({name}) => ({name})), 'bfs_cycle');
  }

  clear() {
    this.rows = [];
    this.split(false);
    $('split').disabled = true;
    $('compared').tBodies[0].replaceChildren();
  }

  own() {
    const {settings} = this.session;
    const {last} = this.stage;
    if (!last) throw new Error('Push something first: then the same push can be repeated.');
    return {...last, technique: settings.technique, weighting: settings.weighting, isOwn: true};
  }

  async repeat(technique) {
    const own = this.own();
    const weighting = Number($('other-weighting').value);
    const reply = await this.session.compare(technique, weighting);
    if (!this.rows.length) this.rows.push(own);
    this.rows.push({...reply, technique, weighting});
    this.other = reply;
    this.otherName = technique;
    this.show();
    this.split(true);
  }

  async repeatAll() {
    const own = this.own();
    const weighting = Number($('other-weighting').value);
    this.rows = [own];
    for (const {name} of this.techniques)
      if (!SKIPPED.has(name)) this.rows.push(await this.tried(name, weighting));
    this.show();
  }

  /** What a technique cannot do (a tree's alone on a graph with cycles) is said in its row. */
  async tried(technique, weighting) {
    try {
      return {...await this.session.compare(technique, weighting), technique, weighting};
    } catch (error) {
      return {technique, why: error.message};
    }
  }

  show() {
    const whole = this.rows.filter((row) => !row.why && row.converged !== false);
    const fewest = Math.min(...whole.map((row) => row.projections));
    $('compared').tBodies[0].replaceChildren(...this.rows.map((row) => this.line(row, fewest)));
    $('split').disabled = !this.other;
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

  split(isOn) {
    const {view} = this;
    const wanted = Boolean(isOn && this.other);
    if (wanted === view.split) return;
    $('split').checked = wanted;
    $('panes').hidden = !wanted;
    view.split = false;
    view.allocate(wanted ? 2 : 1);
    view.split = wanted;
    this.stage.look();
    this.stage.mark();
    this.follow();
    if (wanted) this.label();
    view.fit();
  }

  label() {
    const own = this.own();
    $('pane-left').textContent = `${own.technique}: ${own.sweeps} sweeps`;
    $('pane-right').textContent = `${this.otherName}: ${this.other.sweeps} sweeps`;
    if (!this.view.textures) return;
    this.view.setPositions(this.other.positions, 1);
  }

  /** What is shown goes to the first walker: the left pane. */
  follow() {
    if (!this.stage.model) return;
    const {stage, view} = this;
    const frame = stage.at === null ? stage.session.positions : stage.frames.at(stage.at).positions;
    if (frame) view.setPositions(frame, 0);
  }
}
