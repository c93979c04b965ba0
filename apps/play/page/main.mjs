// SPDX-License-Identifier: MIT
// The page: makes its parts and lets them hear of each other.
import './share/document.mjs';  // first: the page as it was loaded
import {Hand} from './hand.mjs';
import {Compare} from './panel/compare.mjs';
import {Demo} from './first/demo.mjs';
import {Distances} from './panel/distances.mjs';
import {$, fold, guarded, say} from './panel/dom.mjs';
import {Ensemble} from './panel/ensemble.mjs';
import {Hint} from './first/hint.mjs';
import {Constraints} from './panel/constraints.mjs';
import {FitBar} from './panel/fit_bar.mjs';
import {Forces} from './panel/forces.mjs';
import {Keys} from './panel/keys.mjs';
import {Look} from './panel/look.mjs';
import {MapShown} from './panel/map.mjs';
import {Measure} from './panel/measure.mjs';
import {Open} from './panel/open.mjs';
import {Path} from './panel/path.mjs';
import {Plots} from './panel/plots.mjs';
import {Readout} from './panel/readout.mjs';
import {Resolution} from './panel/resolution.mjs';
import {Resolve} from './panel/resolve.mjs';
import {Select} from './panel/select.mjs';
import {Stopped} from './panel/stopped.mjs';
import {Transport} from './panel/transport.mjs';
import {Wander} from './panel/wander.mjs';
import {Why} from './panel/why.mjs';
import {fromBase64} from './base64.mjs';
import {textInside} from './inside.mjs';
import {Host} from './host.mjs';
import {Live} from './live.mjs';
import {Session} from './session.mjs';
import {openPacked, openShared} from './share/share.mjs';
import {Stage} from './stage.mjs';
import {Labels} from './view/labels.mjs';
import {View} from './view/scene.mjs';

const FIRST = 'three_helices.pdb';  // opened where nothing was given
const WAY = [0, 1];  // of the hand of the start scene, on the screen

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
  parts.ensemble = new Ensemble(parts);
  parts.resolution = new Resolution(stage, session, view, hand);
  parts.stopped = new Stopped(session, stage);
  parts.forces = parts.open.forces = new Forces(session, stage);
  parts.fitBar = new FitBar(parts);
  parts.labels = new Labels(view, $('labels'));
  parts.measure = new Measure(parts);
  parts.distances = new Distances(parts);
  parts.map = new MapShown(parts);
  parts.select = new Select(parts);
  parts.plots = new Plots(stage);
  parts.why = new Why(parts);
  parts.constraints = new Constraints(parts);
  parts.transport.parts = parts;
  parts.keys = new Keys(parts);
  parts.hint = new Hint(session, stage);
  parts.demo = new Demo(parts);
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
  $('message-more').onclick = () => fold($('message-more').getAttribute('aria-expanded') === 'true');
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
  const {view, session, stage, hand, transport, resolution, wander, plots, demo} = parts;
  const frame = (now) => {
    const began = performance.now();
    demo.tick(now);
    hand.frame();
    wander.tick();
    transport.tick(now);
    resolution.tick(now);
    stage.tick(now);
    plots.tick(now);
    view.stale = view.quality.tick(now, view.stale) || view.stale;
    if (view.stale) {
      view.frame();
      parts.labels.draw();
    }
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
  const {name, data, gone, model, live, isInside, known, session, distances, map} = JSON.parse(block.textContent);
  if (gone) throw new Error(`${name} was handed out once. Call pliant play again, or drop the file here.`);
  const bytes = fromBase64(data);
  if (isInside) parts.host = new Host(parts);
  if (session) {
    await openPacked(parts, fromBase64(session));
    return true;
  }
  await parts.open.openBytes(name, bytes, model, known);
  if (distances) parts.distances.set(distances);
  if (map) parts.map.set(map);
  if (live) await new Live(parts).start(live);
  return true;
}

/** The start scene: the end of the third helix is swung out and back. */
async function first({open, session, stage, demo}, told) {
  await open.openExample(FIRST, 'protein');
  await session.change({technique: 'froda'});
  if (told) say(told);
  demo.start(stage.sites.at(-1), WAY);
}

async function begin() {
  const parts = makeParts();
  wire(parts);
  watchSize(parts.view);
  loop(parts);
  const facts = await parts.session.boot();
  const files = JSON.parse(await textInside('examples-inside'));
  for (const part of [parts.resolve, parts.open, parts.compare, parts.forces]) part.fill(facts, files);
  $('title').textContent = 'Open a file, drop one here, or choose an example';
  const hasFile = await guarded(async () => await openShared(parts) || given(parts));
  const told = $('message-text').textContent;
  if (hasFile) parts.demo.stop();
  else await first(parts, told);
  return {...parts, costs, facts, say};
}

/** The hint is to be read before the solver is unpacked. A page that nobody sees is not painted. */
const painted = () => new Promise((done) => {
  requestAnimationFrame(() => setTimeout(done));
  setTimeout(done, 200);
});

window.pliant = guarded(async () => {
  await painted();
  return begin();
});
