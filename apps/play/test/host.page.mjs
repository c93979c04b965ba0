// SPDX-License-Identifier: MIT
// The page within another one, as a notebook has it: its theme, what it tells to keep, and how it goes
// on from that.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {describe, test} from 'node:test';
import {gzipSync} from 'node:zlib';
import {built, openTab, root} from './support/browser.mjs';

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

test('the widget: a picture until the page comes, the theme of JupyterLab, and its changes', async () => {
  const tab = await openTab('about:blank');
  const widget = readFileSync(join(root, 'python/pliant/play/widget.mjs'), 'utf8');
  const page = gzipSync(givenPage()).toString('base64');
  await tab.evaluate(async ({source, bytes}) => {
    document.body.dataset.jpThemeLight = 'false';
    window.sent = [];
    let take;
    const model = {
      get: (name) => (name === 'height' ? 420 : new DataView(new Uint8Array([0x89, 0x50]).buffer)),
      on: (_, action) => { take = action; }, off() {},
      send: (facts, _, buffers) => sent.push({...facts, sizes: (buffers ?? []).map((buffer) => buffer.byteLength)}),
    };
    const address = URL.createObjectURL(new Blob([source], {type: 'text/javascript'}));
    const made = (await import(address)).default;
    window.end = made.render({model, el: document.body});
    window.before = [...document.querySelectorAll('img, iframe')].map(({tagName}) => tagName);
    await take({tell: 'page'}, [Uint8Array.from(atob(bytes), (letter) => letter.charCodeAt(0))]);
  }, {source: widget, bytes: page});
  assert.deepEqual(await tab.evaluate(() => window.before), ['IMG']);
  const frame = await (await tab.waitForSelector('iframe')).contentFrame();
  const theme = (wanted) => frame.waitForFunction((name) => document.documentElement.dataset.theme === name, wanted);
  await frame.waitForFunction(() => window.pliant?.then(() => true));
  await theme('dark');
  await tab.evaluate(() => { document.body.dataset.jpThemeLight = 'true'; });
  await theme('light');
  assert.equal(await tab.locator('img').count(), 0);
  await tab.waitForFunction(() => sent.some(({tell, sizes}) => tell === 'rested' && sizes.length === 2 && sizes[0] > 1000 && sizes[1] > 100));
  assert.deepEqual(await tab.evaluate(() => sent.map(({tell}) => tell).slice(0, 2)), ['ready', 'opened']);
  await tab.context().close();
});
});
