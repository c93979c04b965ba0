// SPDX-License-Identifier: MIT
// The chart below the 3-D view: a quantity along the run, the current frame, click to go there.
"use strict";
window.pliantTimeline = (function () {
  const canvas = document.getElementById("chart");
  const margin = { left: 58, right: 10, top: 10, bottom: 8 };
  let ink, faint, line, red, dark;
  let scene = null;

  function size() {
    const scale = window.devicePixelRatio || 1;
    const box = canvas.getBoundingClientRect();
    canvas.width = Math.max(1, Math.round(box.width * scale));
    canvas.height = Math.max(1, Math.round(box.height * scale));
    const context = canvas.getContext("2d");
    context.setTransform(scale, 0, 0, scale, 0, 0);
    return [context, box.width, box.height];
  }

  // Lowest and highest value shown, in the axis' own measure (logarithm or value).
  function range(series) {
    const measure = series.log ? Math.log10 : (value) => value;
    const values = series.values.concat(series.limit ? [series.limit] : []).map(measure);
    let low = Math.min(...values), high = Math.max(...values);
    // The start of a run is exact to the last bit: it would squeeze all the rest.
    if (series.log) [low, high] = [Math.max(low, high - 6) - 0.3, high + 0.3];
    else if (low >= 0 && low < 0.5 * high) low = 0;
    if (high - low < 1e-12) [low, high] = [low - 1, high + 1];
    return [measure, low, high];
  }

  const text = (series, value) => {
    const shown = series.log ? `10${superscript(value)}` : String(Number(value.toPrecision(3)));
    return series.unit ? `${shown} ${series.unit}` : shown;
  };
  const superscript = (value) =>
    Math.round(value).toString().replace(/[-0-9]/g, (c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c]));

  const along = (k, width) =>
    margin.left + (width - margin.left - margin.right) * (scene.frames.length > 1 ? k / (scene.frames.length - 1) : 0.5);

  function curve(context, series, width, up) {
    context.strokeStyle = line;
    context.lineWidth = 1.4;
    context.lineJoin = "round";
    context.beginPath();
    series.values.forEach((value, k) => context[k ? "lineTo" : "moveTo"](along(k, width), up(value)));
    context.stroke();
    context.fillStyle = red;
    for (const k of series.marked || []) dot(context, along(k, width), up(series.values[k]), 3);
  }

  function dot(context, x, y, radius) {
    context.beginPath();
    context.arc(x, y, radius, 0, 7);
    context.fill();
  }

  function axis(context, series, width, low, high, up) {
    context.font = "11.5px system-ui, sans-serif";
    context.textAlign = "right";
    context.textBaseline = "middle";
    const ends = series.log ? [Math.ceil(low), Math.floor(high)] : [low, high];
    for (const value of new Set(ends)) {
      const y = up(series.log ? 10 ** value : value);
      context.fillStyle = ink;
      context.fillText(text(series, value), margin.left - 8, y);
      context.fillStyle = faint;
      context.fillRect(margin.left, y - 0.5, width - margin.left - margin.right, 1);
    }
    if (!series.limit) return;
    context.strokeStyle = dark;
    context.lineWidth = 1;
    context.setLineDash([5, 4]);
    context.beginPath();
    context.moveTo(margin.left, up(series.limit));
    context.lineTo(width - margin.right, up(series.limit));
    context.stroke();
    context.setLineDash([]);
  }

  function draw(state) {
    const series = scene && scene.series[state.series];
    if (!series) return;
    const style = getComputedStyle(document.documentElement);
    [ink, faint, line, red, dark] = ["soft", "line", "blue", "red", "ink"].map((name) =>
      style.getPropertyValue(`--${name}`).trim());
    const [context, width, height] = size();
    const [measure, low, high] = range(series);
    const up = (value) => {
      const share = Math.max(0, (measure(value) - low) / (high - low));
      return height - margin.bottom - share * (height - margin.top - margin.bottom);
    };
    context.clearRect(0, 0, width, height);
    axis(context, series, width, low, high, up);
    curve(context, series, width, up);
    const x = along(state.frame, width);
    context.fillStyle = dark;
    context.fillRect(x - 0.75, margin.top - 6, 1.5, height - margin.top - margin.bottom + 10);
    dot(context, x, up(series.values[state.frame]), 4.5);
  }

  function onSeek(seek) {
    let held = false;
    const go = (event) => {
      const box = canvas.getBoundingClientRect();
      const share = (event.clientX - box.left - margin.left) / (box.width - margin.left - margin.right);
      seek(Math.round(share * (scene.frames.length - 1)));
    };
    canvas.addEventListener("pointerdown", (event) => { held = true; canvas.setPointerCapture(event.pointerId); go(event); });
    canvas.addEventListener("pointermove", (event) => { if (held) go(event); });
    canvas.addEventListener("pointerup", () => { held = false; });
  }

  return { start(given) { scene = given; }, draw, onSeek };
})();
