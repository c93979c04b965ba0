// SPDX-License-Identifier: MIT
// The recording as a film, by the browser's own recorder, as it is played.

// The first that the browser writes: WebM plays in all of them, Safari records MP4 alone.
const KINDS = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm', 'video/mp4'];

/** "video/webm", or what this browser has in place of it; undefined if it records no video. */
const kind = () => globalThis.MediaRecorder && KINDS.find((name) => MediaRecorder.isTypeSupported(name));
export const filmEnding = () => (kind()?.includes('mp4') ? 'mp4' : 'webm');

function checked(stage) {
  if (stage.frames.length < 2) throw new Error('Nothing has been recorded that moves: pull on a joint first.');
}

/** Plays the recording once, at the speed chosen, and records the canvas meanwhile. */
export async function film({view, stage, transport}) {
  checked(stage);
  const canvas = view.renderer.canvas;
  const mimeType = kind();
  if (!mimeType || !canvas.captureStream) throw new Error('This browser records no video.');
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
  return new Blob(pieces, {type: mimeType});
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
