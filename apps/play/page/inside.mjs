// SPDX-License-Identifier: MIT
// What the page carries inside itself: blocks of packed bytes as text, and workers made of them.
import {fromBase64} from './base64.mjs';

async function gunzip(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Bytes of the data block of this id, which gzip has packed. */
export const bytesInside = (id) => gunzip(fromBase64(document.getElementById(id).textContent));

export async function textInside(id) {
  return new TextDecoder().decode(await bytesInside(id));
}

/** A file of the user without its gzip, and its name without .gz. Throws Error if it is broken. */
export async function unzipped(name, bytes) {
  if (bytes[0] !== 0x1f || bytes[1] !== 0x8b) return {name, bytes};
  try {
    return {name: name.replace(/\.gz$/i, ''), bytes: await gunzip(bytes)};
  } catch {
    throw new Error(`${name}: the gzip in it is broken or ends early`);
  }
}

/** A worker whose source is the data block of this id. */
export async function workerInside(id) {
  const source = new Blob([await bytesInside(id)], {type: 'text/javascript'});
  const address = URL.createObjectURL(source);
  const worker = new Worker(address);
  return new Client(worker);
}

/** Requests {id, do, ...} to a worker, each a promise of its reply. */
export class Client {
  constructor(worker) {
    this.worker = worker;
    this.waiting = new Map();
    this.next = 1;
    worker.onmessage = ({data}) => this.settle(data);
    worker.onerror = (event) => this.fail(event.message || 'the worker could not be started');
  }

  ask(what, request = {}, transfer = []) {
    const id = this.next++;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, {resolve, reject});
      this.worker.postMessage({id, do: what, ...request}, transfer);
    });
  }

  settle(reply) {
    const promise = this.waiting.get(reply.id);
    if (!promise) return;
    this.waiting.delete(reply.id);
    if (reply.ok) promise.resolve(reply);
    else promise.reject(new Error(reply.error));
  }

  fail(message) {
    for (const {reject} of this.waiting.values()) reject(new Error(message));
    this.waiting.clear();
  }
}
