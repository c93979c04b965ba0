// SPDX-License-Identifier: MIT
// The page within another one, a notebook: tells that where the molecule is.
import {$} from './panel/dom.mjs';

const EVERY = 200;  // ms between two tellings while it moves; the last place is always told

export class Host {
  constructor({session, stage}) {
    Object.assign(this, {session, stage});
    $('side-toggle').click();  // a cell is narrow: the panel is there when it is asked for
    stage.on('began', (model) => this.began(model));
    stage.on('changed', () => { this.timer ??= setTimeout(() => this.moved(), EVERY); });
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
}
