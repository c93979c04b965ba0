// SPDX-License-Identifier: MIT
// Share: the page with the session inside, in one file. What was recorded is there bit by bit; and
// what the solver was asked for, which it does once more where the file is opened, so that the session
// goes on from where it was.
import {fromBase64, toBase64} from '../base64.mjs';
import {guarded, say} from '../panel/dom.mjs';
import {pageWith} from './document.mjs';
import {differences, packed, summed, unpacked} from './pack.mjs';

const BLOCK = 'shared';
const VERSION = 1;

/** Frames without positions, which lie together. */
function framesOf(stage) {
  const list = stage.frames.list;
  return {
    positions: differences(list.map(({positions}) => positions)),
    facts: list.map(({positions: _, broken: __, ...facts}) => facts),
  };
}

function lookOf({view, stage, look}) {
  const {style} = view;
  return {style, colouring: stage.colouring, theme: look.theme};
}

/** Bytes of a session, and of all that was recorded. Throws Error if nothing is open. */
export async function packedSession(parts) {
  const {session, stage} = parts;
  if (!stage.frames.length) throw new Error('Nothing is recorded that could be shared.');
  const isOwn = !session.live && !stage.isReplay;
  const content = {
    version: VERSION, name: session.fileName, look: lookOf(parts), frames: framesOf(stage), at: stage.at,
    ...(isOwn ? {source: session.source, asked: session.asked, strokes: session.strokes, pins: session.pins}
      : {model: stage.model, timestep: session.settings.timestep}),
  };
  return packed(content);
}

/** Text of a page with this session. Throws Error if nothing is open. */
export async function sharedPage(parts) {
  return pageWith({id: BLOCK, text: toBase64(await packedSession(parts))});
}

/** Opens what Share has put into this page; false if there is nothing. */
export async function openShared(parts) {
  const block = document.getElementById(BLOCK);
  if (!block) return false;
  await openPacked(parts, fromBase64(block.textContent));
  return true;
}

/** Opens the bytes of packedSession(). */
export async function openPacked(parts, bytes) {
  const content = await unpacked(bytes);
  if (content.version !== VERSION) throw new Error('What this page holds was shared by another version of Pliant.');
  const {positions, facts} = content.frames;
  const frames = summed(positions, facts.length).map((row, k) => ({...facts[k], positions: row}));
  if (content.source) await openSession(parts, content, frames);
  else openWatched(parts, content, frames);
  await guarded(() => setLook(parts, content.look));
}

async function openSession({session, stage}, content, frames) {
  const {source, asked, strokes, pins} = content;
  await session.begin(source);
  await session.repeat(asked, {strokes, pins});
  stage.restore(frames, content.at);
  const [end, last] = [session.positions, frames.at(-1).positions];
  if (frames.at(-1).step === session.step && !end.every((x, k) => Object.is(x, last[k])))
    say('The solver comes to other positions here than where this was recorded; the recording is as it was.', true);
}

function openWatched({session, stage}, {model, name, at, timestep}, frames) {
  const {names, bars} = model;
  model.nameOf = (joint) => names[joint] ?? `joint ${joint}`;
  model.barName = (bar) => `${model.nameOf(bars[2 * bar])} – ${model.nameOf(bars[2 * bar + 1])}`;
  stage.replay(model, frames);
  session.fileName = name;
  if (timestep) session.settings.timestep = timestep;
  stage.show(at ?? frames.length - 1);
}

function setLook({look}, {style, colouring, theme}) {
  look.setTheme(theme);
  look.setStyle(style);
  look.setColouring(colouring);
}
