// SPDX-License-Identifier: MIT
// The WebAssembly module: starts it, and makes its calls. Knows no page and no worker.

/** What WASI asks of its host where there are no files: messages, and the clocks. */
function wasiHost(memory) {
  const badFile = 8;
  const view = () => new DataView(memory().buffer);
  const functions = {
    clock_time_get(clock, _precision, place) {
      const now = clock === 0 ? Date.now() : performance.now();
      view().setBigUint64(place, BigInt(Math.round(now * 1e6)), true);
      return 0;
    },
    fd_write(_file, pieces, count, written) {
      let bytes = 0;
      for (let k = 0; k < count; ++k) bytes += view().getUint32(pieces + 8 * k + 4, true);
      view().setUint32(written, bytes, true);
      return 0;
    },
    environ_sizes_get(count, size) {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return 0;
    },
    environ_get: () => 0,
    proc_exit(code) {
      throw new Error(`the solver ended with ${code}`);
    },
  };
  // Whatever else is asked for has to do with files.
  return new Proxy(functions, {get: (known, name) => known[name] ?? (() => badFile)});
}

const arrays = {Float64: Float64Array, Float32: Float32Array, Int32: Int32Array, Uint8: Uint8Array};

/** "frames.3.positions" into the third object of the array `frames`. */
function put(object, path, value) {
  const last = path.pop();
  path.reduce((inner, name) => inner[name], object)[last] = value;
}

export class WasmModule {
  /** Compiles and starts the module. */
  static async start(bytes) {
    const made = new WasmModule();
    const module = await WebAssembly.compile(bytes);
    const host = wasiHost(() => made.exports.memory);
    const imports = {};
    for (const {module: from, name} of WebAssembly.Module.imports(module))
      (imports[from] ??= {})[name] = host[name];
    made.exports = (await WebAssembly.instantiate(module, imports)).exports;
    made.exports._initialize?.();
    return made;
  }

  /** The reply of a call: its fields, and its arrays as typed arrays of their own. */
  call(fields, bytes = new Uint8Array()) {
    const {play_call: call, play_free: free, play_reply: reply} = this.exports;
    const json = this.#put(new TextEncoder().encode(JSON.stringify(fields)));
    const file = this.#put(bytes);
    let length;
    try {
      length = call(json.at, json.size, file.at, file.size);
    } finally {
      free(json.at);
      free(file.at);
    }
    const text = new TextDecoder().decode(new Uint8Array(this.exports.memory.buffer, reply(), length));
    const {arrays: places, ...rest} = JSON.parse(text);
    for (const [path, place] of Object.entries(places)) put(rest, path.split('.'), this.#copy(place));
    return rest;
  }

  #put(bytes) {
    const at = this.exports.play_allocate(Math.max(bytes.length, 1));
    if (at === 0) throw new Error('out of memory');
    new Uint8Array(this.exports.memory.buffer, at, bytes.length).set(bytes);
    return {at, size: bytes.length};
  }

  #copy({type, at, count}) {
    return new arrays[type](this.exports.memory.buffer, at, count).slice();
  }
}
