// SPDX-License-Identifier: MIT
// A path from what is open to another structure of it: found by the worker, shown as it grows, and
// then a recording like any other.
import {unzipped} from '../inside.mjs';
import {$, guarded, say, units} from './dom.mjs';

const ASKED = 60;  // ms of steps in one request: what is drawn between two stays smooth
const ATTEMPTS = 10;  // of going back, where that is chosen

const stemOf = (name) => (name || 'start').replace(/\.(gz|pdb|ent|cif|mmcif)$/i, '').replace(/\.(pdb|ent|cif|mmcif)$/i, '');

export class Path {
  constructor(stage, session) {
    Object.assign(this, {stage, session});
    this.isOn = false;
    this.milliseconds = ASKED;
    $('path-file').onchange = () => this.chosen();
    $('path-stop').onclick = () => this.stop('Stopped');
    stage.on('began', () => this.stop());
  }

  chosen() {
    const [file] = $('path-file').files;
    $('path-file').value = '';
    return file && guarded(async () => this.begin(file.name, new Uint8Array(await file.arrayBuffer())));
  }

  /** From the file that is open, wherever its joints have been pulled to. */
  async begin(name, bytes) {
    say('');
    const {session, stage} = this;
    if (!session.source || session.live || (stage.isReplay && !this.isShown))
      throw new Error('Open a structure first: a path begins at a molecule of a file.');
    const [source, start] = [session.source, this.isShown ? this.start : session.fileName];
    const file = await unzipped(name, bytes);
    const model = await session.begin({do: 'path', name: file.name, bytes: file.bytes, ...this.options()});
    session.source = source;  // another model opens the start anew
    session.fileName = `${stemOf(start)}_to_${stemOf(file.name)}`;
    stage.isReplay = true;
    stage.recording = true;
    stage.tell('began', model);
    Object.assign(this, {start, isOn: true, isShown: true});
    $('path-stop').disabled = false;
    $('path-panel').open = true;
    await this.go();
  }

  options() {
    return {
      atoms: $('path-atoms').value, both: $('path-both').checked,
      backtrack: $('path-backtrack').checked ? ATTEMPTS : 0,
    };
  }

  async go() {
    try {
      while (this.isOn) {
        const found = await this.session.ask('path_steps', {milliseconds: this.milliseconds});
        if (this.isOn) this.take(found);
      }
    } catch (error) {
      this.stop('Ended by an error');
      throw error;
    }
  }

  /** Frames that are new, in place of those after the first `kept`. */
  take(found) {
    const {stage} = this;
    const follows = stage.at === null || stage.at === stage.frames.length - 1;
    if (found.kept < stage.frames.length)
      stage.undone({positions: stage.frames.at(0).positions, step: found.kept - 1});
    for (const frame of found.frames) if (frame.step > 0) this.hold(frame);
    if (follows) stage.show(stage.frames.length - 1);
    else stage.tell('changed');
    this.found = found;
    if (found.over) this.stop(found.arrived ? 'Arrived' : 'Did not arrive', found.notes);
    else this.tell();
  }

  hold(frame) {
    const {stage} = this;
    stage.remember(frame);
    if (stage.frames.add(frame)) return;
    stage.stopFull();
    this.stop('Stopped, as there is no room for more');
  }

  tell() {
    const {left, attempts} = this.found;
    const told = [`${this.state ?? 'On the way'}: ${left.toFixed(2)} Å from the end`,
      units(this.stage.frames.length, 'frame')];
    if (attempts) told.push(`went back ${units(attempts, 'time')}`);
    $('path-note').textContent = [`${told.join(', ')}.`, ...(this.notes ?? [])].join('\n');
  }

  /** Also where something else has been opened, which says nothing. */
  stop(state, notes) {
    Object.assign(this, {isOn: false, state, notes});
    $('path-stop').disabled = true;
    if (state) return this.found && this.tell();
    Object.assign(this, {isShown: false, found: null});
    $('path-note').textContent = 'Frames with exact bonds and angles to another structure of the molecule, as pliant path finds them.';
    return undefined;
  }
}
