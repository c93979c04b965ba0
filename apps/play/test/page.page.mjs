// SPDX-License-Identifier: MIT
// The page as a page: looks, layouts, accessibility, policy, notices.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {before, describe, test} from 'node:test';
import {
  PHONE, WIDE, built, drag, openExample, openPage, require, seenJoint, sharedPage, settle,
} from './support/browser.mjs';

const AXE = readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');

describe('page', () => {
let page;
before(async () => { page = await sharedPage(); });

/** Axe is put in by the browser's debugger: the policy would not let it. */
async function findings(where) {
  await where.evaluate(AXE);
  const {violations} = await where.evaluate(() => axe.run(document, {resultTypes: ['violations']}));
  return violations.filter(({impact}) => impact === 'serious' || impact === 'critical')
    .map(({id, nodes}) => `${id}: ${nodes.map((node) => node.target.join(' ')).join(', ')}`);
}

const pixel = (x, y) => page.evaluate(([left, top]) => {
  P.view.draw();
  const gl = P.view.renderer.gl;
  const bytes = new Uint8Array(4);
  gl.readPixels(left, gl.drawingBufferHeight - top, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  return [...bytes.slice(0, 3)];
}, [x, y]);

test('no serious finding of axe: light, dark, wide, phone, with all panels and dialogs open', async () => {
  const open = (where) => where.evaluate(() => { for (const box of document.querySelectorAll('details')) box.open = true; });
  await page.setViewportSize(WIDE);
  await open(page);
  assert.deepEqual(await findings(page), []);
  await page.click('#theme');
  assert.deepEqual(await findings(page), []);
  await page.click('#help-open');
  assert.deepEqual(await findings(page), []);
  await page.keyboard.press('Escape');
  await page.click('#theme');
  const phone = await openPage({viewport: PHONE, theme: 'dark', hasTouch: true, isMobile: true});
  await open(phone);
  assert.deepEqual(await findings(phone), []);
  await phone.context().close();
});

test('nothing sticks out at 1366 x 768 or on a phone', async () => {
  for (const viewport of [WIDE, PHONE]) {
    await page.setViewportSize(viewport);
    await settle(page);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= viewport.width, `${wide} > ${viewport.width}`);
    const box = await page.locator('#canvas').boundingBox();
    assert.ok(box.height >= 0.45 * viewport.height && box.y + box.height <= viewport.height);
  }
  await page.setViewportSize({width: 1000, height: 600});
});

test('there is room to scrub at every width, with the panel open', async () => {
  for (const width of [390, 640, 901, 940, 1100, 1366]) {
    await page.setViewportSize({width, height: 620});
    await settle(page);
    const {scrub, over} = await page.evaluate(() => {
      const bar = document.querySelector('.transport');
      return {scrub: document.getElementById('scrub').clientWidth, over: bar.scrollWidth - bar.clientWidth};
    });
    assert.ok(scrub >= 150 && over <= 0, `${width}: ${scrub}, ${over}`);
  }
  await page.setViewportSize({width: 1000, height: 600});
});

test('the policy lets no request out and no foreign script in', async () => {
  const failures = await page.evaluate(async () => {
    const tried = [];
    await fetch('https://example.org/').catch(() => tried.push('fetch'));
    const script = document.createElement('script');
    script.textContent = 'window.foreign = 1';
    document.body.append(script);
    if (!window.foreign) tried.push('script');
    return tried;
  });
  assert.deepEqual(failures, ['fetch', 'script']);
  const text = readFileSync(join(built, 'pliant.html'), 'utf8');
  assert.match(text, /Content-Security-Policy" content="default-src 'none'; script-src 'sha256-/);
  assert.doesNotMatch(text.slice(0, 2000), /unsafe-inline|unsafe-eval'(?<!wasm-unsafe-eval')/);
});

test('dark and light, and a background of one’s own', async () => {
  const corner = () => pixel(5, 300);
  const light = await corner();
  await page.click('#theme');
  const dark = await corner();
  assert.ok(light[0] > 200 && dark[0] < 60, `${light} ${dark}`);
  await page.fill('#background', '#336699');
  assert.deepEqual(await corner(), [0x33, 0x66, 0x99]);
  await page.click('#background-reset');
  await page.click('#theme');
  assert.deepEqual(await corner(), light);
});

test('each style and colouring draws another picture', async () => {
  await page.setViewportSize({width: 640, height: 420});
  await openExample(page, 'peptide_20.pdb');
  const {release} = await drag(page, await seenJoint(page, 2), 60, 40, {steps: 3});
  await release();
  const picture = () => page.evaluate(() => {
    P.stage.fading = false;
    P.view.draw();
    return document.getElementById('canvas').toDataURL();
  });
  for (const id of ['style', 'colouring']) {
    const seen = new Set();
    const names = await page.$$eval(`#${id} option:not(:disabled)`, (rows) => rows.map((row) => row.value));
    for (const name of names) {
      await page.selectOption(`#${id}`, name);
      seen.add(await picture());
    }
    assert.equal(seen.size, names.length, `${names}`);
  }
  await page.selectOption('#style', 'balls');
  await page.selectOption('#colouring', 'element');
  await page.setViewportSize({width: 1000, height: 600});
});

test('contacts are dashed lines that can be left out', async () => {
  const picture = () => page.evaluate(() => { P.view.draw(); return document.getElementById('canvas').toDataURL(); });
  assert.ok(await page.evaluate(() => P.stage.model.contacts.length) > 0);
  const colours = () => {
    const {contactKindColours: known, contactKinds: kinds} = P.stage.model;
    const {data} = P.view.textures.bars;
    const drawn = (k) => `#${data[4 * (P.view.textures.stickCount - kinds.length + k) + 3].toString(16).padStart(6, '0')}`;
    return Array.from(kinds, (kind, k) => drawn(k) === known[kind]);
  };
  assert.ok((await page.evaluate(colours)).every(Boolean), 'each in the colour of its kind');
  const withThem = await picture();
  await page.uncheck('#show-contacts');
  assert.notEqual(await picture(), withThem);
  await page.check('#show-contacts');
});

test('plots grow with the steps', async () => {
  await page.waitForFunction(() => document.getElementById('plot-rmsd-value').textContent !== '');
  for (const id of ['residual', 'sweeps', 'rmsd', 'rmsf'])
    assert.match(await page.textContent(`#plot-${id}-value`), /\d/);
  assert.match(await page.getAttribute('#plot-rmsd', 'aria-label'), /^RMSD from start, Å: \d/);
});

test('the help tells the keys, About what is inside', async () => {
  await page.focus('#canvas');
  await page.keyboard.press('?');
  assert.match(await page.textContent('#help'), /Space.*play/s);
  await page.keyboard.press('Escape');
  await page.click('#about-open');
  await page.waitForSelector('#about[open]');
  const text = await page.textContent('#about-notices');
  for (const name of ['Pliant (MIT)', 'musl']) assert.ok(text.includes(name), name);
  await page.keyboard.press('Escape');
});

test('complained of nothing', () => {
  const own = page.complaints.filter((text) => !/Content Security Policy|example\.org|HDF5|#0|major:|minor:/.test(text));
  assert.deepEqual(own, []);
});
});
