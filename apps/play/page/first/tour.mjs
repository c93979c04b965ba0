// SPDX-License-Identifier: MIT
// Six steps through the page, each at its control: it waits until it was done, or for Next. Esc leaves.
import {$} from '../panel/dom.mjs';

/** `at`: ids of the control, the first that is there; `until`: calls its word once it was done. */
const STEPS = [
  {
    name: 'Pull', at: ['canvas'], text: 'Drag any atom. All bonds, rings and contacts hold while it follows.',
    until: ({session}, done) => {
      let pulled = false;
      session.on('step', ({forces}) => { pulled ||= forces?.length > 0; });
      session.on('released', () => { if (pulled) done(); pulled = false; });
    },
  },
  {
    name: 'Pin', at: ['tools'], text: 'Choose Pin and click an atom: it stays where it is. Then choose Pull and drag another one.',
    until: ({session}, done) => session.on('pins', done),
  },
  {
    name: 'Why', at: ['canvas'], text: 'Keep pulling an atom that does not follow: a box says what holds it. One click there cuts a contact, Undo puts it back.',
    until: ({session}, done) => session.on('why', done),
  },
  {
    name: 'Compare', at: ['compare'], text: 'Repeat the last push with another technique, and see what it took.',
    until: (parts, done) => $('compare').addEventListener('click', done),
  },
  {
    name: 'Record', at: ['play'], text: 'All you did was recorded: play it, or draw the slider.',
    until: (parts, done) => { for (const id of ['play', 'scrub']) $(id).addEventListener('click', done); },
  },
  {
    name: 'Share', at: ['share', 'save'], text: 'Save it as a file that others can open.',
    until: (parts, done) => { for (const id of ['share', 'save']) $(id)?.addEventListener('change', done); $('share')?.addEventListener('click', done); },
  },
];

export class Tour {
  constructor(parts) {
    this.parts = parts;
    this.at = -1;
    for (const id of ['tour-start', 'hint-tour']) $(id).onclick = () => this.start();
    $('tour-next').onclick = () => this.next();
    $('tour-leave').onclick = () => this.leave();
    addEventListener('keydown', (event) => this.press(event));
    STEPS.forEach((step, k) => step.until(parts, () => { if (this.steps?.[this.at] === STEPS[k]) this.next(); }));
  }

  press({key}) {
    if (key === 'Escape' && this.at >= 0 && !document.querySelector('dialog[open]')) this.leave();
  }

  start() {
    this.steps = STEPS.filter((step) => controlOf(step));
    this.before = document.activeElement;
    $('hint').hidden = true;
    $('tour').hidden = false;
    this.show(0);
    $('tour-next').focus({preventScroll: true});
  }

  next() {
    if (this.at + 1 < this.steps.length) this.show(this.at + 1);
    else this.leave();
  }

  show(at) {
    this.unpoint();
    this.at = at;
    const {name, text} = this.steps[at];
    $('tour-count').textContent = `${at + 1} of ${this.steps.length}: ${name}.`;
    $('tour-text').textContent = text;
    $('tour-next').textContent = at + 1 < this.steps.length ? 'Next' : 'Done';
    this.point(controlOf(this.steps[at]));
  }

  /** Opens what the control is in and brings it into sight. */
  point(control) {
    if (document.body.classList.contains('wide') && $('side').contains(control)) $('side-toggle').click();
    for (let box = control.closest('details'); box; box = box.parentElement.closest('details')) box.open = true;
    control.classList.add('pointed-at');
    control.scrollIntoView({block: 'nearest'});
  }

  unpoint() {
    document.querySelector('.pointed-at')?.classList.remove('pointed-at');
  }

  leave() {
    this.unpoint();
    this.at = -1;
    $('tour').hidden = true;
    if (document.activeElement === document.body || !document.activeElement) $('canvas').focus({preventScroll: true});
  }
}

/** The control of a step, where the page has it: a run has no pins and no techniques. */
function controlOf({at}) {
  const isLive = document.body.classList.contains('live');
  return at.map($).find((control) => control && !(isLive && control.closest('.not-live')));
}
