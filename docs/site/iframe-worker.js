// Search on pages that are opened from disk: browsers start no worker there, so an empty frame does its work.
// The theme loads polyfills before its own scripts, and its worker looks for the name IFrameWorker.
if (location.protocol === "file:") {
  window.IFrameWorker = window.Worker = class extends EventTarget {
    constructor(url) {
      super()
      const frame = document.createElement("iframe")
      frame.hidden = true
      document.body.appendChild(frame)
      this.inside = frame.contentWindow
      window.addEventListener("message", event => {
        if (event.source === this.inside) {
          event.stopImmediatePropagation()
          this.dispatchEvent(new MessageEvent("message", { data: event.data }))
        }
      })
      const page = this.inside.document
      page.open()
      page.write("<!doctype html><body></body>")
      page.close()
      this.inside.postMessage = data => this.inside.parent.dispatchEvent(
        new MessageEvent("message", { data, source: this.inside }))
      this.inside.importScripts = async (...urls) => {
        for (const each of urls) await load(page, each)
      }
      this.ready = load(page, url)
    }
    postMessage(data) {
      this.ready.then(() => this.inside.dispatchEvent(new MessageEvent("message", { data })))
    }
  }

  function load(page, url) {
    return new Promise((resolve, reject) => {
      const script = page.createElement("script")
      script.src = url
      script.onload = resolve
      script.onerror = reject
      page.body.appendChild(script)
    })
  }
}
