// SPDX-License-Identifier: MIT
// Talks to the worker as the page does, in node: a worker thread, requests with numbers, promises.
import {readFileSync} from 'node:fs';
import {Worker} from 'node:worker_threads';

const root = new URL('../../../../', import.meta.url);

/** The module that ./dev play has built. */
export const wasmOfBuild = () => new Uint8Array(readFileSync(new URL('build/play/pliant.wasm', root))).buffer;

export class Solver {
  #worker = new Worker(new URL('../../page/worker.mjs', import.meta.url));
  #waiting = new Map();
  #next = 1;

  constructor() {
    this.#worker.on('message', (reply) => {
      this.#waiting.get(reply.id)(reply);
      this.#waiting.delete(reply.id);
    });
  }

  /** The reply, ok or not. */
  ask(what, fields = {}) {
    const id = this.#next++;
    const reply = new Promise((resolve) => this.#waiting.set(id, resolve));
    this.#worker.postMessage({id, do: what, ...fields});
    return reply;
  }

  end() {
    return this.#worker.terminate();
  }
}
