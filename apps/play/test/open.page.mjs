// SPDX-License-Identifier: MIT
// What is opened: examples, files, random graphs, bad files.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {before, describe, test} from 'node:test';
import {gzipSync} from 'node:zlib';
import {message, root, sharedPage, settle} from './support/browser.mjs';

describe('open', () => {
let page;
before(async () => { page = await sharedPage(); });

const molecule = (name) => readFileSync(join(root, 'data', 'molecules', name));
const title = () => page.textContent('#title');
const titled = (text) => page.waitForFunction((wanted) => {
  const title = document.getElementById('title').textContent.toLowerCase();
  return title.includes(wanted) && !title.startsWith('reading');
}, text);
const choose = (name, buffer) =>
  page.setInputFiles('#file', {name, mimeType: 'application/octet-stream', buffer});

test('opens from a file, with a molecule, without a request or a complaint', async () => {
  assert.match(page.firstTitle, /^three_helices\.pdb · \d+ joints/);
  assert.deepEqual(page.requests.filter((url) => !/^(file|blob|data):/.test(url)), []);
  assert.deepEqual(page.complaints, []);
});

test('opens an example of each kind', async () => {
  for (const name of ['peptide_20.pdb', 'kaleidocycle.xml', 'thesis_figure_3_7']) {
    await page.selectOption('#examples', name);
    await titled(name);
  }
});

test('opens a chosen file, also one with gzip around it', async () => {
  await choose('butane.sdf', molecule('butane.sdf'));
  await titled('butane');
  assert.match(await title(), /14 joints/);
  await choose('aspirin.sdf.gz', gzipSync(molecule('aspirin.sdf')));
  await titled('aspirin');
});

test('opens a file that is dropped', async () => {
  const text = molecule('cubane.xyz').toString();
  const data = await page.evaluateHandle((content) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([content], 'cubane.xyz'));
    return transfer;
  }, text);
  await page.dispatchEvent('#stage', 'drop', {dataTransfer: data});
  await titled('cubane');
});

test('tells what is wrong with a file, in the words of Pliant, and keeps what was open', async () => {
  const was = await title();
  await choose('bad.pdb', Buffer.from('ATOM      1  N   ALA A   1      aa.000   0.000   0.000\n'));
  assert.match(await message(page), /bad\.pdb:1: x \(columns 31-38\).*not a finite number/);
  assert.equal(await title(), was);
  await page.click('#message-close');
  assert.equal(await page.isHidden('#message'), true);
});

test('tells of a broken gzip', async () => {
  await choose('cut.pdb.gz', gzipSync(molecule('peptide_20.pdb')).subarray(0, 200));
  assert.equal(await message(page), 'cut.pdb.gz: the gzip in it is broken or ends early');
});

test('shows markup in a name as text', async () => {
  const name = '<img src=x onerror=alert(1)>.sdf';
  await choose(name, molecule('benzene.sdf'));
  await page.waitForFunction(() => document.title.length > 0);
  await settle(page);
  await choose(name, Buffer.from('no molecule'));
  assert.match(await message(page), /<img src=x onerror=alert\(1\)>\.sdf/);
  assert.equal(await page.$('#message img, #title img'), null);
});

test('opens the same molecule with angles', async () => {
  await page.selectOption('#examples', 'butane.sdf');
  await titled('butane');
  const bars = () => page.evaluate(() => P.session.model.bars.length / 2);
  await page.selectOption('#model', 'bonds');
  await page.waitForFunction(() => P.session.model.model === 'bonds');
  assert.equal(await bars(), 13);
  await page.selectOption('#model', 'angles');
  await page.waitForFunction(() => P.session.model.model === 'angles');
  assert.equal(await bars(), 13 + 24);
});
});
