// SPDX-License-Identifier: MIT
// The recording as a film: WebM by the browser's own recorder, as it is played; and a loop, forth and
// back, as an animated PNG.
import {animated} from './apng.mjs';
import {atSize, pixelsOf} from './picture.mjs';

const [LOOP_WIDTH, MOST_FRAMES, LOOP_TIME] = [480, 48, 50];  // pixels, frames forth, ms a frame
const KINDS = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'];

function checked(stage) {
  if (stage.frames.length < 2) throw new Error('Nothing has been recorded that moves: pull on a joint first.');
}

/** Frames of the loop: there and back, none twice in a row. */
function loopOf(length, most = MOST_FRAMES) {
  const count = Math.min(length, most);
  const there = Array.from({length: count}, (_, k) => Math.round(k * (length - 1) / (count - 1)));
  return [...there, ...there.slice(1, -1).reverse()];
}

export async function loopPicture({view, stage}) {
  checked(stage);
  const at = stage.at;
  try {
    return await atSize(view, LOOP_WIDTH, async (height) => {
      const pictures = new Map();
      const order = loopOf(stage.frames.length);
      for (const k of order) {
        if (pictures.has(k)) continue;
        stage.show(k);
        pictures.set(k, pixelsOf(view, LOOP_WIDTH, height).data);
      }
      return animated(order.map((k) => pictures.get(k)), LOOP_WIDTH, height, LOOP_TIME);
    });
  } finally {
    if (at === null) stage.live();
    else stage.show(at);
  }
}

/** Plays the recording once, at the speed chosen, and records the canvas meanwhile. */
export async function film({view, stage, transport}) {
  checked(stage);
  const canvas = view.renderer.canvas;
  const mimeType = globalThis.MediaRecorder && KINDS.find((kind) => MediaRecorder.isTypeSupported(kind));
  if (!mimeType || !canvas.captureStream) throw new Error('This browser records no WebM video; the loop is an animated PNG.');
  const stream = canvas.captureStream(30);
  const recorder = new MediaRecorder(stream, {mimeType, videoBitsPerSecond: 8e6});
  const pieces = [];
  recorder.ondataavailable = ({data}) => pieces.push(data);
  const ended = new Promise((done) => { recorder.onstop = done; });
  transport.play(false);
  stage.show(0);
  recorder.start(SLICE);
  transport.play(true);
  await played(transport, view, () => pieces.some(({size}) => size > 0));
  recorder.stop();
  await ended;
  for (const track of stream.getTracks()) track.stop();
  return new Blob(pieces, {type: 'video/webm'});
}

const [SLICE, STILL, LONGEST_WAIT] = [100, 500, 5000];  // ms: of a piece, of the last frame, for a first piece

/** The recorder takes what is drawn, so something is, until the last frame was seen. */
function played(transport, view, hasBegun) {
  let ended = null;
  return new Promise((done) => {
    const look = (now) => {
      view.stale = true;
      if (!transport.playing) ended ??= now;
      const still = ended === null ? 0 : now - ended;
      if (still < STILL || (!hasBegun() && still < LONGEST_WAIT)) requestAnimationFrame(look);
      else done();
    };
    requestAnimationFrame(look);
  });
}
