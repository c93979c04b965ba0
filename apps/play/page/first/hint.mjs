// SPDX-License-Identifier: MIT
// One line that says what to do first. It stands in its own row and goes with the first pull.
import {$} from '../panel/dom.mjs';

export class Hint {
  constructor(session, stage) {
    Object.assign(this, {session, stage});
    this.isDone = false;
    this.isDemo = false;  // what is pulled now is pulled by the page itself
    $('hint-close').onclick = () => this.done();
    stage.on('began', (model) => this.began(model));
    session.on('step', (step) => { if (step.forces?.length && !this.isDemo) this.pulled = true; });
    session.on('released', () => { if (this.pulled) this.done(); });
  }

  /** What is only watched cannot be pulled. */
  began(model) {
    $('hint-text').textContent = model.kind === 'graph' ? 'Drag any joint' : 'Drag any atom';
    $('hint').hidden = this.isDone || this.stage.isReplay;
  }

  done() {
    this.isDone = true;
    $('hint').hidden = true;
  }
}
