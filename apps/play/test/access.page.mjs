// SPDX-License-Identifier: MIT
// For those who use no mouse, no eyes, or eyes that see fewer colours.
import assert from 'node:assert/strict';
import {before, describe, test} from 'node:test';
import {openExample, sharedPage, settle} from './support/browser.mjs';
import {SEEN, leastApart} from './support/vision.mjs';
import {CATEGORIES, domainColour, elementColour} from '../page/view/colours.mjs';
import {COLOURS} from '../page/view/uniforms.mjs';

const CONTROLS = new Set(['button', 'link', 'textbox', 'combobox', 'slider', 'spinbutton', 'checkbox', 'radio',
  'application', 'ColorWell', 'DisclosureTriangle', 'img', 'dialog', 'region', 'switch', 'menuitem']);

describe('access', () => {
let page;
before(async () => {
  page = await sharedPage();
  await page.setViewportSize({width: 1366, height: 768});
  await openExample(page, 'peptide_20.pdb');
});

const openAll = () => page.evaluate(() => { for (const box of document.querySelectorAll('details')) box.open = true; });

test('every control has a name for screen readers', async () => {
  await openAll();
  const client = await page.context().newCDPSession(page);
  const {nodes} = await client.send('Accessibility.getFullAXTree');
  const controls = nodes.filter(({ignored, role}) => !ignored && CONTROLS.has(role?.value));
  assert.ok(controls.length > 40, `${controls.length}`);
  const unnamed = controls.filter(({name}) => !name?.value?.trim()).map(({role, nodeId}) => `${role.value} ${nodeId}`);
  assert.deepEqual(unnamed, []);
});

/** What Tab comes to, from the start of the page until it comes to the start again. */
async function walk() {
  await page.evaluate(() => { document.activeElement.blur(); getSelection().removeAllRanges(); });
  await page.focus('#file');
  const seen = [];
  for (let k = 0; k < 160; ++k) {
    const found = await page.evaluate(() => {
      const at = document.activeElement;
      const drawn = at.matches('.unseen, .segments input') ? at.nextElementSibling ?? at.parentElement : at;
      const style = getComputedStyle(at.matches('input[type=file]') ? document.querySelector(`label[for=${at.id}].button`) : drawn);
      const key = at === document.body ? '' : at.id || at.value || at.textContent.trim();
      return {key, outline: style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) > 0};
    });
    if (seen.length > 3 && found.key === seen[0].key) break;
    if (found.key) seen.push(found);
    await page.keyboard.press('Tab');
  }
  return seen;
}

test('Tab comes to every control, in the order of the page, with a visible focus', async () => {
  await openAll();
  const seen = await walk();
  const keys = seen.map(({key}) => key);
  const wanted = await page.evaluate(() => [...document.querySelectorAll('button, select, input, summary, canvas[tabindex]')]
    .filter((x) => !x.disabled && x.getClientRects().length && x.type !== 'radio' && !x.closest('dialog')).map((x) => x.id || x.value || x.textContent.trim()));
  assert.deepEqual(wanted.filter((key) => !keys.includes(key)), []);
  const order = keys.filter((key) => wanted.includes(key));
  assert.deepEqual(order, wanted.filter((key) => order.includes(key)), 'the order of the page');
  assert.deepEqual(seen.filter(({outline}) => !outline).map(({key}) => key), []);
});

test('what was done is said in a live region', async () => {
  await page.focus('#canvas');
  assert.equal(await page.getAttribute('#said', 'role'), 'status');
  await page.keyboard.press('.');
  const name = await page.textContent('#said');
  assert.ok(name.length > 2);
  const said = () => page.textContent('#said');
  await page.keyboard.press('p');
  assert.match(await said(), /pinned/);
  await page.keyboard.press('p');
  assert.doesNotMatch(await said(), /, pinned/);
  await page.keyboard.press('.');
  await page.keyboard.press('Shift+ArrowRight');
  await page.waitForFunction(() => /moved/.test(document.getElementById('said').textContent));
  await page.keyboard.press('z');
  await page.waitForFunction(() => /taken back/.test(document.getElementById('said').textContent));
});

test('all of the picture by keys: move, nearer, the force in numbers', async () => {
  await page.focus('#canvas');
  const camera = () => page.evaluate(() => ({far: P.view.orbit.distance, at: [...P.view.orbit.target]}));
  const start = await camera();
  await page.keyboard.press('+');
  const near = await camera();
  assert.ok(near.far < start.far);
  await page.keyboard.press('Alt+ArrowRight');
  assert.notDeepEqual((await camera()).at, near.at);
  await page.keyboard.press('f');
  await settle(page);
});

describe('colours that mean different things can be told apart', () => {
  /** Each means something else; at least so far apart in CIELAB whatever the eye sees. */
  const sets = async () => {
    const text = (colour) => `#${colour.map((x) => x.toString(16).padStart(2, '0')).join('')}`;
    const numbers = {H: 1, C: 6, N: 7, O: 8, S: 16};
    const {longColour: long, shortColour: short} = COLOURS;
    const contacts = await page.evaluate(() => {
      const {contactKindNames: names, contactKindColours: colours} = P.stage.model;
      return Object.fromEntries(colours.map((colour, k) => [names[k], colour]));
    });
    return {
      categories: {colours: {...[...CATEGORIES, domainColour(-1)].map(text)}, least: 14},
      contacts: {colours: contacts, least: 15},
      elements: {colours: Object.fromEntries(Object.entries(numbers).map(([name, k]) => [name, text(elementColour(k))])), least: 20},
      strain: {colours: {long, short, plain: '#9aa3ad'}, least: 20},
    };
  };
  for (const seen of Object.keys(SEEN))
    test(seen, async () => {
      for (const [name, {colours, least}] of Object.entries(await sets())) {
        const {apart, pair} = leastApart(colours, seen);
        assert.ok(apart >= least, `${name}: ${pair.join(' and ')} are ${apart.toFixed(1)} apart`);
      }
    });
});
});
