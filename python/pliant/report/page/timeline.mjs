// SPDX-License-Identifier: MIT
// The chart below the 3-D view: a quantity along the run, the current frame, click to go there.

const MARGIN = {left: 58, right: 10, top: 10, bottom: 8};  // CSS pixels
const DIGITS = '⁰¹²³⁴⁵⁶⁷⁸⁹';

const superscript = (value) => String(Math.round(value)).replace(/[-0-9]/g, (c) => (c === '-' ? '⁻' : DIGITS[c]));

function textOf(series, value) {
  const shown = series.log ? `10${superscript(value)}` : String(Number(value.toPrecision(3)));
  return series.unit ? `${shown} ${series.unit}` : shown;
}

/** How a value is measured (logarithm or value), the lowest and the highest that is shown. */
function rangeOf(series) {
  const measure = series.log ? Math.log10 : (value) => value;
  const values = series.values.concat(series.limit ? [series.limit] : []).map(measure);
  let [low, high] = [Math.min(...values), Math.max(...values)];
  // The start of a run is exact to the last bit: it would squeeze all the rest.
  if (series.log) [low, high] = [Math.max(low, high - 6) - 0.3, high + 0.3];
  else if (low >= 0 && low < 0.5 * high) low = 0;
  if (high - low < 1e-12) [low, high] = [low - 1, high + 1];
  return [measure, low, high];
}

export class Timeline {
  /** `seek`: told the frame that was clicked. */
  constructor(canvas, scene, seek) {
    Object.assign(this, {canvas, scene, seek});
    let held = false;
    canvas.addEventListener('pointerdown', (event) => {
      held = true;
      canvas.setPointerCapture(event.pointerId);
      this.go(event);
    });
    canvas.addEventListener('pointermove', (event) => { if (held) this.go(event); });
    canvas.addEventListener('pointerup', () => { held = false; });
  }

  go(event) {
    const box = this.canvas.getBoundingClientRect();
    const share = (event.clientX - box.left - MARGIN.left) / (box.width - MARGIN.left - MARGIN.right);
    this.seek(Math.round(share * (this.scene.frames.length - 1)));
  }

  draw(name, frame) {
    this.series = this.scene.series[name];
    if (!this.series) return;
    const style = getComputedStyle(document.documentElement);
    this.colours = Object.fromEntries(['soft', 'line', 'blue', 'red', 'ink'].map((word) =>
      [word, style.getPropertyValue(`--${word}`).trim()]));
    this.room();
    this.curve();
    this.axis();
    const x = this.along(frame);
    this.pen.fillStyle = this.colours.ink;
    this.pen.fillRect(x - 0.75, MARGIN.top - 6, 1.5, this.height - MARGIN.top - MARGIN.bottom + 10);
    this.dot(x, this.up(this.series.values[frame]), 4.5);
  }

  /** Sharp on any screen, and empty. */
  room() {
    const ratio = devicePixelRatio || 1;
    const box = this.canvas.getBoundingClientRect();
    Object.assign(this, {width: box.width, height: box.height, range: rangeOf(this.series)});
    this.canvas.width = Math.max(1, Math.round(box.width * ratio));
    this.canvas.height = Math.max(1, Math.round(box.height * ratio));
    this.pen = this.canvas.getContext('2d');
    this.pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  }

  along(frame) {
    const last = this.scene.frames.length - 1;
    return MARGIN.left + (this.width - MARGIN.left - MARGIN.right) * (last ? frame / last : 0.5);
  }

  up(value) {
    const [measure, low, high] = this.range;
    const share = Math.max(0, (measure(value) - low) / (high - low));
    return this.height - MARGIN.bottom - share * (this.height - MARGIN.top - MARGIN.bottom);
  }

  curve() {
    const {pen, series, colours} = this;
    Object.assign(pen, {strokeStyle: colours.blue, lineWidth: 1.4, lineJoin: 'round'});
    pen.beginPath();
    series.values.forEach((value, k) => pen[k ? 'lineTo' : 'moveTo'](this.along(k), this.up(value)));
    pen.stroke();
    pen.fillStyle = colours.red;
    for (const k of series.marked ?? []) this.dot(this.along(k), this.up(series.values[k]), 3);
  }

  dot(x, y, radius) {
    this.pen.beginPath();
    this.pen.arc(x, y, radius, 0, 7);
    this.pen.fill();
  }

  axis() {
    const {pen, series, colours, range: [, low, high]} = this;
    Object.assign(pen, {font: '11.5px system-ui, sans-serif', textAlign: 'right', textBaseline: 'middle'});
    const ends = series.log ? [Math.ceil(low), Math.floor(high)] : [low, high];
    const wide = this.width - MARGIN.left - MARGIN.right;
    for (const value of new Set(ends)) {
      const y = this.up(series.log ? 10 ** value : value);
      pen.fillStyle = colours.soft;
      pen.fillText(textOf(series, value), MARGIN.left - 8, y);
      pen.fillStyle = colours.line;
      pen.fillRect(MARGIN.left, y - 0.5, wide, 1);
    }
    if (!series.limit) return;
    Object.assign(pen, {strokeStyle: colours.ink, lineWidth: 1});
    pen.setLineDash([5, 4]);
    pen.beginPath();
    pen.moveTo(MARGIN.left, this.up(series.limit));
    pen.lineTo(MARGIN.left + wide, this.up(series.limit));
    pen.stroke();
    pen.setLineDash([]);
  }
}
