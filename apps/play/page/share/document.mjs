// SPDX-License-Identifier: MIT
// The document as it was loaded, to be handed on with something else inside. Imported first: nothing
// of the page has changed then. The texts of scripts and styles are kept to the letter, so that the
// hashes of the page's policy hold.

const original = document.documentElement.cloneNode(true);

/** The text of the page with this block of data, {id, text}, in place of what was given to it. */
export function pageWith({id, text}) {
  const page = original.cloneNode(true);
  for (const old of page.querySelectorAll('#given, #shared')) old.remove();
  const policy = page.querySelector('meta[http-equiv="Content-Security-Policy"]');
  policy.content = policy.content.replace(/;\s*connect-src [^;]*/, '');  // no run is followed from there
  const block = document.createElement('script');
  block.type = 'application/octet-stream';
  block.id = id;
  block.textContent = text;
  page.querySelector('script').before(block);
  return `<!doctype html>\n${page.outerHTML}\n`;
}
