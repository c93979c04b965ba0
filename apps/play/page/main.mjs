// SPDX-License-Identifier: MIT
// The page: makes its parts and lets them hear of each other.
import {Hand} from './hand.mjs';
import {Compare} from './panel/compare.mjs';
import {$, guarded, say} from './panel/dom.mjs';
import {Keys} from './panel/keys.mjs';
import {Look} from './panel/look.mjs';
import {Open} from './panel/open.mjs';
import {Path} from './panel/path.mjs';
import {Plots} from './panel/plots.mjs';
import {Readout} from './panel/readout.mjs';
import {Resolution} from './panel/resolution.mjs';
import {Resolve} from './panel/resolve.mjs';
import {Transport} from './panel/transport.mjs';
import {Wander} from './panel/wander.mjs';
import {textInside} from './inside.mjs';
import {Host} from './host.mjs';
import {Live} from './live.mjs';
import {Session} from './session.mjs';
import {Stage} from './stage.mjs';
import {View} from './view/scene.mjs';

const FIRST = 'caffeine.sdf';  // opened where nothing was given

function makeView() {
  try {
    return new View($('canvas'));
  } catch {
    throw new Error('This browser gives no WebGL 2: the picture cannot be drawn. Hardware acceleration may be switched off in its settings.');
  }
}

function makeParts() {
  const view = makeView();
  const session = new Session();
  const stage = new Stage(view, session);
  const hand = new Hand($('canvas'), view, session);
  const parts = {view, session, stage, hand};
  parts.look = new Look(view, stage);
  parts.resolve = new Resolve(session, stage);
  parts.readout = new Readout(stage, session, hand);
  parts.open = new Open(session, stage, hand);
  parts.transport = new Transport(stage, session, view);
  parts.compare = new Compare(stage, session, view);
  parts.wander = new Wander(stage, session, view);
  parts.path = new Path(stage, session);
  parts.resolution = new Resolution(stage, session, view, hand);
  parts.plots = new Plots(stage);
  parts.keys = new Keys(parts);
  return parts;
}

/** The force follows the pointer, or is a vector in numbers. */
function chooseHand(hand) {
  const isVector = $('hand').value === 'vector';
  $('vector').hidden = !isVector;
  hand.vector = isVector ? ['x', 'y', 'z'].map((axis) => Number($(`vector-${axis}`).value) || 0) : null;
}

function wire({view, session, stage, hand}) {
  for (const input of document.querySelectorAll('[name=tool]'))
    input.onchange = () => { hand.tool = input.value; };
  $('strength').onchange = () => { hand.strength = $('strength').value; };
  for (const id of ['hand', 'vector-x', 'vector-y', 'vector-z']) $(id).onchange = () => chooseHand(hand);
  $('pins-clear').onclick = () => session.clearPins();
  $('message-close').onclick = () => say('');
  $('side-toggle').onclick = () => {
    const isWide = document.body.classList.toggle('wide');
    $('side-toggle').setAttribute('aria-pressed', !isWide);
  };
  $('fit').onclick = () => {
    if (!stage.model) return;
    const frame = stage.at === null ? session.positions : stage.frames.at(stage.at).positions;
    view.orbit.frame(frame, view.unit);
    view.stale = true;
  };
  session.on('error', (error) => say(error.message));
}

function watchSize(view) {
  const fit = () => view.resize($('stage').clientWidth, $('stage').clientHeight,
    Math.min(devicePixelRatio || 1, 2));
  new ResizeObserver(fit).observe($('stage'));
  fit();
}

/** JavaScript of a frame, ms, by the last hundred: what the page itself costs. */
const costs = [];

function loop(parts) {
  const {view, session, stage, hand, transport, resolution, wander, plots} = parts;
  const frame = (now) => {
    const began = performance.now();
    hand.frame();
    wander.tick();
    transport.tick(now);
    resolution.tick(now);
    stage.tick(now);
    plots.tick(now);
    view.stale = view.quality.tick(now, view.stale) || view.stale;
    if (view.stale) view.frame();
    session.live?.tick(now);
    costs.push(performance.now() - began);
    if (costs.length > 100) costs.shift();
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
}

/** A file that `pliant play FILE` has put into the page, and the run that it belongs to. */
async function given(parts) {
  const block = $('given');
  if (!block) return false;
  const {name, data, gone, model, live, isInside, known} = JSON.parse(block.textContent);
  if (gone) throw new Error(`${name} was handed out once. Call pliant play again, or drop the file here.`);
  const bytes = Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
  if (isInside) parts.host = new Host(parts);
  await parts.open.openBytes(name, bytes, model, known);
  if (live) await new Live(parts).start(live);
  return true;
}

async function begin() {
  const parts = makeParts();
  wire(parts);
  watchSize(parts.view);
  loop(parts);
  const facts = await parts.session.boot();
  const files = JSON.parse(await textInside('examples-inside'));
  for (const part of [parts.resolve, parts.open, parts.compare]) part.fill(facts, files);
  $('title').textContent = 'Open a file, drop one here, or choose an example';
  const hasFile = await guarded(() => given(parts));
  const told = $('message-text').textContent;
  if (!hasFile) {
    await parts.open.openExample(FIRST);
    if (told) say(told);
  }
  return {...parts, costs, facts};
}

window.pliant = guarded(begin);
