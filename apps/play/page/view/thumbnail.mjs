// SPDX-License-Identifier: MIT
// A small picture of the model in given positions, by the view itself and as it is looked at.

const SIZE = {width: 160, height: 120};  // pixels
const NEARER = 0.8;  // no controls need room

/** Draws `positions` on `canvas`; the view then shows what it showed before. */
export function drawThumbnail(view, canvas, positions, shown) {
  const {orbit} = view;
  const before = {
    size: view.size, distance: orbit.distance, radius: orbit.radius,
    target: orbit.target, half: orbit.half,
  };
  const {overlays} = view;
  view.overlays = [];
  view.resize(SIZE.width, SIZE.height, 1);
  view.setPositions(positions);
  orbit.enclose(positions, view.unit);
  orbit.zoom(NEARER);
  view.draw();
  Object.assign(canvas, SIZE);
  canvas.getContext('2d').drawImage(view.renderer.canvas, 0, 0, SIZE.width, SIZE.height);
  view.overlays = overlays;
  Object.assign(orbit, {distance: before.distance, radius: before.radius, target: before.target, half: before.half});
  view.setPositions(shown);
  view.resize(before.size.width, before.size.height, Math.min(devicePixelRatio || 1, 2));
  view.draw();
}
