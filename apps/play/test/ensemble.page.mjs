// SPDX-License-Identifier: MIT
// An ensemble in the page: pliant sample's frames, played in an order for the eye, and pulled on.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, before, describe, test} from 'node:test';
import {root, settle, sharedPage} from './support/browser.mjs';

const COMMAND = process.env.PLIANT_COMMAND || join(root, '.venv', 'bin', 'pliant');
const FRAMES = 12;

/** What pliant play would have found: two halves of the helix, and two frames that stand for all. */
const FOUND = {
  kind: 'ensemble', frames: FRAMES, numbers: Array.from({length: FRAMES}, (_, k) => k), notes: [],
  domainNames: ['SER1 to ALA10', 'ALA11 to ALA20'], core: [1, 20, 40, 60],
  turns: [{domain: 1, angle: 41.6, shift: 0.1, point: [0, 0, 0], axis: [0, 0, 1], from: 2, to: 9, hinges: ['ALA10']}],
  shapes: {title: 'Representatives', about: 'Two.', rows: [{frame: 3, text: 'nearest to 8 frames'}, {frame: 7, text: 'nearest to 4 frames'}]},
};

describe('ensemble', () => {
let page;
let folder;
let bytes;
before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'pliant-ensemble-'));
  execFileSync(COMMAND, ['sample', join(root, 'data', 'molecules', 'peptide_20.pdb'), '-o', 'ensemble.h5md',
    '--frames', String(FRAMES), '--quiet'], {cwd: folder});
  bytes = readFileSync(join(folder, 'ensemble.h5md')).toString('base64');
  page = await sharedPage();
  await page.emulateMedia({reducedMotion: 'reduce'});
});
after(() => rmSync(folder, {recursive: true, force: true}));

const open = async (known) => {
  await page.evaluate(async ([text, more]) => {
    await P.open.openBytes('ensemble.h5md', Uint8Array.from(atob(text), (c) => c.charCodeAt(0)), 'auto', more);
  }, [bytes, known]);
  await page.waitForFunction(() => P.ensemble.of?.films && !P.ensemble.shapes.waiting?.length);
  await settle(page);
};

test('a file alone: names, an order of its own frames, mobility, and what it lacks', async () => {
  await open({});
  assert.match(await page.evaluate(() => P.stage.model.nameOf(0)), /^(A:)?SER1:N$/);
  const {along, nearest} = await page.evaluate(() => P.ensemble.of.films);
  assert.deepEqual([...nearest].sort((a, b) => a - b), Array.from({length: FRAMES}, (_, k) => k));
  assert.equal(new Set(along).size, along.length);
  assert.equal(await page.evaluate(() => P.stage.colouring), 'mobility');
  assert.match(await page.textContent('#ensemble-note'), /independent[^]*pliant play FILE finds domains/);
  assert.equal(await page.isVisible('#ensemble-domains'), false);
});

test('the film goes along its order, which the slider follows', async () => {
  const order = await page.evaluate(() => P.transport.film.order);
  await page.fill('#scrub', '2');
  assert.equal(await page.evaluate(() => P.stage.at), order[2]);
  await page.selectOption('#ensemble-order', 'file');
  await page.fill('#scrub', '2');
  assert.equal(await page.evaluate(() => P.stage.at), 2);
});

test('domains have colours, axes that can be hidden, and turns in words', async () => {
  await open({ensemble: {...FOUND, domain: await page.evaluate(() => Array.from(P.stage.model.residue, (r) => (r < 10 ? 0 : 1)))}});
  assert.equal(await page.evaluate(() => P.stage.colouring), 'domain');
  assert.equal(await page.textContent('#ensemble-domain-list button'), 'Turns by 42° about the hinge ALA10');
  assert.equal(await page.textContent('.ensemble-angle'), '42°');
  await page.click('#ensemble-domain-list button');
  const one = await page.evaluate(() => P.stage.at);
  await page.click('#ensemble-domain-list button');
  assert.deepEqual([one, await page.evaluate(() => P.stage.at)].sort(), [2, 9]);
  await page.uncheck('#ensemble-axes');
  await settle(page);
  assert.equal(await page.isVisible('.ensemble-angle'), false);
});

test('a shape is a picture; a click shows its frame', async () => {
  assert.equal(await page.locator('#ensemble-shapes button').count(), 2);
  const painted = await page.evaluate(() => {
    const canvas = document.querySelector('#ensemble-shapes canvas');
    return new Set(new Uint32Array(canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.buffer)).size;
  });
  assert.ok(painted > 10, `${painted} colours`);
  await page.click('#ensemble-shapes button:nth-child(2)');
  assert.equal(await page.evaluate(() => P.stage.at), 7);
  assert.equal(await page.getAttribute('#ensemble-shapes button:nth-child(2)', 'aria-pressed'), 'true');
});

test('a session begins at the bits of the frame, and the frames come back', async () => {
  await page.evaluate(() => { window.was = P.stage.frames.at(7).positions.slice(); });
  await page.click('#ensemble-drag');
  await page.waitForFunction(() => P.ensemble.isPulled && /^From frame 7/.test(document.getElementById('ensemble-drag-note').textContent));
  assert.ok(await page.evaluate(() => P.session.positions.every((x, k) => x === window.was[k])));
  const step = await page.evaluate(() => P.session.pull([[0, 300, 0, 0]]));
  assert.equal(step.converged, true);
  assert.ok(await page.evaluate(() => P.session.positions.some((x, k) => x !== window.was[k])));
  await page.click('#ensemble-back');
  await page.waitForFunction(() => P.stage.isReplay && P.stage.at === 7);
  assert.equal(await page.evaluate(() => P.stage.frames.length), FRAMES);
  assert.deepEqual(page.complaints, []);
});
});
