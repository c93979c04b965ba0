// SPDX-License-Identifier: MIT
// The module in Chromium, in the worker of the page: the bits of the library, by every technique.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {createHash} from 'node:crypto';
import {readFileSync} from 'node:fs';
import {basename, dirname, join} from 'node:path';
import {before, describe, test} from 'node:test';
import {root, sharedPage} from './support/browser.mjs';

const PYTHON = join(dirname(process.env.PLIANT_COMMAND || join(root, '.venv', 'bin', 'pliant')), 'python');
// Steps, model, file: rings, no ring, many residues, and limits, with which some techniques are slow.
const CASES = [
  [100, 'bonds', 'molecules/caffeine.sdf'], [100, 'bonds', 'molecules/butane.sdf'],
  [100, 'bonds', 'molecules/peptide_20.pdb'], [10, 'protein', 'molecules/peptide_20.pdb'],
];

describe('bits', () => {
let page;
before(async () => { page = await sharedPage(); });

/** {settings, rows: {file: {technique: hash}}} of the library. */
function native(steps, model, file) {
  const words = [join(root, 'tests/support/python/native_bits.py'), steps, model, file];
  return JSON.parse(execFileSync(PYTHON, words.map(String), {encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore']}));
}

/** Positions after so many steps by this technique, as the page's worker gives them: bytes in base64;
 * or {error}, why it does not. */
function walked(given) {
  return page.evaluate(async ({name, data, model, settings, steps}) => {
    const {session} = P;
    const bytes = Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
    await session.ask('open', {name, bytes, model});
    let frames;
    try {
      await session.ask('settings', settings);
      ({frames} = await session.ask('wander', {steps, last: true, pins: []}));
    } catch ({message}) {
      return {error: message};
    }
    const {buffer, byteOffset, byteLength} = frames.at(-1).positions;
    return btoa(Array.from(new Uint8Array(buffer, byteOffset, byteLength), (byte) => String.fromCharCode(byte)).join(''));
  }, given);
}

test('are those of Chromium, and every technique is tried', async () => {
  const facts = await page.evaluate(() => ({
    agent: navigator.userAgent, worker: P.session.client.worker instanceof Worker,
    techniques: P.session.facts.techniques.map(({name}) => name),
  }));
  assert.match(facts.agent, /Chrome\//);
  assert.ok(facts.worker);
  const [tried] = Object.values(native(1, 'bonds', join(root, 'data/molecules/caffeine.sdf')).rows);
  assert.deepEqual(Object.keys(tried), facts.techniques);
});

for (const [steps, model, path] of CASES)
  test(`${basename(path)}, ${model}, ${steps} steps`, async () => {
    const file = join(root, 'data', path);
    const data = readFileSync(file).toString('base64');
    const {settings, rows} = native(steps, model, file);
    const [name, expected] = Object.entries(rows)[0];
    const found = {};
    for (const technique of Object.keys(expected)) {
      const end = await walked({name, data, model, settings: {...settings, technique}, steps});
      found[technique] = end.error ?? createHash('sha1').update(Buffer.from(end, 'base64')).digest('hex');
    }
    assert.deepEqual(found, expected);
    assert.ok(new Set(Object.values(found)).size > 1, 'techniques end at different places');
  });
});
