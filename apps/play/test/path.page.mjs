// SPDX-License-Identifier: MIT
// A path to another structure: it grows, is scrubbed and replayed, and is saved.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {before, describe, test} from 'node:test';
import {message, openExample, root, saved, settle, sharedPage} from './support/browser.mjs';
import {superpose} from '../page/record/superpose.mjs';

const START = readFileSync(join(root, 'data', 'molecules', 'peptide_20.pdb'), 'utf8');

/** The helix with what follows residue 10 turned by 60 degrees about its bond N-CA. */
function bent() {
  const rows = START.split('\n').map((line) => ({
    line, isAtom: line.startsWith('ATOM'), name: line.slice(12, 16).trim(),
    residue: Number(line.slice(22, 26)),
    x: [30, 38, 46].map((at) => Number(line.slice(at, at + 8))),
  }));
  const of = (name) => rows.find((row) => row.isAtom && row.residue === 10 && row.name === name).x;
  const [n, ca] = [of('N'), of('CA')];
  const axis = ca.map((c, k) => (c - n[k]) / Math.hypot(...ca.map((d, j) => d - n[j])));
  const turned = (x) => {
    const arm = x.map((c, k) => c - n[k]);
    const along = arm.reduce((sum, c, k) => sum + c * axis[k], 0);
    const across = arm.map((_, k) => axis[(k + 1) % 3] * arm[(k + 2) % 3] - axis[(k + 2) % 3] * arm[(k + 1) % 3]);
    return arm.map((c, k) => n[k] + axis[k] * along + 0.5 * (c - axis[k] * along) + Math.sqrt(0.75) * across[k]);
  };
  return rows.map(({line, isAtom, name, residue, x}) => {
    const stays = residue < 10 || (residue === 10 && ['N', 'H', 'CA', 'HA'].includes(name));
    if (!isAtom || stays) return line;
    return line.slice(0, 30) + turned(x).map((c) => c.toFixed(3).padStart(8)).join('') + line.slice(54);
  }).join('\n');
}

describe('path', () => {
let page;
before(async () => {
  page = await sharedPage();
  await openExample(page, 'peptide_20.pdb');
});

const choose = (name, text) => page.setInputFiles('#path-file', {name, mimeType: '', buffer: Buffer.from(text)});
const walk = async () => {
  await page.evaluate(() => { P.path.found = null; });
  await choose('bent.pdb', bent());
  await page.waitForFunction(() => P.path.found?.over && !P.path.isOn);
};
const note = () => page.textContent('#path-note');
const distance = async (frame, other) => {
  const [a, b, which] = await page.evaluate((numbers) => [
    ...numbers.map((k) => [...P.stage.frames.at(k).positions]), [...P.stage.measured()],
  ], [frame, other]);
  return superpose(a, b, which).rmsd;
};

test('it grows frame by frame, and arrives', async () => {
  await page.evaluate(() => {
    P.path.milliseconds = 0;  // one step a request, however fast
    P.seen = [];
    P.stage.on('changed', () => P.seen.push(P.stage.frames.length));
  });
  await walk();
  const seen = await page.evaluate(() => P.seen);
  assert.deepEqual([...new Set(seen)], Array.from({length: seen.at(-1)}, (_, k) => k + 1));
  assert.match(await note(), /^Arrived: 0\.\d\d Å from the end, \d+ frames\.\nbent\.pdb: 20 of our 20 residues are in it$/);
  assert.ok(await distance(0, -1) > 2);
});

test('it is scrubbed and replayed, and every bar is whole', async () => {
  const last = await page.evaluate(() => P.stage.frames.length - 1);
  await page.fill('#scrub', '0');
  assert.equal(await page.textContent('#frame'), `0 / ${last}`);
  await page.selectOption('#speed', '4');
  await page.click('#play');
  await page.waitForFunction(() => P.stage.at === P.stage.frames.length - 1 && !P.transport.playing);
  const worst = await page.evaluate(() => {
    const {model, frames} = P.stage;
    let most = 0;
    for (const {positions: x} of frames.list)
      for (let b = 0; b < model.bars.length / 2; ++b) {
        const [i, j] = [3 * model.bars[2 * b], 3 * model.bars[2 * b + 1]];
        const far = Math.hypot(x[i] - x[j], x[i + 1] - x[j + 1], x[i + 2] - x[j + 2]);
        most = Math.max(most, Math.abs(far / model.rest[b] - 1));
      }
    return most;
  });
  assert.ok(worst < 1e-9, `${worst}`);
});

test('it is saved as H5MD, and opens again', async () => {
  const {name, path} = await saved(page, 'h5md');
  assert.equal(name, 'peptide_20_to_bent.h5md');
  const frames = await page.evaluate(() => P.stage.frames.length);
  await page.setInputFiles('#file', {name, mimeType: '', buffer: readFileSync(path)});
  await page.waitForFunction(() => P.stage.model.title === 'peptide_20_to_bent.h5md');
  assert.equal(await page.evaluate(() => P.stage.frames.length), frames);
  await choose('bent.pdb', bent());
  assert.match(await message(page), /^Open a structure first/);
});

test('both ends meet; another path begins where the first did', async () => {
  await openExample(page, 'peptide_20.pdb');
  await page.evaluate(() => { document.getElementById('path-both').checked = true; });
  await walk();
  assert.match(await note(), /^Arrived[^]*the two ends met, 0\.\d\d A apart/);
  await page.evaluate(() => { document.getElementById('path-both').checked = false; });
  await walk();
  assert.match(await note(), /^Arrived/);
});

test('another molecule is refused, and what was open stays', async () => {
  await openExample(page, 'peptide_20.pdb');
  const title = await page.textContent('#title');
  await choose('water.pdb', 'HETATM    1  O   HOH A   1       0.000   0.000   0.000  1.00  0.00           O\nEND\n');
  assert.match(await message(page), /water\.pdb/);
  assert.equal(await page.textContent('#title'), title);
  assert.equal(await page.isDisabled('#technique'), false);
  await settle(page);
});
});
