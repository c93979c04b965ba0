// SPDX-License-Identifier: MIT
// Pictures of what is shown at any size, their ground left out if wanted: drawn once on black and
// once on white, since what differs is ground. So it holds for whatever way the view draws.
import {$} from '../panel/dom.mjs';

/** Draws at another size, and then as before; `action` gets the size. */
export async function atSize(view, width, action) {
  const {clientWidth, clientHeight} = $('stage');
  const height = Math.round(width * clientHeight / clientWidth / 2) * 2;
  try {
    view.resize(width, height, 1);
    return await action(height);
  } finally {
    view.resize(clientWidth, clientHeight, Math.min(devicePixelRatio || 1, 2));
  }
}

/** Pixels of what the view draws now: {data, width, height}, RGBA by rows. */
export function pixelsOf(view, width, height) {
  const canvas = new OffscreenCanvas(width, height);
  const pen = canvas.getContext('2d', {willReadFrequently: true});
  view.draw();
  pen.drawImage(view.renderer.canvas, 0, 0, width, height);
  return pen.getImageData(0, 0, width, height);
}

/** Colours and opacity from the pictures on black and on white. */
function withoutGround(black, white) {
  const [a, b] = [black.data, white.data];
  for (let k = 0; k < a.length; k += 4) {
    const ground = Math.max(b[k] - a[k], b[k + 1] - a[k + 1], b[k + 2] - a[k + 2], 0);
    const opacity = 255 - ground;
    for (let c = 0; c < 3; ++c) a[k + c] = opacity ? Math.min(255, Math.round(a[k + c] * 255 / opacity)) : 0;
    a[k + 3] = opacity;
  }
  return black;
}

/** A PNG of what is shown, so wide, without its ground. */
export function largePicture(view, width = 3840) {
  const ground = view.background;
  const haze = view.uniforms.background.value;  // what is far fades into the usual ground, on both
  const drawnOn = (colour, height) => {
    view.setBackground(colour);
    view.uniforms.background.value = haze;
    return pixelsOf(view, width, height);
  };
  return atSize(view, width, async (height) => {
    try {
      const black = drawnOn('#000000', height);
      const picture = withoutGround(black, drawnOn('#ffffff', height));
      const canvas = new OffscreenCanvas(width, height);
      canvas.getContext('2d').putImageData(picture, 0, 0);
      return await canvas.convertToBlob({type: 'image/png'});
    } finally {
      view.setBackground(ground);
    }
  });
}
