// SPDX-License-Identifier: MIT
// Frames that stand for many, as small pictures to click.
import {$, element} from './dom.mjs';
import {drawThumbnail} from '../view/thumbnail.mjs';

export class Shapes {
  constructor(stage, view, show) {
    Object.assign(this, {stage, view, show});
    this.buttons = [];
    stage.on('began', () => { this.waiting = []; });
  }

  /** `found`: title, about and rows of {frame, text}; `indexOf`: of a frame among those held. */
  open(found, indexOf) {
    const rows = (found?.rows ?? []).map((row) => ({...row, index: indexOf(row.frame)})).filter(({index}) => index >= 0);
    $('ensemble-shapes-title').parentElement.hidden = !rows.length;
    if (!rows.length) return;
    $('ensemble-shapes-title').textContent = found.title;
    $('ensemble-shapes-note').textContent = found.about;
    this.buttons = rows.map((row) => this.button(row));
    $('ensemble-shapes').replaceChildren(...this.buttons.map(({made}) => made));
    this.waiting = [...this.buttons];
    this.drawNext();
  }

  button({frame, text, index}) {
    const made = element('button', '', {type: 'button', 'aria-pressed': 'false'});
    const canvas = element('canvas', '', {'aria-hidden': 'true'});
    made.append(canvas, element('span', `Frame ${frame}`), element('small', text));
    made.onclick = () => this.show(index);
    return {made, canvas, index};
  }

  /** One a frame of the screen, so that the page goes on. */
  drawNext() {
    const next = this.waiting.shift();
    if (!next) return;
    const {stage, view} = this;
    const {positions} = stage.frames.at(next.index);
    drawThumbnail(view, next.canvas, positions, stage.frames.at(stage.at ?? 0).positions);
    requestAnimationFrame(() => this.drawNext());
  }

  mark(at) {
    for (const {made, index} of this.buttons) made.setAttribute('aria-pressed', index === at);
  }
}
