// SPDX-License-Identifier: MIT
// The page on a run: pliant run --imd, pliant play --connect, and a hand that pulls.
import assert from 'node:assert/strict';
import {spawn} from 'node:child_process';
import {existsSync, mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {dirname, join} from 'node:path';
import {after, before, describe, test} from 'node:test';
import {built, openPage, placeOf, root, seenJoint, settle} from './support/browser.mjs';

const COMMAND = process.env.PLIANT_COMMAND || join(root, '.venv', 'bin', 'pliant');
const PEPTIDE = join(root, 'data', 'molecules', 'peptide_20.pdb');

/** pliant play of the page that was built, and not of the one that is installed. */
const PLAY = `
import pathlib, sys
from pliant.play import command, page
page.PAGE = pathlib.Path(sys.argv[1])
sys.exit(command.main(sys.argv[2:]))`;

/** A program, the first text of its output that fits, and its exit code. */
function start(words, pattern, stream, folder) {
  const child = spawn(words[0], words.slice(1), {cwd: folder});
  const job = {child, said: ''};
  job.ended = new Promise((done) => child.on('close', done));
  job.found = new Promise((found, failed) => {
    const take = (text) => {
      job.said += text;
      const match = pattern.exec(job.said);
      if (match) found(match[1]);
    };
    for (const name of ['stdout', 'stderr']) child[name].setEncoding('utf8').on('data', take);
    child.on('close', () => failed(new Error(`ended: ${job.said}`)));
  });
  return job;
}

const connected = (port) => start([join(dirname(COMMAND), 'python'), '-c', PLAY, join(built, 'pliant.html'),
  '--connect', `:${port}`, PEPTIDE, '--no-open'], /(http:\S+)\n/);

describe('live', () => {
let folder;
let run;
let play;
let page;
before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'pliant-live-'));
  run = start([COMMAND, 'run', PEPTIDE, '-o', 'run.h5md', '--steps', '1000000000', '--every', '1000000',
    '--force', '0', '--damping', '1', '--technique', 'bfs_cycle', '--imd', '0'], /127\.0\.0\.1:(\d+)/, 'stderr', folder);
  play = connected(await run.found);
  page = await openPage({address: await play.found, viewport: {width: 1000, height: 600}});
});
after(async () => {
  for (const job of [run, play]) job?.child.kill('SIGKILL');
  await page?.context().close();
  rmSync(folder, {recursive: true, force: true});
});

const number = async (id) => Number((await page.textContent(id)).replaceAll(',', ''));
const positionOf = (joint) => page.evaluate((j) => [...P.session.positions.subarray(3 * j, 3 * j + 3)], joint);

test('frames of the run come, and what they are is told', async () => {
  const first = await number('#out-step');
  await page.waitForFunction((step) => P.session.live.step > step, first);
  await settle(page);
  assert.ok(await number('#out-step') > first);
  assert.ok(await number('#out-rate') > 0);
  assert.ok(await number('#out-pace') > 0);
  assert.equal(await page.textContent('#out-verdict'), 'Live');
  assert.equal(await page.isVisible('#technique'), false);
});

test('a drag pulls on the atom of the run, and the run goes on when it ends', async () => {
  const joint = await seenJoint(page, 3);
  const [from, start] = [await placeOf(page, joint), await positionOf(joint)];
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  for (let k = 1; k <= 4; ++k) await page.mouse.move(from.x + 25 * k, from.y - 15 * k);
  await page.waitForFunction(([j, at]) => {
    const apart = (point) => Math.hypot(...P.hand.held.target.map((x, c) => x - point[c]));
    return apart(P.session.positions.subarray(3 * j, 3 * j + 3)) < 0.7 * apart(at);
  }, [joint, start]);
  if (process.env.PLIANT_PICTURES) await page.screenshot({path: join(process.env.PLIANT_PICTURES, 'live.png')});
  await page.mouse.up();
  assert.equal(await page.evaluate(() => P.session.live.isPulling), false);
  await page.evaluate(() => P.session.live.next());
  assert.ok(await page.evaluate(() => P.stage.frames.list.every((frame) => frame.residual <= 1e-6)));
});

test('the past is looked at while the run goes on', async () => {
  await page.evaluate(() => P.stage.show(1));
  await page.evaluate(() => P.session.live.next());
  assert.equal(await page.evaluate(() => P.stage.at), 1);
  await page.click('#live');
  assert.equal(await page.evaluate(() => P.stage.at), null);
});

test('a run that stands still is waited for', async () => {
  run.child.kill('SIGSTOP');
  const says = (text) => page.waitForFunction((t) => document.getElementById('out-verdict').textContent === t, text);
  await says('Waiting for the run');
  run.child.kill('SIGCONT');
  await says('Live');
});

test('a second page joins, and each sees what the other pulls with', async () => {
  const second = await openPage({address: await play.found, viewport: {width: 640, height: 420}});
  await second.waitForFunction(() => P.session.live.rates.frames > 0);
  assert.equal(await page.evaluate(() => Boolean(P.session.live.isOver)), false);
  await second.evaluate(() => P.session.live.pull([[7, 0, 0, 1]]));
  await page.waitForFunction(() => P.session.live.others.rows.length === 1);
  assert.deepEqual(await page.evaluate(() => P.session.live.others.rows), [[7, 0, 0, 1]]);
  assert.ok(await page.evaluate(() => P.session.live.others.arrows[0].isShown));
  assert.match(await page.textContent('#said'), /^Someone else pulls on .+/);
  assert.equal(await second.evaluate(() => P.session.live.others.rows.length), 0);
  if (process.env.PLIANT_PICTURES) await page.screenshot({path: join(process.env.PLIANT_PICTURES, 'live-two.png')});
  await second.context().close();
  await page.waitForFunction(() => P.session.live.others.rows.length === 0);
});

test('the end of the run is told, and what was pulled is kept', async () => {
  run.child.kill('SIGINT');
  assert.equal(await run.ended, 130);
  await page.waitForFunction(() => P.session.live.isOver);
  assert.match(await page.textContent('#message-text'), /^The run has ended\./);
  assert.equal(await page.textContent('#out-verdict'), 'The run has ended');
  assert.equal(await play.ended, 0);
  const kept = join(folder, 'run.forces');
  assert.ok(existsSync(kept), run.said);
  assert.match(readFileSync(kept, 'utf8'), /^force \d+ /m);
  assert.deepEqual(page.complaints, []);
  const own = await play.found;
  assert.deepEqual(page.requests.filter((address) => address !== own && !/^(blob|data):/.test(address)), []);
});
});
