// SPDX-License-Identifier: MIT
// pliant.view in JupyterLab: node apps/play/test/from_python/notebook.mjs ADDRESS [PICTURE]. ADDRESS is of a
// notebook whose first cell shows a view and whose second one writes what it tells. Runs the first,
// drags a joint, runs the second; prints where the page has the joints, as JSON.
import {drag, openTab, quit, seenJoint} from '../support/browser.mjs';

const [address, picture] = process.argv.slice(2);

/** Runs the cell of this number. */
async function runCell(lab, number) {
  await lab.locator('.jp-Notebook .jp-CodeCell').nth(number).locator('.jp-InputArea-editor').click();
  await lab.keyboard.press('Control+Enter');
}

/** The page in the output of the first cell, once its solver stands. */
async function pageInside(lab) {
  const handle = await lab.waitForSelector('iframe[title="Pliant play"]');
  await handle.scrollIntoViewIfNeeded();
  const frame = await handle.contentFrame();
  await frame.waitForFunction(() => window.pliant);
  await frame.evaluate(() => window.pliant.then((parts) => { window.P = parts; }));
  return {frame, box: () => handle.boundingBox()};
}

const lab = await openTab(address);
await lab.waitForSelector('.jp-Notebook .jp-CodeCell');
await lab.waitForSelector('.jp-Notebook-ExecutionIndicator[data-status="idle"]', {state: 'attached'});
await runCell(lab, 0);
const {frame, box} = await pageInside(lab);
const joint = await seenJoint(frame, 2);
const {release} = await drag(frame, joint, 40, -25, {steps: 5, mouse: lab.mouse, corner: await box()});
if (picture) await lab.screenshot({path: picture});
await release();
await frame.waitForFunction(() => P.host.told === P.session.positions);
const positions = await frame.evaluate(() => [...P.session.positions]);
await runCell(lab, 1);
await lab.waitForSelector('.jp-OutputArea-output:has-text("written")');
console.log(JSON.stringify({joint, positions, complaints: lab.complaints}));
await quit();
