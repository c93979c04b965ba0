// SPDX-License-Identifier: MIT
// What a patch of the picture shows: each joint, bar and contact is drawn in the colour of its number.
import {Target} from './gl.mjs';

/** Numbers of joints and bars in a patch of pixels, as colours; its left upper corner in CSS pixels. */
export function numbersSeen(view, x, y, edge) {
  const {renderer, uniforms, orbit} = view;
  if (view.patch.width !== edge) {
    renderer.forget(view.patch);
    view.patch = new Target(edge, edge);
  }
  uniforms.picking.value = 1;
  view.count(1);
  renderer.into(view.patch);
  view.paintAll(orbit.projectionOf(x, y, edge, edge), [0, 0, 0], 0);
  const bytes = renderer.bytes();
  renderer.into(null);
  uniforms.picking.value = 0;
  return bytes;
}

/** What is in the middle of the patch, but for joints near it. */
export function nearest(view, bytes, edge) {
  const middle = (edge - 1) / 2;
  let found = meaning(view, bytes, middle * edge + middle);
  let least = found?.joint === undefined ? Infinity : 0;
  for (let k = 0; k < edge * edge; ++k) {
    const far = Math.hypot(k % edge - middle, Math.floor(k / edge) - middle);
    if (far >= least || far > middle + 0.5) continue;
    const here = meaning(view, bytes, k);
    if (here?.joint === undefined) continue;
    [found, least] = [here, far];
  }
  return found;
}

function meaning(view, bytes, pixel) {
  const {model} = view;
  const number = bytes[4 * pixel] + 256 * bytes[4 * pixel + 1] + 65536 * bytes[4 * pixel + 2] - 1;
  if (number < 0) return null;
  if (number < model.joints) return {joint: number};
  const bar = number - model.joints;
  if (bar < model.bars.length / 2) return {bar};
  const contact = bar - view.textures.stickCount + model.contacts.length / 2;
  return contact >= 0 ? {contact, stick: bar} : null;
}
