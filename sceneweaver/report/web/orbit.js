// A camera that circles a point, and how mouse, fingers and keys move it.
const FOV = (34 * Math.PI) / 180;
const STEEPEST = Math.PI / 2 - 0.002;

class Orbit {
  constructor(room, yaw) {
    this.room = room;
    this.home = { yaw, pitch: 0.62 };
    this.goal = null;
    this.aspect = 1;
    this.moved = false; // by the user: then the view is left as it is when the window changes
    Object.assign(this, this.fit(this.home.yaw, this.home.pitch));
  }

  // Circles another room, at first from a direction.
  show(room, yaw, pitch) {
    this.room = room;
    this.home = { yaw, pitch };
    this.goal = null;
    this.moved = false;
    Object.assign(this, this.fit(yaw, this.home.pitch));
  }

  // The place from which the whole room is seen in a direction.
  fit(yaw, pitch) {
    const { low, high, height } = this.room;
    const top = pitch > 1.4;
    const target = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, top ? 0 : height * 0.32];
    const [t, a] = [Math.tan(FOV / 2), this.aspect];
    const back = [Math.cos(pitch) * Math.cos(yaw), Math.cos(pitch) * Math.sin(yaw), Math.sin(pitch)];
    const right = [-Math.sin(yaw), Math.cos(yaw), 0];
    const up = cross(back, right);
    const level = (k) => (k & 1 ? high[0] : low[0]) * back[0] + (k & 2 ? high[1] : low[1]) * back[1];
    const nearest = [0, 1, 2, 3].reduce((a, b) => (level(b) > level(a) ? b : a));
    let distance = 0.5;
    for (let k = 0; k < 8; k++) {
      // Walls are outside the outline; those in front are cut, so the upper corner between them need not be seen.
      const corner = [k & 1 ? high[0] + 0.1 : low[0] - 0.1, k & 2 ? high[1] + 0.1 : low[1] - 0.1, k & 4 ? height : 0];
      const p = sub(corner, target);
      if (k === nearest + 4 && !top) continue;
      const side = Math.max(Math.abs(dot(p, right)) / (t * a), Math.abs(dot(p, up)) / t);
      distance = Math.max(distance, side + dot(p, back));
    }
    return { target, yaw, pitch, distance: distance * 1.06 };
  }

  eye() {
    const { target, yaw, pitch, distance: d } = this;
    return [
      target[0] + d * Math.cos(pitch) * Math.cos(yaw), target[1] + d * Math.cos(pitch) * Math.sin(yaw),
      target[2] + d * Math.sin(pitch),
    ];
  }

  matrix(aspect) {
    // As tight around the room as can be: a rug lies less than a millimetre over the floor.
    const { low, high, height } = this.room;
    const middle = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, height / 2];
    const radius = Math.hypot(high[0] - low[0], high[1] - low[1], height) / 2 + 1;
    const eye = this.eye();
    const away = Math.hypot(...sub(eye, middle));
    const near = Math.max(Math.min(0.1, this.distance * 0.05), away - radius);
    return multiply(perspective(FOV, aspect, near, away + radius), lookAt(eye, this.target, [0, 0, 1]));
  }

  turn(dx, dy) {
    this.goal = null;
    this.moved = true;
    this.yaw -= dx;
    this.pitch = Math.min(STEEPEST, Math.max(-0.1, this.pitch + dy));
  }

  zoom(factor) {
    this.goal = null;
    this.moved = true;
    this.distance = Math.min(200, Math.max(0.3, this.distance * factor));
  }

  // Moves the target in the plane of the picture, by shares of its height.
  pan(dx, dy) {
    this.goal = null;
    this.moved = true;
    const size = 2 * Math.tan(FOV / 2) * this.distance;
    const right = [-Math.sin(this.yaw), Math.cos(this.yaw), 0];
    const forward = [-Math.cos(this.yaw), -Math.sin(this.yaw), 0];
    const s = Math.sin(this.pitch);
    const up = [forward[0] * s, forward[1] * s, Math.cos(this.pitch)];
    this.target = add(this.target, add(scale(right, -dx * size), scale(up, dy * size)));
  }

  // Goes there in a few frames.
  go(place) {
    const yaw = place.yaw + 2 * Math.PI * Math.round((this.yaw - place.yaw) / (2 * Math.PI));
    this.goal = { ...place, yaw };
  }

  reset() {
    this.moved = false;
    this.go(this.fit(this.home.yaw, this.home.pitch));
  }

  top() {
    this.moved = true;
    this.go(this.fit(-Math.PI / 2, STEEPEST));
  }

  // One frame of the way; true while there is way to go.
  step(jump) {
    if (!this.goal) return false;
    const g = this.goal;
    const part = jump ? 1 : 0.16;
    const mix = (a, b) => a + (b - a) * part;
    this.yaw = mix(this.yaw, g.yaw);
    this.pitch = mix(this.pitch, g.pitch);
    this.distance = mix(this.distance, g.distance);
    this.target = this.target.map((v, k) => mix(v, g.target[k]));
    const rest = Math.abs(g.yaw - this.yaw) + Math.abs(g.pitch - this.pitch) + Math.abs(g.distance - this.distance);
    if (rest < 0.003) {
      Object.assign(this, g);
      this.goal = null;
    }
    return true;
  }
}

// Connects a canvas: changed() after a movement, clicked(x, y) for a click, in CSS pixels of the canvas.
function listen(canvas, orbit, { changed, clicked, hovered, cleared }) {
  const fingers = new Map();
  let travelled = 0;
  let scrolled = 0;
  const spot = (event) => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    canvas.focus({ preventScroll: true });
    if (fingers.size === 0) travelled = 0;
    fingers.set(event.pointerId, spot(event));
  });
  canvas.addEventListener("pointermove", (event) => {
    const now = spot(event);
    const before = fingers.get(event.pointerId);
    if (!before) {
      if (event.pointerType === "mouse") hovered(now[0], now[1]);
      return;
    }
    const [dx, dy] = [now[0] - before[0], now[1] - before[1]];
    travelled += Math.hypot(dx, dy);
    const height = canvas.clientHeight || 1;
    if (fingers.size === 2) {
      const other = [...fingers].find(([id]) => id !== event.pointerId)[1];
      const was = Math.hypot(before[0] - other[0], before[1] - other[1]);
      const is = Math.hypot(now[0] - other[0], now[1] - other[1]);
      if (is > 1) orbit.zoom(was / is);
      orbit.pan(dx / 2 / height, dy / 2 / height);
    } else if (event.shiftKey || event.buttons & 6) orbit.pan(dx / height, dy / height);
    else if (travelled > 3) orbit.turn((dx / height) * 3.2, (dy / height) * 3.2);
    fingers.set(event.pointerId, now);
    if (travelled > 3) changed();
  });
  const lift = (event) => {
    if (!fingers.delete(event.pointerId)) return;
    const still = event.type === "pointerup" && fingers.size === 0 && travelled <= 3;
    if (still && event.button === 0) clicked(...spot(event));
  };
  canvas.addEventListener("pointerup", lift);
  canvas.addEventListener("pointercancel", lift);
  canvas.addEventListener("pointerleave", () => hovered(-1, -1));
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  // A page that is being scrolled goes on scrolling when the canvas comes under the pointer.
  window.addEventListener("wheel", (event) => {
    if (event.target !== canvas) scrolled = performance.now();
  }, { passive: true });
  canvas.addEventListener("wheel", (event) => {
    if (performance.now() - scrolled < 300) {
      scrolled = performance.now();
      return;
    }
    event.preventDefault();
    orbit.zoom(Math.exp(Math.max(-60, Math.min(60, event.deltaY * (event.deltaMode ? 20 : 1))) * 0.0022));
    changed();
  }, { passive: false });
  canvas.addEventListener("keydown", (event) => {
    const step = event.shiftKey ? 0.35 : 0.12;
    const actions = {
      ArrowLeft: () => orbit.turn(step, 0), ArrowRight: () => orbit.turn(-step, 0), ArrowUp: () => orbit.turn(0, step),
      ArrowDown: () => orbit.turn(0, -step), "+": () => orbit.zoom(0.9), "=": () => orbit.zoom(0.9),
      "-": () => orbit.zoom(1.1), Home: () => orbit.reset(), t: () => orbit.top(), Escape: cleared,
    };
    if (event.ctrlKey || event.metaKey || event.altKey || !(event.key in actions)) return;
    event.preventDefault();
    actions[event.key]();
    changed();
  });
}
