// SPDX-License-Identifier: MIT
// The cartoon: it is where the atoms are, can be picked and pulled, and costs few draw calls.
import assert from 'node:assert/strict';
import {before, describe, test} from 'node:test';
import {drag, openExample, settle, sharedPage} from './support/browser.mjs';

describe('ribbon', () => {
let page;
before(async () => {
  page = await sharedPage();
  await page.evaluate(() => { P.look.ownStyle = P.look.ownColouring = undefined; });
  await openExample(page, 'peptide_20.pdb');
});

/** Bytes of the picture, drawn whole. */
const picture = () => page.evaluate(() => {
  const {view} = P;
  view.draw();
  const gl = view.renderer.gl;
  const [w, h] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
  const pixels = new Uint8Array(4 * w * h);
  gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return [...pixels].filter((_, k) => k % 28 < 3);
});
const differing = (a, b) => a.reduce((sum, value, k) => sum + Number(Math.abs(value - b[k]) > 8), 0);
const style = (name) => page.evaluate((wanted) => P.look.setStyle(wanted), name);

test('a peptide opens as a cartoon of a helix, a small molecule and a graph as before', async () => {
  assert.equal(await page.evaluate(() => P.view.style), 'cartoon');
  assert.equal(await page.evaluate(() => P.session.model.secondary), `--${'H'.repeat(17)}-`);
  assert.match(await page.textContent('#legend-list'), /Helix.*Coil/);
  await openExample(page, 'caffeine.sdf');
  assert.deepEqual(await page.evaluate(() => [P.view.style, P.stage.colouring]), ['balls', 'element']);
  assert.equal(await page.evaluate(() => [...document.getElementById('style').options].find(({value}) => value === 'cartoon').disabled), true);
  await openExample(page, 'thesis_figure_3_7');
  assert.equal(await page.evaluate(() => P.view.style), 'balls');
  await openExample(page, 'peptide_20.pdb');
  assert.equal(await page.evaluate(() => P.view.style), 'cartoon');
});

test('the ribbon moves with the atoms, and comes back with them', async () => {
  const first = await picture();
  await page.evaluate(() => {
    const moved = P.session.positions.slice();
    for (const joint of P.session.model.trace.slice(0, 8)) moved[3 * joint + 1] += 4;
    P.view.setPositions(moved);
  });
  assert.ok(differing(first, await picture()) > 400);
  await page.evaluate(() => P.view.setPositions(P.session.positions));
  assert.equal(differing(first, await picture()), 0);
});

test('what is picked on the ribbon is the CA of the residue that is there', async () => {
  const found = await page.evaluate(() => {
    const {view, session} = P;
    return [...session.model.trace].slice(1, -1).map((joint) => {
      const {x, y} = view.orbit.project([...session.positions.subarray(3 * joint, 3 * joint + 3)]);
      return [joint, view.pick(x, y)?.joint];
    });
  });
  const same = found.filter(([wanted, met]) => wanted === met).length;
  const all = new Set(await page.evaluate(() => [...P.session.model.trace]));
  assert.ok(found.every(([, met]) => met === undefined || all.has(met)), JSON.stringify(found));
  assert.ok(same >= 8, `${same} of ${found.length}`);
});

test('side chains stand beside the ribbon near the atom under the pointer, and no others', async () => {
  const shown = await page.evaluate(() => {
    const {view, session} = P;
    const joint = session.model.trace[9];
    const count = (hover) => {
      view.setLit({hover});
      view.draw();
      return [view.balls.instances, view.sticks.instances];
    };
    view.members.centre = -1;
    view.members.seen = '';
    return {none: count(-1), near: count(joint), kept: count(-1), joints: session.model.joints};
  });
  assert.deepEqual(shown.none, [0, 0]);
  assert.ok(shown.near[0] > 10 && shown.near[0] < 0.7 * shown.joints, JSON.stringify(shown));
  assert.ok(shown.near[1] > 5);
  assert.deepEqual(shown.kept, shown.near);
});

test('an atom that is held by its ribbon is pulled', async () => {
  const joint = await page.evaluate(() => {
    const {view, session} = P;
    return [...session.model.trace].find((k) => {
      const {x, y} = view.orbit.project([...session.positions.subarray(3 * k, 3 * k + 3)]);
      return view.pick(x, y)?.joint === k;
    });
  });
  const {release} = await drag(page, joint, 60, -40, {steps: 4});
  assert.equal(await page.evaluate(() => P.hand.held.joint), joint);
  await release();
});

test('a frame is at most four draw calls in each style, also of several walkers', async () => {
  const calls = await page.evaluate(() => {
    const {view} = P;
    P.why.close();  // what holds a pull is drawn over all
    const found = {};
    const {renderer} = view;
    for (const name of ['cartoon', 'cartoon-sticks', 'balls', 'surface']) {
      P.look.setStyle(name);
      for (const level of [0, 3]) {
        view.quality.use(level);
        renderer.calls = 0;
        view.frame();
        found[`${name} ${level}`] = renderer.calls;
      }
    }
    P.look.setStyle('cartoon');
    view.allocate(3);
    renderer.calls = 0;
    view.draw();
    found.walkers = renderer.calls;
    view.allocate(1);
    view.setPositions(P.session.positions);
    P.stage.look();
    return found;
  });
  for (const [name, count] of Object.entries(calls)) assert.ok(count >= 1 && count <= 4, `${name}: ${count}`);
});

test('a surface covers more than the ribbon and follows the atoms', async () => {
  await style('surface');
  const before = await picture();
  await page.evaluate(() => P.view.setPositions(P.session.positions.map((x, k) => k % 3 === 1 ? x + 2 : x)));
  assert.ok(differing(before, await picture()) > 1000);
  await page.evaluate(() => P.view.setPositions(P.session.positions));
  await style('cartoon');
});

test('contacts take the colour of how taut they are', async () => {
  await page.selectOption('#colouring', 'contacts');
  const {limits, contacts, sticks} = await page.evaluate(() => {
    P.view.draw();
    return {
      limits: [...P.session.model.contactLimits], contacts: P.session.model.contacts.length / 2,
      sticks: P.view.sticks.instances,
    };
  });
  assert.equal(limits.length, 3 * contacts);
  assert.ok(contacts > 0 && sticks >= contacts);
  for (let k = 0; k < limits.length; k += 3) assert.ok(limits[k] <= limits[k + 1] && limits[k + 1] <= limits[k + 2]);
  assert.equal(await page.textContent('#legend-high'), 'at its limit');
  await page.evaluate(() => { P.look.ownColouring = undefined; P.look.setColouring('secondary'); });
});

test('while something moves fewer pixels are drawn where that is slow, at rest all of them', async () => {
  const widths = await page.evaluate(() => {
    const {view} = P;
    const {quality} = view;
    const gl = view.renderer.gl;
    quality.level = 3;
    quality.tick(1000, true);
    view.frame();
    const moving = gl.drawingBufferWidth;
    quality.tick(quality.drawn + 1000, false);
    return [moving, gl.drawingBufferWidth, Math.round(view.size.width * view.ratio)];
  });
  assert.ok(widths[0] < widths[1]);
  assert.equal(widths[1], widths[2]);
});

test('a level is left after three slow pictures, and not at once tried again', async () => {
  const levels = await page.evaluate(() => {
    const {quality} = P.view;
    quality.reset();
    quality.level = 1;
    const seen = [];
    for (let k = 0; k < 3; ++k) { quality.took(90, 1000); seen.push(quality.level); }
    for (let k = 0; k < 40; ++k) quality.took(5, 2000);
    seen.push(quality.level);
    for (let k = 0; k < 5; ++k) quality.took(5, 20000);
    seen.push(quality.level);
    quality.reset();
    quality.level = 3;
    return seen;
  });
  assert.deepEqual(levels, [1, 1, 2, 2, 1]);
});

test('what the browser loses of the picture is made once more', async () => {
  await page.evaluate(() => { Object.assign(P.view.quality, {isFixed: true}).use(0); });  // however slow
  const first = await picture();
  await page.evaluate(async () => {
    const {gl, canvas} = P.view.renderer;
    const next = (name) => new Promise((done) => canvas.addEventListener(name, done, {once: true}));
    const lost = gl.getExtension('WEBGL_lose_context');
    const isLost = next('webglcontextlost');
    lost.loseContext();
    await isLost;
    await new Promise((done) => setTimeout(done));  // only then it may come back
    P.view.draw();
    const isBack = next('webglcontextrestored');
    lost.restoreContext();
    await isBack;
  });
  // Edges may fall otherwise by a few pixels; an empty picture differs by thousands.
  assert.ok(differing(first, await picture()) < 50);
  await page.evaluate(() => { P.view.quality.isFixed = false; });
});

test('no shader is refused', async () => {
  await settle(page);
  assert.deepEqual(page.complaints.filter((text) => /shader|WebGL/.test(text)), []);
});
});
