// SPDX-License-Identifier: MIT
// The page within another one, as a notebook has it: its theme, what it tells to keep, and how it goes
// on from that.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {describe, test} from 'node:test';
import {built, openTab, root} from './browser.mjs';

function givenPage(more = {}) {
  const file = readFileSync(join(root, 'data/molecules/alanine_dipeptide.pdb'));
  const facts = {...more, name: 'a.pdb', data: file.toString('base64'), model: 'bonds', isInside: true};
  const block = `<script type="application/json" id="given">${JSON.stringify(facts)}</script>`;
  return readFileSync(join(built, 'pliant.html'), 'utf8').replace('<!-- GIVEN -->', () => block);
}

/** A tab with the page in a frame of no origin; `told`: what it says, its arrays as lists. */
async function hosted(text) {
  const tab = await openTab('about:blank');
  await tab.evaluate((page) => {
    window.told = [];
    addEventListener('message', ({data, source}) => {
      if (data.tell === 'theme') source.postMessage({tell: 'theme', theme: 'dark'}, '*');
      else told.push(data);
    });
    const frame = document.createElement('iframe');
    frame.setAttribute('sandbox', 'allow-scripts allow-downloads');
    Object.assign(frame.style, {width: '800px', height: '500px'});
    frame.srcdoc = page;
    document.body.append(frame);
  }, text);
  const frame = await (await tab.waitForSelector('iframe')).contentFrame();
  await frame.waitForFunction(() => window.pliant?.then((parts) => { window.P = parts; return true; }));
  return {tab, frame};
}

const restedOf = (tab) => tab.waitForFunction(() => {
  const last = told.findLast(({tell}) => tell === 'rested');
  return last && {picture: [...last.picture.subarray(1, 4)], session: btoa(Array.from(last.session, (c) => String.fromCharCode(c)).join(''))};
}).then((handle) => handle.jsonValue());

describe('host', () => {
test('the theme of the notebook, a picture and the session to keep, and on from there', async () => {
  const {tab, frame} = await hosted(givenPage());
  assert.equal(await frame.evaluate(() => document.documentElement.dataset.theme), 'dark');
  await frame.evaluate(async () => { for (let k = 0; k < 4; ++k) await P.session.pull([[3, 40, k, -9]], k === 2); });
  await tab.evaluate(() => { told.length = 0; });
  const kept = await restedOf(tab);
  assert.equal(String.fromCharCode(...kept.picture), 'PNG');
  const facts = (of) => of.evaluate(() => ({positions: [...P.session.positions], frames: P.stage.frames.length, strokes: P.session.strokes}));
  const before = await facts(frame);
  await tab.context().close();
  const again = await hosted(givenPage({session: kept.session}));
  assert.deepEqual(await facts(again.frame), before);
  assert.equal(before.frames, 5);
  await again.tab.context().close();
});
});
