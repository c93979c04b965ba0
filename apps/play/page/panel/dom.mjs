// SPDX-License-Identifier: MIT
// Elements by id, and options of a select. Text is always text: nothing here makes markup of it.

export const $ = (id) => document.getElementById(id);

export function element(tag, text = '', attributes = {}) {
  const made = document.createElement(tag);
  made.textContent = text;
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  return made;
}

/** Replaces the options of a select by [{name, title}]. */
export function fillSelect(select, rows, chosen) {
  select.replaceChildren(...rows.map(({name, title}) => new Option(title ?? name, name)));
  if (chosen !== undefined && rows.some((row) => row.name === chosen)) select.value = chosen;
}

/** A number as the field writes it: short, with an exponent where it is small. */
export function shortNumber(value) {
  if (!Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  return size < 1e-3 || size >= 1e6 ? value.toExponential(1) : String(Number(value.toPrecision(3)));
}

const units = (count, one, many = `${one}s`) => `${count.toLocaleString('en')} ${count === 1 ? one : many}`;
export {units};

const SHORT = 90;  // letters of a note that stands in one line

/** Tells what went wrong, or what is to be known, in a row of its own above the picture. Long notes
 * are folded, what went wrong never is. */
export function say(text, isNote = false) {
  const notes = text.split('\n').length;
  $('message-text').textContent = text;
  $('message').classList.toggle('note-only', isNote);
  $('message').hidden = !text;
  $('message-more').hidden = !isNote || (notes < 2 && text.length <= SHORT);
  $('message-more').textContent = units(notes, 'note');
  fold(!$('message-more').hidden);
}

/** Shows the first line of a note, or all of it. */
export function fold(isFolded) {
  $('message').classList.toggle('folded', isFolded);
  $('message-more').setAttribute('aria-expanded', !isFolded);
}

/** Runs what may fail; the error goes to the user. */
export async function guarded(action) {
  try {
    return await action();
  } catch (error) {
    say(error.message || String(error));
    return undefined;
  }
}

/** Hands name and bytes of a file that is chosen to `open`. */
export function whenChosen(id, open) {
  $(id).onchange = () => {
    const [file] = $(id).files;
    $(id).value = '';
    return file && guarded(async () => open(file.name, new Uint8Array(await file.arrayBuffer())));
  };
}
