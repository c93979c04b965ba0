// SPDX-License-Identifier: MIT
// The page of pliant play in the output of a cell. The kernel sends the page, which runs in a frame
// of no origin: it reaches neither the notebook nor the network. What it tells goes to the kernel.

const unpacked = (bytes) => new Response(
  new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).text();

function makeFrame(height) {
  const frame = document.createElement('iframe');
  frame.title = 'Pliant play';
  frame.setAttribute('sandbox', 'allow-scripts allow-downloads');
  Object.assign(frame.style, {
    width: '100%', height: `${height}px`, border: '1px solid rgb(128 128 128 / 40%)', borderRadius: '6px',
  });
  return frame;
}

function render({model, el}) {
  const frame = makeFrame(model.get('height'));
  el.append(frame);
  const fromKernel = async ({tell}, buffers) => {
    if (tell === 'page' && !frame.srcdoc) frame.srcdoc = await unpacked(buffers[0]);
  };
  const fromPage = ({source, data}) => {
    if (source !== frame.contentWindow || !data?.tell) return;
    const {positions, ...facts} = data;
    model.send(facts, undefined, positions ? [positions.buffer] : []);
  };
  model.on('msg:custom', fromKernel);
  addEventListener('message', fromPage);
  model.send({tell: 'ready'});
  return () => {
    removeEventListener('message', fromPage);
    model.off('msg:custom', fromKernel);
  };
}

export default {render};
