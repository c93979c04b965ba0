// SPDX-License-Identifier: MIT
// How it is drawn: style, colours, background, dark and light.
import {$, element, fillSelect} from './dom.mjs';
import {showLegend} from './legend.mjs';
import {COLOURINGS} from '../view/colours.mjs';
import {STYLES, needsTrace} from '../view/styles.mjs';

const GROUNDS = {light: '#f7f9fb', dark: '#10161c'};

export class Look {
  constructor(view, stage) {
    Object.assign(this, {view, stage});
    this.ownGround = false;
    fillSelect($('style'), Object.entries(STYLES).map(([name, {title}]) => ({name, title})), 'balls');
    fillSelect($('colouring'), COLOURINGS, 'element');
    $('style').onchange = () => this.setStyle(this.ownStyle = $('style').value);
    $('colouring').onchange = () => this.setColouring(this.ownColouring = $('colouring').value);
    $('background').oninput = () => this.setGround($('background').value);
    $('background-reset').onclick = () => this.resetGround();
    $('show-contacts').onchange = () => this.toggles();
    $('show-bars').onchange = () => this.toggles();
    $('show-strain').onchange = () => { stage.showStrain = $('show-strain').checked; };
    $('theme').onclick = () => this.setTheme(this.theme === 'dark' ? 'light' : 'dark');
    stage.on('began', (model) => this.began(model));
    this.setTheme(matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light');
    this.legend();
  }

  /** The trace of a protein is offered where there is one; large ones begin with it. */
  began(model) {
    this.model = model;
    const hasTrace = model.trace.length > 2;
    for (const option of $('style').options) option.disabled = needsTrace(option.value) && !hasTrace;
    this.chooseStyle(model, hasTrace);
    const hasClusters = model.cluster.some((number) => number >= 0);
    this.allow('chain', new Set(model.chain).size > 1);
    this.allow('cluster', hasClusters);
    this.allow('domain', Boolean(model.domain));
    this.allow('secondary', /[HE-]/.test(model.secondary ?? ''));
    this.allow('contacts', model.contacts.length > 0);
    this.chooseColouring(model);
    this.legend();
  }

  /** A cartoon where there is more than its line, unless a person has chosen another style. */
  chooseStyle({joints, trace}, hasTrace) {
    const hasMore = hasTrace && joints > 2 * trace.length;
    const usual = hasMore ? 'cartoon' : 'balls';
    const wanted = this.ownStyle ?? usual;
    const style = needsTrace(wanted) && !hasTrace ? 'balls' : wanted;
    if (style !== this.view.style) this.setStyle(style);
  }

  /** A cartoon tells helices from strands, or chains apart; the rest is told by element. */
  chooseColouring(model) {
    if (this.ownColouring) return;
    const isSeveral = new Set(model.chain).size > 1;
    const usual = !STYLES[this.view.style].ribbon ? 'element' : isSeveral ? 'chain' : 'secondary';
    const isAllowed = ![...$('colouring').options].find(({value}) => value === usual).disabled;
    this.setColouring(isAllowed ? usual : 'element');
  }

  /** A colouring that has nothing to tell of this model cannot be chosen. */
  allow(name, isMeant) {
    [...$('colouring').options].find((option) => option.value === name).disabled = !isMeant;
    if (!isMeant && this.stage.colouring === name) this.setColouring('element');
  }

  setStyle(name) {
    $('style').value = name;
    this.view.setStyle(name);
    this.stage.look();
  }

  setColouring(name) {
    $('colouring').value = name;
    this.stage.colouring = name;
    this.stage.look();
    this.legend();
  }

  toggles() {
    this.view.showContacts = $('show-contacts').checked;
    this.view.showAllBars = $('show-bars').checked;
    this.view.setStyle(this.view.style);
  }

  setTheme(theme) {
    this.theme = theme;
    document.documentElement.dataset.theme = theme;
    if (!this.ownGround) this.paintGround(GROUNDS[theme]);
    dispatchEvent(new Event('resize'));
  }

  setGround(colour) {
    this.ownGround = true;
    this.paintGround(colour);
  }

  resetGround() {
    this.ownGround = false;
    this.paintGround(GROUNDS[this.theme]);
  }

  paintGround(colour) {
    $('background').value = colour;
    this.view.setBackground(colour);
  }

  legend() {
    showLegend(this.stage.colouring, this.model);
  }
}

/** A table of keys for the help. */
export function helpRow(keys, meaning) {
  const row = element('tr');
  const cell = element('td');
  keys.forEach((key) => cell.append(element('kbd', key), ' '));
  row.append(cell, element('td', meaning));
  return row;
}
