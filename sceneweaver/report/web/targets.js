// What the renderer draws into, and the wires of a box.
Object.assign(Renderer.prototype, {
  makeCube() {
    const gl = this.gl;
    const ends = [];
    for (let a = 0; a < 8; a++) {
      for (const bit of [1, 2, 4]) {
        if (a & bit) continue;
        for (const c of [a, a | bit]) ends.push(c & 1, (c >> 1) & 1, (c >> 2) & 1);
      }
    }
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(ends), gl.STATIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    gl.bindVertexArray(null);
    return array;
  },

  makeMap(size) {
    const gl = this.gl;
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.DEPTH_COMPONENT24, size, size);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE);
    for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) {
      gl.texParameteri(gl.TEXTURE_2D, side, gl.LINEAR);
    }
    const frame = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, texture, 0);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    return { texture, frame, size, view: null };
  },

  // A target of the canvas's size: a texture of the format, with depth when wanted.
  makeTarget(format, depth) {
    const gl = this.gl;
    const [width, height] = [this.canvas.width, this.canvas.height];
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
    for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) {
      gl.texParameteri(gl.TEXTURE_2D, side, format === gl.R8 ? gl.LINEAR : gl.NEAREST);
    }
    for (const axis of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) {
      gl.texParameteri(gl.TEXTURE_2D, axis, gl.CLAMP_TO_EDGE);
    }
    const frame = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    let store = null;
    if (depth) {
      store = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, store);
      gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT24, width, height);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, store);
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    return { texture, frame, store };
  },

  targets() {
    const gl = this.gl;
    const size = `${this.canvas.width} ${this.canvas.height}`;
    if (this.targetSize === size) return;
    for (const old of [this.mask, this.ids, this.once, ...(this.sums || [])]) {
      if (!old || !old.texture) continue;
      gl.deleteTexture(old.texture);
      gl.deleteFramebuffer(old.frame);
      if (old.store) gl.deleteRenderbuffer(old.store);
    }
    this.targetSize = size;
    this.mask = this.makeTarget(gl.R8, false);
    this.ids = this.makeTarget(gl.RGBA8, true);
    this.once = this.canGather ? this.makeTarget(gl.RGBA16F, true) : null;
    this.sums = this.canGather ? [0, 1].map(() => this.makeTarget(gl.RGBA32F, false)) : null;
    this.gathered = 0;
  },
});
