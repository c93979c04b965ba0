// SPDX-License-Identifier: MIT
// Makes build/play/pliant.html, the page of `pliant play`: markup, style, script, the sources of the
// two workers and the WebAssembly in one file. node apps/play/build_page.mjs [--worker FILE]
import {createHash} from 'node:crypto';
import {existsSync, readFileSync, readdirSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {gzipSync} from 'node:zlib';
import {notices} from './notices.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, '..', '..');
const out = join(root, 'build', 'play');
const {build} = createRequire(join(out, 'package.json'))('esbuild');

const source = (name) => readFileSync(join(here, 'page', name), 'utf8');
// By their names: what is for narrow windows comes last.
const styles = () => readdirSync(join(here, 'page', 'style')).sort().map((name) => source(join('style', name))).join('');
const version = /project\(pliant VERSION ([0-9.]+)/.exec(
  readFileSync(join(root, 'CMakeLists.txt'), 'utf8'))[1];

// One script without imports.
async function bundle(file) {
  const result = await build({
    entryPoints: [file],
    bundle: true,
    minify: true,
    write: false,
    format: 'iife',
    target: 'es2022',
    legalComments: 'none',
    charset: 'utf8',
    external: ['node:*'],
    define: {PLIANT_VERSION: JSON.stringify(version)},
    logLevel: 'warning',
  });
  return result.outputFiles[0].text;
}

const packed = (bytes) => gzipSync(bytes, {level: 9}).toString('base64');
const hash = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;
const inScript = (text) => text.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
// A block of data is no script: it needs no leave of the policy.
const data = (id, text) => `<script type="application/octet-stream" id="${id}">${text}</script>`;

// No request leaves the page: data and scripts are inside, workers are made from blobs.
function policy(script, style) {
  return [
    "default-src 'none'", `script-src ${hash(script)} 'wasm-unsafe-eval'`,
    `style-src ${hash(style)}`, 'worker-src blob:', 'img-src data: blob:', "base-uri 'none'",
    "form-action 'none'",
  ].join('; ');
}

function workerFile() {
  const at = process.argv.indexOf('--worker');
  return at < 0 ? join(here, 'page', 'worker.mjs') : process.argv[at + 1];
}

function wasmBytes() {
  const file = join(out, 'pliant.wasm');
  if (existsSync(file)) return readFileSync(file);
  console.warn('warning: build/play/pliant.wasm is missing: ./dev play builds it');
  return Buffer.alloc(0);
}

// The proteins, molecules and mechanisms of data/, as files by their names.
function examples() {
  const rows = [];
  for (const kind of ['proteins', 'molecules', 'mechanisms'])
    for (const name of readdirSync(join(root, 'data', kind)).sort())
      rows.push({kind, name, text: readFileSync(join(root, 'data', kind, name), 'utf8')});
  return Buffer.from(JSON.stringify(rows));
}

function assemble(parts) {
  const style = styles();
  const script = inScript(parts.page);
  const blocks = [
    data('solver-wasm', packed(parts.wasm)), data('solver-worker', packed(parts.solver)),
    data('hdf5-worker', packed(parts.hdf5)), data('examples-inside', packed(examples())),
    data('notices', packed(Buffer.from(notices(root)))),
  ].join('\n');
  return source('index.html')
    .replace('%POLICY%', () => policy(script, style))
    .replace('<!-- STYLE -->', () => `<style>${style}</style>`)
    .replace('<!-- DATA -->', () => blocks)
    .replace('<!-- SCRIPT -->', () => `<script>${script}</script>`);
}

const [page, solver, hdf5] = await Promise.all([
  bundle(join(here, 'page', 'main.mjs')), bundle(workerFile()),
  bundle(join(here, 'page', 'record', 'hdf5_worker.mjs')),
]);
const wasm = wasmBytes();
const html = assemble({page, solver, hdf5, wasm});
writeFileSync(join(out, 'pliant.html'), html);
const kb = (text) => `${(text.length / 1000).toFixed(0)} kB`;
console.log(`build/play/pliant.html ${kb(Buffer.from(html))} (gzip ${kb(gzipSync(html))}): ` +
  `script ${kb(page)}, worker ${kb(solver)}, wasm ${kb(wasm)}, HDF5 ${kb(hdf5)}`);
