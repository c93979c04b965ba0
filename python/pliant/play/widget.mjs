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

/** Of the notebook, not of the system: JupyterLab and VS Code say it of their body. */
function themeOf({dataset, classList}) {
  if (dataset.jpThemeLight) return dataset.jpThemeLight === 'true' ? 'light' : 'dark';
  if (/vscode-/.test(classList.value)) return /vscode-(dark|high-contrast(?!-light))/.test(classList.value) ? 'dark' : 'light';
  return null;
}

/** What was shown when the notebook was saved, until a kernel sends the page. */
function showPicture(model, el) {
  const bytes = model.get('picture');
  if (!bytes?.byteLength) return null;
  const picture = document.createElement('img');
  picture.src = URL.createObjectURL(new Blob([bytes], {type: 'image/png'}));
  picture.alt = 'The molecule as it was shown last';
  Object.assign(picture.style, {maxWidth: '100%', maxHeight: `${model.get('height')}px`});
  el.append(picture);
  return picture;
}

function render({model, el}) {
  const frame = makeFrame(model.get('height'));
  const picture = showPicture(model, el);
  const sayTheme = () => {
    const theme = themeOf(document.body);
    if (theme) frame.contentWindow?.postMessage({tell: 'theme', theme}, '*');
  };
  const watch = new MutationObserver(sayTheme);
  watch.observe(document.body, {attributes: true, attributeFilter: ['class', 'data-jp-theme-light']});
  const fromKernel = async ({tell}, buffers) => {
    if (tell !== 'page' || frame.srcdoc) return;
    frame.srcdoc = await unpacked(buffers[0]);
    picture?.remove();
    el.append(frame);
  };
  const fromPage = ({source, data}) => {
    if (source !== frame.contentWindow || !data?.tell) return;
    const {positions, picture: shown, session, ...facts} = data;
    if (facts.tell === 'theme') sayTheme();
    else model.send(facts, undefined, [positions, shown, session].filter(Boolean).map((array) => array.buffer));
  };
  model.on('msg:custom', fromKernel);
  addEventListener('message', fromPage);
  model.send({tell: 'ready'});
  return () => {
    watch.disconnect();
    removeEventListener('message', fromPage);
    model.off('msg:custom', fromKernel);
  };
}

export default {render};
