// SPDX-License-Identifier: MIT
// All tests of the page, one browser: node apps/play/test/run.mjs [WORD...] runs those of files whose
// name has one of the words. Ends with 1 if one failed.
import {readdirSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {after} from 'node:test';
import {fileURLToPath, pathToFileURL} from 'node:url';
import {quit} from './support/browser.mjs';

const folder = dirname(fileURLToPath(import.meta.url));
const words = process.argv.slice(2);
for (const name of readdirSync(folder).filter((file) => file.endsWith('.page.mjs')).sort())
  if (!words.length || words.some((word) => name.includes(word)))
    await import(pathToFileURL(join(folder, name)).href);
after(quit);
