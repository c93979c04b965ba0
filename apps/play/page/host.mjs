// SPDX-License-Identifier: MIT
// The page within another one, a notebook: tells that where the molecule is.
import {$} from './panel/dom.mjs';
import {packedSession} from './share/share.mjs';

const EVERY = 200;  // ms between two tellings while it moves; the last place is always told
const RESTS = 1500;  // ms without a change after which the host is told what to save
const MOST_SAVED = 16 * 1024 * 1024;  // bytes of frames; more are not saved with a notebook

export class Host {
  constructor(parts) {
    const {session, stage, look} = parts;
    Object.assign(this, {session, stage, parts});
    addEventListener('message', ({source, data}) => {
      if (source === parent && data?.tell === 'theme') look.setTheme(data.theme);
    });
    parent.postMessage({tell: 'theme'}, '*');  // asks for it
    $('side-toggle').click();  // a cell is narrow: the panel is there when it is asked for
    stage.on('began', (model) => this.began(model));
    stage.on('changed', () => { this.timer ??= setTimeout(() => this.moved(), EVERY); });
    stage.on('changed', () => {
      clearTimeout(this.rest);
      this.rest = setTimeout(() => this.rested(), RESTS);
    });
  }

  began(model) {
    const names = Array.from({length: model.joints}, (_, joint) => model.nameOf(joint));
    parent.postMessage({tell: 'opened', model: model.model, names}, '*');
  }

  moved() {
    this.timer = null;
    const {session, stage} = this;
    const positions = stage.at === null ? session.positions : stage.frames.at(stage.at).positions;
    if (positions === this.told) return;
    this.told = positions;
    parent.postMessage({tell: 'moved', positions: positions.slice()}, '*');
  }

  /** What is kept with the notebook: a picture, and what was done. */
  async rested() {
    const {view, stage} = this.parts;
    const canvas = view.renderer.canvas;
    const shown = await new Promise((done) => { view.draw(); canvas.toBlob(done, 'image/png'); });
    if (!shown) return;
    const isSmall = stage.frames.bytes <= MOST_SAVED;
    const session = isSmall ? await packedSession(this.parts) : new Uint8Array();
    parent.postMessage({tell: 'rested', picture: new Uint8Array(await shown.arrayBuffer()), session}, '*');
  }
}
