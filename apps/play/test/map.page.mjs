// SPDX-License-Identifier: MIT
// A density map that the molecule is in: its surface, and how many residues are inside.
import assert from 'node:assert/strict';
import {before, describe, test} from 'node:test';
import {openExample, settle, sharedPage} from './support/browser.mjs';

describe('map', () => {
let page;
before(async () => {
  page = await sharedPage();
  await openExample(page, 'peptide_20.pdb');
});

/** A box about the first five residues, as a surface and as points that are 1 A apart. */
const box = () => page.evaluate(() => {
  const points = [...P.stage.sites].slice(0, 5).map((joint) => [...P.session.positions.subarray(3 * joint, 3 * joint + 3)]);
  const low = [0, 1, 2].map((c) => Math.floor(Math.min(...points.map((x) => x[c]))) - 1);
  const shape = [0, 1, 2].map((c) => Math.ceil(Math.max(...points.map((x) => x[c]))) + 2 - low[c]);
  const text = (array) => btoa(String.fromCharCode(...new Uint8Array(array.buffer)));
  const corners = Array.from({length: 8}, (_, k) => low.map((x, c) => 100 * (x + (k >> c & 1) * shape[c]))).flat();
  const faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
  P.map.set({
    step: 0.01, positions: text(Int16Array.from(corners)), triangles: text(Uint16Array.from(faces.flatMap(([a, b, c, d]) => [a, b, c, a, c, d]))),
    inside: text(new Uint8Array(shape[0] * shape[1] * shape[2]).fill(1)), shape, origin: low, spacing: 1,
  });
  return [...P.stage.sites].filter((joint) => [0, 1, 2].every((c) => {
    const at = Math.round(P.session.positions[3 * joint + c] - low[c]);
    return at >= 0 && at < shape[c];
  })).length;
});
const picture = () => page.evaluate(() => { P.view.draw(); return P.view.renderer.canvas.toDataURL(); });

test('it says how many residues are inside, and can be hidden', async () => {
  const bare = await picture();
  const count = await box();
  assert.ok(count >= 5 && count < 20);
  await settle(page);
  assert.equal(await page.textContent('#out-map'), `${count} of 20 residues inside`);
  assert.notEqual(await picture(), bare);
  await page.evaluate(() => document.getElementById('show-map').click());
  assert.equal(await picture(), bare);
  await page.evaluate(() => document.getElementById('show-map').click());
});

test('what a click meets is the molecule, not the map before it', async () => {
  const met = await page.evaluate(() => {
    const joint = P.stage.sites[2];
    const {x, y} = P.view.orbit.project([...P.session.positions.subarray(3 * joint, 3 * joint + 3)]);
    const seen = () => P.view.pick(x, y, 5);
    const {shell} = P.view;
    const before = seen();
    P.view.shell = null;
    const without = seen();
    P.view.shell = shell;
    return [before, without];
  });
  assert.deepEqual(met[0], met[1]);
});

test('another molecule is in no map', async () => {
  await openExample(page, 'butane.sdf');
  assert.equal(await page.isHidden('#map'), true);
  assert.equal(await page.evaluate(() => P.view.shell), null);
  await page.evaluate(() => { delete P.map.fileName; });  // the page is shared
});
});
