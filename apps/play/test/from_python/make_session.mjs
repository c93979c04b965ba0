// SPDX-License-Identifier: MIT
// Opens a molecule in the page, pulls on it by the mouse and saves what came of it:
// node make_session.mjs FILE FOLDER [TECHNIQUE] [MODEL]. Writes session.h5md, session.pdb and
// session.forces.txt to FOLDER, and session.html, the page that is shared; prints how many steps there were.
import {copyFileSync, readFileSync} from 'node:fs';
import {basename, join} from 'node:path';
import {drag, openPage, quit, saved} from '../support/browser.mjs';

const STEPS = 5;

/** A joint that is seen near a place, in shares of the picture. */
function jointNear(page, x, y) {
  return page.evaluate(([right, down]) => {
    const {width, height} = P.view.orbit.size;
    return P.view.pick(right * width, down * height, 80).joint;
  }, [x, y]);
}

async function pullAbout(page) {
  for (const [x, y, dx, dy] of [[0.5, 0.5, 80, -40], [0.4, 0.6, -60, 50]]) {
    const joint = await jointNear(page, x, y);
    const {release} = await drag(page, joint, dx, dy, {steps: STEPS});
    await release();
    await page.waitForFunction(() => !P.hand.busy);
  }
}

async function make(file, folder, technique = 'auto', model = 'auto') {
  const page = await openPage({viewport: {width: 940, height: 560}});
  page.setDefaultTimeout(60000);
  const given = {name: basename(file), data: readFileSync(file).toString('base64'), model, technique};
  await page.evaluate(async ({name, data, model: held, technique: how}) => {
    await P.open.openBytes(name, Uint8Array.from(atob(data), (c) => c.charCodeAt(0)), held);
    await P.session.change({technique: how});
  }, given);
  await pullAbout(page);
  for (const [kind, name] of [['h5md', 'session.h5md'], ['pdb', 'session.pdb'], ['forces', 'session.forces.txt']])
    copyFileSync((await saved(page, kind)).path, join(folder, name));
  const [shared] = await Promise.all([page.waitForEvent('download'), page.click('#share')]);
  copyFileSync(await shared.path(), join(folder, 'session.html'));
  console.log(await page.evaluate(() => JSON.stringify({
    steps: P.stage.history.length, joints: P.stage.model.joints, model: P.stage.model.model,
  })));
}

try {
  await make(...process.argv.slice(2));
} finally {
  await quit();
}
