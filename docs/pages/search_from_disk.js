// SPDX-License-Identifier: MIT
// Browsers start no worker from a file on the disk. There the search runs in a hidden frame, which
// takes and sends messages as a worker does. The theme looks for the name IFrameWorker.
if (location.protocol === "file:") {
  const inside = (source) => `<script>
    const outside = frameElement.worker
    self.postMessage = (data) => outside.dispatchEvent(new MessageEvent("message", { data }))
    const load = (source) => new Promise((done, failed) => {
      const script = document.createElement("script")
      Object.assign(script, { src: source, onload: done, onerror: failed })
      document.head.append(script)
    })
    self.importScripts = (...sources) =>
      sources.reduce((before, source) => before.then(() => load(source)), Promise.resolve())
  <\/script><script src="${source}" onload="frameElement.worker.begin()"><\/script>`

  window.Worker = window.IFrameWorker = class extends EventTarget {
    constructor(source) {
      super()
      this.frame = document.createElement("iframe")
      this.ready = new Promise((begin) => { this.begin = begin })
      Object.assign(this.frame, { hidden: true, worker: this, srcdoc: inside(source) })
      // Once: a frame that is appended again begins anew, and forgets the index that it was given.
      const append = () => document.body.append(this.frame)
      if (document.body) append()
      else document.addEventListener("DOMContentLoaded", append)
    }
    postMessage(data) {
      const send = () =>
        this.frame.contentWindow.dispatchEvent(new MessageEvent("message", { data }))
      this.ready.then(send)
    }
    terminate() { this.frame.remove() }
  }
}
