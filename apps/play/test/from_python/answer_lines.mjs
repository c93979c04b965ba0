// SPDX-License-Identifier: MIT
// The worker for tests in other languages: requests as lines of JSON on standard input, replies as
// lines on standard output. `file` in a request names the file whose bytes are sent. In replies
// each array is {type, length, sha1} of its bytes, or all of its numbers if the request says
// `whole`.
import {createHash} from 'node:crypto';
import {readFileSync} from 'node:fs';
import {createInterface} from 'node:readline';
import {Solver, wasmOfBuild} from './ask_worker.mjs';

function shown(value, whole) {
  if (ArrayBuffer.isView(value)) {
    if (whole) return [...value];
    const bytes = new Uint8Array(value.buffer, value.byteOffset, value.byteLength);
    const sha1 = createHash('sha1').update(bytes).digest('hex');
    return {type: value.constructor.name, length: value.length, sha1};
  }
  if (Array.isArray(value)) return value.map((one) => shown(one, whole));
  if (value === null || typeof value !== 'object') return value;
  return Object.fromEntries(Object.entries(value).map(([name, one]) => [name, shown(one, whole)]));
}

const solver = new Solver();
await solver.ask('boot', {wasm: wasmOfBuild()});
for await (const line of createInterface({input: process.stdin})) {
  const {do: what, file, whole, ...fields} = JSON.parse(line);
  if (file !== undefined) fields.bytes = new Uint8Array(readFileSync(file));
  const {id, ...reply} = await solver.ask(what, fields);
  console.log(JSON.stringify(shown(reply, whole)));
}
await solver.end();
