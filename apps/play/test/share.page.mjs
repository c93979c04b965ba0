// SPDX-License-Identifier: MIT
// What is handed on: the page with the session inside, pictures, films, SD files.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {after, before, describe, test} from 'node:test';
import {pathToFileURL} from 'node:url';
import {drag, openExample, openPage, saved, seenJoint, settle, sharedPage} from './support/browser.mjs';

/** FNV-1a of the bits of all frames, and of where the solver stands. */
const bitsOf = (tab) => tab.evaluate(() => {
  const hash = (arrays) => {
    let value = 0x811c9dc5;
    for (const array of arrays)
      for (const byte of new Uint8Array(array.buffer, array.byteOffset, array.byteLength)) value = Math.imul(value ^ byte, 0x01000193) >>> 0;
    return value;
  };
  const {stage, session} = P;
  return {frames: hash(stage.frames.list.map(({positions}) => positions)), count: stage.frames.length,
    now: session.positions && hash([session.positions]), pins: [...session.pins], strokes: session.strokes, technique: session.settings.technique,
    steps: stage.frames.list.map(({step}) => step)};
});

describe('share', () => {
let page;
before(async () => {
  page = await sharedPage();
  await openExample(page, 'caffeine.sdf');
  const {release} = await drag(page, await seenJoint(page, 3), 70, -50, {steps: 8});
  await release();
  await page.waitForFunction(() => !P.hand.busy);
  await page.evaluate(async () => {
    await P.session.limitSteps(0);  // no step is too late on a busy machine
    await P.session.change({technique: 'bfs_cycle', damping: 0.25});
    P.session.togglePin(5);
    for (let k = 0; k < 3; ++k) await P.session.pull([[2, 30, k, -9]], k === 0);
    await P.session.undo();
    await P.session.pull([[7, -12, 40, 1]]);
  });
});
after(() => page.evaluate(() => P.session.limitSteps(100)));

async function savedByButton() {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#share')]);
  return {name: download.suggestedFilename(), path: await download.path()};
}

test('one file with the session inside: the same bits, and it goes on', async () => {
  const here = await bitsOf(page);
  const {name, path} = await savedByButton();
  assert.equal(name, 'caffeine.html');
  const text = readFileSync(path, 'utf8');
  assert.ok(text.length < readFileSync(new URL('../../../build/play/pliant.html', import.meta.url), 'utf8').length + 60000);
  assert.ok(!/connect-src/.test(text.slice(0, 2000)));
  const {copyFileSync, mkdtempSync} = await import('node:fs');
  const copy = `${mkdtempSync('/tmp/pliant-share-')}/${name}`;
  copyFileSync(path, copy);
  const other = await openPage({address: pathToFileURL(copy).href});
  assert.deepEqual(await bitsOf(other), here);
  assert.deepEqual(other.complaints, []);
  assert.deepEqual(other.requests.filter((url) => !/^(blob|data|file):/.test(url)), []);
  const undone = [];
  for (const tab of [page, other]) {
    await tab.evaluate(async () => { await P.session.limitSteps(0); await P.session.pull([[1, 20, 3, 4]]); await P.session.undo(); await P.session.undo(); });
    undone.push(await bitsOf(tab));
  }
  assert.deepEqual(undone[1], undone[0]);
  await other.context().close();
});

test('a trajectory that is watched is handed on as it is', async () => {
  const {path} = await saved(page, 'h5md');
  await page.setInputFiles('#file', {name: 'again.h5md', mimeType: '', buffer: readFileSync(path)});
  await page.waitForFunction(() => P.stage.isReplay);
  const here = await bitsOf(page);
  const {path: html} = await savedByButton();
  const {copyFileSync, mkdtempSync} = await import('node:fs');
  const copy = `${mkdtempSync('/tmp/pliant-share-')}/again.html`;
  copyFileSync(html, copy);
  const other = await openPage({address: pathToFileURL(copy).href});
  const there = await bitsOf(other);
  assert.equal(there.frames, here.frames);
  assert.equal(await other.evaluate(() => P.stage.isReplay), true);
  await other.context().close();
});

test('SDF: a record a frame, with bonds and their orders', async () => {
  await openExample(page, 'caffeine.sdf');
  await page.evaluate(() => P.session.pull([[2, 30, 1, -9]]));
  await settle(page);
  const records = readFileSync((await saved(page, 'sdf')).path, 'utf8').split('$$$$\n').filter(Boolean);
  assert.equal(records.length, 2);
  const lines = records[1].split('\n');
  assert.match(lines[3], /^ 24 25 .*V2000$/);
  assert.equal(lines.slice(28, 53).filter((line) => line.slice(6, 9) === '  2').length > 0, true);
  const x = await page.evaluate(() => P.stage.frames.at(1).positions[0]);
  assert.equal(Number(lines[4].slice(0, 10)), Number(x.toFixed(4)));
  await page.setInputFiles('#file', {name: 'again.sdf', mimeType: '', buffer: Buffer.from(records[1] + '$$$$\n')});
  await page.waitForFunction(() => P.session.fileName === 'again.sdf');
  assert.equal(await page.evaluate(() => P.stage.model.bonds.length), 50);
});

test('SDF: charges of the file', async () => {
  const places = [[0, 0, 0, 'N'], [0.6, 0.6, 0.6, 'H'], [-0.6, -0.6, 0.6, 'H'], [-0.6, 0.6, -0.6, 'H'], [0.6, -0.6, -0.6, 'H']];
  const atoms = places.map(([x, y, z, symbol]) =>
    [x, y, z].map((value) => value.toFixed(4).padStart(10)).join('') + ` ${symbol}   0  0  0  0  0  0  0  0  0  0  0  0`);
  const bonds = [2, 3, 4, 5].map((joint) => `  1  ${joint}  1  0  0  0  0`);
  const text = ['ammonium', '', '', '  5  4  0  0  0  0  0  0  0  0999 V2000', ...atoms, ...bonds, 'M  CHG  1   1   1', 'M  END', '$$$$', ''];
  await page.setInputFiles('#file', {name: 'nh4.sdf', mimeType: '', buffer: Buffer.from(text.join('\n'))});
  await page.waitForFunction(() => P.session.fileName === 'nh4.sdf');
  assert.match(readFileSync((await saved(page, 'sdf')).path, 'utf8'), /^M {2}CHG {2}1 {3}1 {3}1$/m);
  await openExample(page, 'caffeine.sdf');
  await page.evaluate(() => P.session.pull([[2, 30, 1, -9]]));
});

test('a picture 3840 wide without its ground', async () => {
  const bytes = readFileSync((await saved(page, 'large')).path);
  assert.equal(bytes.readUInt32BE(16), 3840);
  assert.equal(bytes[25], 6);  // colours and opacity
  const shares = await page.evaluate(async (data) => {
    const blob = new Blob([Uint8Array.from(atob(data), (c) => c.charCodeAt(0))], {type: 'image/png'});
    const picture = await createImageBitmap(blob);
    const pen = new OffscreenCanvas(picture.width, picture.height).getContext('2d');
    pen.drawImage(picture, 0, 0);
    const {data: pixels} = pen.getImageData(0, 0, picture.width, picture.height);
    let [clear, full] = [0, 0];
    for (let k = 3; k < pixels.length; k += 4) { clear += pixels[k] === 0; full += pixels[k] === 255; }
    return {clear: clear / pixels.length * 4, full: full / pixels.length * 4};
  }, bytes.toString('base64'));
  assert.ok(shares.clear > 0.3 && shares.full > 0.01, JSON.stringify(shares));
  assert.equal(await page.evaluate(() => P.view.size.width < 1100), true);
});

test('a film', async () => {
  await page.evaluate(async () => { for (let k = 0; k < 4; ++k) await P.session.pull([[2, 30, 9, -9]]); });
  const film = readFileSync((await saved(page, 'video')).path);
  assert.deepEqual([...film.subarray(0, 4)], [0x1a, 0x45, 0xdf, 0xa3]);
  assert.ok(film.length > 1000);
});
});
