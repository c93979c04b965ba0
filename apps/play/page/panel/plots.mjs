// SPDX-License-Identifier: MIT
// Small plots beside the picture, drawn as the numbers come in.
import {$, element, shortNumber} from './dom.mjs';

const MOST_POINTS = 600;
const EVERY = 90;  // ms between two drawings

const PLOTS = [
  {id: 'residual', title: 'Worst residual', log: true, of: (row) => row.residual},
  {id: 'sweeps', title: 'Sweeps a step', of: (row) => row.sweeps},
  {id: 'rmsd', title: 'RMSD from start, Å', of: (row) => row.rmsd},
  {id: 'rmsf', title: 'RMSF, Å', bars: true},
];

function build({id, title}) {
  const figure = element('figure');
  const caption = element('figcaption');
  const value = element('b', '', {id: `plot-${id}-value`});
  const canvas = element('canvas', '', {id: `plot-${id}`, role: 'img', 'aria-label': title});
  caption.append(element('span', title, {title}), value);
  figure.append(caption, canvas);
  return {figure, canvas, value};
}

/** Of many points the largest of each stretch, so that no peak is lost. */
function thinned(values) {
  if (values.length <= MOST_POINTS) return values;
  const share = values.length / MOST_POINTS;
  return Array.from({length: MOST_POINTS}, (_, k) =>
    Math.max(...values.slice(Math.floor(k * share), Math.max(Math.floor((k + 1) * share), Math.floor(k * share) + 1))));
}

function prepared(canvas) {
  const ratio = Math.min((devicePixelRatio || 1) * (canvas.currentCSSZoom ?? 1), 3);
  const [width, height] = [canvas.clientWidth, canvas.clientHeight];
  if (canvas.width !== Math.round(width * ratio)) canvas.width = Math.round(width * ratio);
  if (canvas.height !== Math.round(height * ratio)) canvas.height = Math.round(height * ratio);
  const pen = canvas.getContext('2d');
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  return {pen, width, height};
}

function range(values, log) {
  const shown = values.filter(Number.isFinite);
  if (!shown.length) return [0, 1];
  const most = Math.max(...shown);
  if (log) return [Math.floor(Math.min(...shown)), Math.max(Math.ceil(most), Math.floor(Math.min(...shown)) + 1)];
  return [0, most > 0 ? most * 1.08 : 1];
}

const LEFT = 42;

function axes(pen, [low, high], {width, height}, log, colours) {
  pen.font = '10px system-ui, sans-serif';
  pen.fillStyle = colours.soft;
  pen.strokeStyle = colours.line;
  pen.textAlign = 'right';
  for (const share of [0, 1]) {
    const y = height - 5 - share * (height - 12);
    pen.beginPath();
    pen.moveTo(LEFT, y + 0.5);
    pen.lineTo(width, y + 0.5);
    pen.stroke();
    const value = low + share * (high - low);
    pen.fillText(log ? `1e${value}` : shortNumber(value), LEFT - 5, y + 3);
  }
}

function drawLine(pen, values, scale, colour) {
  pen.strokeStyle = colour;
  pen.lineWidth = 1.4;
  pen.beginPath();
  let isDown = false;
  values.forEach((value, k) => {
    if (!Number.isFinite(value)) return;
    const [x, y] = scale(k, value);
    if (isDown) pen.lineTo(x, y);
    else pen.moveTo(x, y);
    isDown = true;
  });
  pen.stroke();
}

function drawColumns(pen, values, scale, width, colour) {
  const step = (width - LEFT) / values.length;
  pen.fillStyle = colour;
  values.forEach((value, k) => {
    const [, y] = scale(k, value);
    const [, floor] = scale(k, 0);
    pen.fillRect(LEFT + k * step, y, Math.max(1, step - (step > 4 ? 1 : 0)), floor - y);
  });
}

function draw(canvas, values, {log, bars}, mark) {
  const {pen, width, height} = prepared(canvas);
  if (width < 50) return;
  const style = getComputedStyle(document.documentElement);
  const colours = {
    soft: style.getPropertyValue('--soft'), line: style.getPropertyValue('--line'),
    ink: style.getPropertyValue('--plot'),
  };
  if (!values.some(Number.isFinite)) return;
  const shown = thinned(log ? values.map((value) => Math.log10(value || NaN)) : values);
  const [low, high] = range(shown, log);
  axes(pen, [low, high], {width, height}, log, colours);
  const wide = (width - LEFT - 2) / Math.max(1, shown.length - 1);
  const scale = (k, value) => [LEFT + 1 + k * wide, height - 5 - (value - low) / (high - low) * (height - 12)];
  if (bars) drawColumns(pen, shown, scale, width, colours.ink);
  else drawLine(pen, shown, scale, colours.ink);
  if (mark === null) return;
  pen.fillStyle = colours.soft;
  pen.fillRect(LEFT + mark * (width - LEFT - 2), 2, 1, height - 7);
}

export class Plots {
  constructor(stage) {
    this.stage = stage;
    this.parts = PLOTS.map((plot) => ({...plot, ...build(plot)}));
    $('plots').append(...this.parts.map((part) => part.figure));
    this.drawn = 0;
    this.isStale = true;
    stage.on('changed', () => { this.isStale = true; });
    addEventListener('resize', () => { this.isStale = true; });
  }

  tick(now) {
    if (!this.isStale || now - this.drawn < EVERY || !this.stage.model) return;
    this.drawn = now;
    this.isStale = false;
    for (const part of this.parts) this.drawPart(part);
  }

  valuesOf(part) {
    if (!this.stage.history.length) return [];
    return part.bars ? this.stage.rmsf() : this.stage.history.map(part.of);
  }

  drawPart(part) {
    if (part.bars) part.figure.hidden = this.stage.sites.length < 3;
    if (part.figure.hidden) return;
    const values = this.valuesOf(part);
    const {at, frames} = this.stage;
    const mark = part.bars || at === null || frames.length < 2 ? null : at / (frames.length - 1);
    draw(part.canvas, values, part, mark);
    const last = part.bars ? values.reduce((a, b) => Math.max(a, b), 0) : values.at(-1);
    const text = values.length ? shortNumber(last) : '';
    part.value.textContent = part.bars && text ? `max ${text}` : text;
    part.canvas.setAttribute('aria-label', `${part.title}: ${part.value.textContent || 'nothing yet'}`);
  }
}
