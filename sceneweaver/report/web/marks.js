// What is drawn over the room: boxes, the outlines of the selected objects, and the picture of ids that clicks ask.
const ACCENT = [0.16, 0.5, 1.0];

Object.assign(Renderer.prototype, {
  drawBoxes(view, shown) {
    const gl = this.gl;
    const program = this.use("lines", { view, cut: NEVER_CUT });
    gl.enable(gl.DEPTH_TEST);
    gl.bindVertexArray(this.cube);
    for (const item of this.items) {
      if (item.kind !== "object") continue;
      const box = this.data.objects[item.id].box;
      const color = shown.has(item.id) ? [...ACCENT, 1] : [0.93, 0.42, 0.16, 1];
      this.set(program, "flatColor", color);
      this.set(program, "low", box.low);
      this.set(program, "high", box.high);
      this.set(program, "model", placed(item.position, item.quaternion, [1, 1, 1]));
      gl.drawArrays(gl.LINES, 0, 24);
    }
  },

  drawOutline(view, shown) {
    const gl = this.gl;
    const [width, height] = [this.canvas.width, this.canvas.height];
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.mask.frame);
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.BLEND);
    const program = this.use("flat", { view, flatColor: [1, 1, 1, 1] });
    for (const item of this.items) {
      if (item.kind !== "object" || !shown.has(item.id)) continue;
      // A picture on a wall that is cut away is still outlined.
      this.drawItem(program, { ...item, cut: NEVER_CUT }, 0, item.mesh.count);
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, width, height);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    const wide = 1.4 * (window.devicePixelRatio || 1);
    const outline = this.use("outline", { pixel: [wide / width, wide / height], flatColor: [...ACCENT, 1] });
    this.screen(outline, this.mask.texture);
    gl.disable(gl.BLEND);
  },

  // What is at a pixel of the canvas, counted from its lower left corner: an object or a part of it that moves, or the
  // leaf of a door; null for none.
  pick(camera, x, y) {
    const gl = this.gl;
    this.targets();
    const [width, height] = [this.canvas.width, this.canvas.height];
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.ids.frame);
    gl.viewport(0, 0, width, height);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(x, y, 1, 1);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.disable(gl.BLEND);
    const program = this.use("flat", { view: camera.matrix(width / height) });
    this.items.forEach((item, k) => {
      const code = k + 1;
      this.set(program, "flatColor", [(code & 255) / 255, ((code >> 8) & 255) / 255, (code >> 16) / 255, 1]);
      this.drawItem(program, item, 0, item.mesh.count);
    });
    const pixel = new Uint8Array(4);
    gl.readPixels(x, y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    gl.disable(gl.SCISSOR_TEST);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    const item = this.items[pixel[0] + 256 * pixel[1] + 65536 * pixel[2] - 1];
    return item && item.id !== null ? item : null;
  },
});
