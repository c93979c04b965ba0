// SPDX-License-Identifier: MIT
// Mouse, fingers and keys on the picture.
import assert from 'node:assert/strict';
import {before, describe, test} from 'node:test';
import {
  PHONE, drag, openExample, openPage, placeOf, seenJoint, sharedPage, settle,
} from './support/browser.mjs';

describe('hand', () => {
let page;
before(async () => { page = await sharedPage(); });

const positions = () => page.evaluate(() => [...P.session.positions]);
const apart = (a, b, joint) => Math.hypot(...[0, 1, 2].map((c) => a[3 * joint + c] - b[3 * joint + c]));
const worst = () => page.evaluate(() => Math.max(...P.stage.frames.list.map((frame) => frame.residual)));

test('a drag pulls the joint under the pointer, and every bar of every frame is whole', async () => {
  await openExample(page, 'alanine_dipeptide.pdb');
  const joint = await seenJoint(page, 3);
  const start = await positions();
  const {release} = await drag(page, joint, 80, -60, {steps: 8});
  assert.equal(await page.evaluate(() => P.hand.held.joint), joint);
  assert.equal(await page.evaluate(() => P.view.arrow.isShown), true);
  const strain = await page.evaluate(() => P.stage.frames.at(2).broken.reduce((a, b) => Math.max(a, Math.abs(b)), 0));
  assert.ok(strain > 1e-3, 'the push broke no bar');
  await release();
  assert.equal(await page.evaluate(() => P.view.arrow.isShown), false);
  assert.ok(apart(start, await positions(), joint) > 0.05);
  assert.ok(await page.evaluate(() => P.stage.frames.length) >= 9);
  assert.ok(await worst() <= 1e-6);
  assert.equal(await page.textContent('#out-verdict'), 'All bars whole');
});

test('broken bars are drawn in red', async () => {
  const red = await page.evaluate(() => {
    const {view, stage} = P;
    const count = () => {
      view.draw();
      const gl = view.renderer.gl;
      const [w, h] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
      const pixels = new Uint8Array(4 * w * h);
      gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      let found = 0;
      for (let k = 0; k < pixels.length; k += 4) found += pixels[k] > 90 && pixels[k] > 3.2 * pixels[k + 1] && pixels[k] > 3.2 * pixels[k + 2];
      return found;
    };
    stage.holdsStrain = true;
    view.setStrain(new Float32Array(stage.strain.length));
    const whole = count();
    view.setStrain(new Float32Array(stage.strain.length).fill(0.1));
    const broken = count();
    stage.holdsStrain = false;
    stage.fading = true;
    return [whole, broken];
  });
  assert.ok(red[1] > red[0] + 500, `${red}`);
});

test('the weak hand moves a joint less than the strong one', async () => {
  const moved = {};
  for (const strength of ['weak', 'strong']) {
    await openExample(page, 'butane.sdf');
    await page.selectOption('#strength', strength);
    const joint = await seenJoint(page, 0);
    const start = await positions();
    const {release} = await drag(page, joint, 90, 0, {steps: 3});
    await release();
    moved[strength] = await page.evaluate(([from, j]) => {
      const x = P.stage.frames.at(2).positions;
      return Math.hypot(...[0, 1, 2].map((c) => x[3 * j + c] - from[3 * j + c]));
    }, [start, joint]);
  }
  assert.ok(moved.weak < 0.6 * moved.strong, JSON.stringify(moved));
});

test('a pinned joint stays where it is', async () => {
  await openExample(page, 'alanine_dipeptide.pdb');
  await page.check('[name=tool][value=pin]', {force: true});
  const pin = await seenJoint(page, 0);
  const joint = await page.evaluate((from) => {
    const {view, session: {positions: x, model}} = P;
    const far = (j) => Math.hypot(...[0, 1, 2].map((c) => x[3 * j + c] - x[3 * from + c]));
    const isSeen = (j) => {
      const at = view.orbit.project([...x.subarray(3 * j, 3 * j + 3)]);
      return view.pick(at.x, at.y)?.joint === j;
    };
    const all = [...Array(model.joints).keys()].sort((a, b) => far(b) - far(a));
    return all.find(isSeen);
  }, pin);
  const place = await placeOf(page, pin);
  await page.mouse.click(place.x, place.y);
  assert.deepEqual(await page.evaluate(() => [...P.session.pins]), [pin]);
  assert.equal(await page.textContent('#pins'), '1 joint');
  await page.check('[name=tool][value=pull]', {force: true});
  const start = await positions();
  const {release} = await drag(page, joint, 60, 60);
  await release();
  const end = await positions();
  assert.equal(apart(start, end, pin), 0);
  assert.ok(apart(start, end, joint) > 0.02);
  await page.click('#pins-clear');
  assert.equal(await page.textContent('#pins'), 'none');
});

test('a force in numbers pushes the joint that is held', async () => {
  await openExample(page, 'butane.sdf');
  await page.selectOption('#hand', 'vector');
  await page.fill('#vector-x', '0');
  await page.fill('#vector-y', '0');
  await page.fill('#vector-z', '-200');
  await page.press('#vector-z', 'Tab');
  const joint = await seenJoint(page, 0);
  const start = await positions();
  const place = await placeOf(page, joint);
  await page.mouse.move(place.x, place.y);
  await page.mouse.down();
  await page.waitForFunction(() => P.stage.history.length > 2);
  await page.mouse.up();
  await page.waitForFunction(() => !P.hand.busy);
  assert.ok((await positions())[3 * joint + 2] < start[3 * joint + 2]);
  await page.selectOption('#hand', 'pointer');
});

test('beside the joints a drag turns the picture and moves nothing', async () => {
  const start = await positions();
  const turn = () => page.evaluate(() => P.view.orbit.axes.flat());
  const before = await turn();
  const box = await page.locator('#canvas').boundingBox();
  await page.mouse.move(box.x + 20, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + 140, box.y + box.height / 2 + 40, {steps: 3});
  await page.mouse.up();
  assert.notDeepEqual(await turn(), before);
  assert.deepEqual(await positions(), start);
});

test('the wheel zooms, Shift and a drag move the picture, Fit brings it back', async () => {
  const camera = () => page.evaluate(() => ({far: P.view.orbit.distance, at: [...P.view.orbit.target]}));
  await page.click('#fit');
  const before = await camera();
  const box = await page.locator('#canvas').boundingBox();
  await page.mouse.move(box.x + 30, box.y + 120);
  await page.mouse.wheel(0, 200);
  await page.waitForFunction((far) => P.view.orbit.distance > far, before.far);
  await page.keyboard.down('Shift');
  await page.mouse.down();
  await page.mouse.move(box.x + 90, box.y + 150, {steps: 2});
  await page.mouse.up();
  await page.keyboard.up('Shift');
  assert.notDeepEqual((await camera()).at, before.at);
  await page.click('#fit');
  assert.ok(Math.abs((await camera()).far - before.far) < 1e-9);
});

test('keys choose a joint, pull it, pin it and turn the picture', async () => {
  await openExample(page, 'butane.sdf');
  await page.focus('#canvas');
  const start = await positions();
  await page.keyboard.press('.');
  assert.notEqual(await page.textContent('#said'), '');
  await page.keyboard.press('Shift+ArrowRight');
  await page.waitForFunction(() => P.stage.history.length === 1);
  assert.ok(apart(start, await positions(), 0) > 1e-3);
  await page.keyboard.press('p');
  assert.equal(await page.textContent('#pins'), '1 joint');
  const turn = await page.evaluate(() => P.view.orbit.axes.flat());
  await page.keyboard.press('ArrowLeft');
  assert.notDeepEqual(await page.evaluate(() => P.view.orbit.axes.flat()), turn);
});

test('a finger pulls a joint, two fingers zoom', async () => {
  const phone = await openPage({viewport: PHONE, hasTouch: true, isMobile: true});
  await openExample(phone, 'butane.sdf');
  const joint = await seenJoint(phone, 0);
  const {x, y} = await placeOf(phone, joint);
  const client = await phone.context().newCDPSession(phone);
  const touch = (type, ...points) => client.send('Input.dispatchTouchEvent', {type, touchPoints: points});
  await touch('touchStart', {x: x + 9, y, id: 1});
  for (let k = 1; k < 6; ++k) await touch('touchMove', {x: x + 9 + 10 * k, y: y + 4 * k, id: 1});
  await phone.waitForFunction(() => P.stage.history.length > 3);
  assert.equal(await phone.evaluate(() => P.hand.held.joint), joint);
  await touch('touchEnd');
  const far = await phone.evaluate(() => P.view.orbit.distance);
  await touch('touchStart', {x: 60, y: 400, id: 1}, {x: 120, y: 400, id: 2});
  for (let k = 1; k < 5; ++k) await touch('touchMove', {x: 60, y: 400, id: 1}, {x: 120 + 20 * k, y: 400, id: 2});
  await touch('touchEnd');
  await settle(phone);
  assert.ok(await phone.evaluate(() => P.view.orbit.distance) < far);
  await phone.context().close();
});
});
