// SPDX-License-Identifier: MIT
// What the shaders of the picture are told: {name: {value}}.
import {WIDTH} from './textures.mjs';

export const rgb = (text) => [1, 3, 5].map((k) => parseInt(text.slice(k, k + 2), 16) / 255);

export const COLOURS = {
  hoverColour: '#ffd23f', nearColour: '#56b4e9', farColour: '#e69f00', pinColour: '#222831',
  waveColour: '#56b4e9', longColour: '#e0201b', shortColour: '#c2185b', litColour: '#ffd23f',
};

export function uniformsOf() {
  const values = {
    positions: null, look: null, marks: null, bars: null, controls: null, strain: null, limits: null, firstContact: 0, byTautness: 0,
    width: WIDTH, joints: 1, barCount: 1, pieceCount: 1, ballScale: 0.24, unit: 1,
    stickRadius: 0.13, traceRadius: 0.5, litBar: -1, picking: 0, rich: 1, unlit: 0,
    kindRadius: [1, 0, 0.45, 0], others: [0.5, 0.5, 0.5, 0.35], lit: [-1, -1, -1], background: [1, 1, 1], fog: [10, 100],
    viewMatrix: null, projectionMatrix: null,
  };
  for (const [name, text] of Object.entries(COLOURS)) values[name] = rgb(text);
  return Object.fromEntries(Object.entries(values).map(([name, value]) => [name, {value}]));
}
