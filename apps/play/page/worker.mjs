// SPDX-License-Identifier: MIT
// The worker: answers {id, do, ...} with {id, ok, ...}. All that is computed is computed in the
// WebAssembly module; here requests go in and replies come out. Runs in a browser's Worker and in
// node's worker_threads.
import {WasmModule} from './wasm_module.mjs';

let solver = null;

async function boot({wasm}) {
  solver = await WasmModule.start(wasm);
  return solver.call({do: 'boot'});
}

/** The module is of no more use once it was stopped in the middle of a call. */
function ask({bytes, ...fields}) {
  if (!solver) throw new Error('the solver has not been started');
  try {
    const began = performance.now();
    const reply = solver.call(fields, bytes);
    if (fields.timed) reply.took = performance.now() - began;
    return reply;
  } catch (error) {
    if (!(error instanceof WebAssembly.RuntimeError || error instanceof RangeError)) throw error;
    solver = null;
    throw new Error(`the solver stopped: ${error.message}`);
  }
}

/** The reply to a request, never an exception. */
export async function answer({id, ...request}) {
  try {
    return {id, ...(request.do === 'boot' ? await boot(request) : ask(request))};
  } catch (error) {
    return {id, ok: false, error: error.message};
  }
}

/** The buffers of a reply, which are handed over and not copied. */
export function buffersOf(reply) {
  return Object.values(reply).flatMap((value) => {
    if (ArrayBuffer.isView(value)) return [value.buffer];
    return Array.isArray(value) && value[0]?.positions ? value.flatMap(buffersOf) : [];
  });
}

/** Answers requests in the order in which they come. */
function listen(port) {
  let last = Promise.resolve();
  const take = (request) => {
    last = last.then(async () => {
      const reply = await answer(request);
      port.postMessage(reply, buffersOf(reply));
    });
  };
  if (port.on) port.on('message', take);
  else port.onmessage = ({data}) => take(data);
}

const isBrowserWorker = typeof WorkerGlobalScope !== 'undefined' && self instanceof WorkerGlobalScope;
if (isBrowserWorker) {
  listen(self);
} else if (typeof process !== 'undefined' && process.versions?.node) {
  import('node:worker_threads').then(({parentPort}) => parentPort && listen(parentPort));
}
