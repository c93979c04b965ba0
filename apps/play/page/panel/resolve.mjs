// SPDX-License-Identifier: MIT
// Technique, weighting, tolerance, sweeps, timestep, model: at once in force.
import {$, fillSelect, guarded, say} from './dom.mjs';

const FIELDS = [
  ['technique', 'technique', String], ['weighting', 'weighting', Number],
  ['tolerance', 'tolerance', Number], ['max-sweeps', 'max_sweeps', Number],
  ['timestep', 'timestep', Number],
];
const MODELS = {
  auto: 'What the file is', bonds: 'Bonds', angles: 'Bonds and angles', molecule: 'Molecule',
  protein: 'Protein',
};

const asText = (value) => (typeof value === 'number' && value && Math.abs(value) < 1e-3
  ? value.toExponential().replace('e-', 'e-') : String(value));

export class Resolve {
  constructor(session, stage) {
    this.session = session;
    this.techniques = [];
    for (const [id, field, read] of FIELDS)
      $(id).onchange = () => this.change(id, field, read);
    $('model').onchange = () => this.reopen();
    session.on('settings', () => this.show());
    stage.on('began', (model) => this.began(model, stage.isReplay));
  }

  fill(facts) {
    this.techniques = facts.techniques;
    fillSelect($('technique'), facts.techniques.map(({name}) => ({name})));
    const models = (facts.models ?? Object.keys(MODELS)).map((row) => row.name ?? row);
    const names = models.includes('auto') ? models : ['auto', ...models];
    fillSelect($('model'), names.map((name) => ({name, title: MODELS[name] ?? name})));
  }

  /** Techniques that refuse what is open, or are known not to arrive on it, cannot be chosen, and say why.
   * Of a graph that is not known: there they are tried, and the clock stops them. */
  judge(unfit = {}, isGraph = false) {
    this.unfit = unfit;
    for (const id of ['technique', 'other'])
      for (const option of $(id).options) {
        const found = unfit[option.value];
        option.disabled = Boolean(found?.refused || (found && !isGraph));
        option.title = found?.why ?? '';
        option.textContent = option.disabled ? `${option.value}: ${this.reason(option.value, found)}` : option.value;
      }
  }

  /** In few words why it is grey; the whole reason is the option's title. */
  reason(technique, {refused}) {
    const row = this.techniques.find(({name}) => name === technique);
    if (!refused) return 'stuck on rigid angles';
    return row?.forestsOnly ? 'for trees alone' : 'knows no limits';
  }

  began(model, isReplay) {
    this.judge(model.unfit, model.kind === 'graph');
    for (const [id] of FIELDS) $(id).disabled = isReplay;
    $('model').disabled = isReplay || model.kind === 'graph';
    $('model').value = this.session.source?.model ?? 'auto';
    const held = model.model && model.kind !== 'graph' ? `Held by: ${MODELS[model.model] ?? model.model}. ` : '';
    $('model-note').textContent = model.kind === 'graph' ? 'A graph is held by its bars.'
      : `${held}Another model begins again.`;
  }

  async change(id, field, read) {
    const value = read($(id).value);
    if (Number.isNaN(value)) {
      say(`${field}: expected a number, found "${$(id).value}"`);
      return this.show();
    }
    try {
      await this.session.change({[field]: value});
      say('');
    } catch (error) {
      say(error.message);
      this.show();
    }
    return undefined;
  }

  show() {
    const {settings} = this.session;
    for (const [id, field] of FIELDS)
      if (settings[field] !== undefined) $(id).value = asText(settings[field]);
    const row = this.techniques.find(({name}) => name === settings.technique);
    const unfit = this.unfit?.[settings.technique];
    $('technique-title').textContent = unfit?.why ?? row?.title ?? '';
    $('weighting').disabled = row?.weightings === false;
  }

  reopen() {
    if (!this.session.source) return undefined;
    return guarded(() => this.session.again($('model').value));
  }
}
