// Draws the room. While anything moves: one frame with hardware antialiasing. When all is still: many frames, each
// with light from another part of the sky, another point of the sun and another place within the pixel, are added up.
const NEVER_CUT = 1000;
const WALL_STUMP = 0.07; // what is left of a wall that would hide the room [m]
const SUN_MAP = 2048; // pixels of a shadow map; the sky's is coarser, as many of it are added up
const SKY_MAP = 1024;
const FRAMES = 96;
const [THIN, THICK] = [0.005, 0.008]; // [m]

class Renderer {
  constructor(canvas, data, buffer, textures) {
    const gl = canvas.getContext("webgl2", { antialias: true, alpha: true, powerPreference: "high-performance" });
    if (!gl) throw new Error("WebGL 2 is not available");
    this.gl = gl;
    this.canvas = canvas;
    this.data = data;
    this.canGather = Boolean(gl.getExtension("EXT_color_buffer_float"));
    this.programs = {
      surface: this.program(VERTEX, SURFACE), depth: this.program(VERTEX, DEPTH), flat: this.program(VERTEX, FLAT),
      lines: this.program(LINES, FLAT), sum: this.program(SCREEN, SUM), develop: this.program(SCREEN, DEVELOP),
      outline: this.program(SCREEN, OUTLINE),
    };
    this.tints = this.layers(gl.SRGB8_ALPHA8, textures.map((t) => t.color), data.pixels[0]);
    this.bumps = this.layers(gl.RGBA8, textures.map((t) => t.normal), data.pixels[1]);
    this.gains = new Float32Array(2 * 64); // tint's gain, and whether there are normals
    textures.forEach((t, k) => this.gains.set([t.gain, t.normal ? 1 : 0], 2 * k));
    this.meshes = data.meshes.map((mesh) => this.upload(decodeMesh(buffer, mesh, data.materials)));
    this.all = data.items.map((item) => {
      const mesh = this.meshes[item.mesh];
      // A rug of half a millimetre would flicker in and out of the floor, so such things are shown thicker.
      const thick = mesh.high[2] - mesh.low[2];
      const scale = [item.scale[0], item.scale[1], item.scale[2] * (thick < THIN ? THICK / thick : 1)];
      const model = placed(item.position, item.quaternion, scale);
      const more = { stretch: scale, share: 0, inverseScale: scale.map((s) => 1 / (s * s)), cut: NEVER_CUT };
      return { ...item, mesh, model, ...more };
    });
    this.empty = gl.createVertexArray();
    this.cube = this.makeCube();
    this.sun = unit([0.42, -0.5, 1.0]);
    this.sunMap = this.makeMap(SUN_MAP);
    this.skyMap = this.makeMap(SKY_MAP);
    this.mask = { texture: null, frame: null, width: 0, height: 0 };
    this.show(data.room, data.walls, this.all);
  }

  // Shows some of the items in a room with walls that sink where they stand in the way.
  show(room, walls, items) {
    const { low, high, height } = room;
    this.data = { ...this.data, room, walls };
    this.items = items;
    this.center = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, height / 2];
    this.radius = Math.hypot(high[0] - low[0], high[1] - low[1], height) / 2 + 0.3;
    this.heights = walls.map(() => height + 0.01);
    this.gathered = 0;
    this.started = false;
    this.renderSun(this.sun);
  }

  // The doors, drawers and lids of an object, or of all and of the room.
  moving(id) {
    return this.items.filter((item) => item.joint && (id === undefined || item.id === id));
  }

  // Opens doors and drawers by a share of their range; 0 is closed.
  open(items, share) {
    const none = [0, 0, 0, 1];
    for (const item of items) {
      const { kind, axis, anchor, limits } = item.joint;
      const far = share * (Math.abs(limits[1]) >= Math.abs(limits[0]) ? limits[1] : limits[0]);
      const moved = kind === "hinge" ? turnedAbout(axis, anchor, far) : placed(scale(axis, far), none, [1, 1, 1]);
      const still = placed(item.position, item.quaternion, [1, 1, 1]);
      item.model = multiply(multiply(still, moved), placed([0, 0, 0], none, item.stretch));
      item.share = share;
    }
    this.renderSun(this.sun);
  }

  program(vertex, fragment) {
    const gl = this.gl;
    const program = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost()) {
        throw new Error("shader: " + gl.getShaderInfoLog(shader));
      }
    }
    gl.linkProgram(program);
    const found = { program };
    const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) || 0;
    for (let i = 0; i < count; i++) {
      const { name } = gl.getActiveUniform(program, i);
      found[name] = gl.getUniformLocation(program, name);
    }
    return found;
  }

  upload(mesh) {
    const gl = this.gl;
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, mesh.data, gl.STATIC_DRAW);
    const layout = [[3, gl.FLOAT, false, 0], [3, gl.BYTE, true, 12], [4, gl.UNSIGNED_BYTE, true, 16],
      [4, gl.UNSIGNED_BYTE, true, 20], [2, gl.FLOAT, false, 24]];
    layout.forEach(([size, type, normalized, offset], k) => {
      gl.enableVertexAttribArray(k);
      gl.vertexAttribPointer(k, size, type, normalized, VERTEX_BYTES, offset);
    });
    gl.bindVertexArray(null);
    return { array, opaque: mesh.opaque, count: mesh.count, low: mesh.low, high: mesh.high };
  }

  // Square images as layers of one texture, which repeats; a missing one is a blank layer.
  layers(format, images, side) {
    const gl = this.gl;
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, texture);
    gl.texStorage3D(gl.TEXTURE_2D_ARRAY, Math.log2(side) + 1, format, side, side, Math.max(1, images.length));
    images.forEach((image, k) => {
      if (!image) return;
      gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, k, side, side, 1, gl.RGBA, gl.UNSIGNED_BYTE, image);
    });
    gl.generateMipmap(gl.TEXTURE_2D_ARRAY);
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
    const sharp = gl.getExtension("EXT_texture_filter_anisotropic");
    if (sharp) gl.texParameterf(gl.TEXTURE_2D_ARRAY, sharp.TEXTURE_MAX_ANISOTROPY_EXT, 8);
    return texture;
  }

  use(name, uniforms) {
    const gl = this.gl;
    const program = this.programs[name];
    gl.useProgram(program.program);
    for (const [key, value] of Object.entries(uniforms)) this.set(program, key, value);
    return program;
  }

  set(program, key, value) {
    const gl = this.gl;
    const at = program[key];
    if (at === undefined) return;
    if (typeof value === "number") gl.uniform1f(at, value);
    else if (value.length === 16) gl.uniformMatrix4fv(at, false, value);
    else if (value.length === 4) gl.uniform4fv(at, value);
    else if (value.length === 3) gl.uniform3fv(at, value);
    else gl.uniform2fv(at, value);
  }

  drawItem(program, item, first, count) {
    const gl = this.gl;
    if (count <= 0) return;
    gl.uniformMatrix4fv(program.model, false, item.model);
    if (program.inverseScale !== undefined) gl.uniform3fv(program.inverseScale, item.inverseScale);
    gl.uniform1f(program.cut, item.cut);
    gl.bindVertexArray(item.mesh.array);
    gl.drawArrays(gl.TRIANGLES, first, count);
  }

  renderMap(map, direction, walls) {
    const gl = this.gl;
    const up = Math.abs(direction[2]) > 0.9 ? [0, 1, 0] : [0, 0, 1];
    const r = this.radius;
    const look = lookAt(add(this.center, scale(direction, 2 * r)), this.center, up);
    map.view = multiply(orthographic(r, r, 0.5 * r, 3.5 * r), look);
    gl.bindFramebuffer(gl.FRAMEBUFFER, map.frame);
    gl.viewport(0, 0, map.size, map.size);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.disable(gl.BLEND);
    gl.disable(gl.CULL_FACE);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(1.5, 2);
    const program = this.use("depth", { view: map.view });
    for (const item of this.items) {
      // The sun shines over the walls, as if into a doll's house; the sky is dimmed by the walls that are shown.
      const inside = item.kind === "object" || item.kind === "floor" || item.share > 0;
      if (inside || walls) this.drawItem(program, item, 0, item.mesh.opaque);
    }
    gl.disable(gl.POLYGON_OFFSET_FILL);
  }

  renderSun(direction) {
    this.renderMap(this.sunMap, direction, false);
  }

  // Sinks the walls that stand between the camera and the room; true while they move.
  moveWalls(eye, hideAll, jump) {
    const full = this.data.room.height + 0.01;
    let moving = false;
    this.data.walls.forEach((wall, k) => {
      const outside = (eye[0] - wall.point[0]) * wall.outward[0] + (eye[1] - wall.point[1]) * wall.outward[1] > 0.12;
      const goal = hideAll || outside ? WALL_STUMP : full;
      const gap = goal - this.heights[k];
      this.heights[k] = jump || Math.abs(gap) < 0.01 ? goal : this.heights[k] + gap * 0.22;
      moving = moving || this.heights[k] !== goal;
    });
    for (const item of this.items) {
      const height = item.wall === null ? full : this.heights[item.wall];
      item.cut = height >= full ? NEVER_CUT : height;
    }
    return moving;
  }

  surfaces(view, eye, gather, lit) {
    const gl = this.gl;
    const program = this.use("surface", {
      view, eye, sun: this.sunNow || this.sun, sky: this.sky || this.sun, sunView: this.sunMap.view,
      skyView: (this.skyMap.view || this.sunMap.view), texel: (2 * this.radius) / SUN_MAP, mapTexel: 1 / SUN_MAP,
      phase: gather ? this.gathered * 1.37 : 0,
    });
    gl.uniform1i(program.gather, gather ? 1 : 0);
    gl.uniform1i(program.sunMap, 0);
    gl.uniform1i(program.skyMap, 1);
    gl.uniform1i(program.tints, 2);
    gl.uniform1i(program.bumps, 3);
    gl.uniform2fv(program["gains[0]"], this.gains);
    gl.activeTexture(gl.TEXTURE3);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, this.bumps);
    gl.activeTexture(gl.TEXTURE2);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, this.tints);
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, this.skyMap.texture);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.sunMap.texture);
    gl.enable(gl.DEPTH_TEST);
    gl.disable(gl.BLEND);
    gl.disable(gl.CULL_FACE);
    for (const item of this.items) {
      // Furniture may be open; of walls the back is seen where they are cut.
      if (item.kind === "object" || item.cut < NEVER_CUT) gl.disable(gl.CULL_FACE);
      else gl.enable(gl.CULL_FACE);
      gl.uniform1f(program.lit, lit === item.id && item.kind === "object" ? 0.16 : 0);
      this.drawItem(program, item, 0, item.mesh.opaque);
    }
    gl.disable(gl.CULL_FACE);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    const glass = this.items.filter((item) => item.mesh.count > item.mesh.opaque);
    const far = (item) => Math.hypot(item.model[12] - eye[0], item.model[13] - eye[1], item.model[14] - eye[2]);
    for (const item of glass.sort((a, b) => far(b) - far(a))) {
      gl.uniform1f(program.lit, lit === item.id ? 0.16 : 0);
      this.drawItem(program, item, item.mesh.opaque, item.mesh.count - item.mesh.opaque);
    }
    gl.depthMask(true);
    gl.disable(gl.BLEND);
  }

  // One frame to the canvas. Returns true when another frame would still make it better.
  draw(camera, options) {
    const gl = this.gl;
    if (gl.isContextLost()) return false;
    this.targets();
    const [width, height] = [this.canvas.width, this.canvas.height];
    const gather = this.canGather && options.still;
    let view = camera.matrix(width / height);
    if (gather && this.gathered < options.frames) {
      if (this.gathered === 0) {
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.sums[0].frame);
        gl.clearColor(0, 0, 0, 0);
        gl.clear(gl.COLOR_BUFFER_BIT);
      }
      this.gatherOne(camera, view, width, height, options.hover);
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    if (gather && this.gathered >= Math.min(8, options.frames)) {
      const program = this.use("develop", { share: 1 / this.gathered });
      this.screen(program, this.sums[0].texture);
    } else {
      if (!gather) this.gathered = 0;
      if (this.sunNow) this.renderSun(this.sun);
      this.sunNow = null;
      gl.bindFramebuffer(gl.FRAMEBUFFER, null);
      gl.viewport(0, 0, width, height);
      this.surfaces(view, camera.eye(), false, options.hover);
    }
    if (options.boxes) this.drawBoxes(view, options.shown);
    if (options.shown.size) this.drawOutline(view, options.shown);
    return gather && this.gathered < options.frames;
  }

  gatherOne(camera, view, width, height, hover) {
    const gl = this.gl;
    const k = this.gathered;
    const angle = 2 * Math.PI * halton(k, 2);
    const up = 0.06 + 0.94 * halton(k, 3);
    const flat = Math.sqrt(1 - up * up);
    this.sky = [flat * Math.cos(angle), flat * Math.sin(angle), up];
    this.renderMap(this.skyMap, this.sky, true);
    const spread = 0.05 * Math.sqrt(halton(k, 5));
    const turn = 2 * Math.PI * halton(k, 7);
    const side = unit(cross(this.sun, [0, 0, 1]));
    const other = cross(side, this.sun);
    const shift = add(scale(side, spread * Math.cos(turn)), scale(other, spread * Math.sin(turn)));
    this.sunNow = unit(add(this.sun, shift));
    this.renderSun(this.sunNow);
    const jittered = new Float32Array(view);
    // Another sequence than the light's, or edges would always be lit from the same side.
    const dx = (2 * ((0.5 + k * 0.7548776662) % 1) - 1) / width;
    const dy = (2 * ((0.5 + k * 0.569840291) % 1) - 1) / height;
    for (let c = 0; c < 4; c++) {
      jittered[4 * c] += dx * view[4 * c + 3];
      jittered[4 * c + 1] += dy * view[4 * c + 3];
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.once.frame);
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.surfaces(jittered, camera.eye(), true, hover);
    // Half floats cannot hold a sum, and not every device blends floats: the sum goes from one target to the other.
    const [before, after] = this.sums;
    gl.bindFramebuffer(gl.FRAMEBUFFER, after.frame);
    gl.disable(gl.BLEND);
    const program = this.use("sum", {});
    gl.uniform1i(program.before, 1);
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, before.texture);
    this.screen(program, this.once.texture);
    this.sums = [after, before];
    this.gathered++;
  }

  screen(program, texture) {
    const gl = this.gl;
    gl.disable(gl.DEPTH_TEST);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.uniform1i(program.image, 0);
    gl.bindVertexArray(this.empty);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}
