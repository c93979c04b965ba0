// SPDX-License-Identifier: MIT
// The same acts in Chromium and in Firefox.
import {after, before, describe, test} from 'node:test';
import {ACTS} from './support/acts.mjs';
import {openPage} from './support/browser.mjs';
import {missing, openFirefox} from './support/firefox.mjs';

/** Playwright's takes the argument before the options. */
async function openChromium() {
  const page = await openPage({viewport: {width: 1000, height: 600}, wait: 60000});
  const wait = page.waitForFunction.bind(page);
  page.waitForFunction = (look, options, argument) => wait(look, argument, options);
  return {page, close: () => page.context().close()};
}

const BROWSERS = {chromium: {open: openChromium, lacks: ''}, firefox: {open: openFirefox, lacks: missing()}};

for (const [name, {open, lacks}] of Object.entries(BROWSERS))
  describe(`both: ${name}`, {skip: lacks || false}, () => {
    let opened;
    before(async () => { opened = await open(); });
    after(() => opened?.close());
    for (const [act, run] of Object.entries(ACTS)) test(act, () => run(opened.page));
  });
