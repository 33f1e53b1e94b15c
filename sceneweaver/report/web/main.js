const data = JSON.parse(byId("scene-data").textContent);
let showObjects = () => {};
const mentions = ["request", "seen"].map((section) => new Mentions(section, data[section], (ids, one) => {
  for (const other of mentions) if (other !== one) other.release();
  showObjects(ids);
}));

// Starts the view. When anything fails, the picture that is already on the page stays, with a line that says why.
async function start() {
  const stage = byId("stage");
  const canvas = byId("view");
  if (typeof DecompressionStream === "undefined") throw new Error("this browser is too old to unpack the scene");
  const buffer = await unpack(byId("scene-meshes").textContent.trim());
  const renderer = new Renderer(canvas, data, buffer, await loadTextures(data.textures));
  const orbit = new Orbit(data.room, data.yaw);
  const state = { shown: new Set(), hover: null, boxes: false, labels: false, hideWalls: false };
  const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
  let dirty = true; // the picture changed, so light is gathered anew
  let marked = true; // only what lies over it did
  let pending = false;
  let last = 0;
  let slow = 0;

  const ask = () => {
    if (pending) return;
    pending = true;
    requestAnimationFrame(frame);
  };
  const changed = () => {
    dirty = true;
    ask();
  };
  const show = (ids, details, words) => {
    state.shown = new Set(ids);
    marked = true;
    panel.show(details);
    panel.mark(state.shown);
    byId("announce").textContent = ids.length ? `${ids.join(", ")} ${words}` : "Nothing selected";
    ask();
  };
  const select = (id) => {
    for (const one of mentions) one.release();
    show(id === null ? [] : [id], id, "selected");
  };
  // Several objects at once, without the details of one.
  showObjects = (ids) => {
    show(ids, null, "shown");
    if (ids.length) byId("room").scrollIntoView({ block: "nearest", behavior: still ? "auto" : "smooth" });
  };
  const open = (items, share) => {
    renderer.open(items, share);
    const all = renderer.moving();
    byId("button-open").setAttribute("aria-pressed", String(all.length > 0 && all.every((item) => item.share > 0)));
    changed();
  };
  // What a click on it does: a door or drawer opens or closes, an object is selected.
  const touch = (item) => {
    if (item && item.joint) open([item], item.share > 0 ? 0 : 1);
    if (!item || item.kind === "object") select(item && item.id);
    else byId("announce").textContent = `${item.id} ${item.share > 0 ? "opened" : "closed"}`;
  };
  const panel = new Panel(data, select, (id) => renderer.moving(id), open);
  const labels = new Labels(data, select);
  const pixel = (x, y) => {
    const ratio = canvas.width / (canvas.clientWidth || 1);
    return [Math.floor(x * ratio), canvas.height - 1 - Math.floor(y * ratio)];
  };
  const pick = (x, y) => {
    const [px, py] = pixel(x, y);
    return px < 0 || py < 0 || px >= canvas.width || py >= canvas.height ? null : renderer.pick(orbit, px, py);
  };

  function resize() {
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    const [width, height] = [Math.round(canvas.clientWidth * ratio), Math.round(canvas.clientHeight * ratio)];
    if (!width || !height || (canvas.width === width && canvas.height === height)) return;
    canvas.width = width;
    canvas.height = height;
    orbit.aspect = width / height;
    if (!orbit.moved) Object.assign(orbit, orbit.fit(orbit.home.yaw, orbit.home.pitch));
    changed();
  }

  function frame(now) {
    pending = false;
    // On a slow machine the frames of a still picture are fewer, so that the page stays quick.
    if (now - last > 120 && now - last < 3000) slow = Math.min(8, slow + 1);
    else if (slow > 0) slow -= 0.25;
    last = now;
    const gliding = orbit.step(still);
    const sinking = renderer.moveWalls(orbit.eye(), state.hideWalls, still || !renderer.started);
    renderer.started = true;
    const moving = dirty || gliding || sinking;
    if (moving) renderer.gathered = 0;
    dirty = false;
    const more = renderer.draw(orbit, {
      still: !moving, boxes: state.boxes, shown: state.shown, hover: state.hover,
      frames: slow > 3 ? 32 : FRAMES,
    });
    if (moving || marked) {
      const view = orbit.matrix(canvas.width / canvas.height);
      const cut = new Set(renderer.items.filter((i) => i.kind === "object" && i.cut < NEVER_CUT).map((i) => i.id));
      const there = (id) => panel.here.has(id) && !cut.has(id);
      labels.draw(view, canvas.clientWidth, canvas.clientHeight, state.labels, state.shown, there);
      marked = false;
    }
    stage.dataset.frames = String(renderer.gathered);
    if (gliding || sinking || moving || more) ask();
  }

  let hovering = 0;
  listen(canvas, orbit, {
    changed,
    clicked: (x, y) => touch(pick(x, y)),
    hovered: (x, y) => {
      const now = performance.now();
      if (x >= 0 && now - hovering < 60) return;
      hovering = now;
      const item = x < 0 || slow > 3 ? null : pick(x, y);
      canvas.style.cursor = item ? "pointer" : "grab";
      canvas.title = item ? item.id : "";
    },
    cleared: () => select(null),
  });
  const toggle = (name, key) => {
    const button = byId(name);
    button.addEventListener("click", () => {
      state[key] = !state[key];
      button.setAttribute("aria-pressed", String(state[key]));
      marked = true;
      if (key === "hideWalls") changed();
      else ask();
    });
  };
  toggle("button-boxes", "boxes");
  toggle("button-labels", "labels");
  toggle("button-walls", "hideWalls");
  const doors = byId("button-open");
  doors.hidden = !renderer.moving().length;
  doors.addEventListener("click", () => {
    open(renderer.moving(), doors.getAttribute("aria-pressed") === "true" ? 0 : 1);
    panel.opened();
  });
  byId("button-top").addEventListener("click", () => { orbit.top(); changed(); });
  byId("button-reset").addEventListener("click", () => { orbit.reset(); select(null); changed(); });
  // A page about several rooms shows one of them, or a storey, at a time.
  const scopes = new Map((data.scopes || []).map((scope) => [scope.id, scope]));
  const buttons = [...document.querySelectorAll("[data-scope]")];
  const enter = (id) => {
    const scope = scopes.get(id);
    if (!scope) return;
    select(null);
    const items = scope.items.map((k) => renderer.all[k]);
    renderer.show(scope.room, scope.walls, items);
    orbit.show(scope.room, scope.yaw, scope.pitch);
    panel.only(new Set(items.filter((item) => item.kind === "object").map((item) => item.id)));
    for (const one of buttons) one.setAttribute("aria-pressed", String(one.dataset.scope === id));
    doors.hidden = !renderer.moving().length;
    doors.setAttribute("aria-pressed", "false");
    byId("announce").textContent = `${scope.title} shown`;
    changed();
  };
  for (const one of buttons) {
    one.addEventListener("click", () => {
      enter(one.dataset.scope);
      byId("room").scrollIntoView({ block: "nearest", behavior: still ? "auto" : "smooth" });
    });
  }
  canvas.addEventListener("webglcontextlost", () => fail(new Error("the graphics driver gave up")));
  new ResizeObserver(resize).observe(canvas);
  stage.classList.add("running");
  if (scopes.size) enter(data.scopes[0].id);
  resize();
  ask();
  return { orbit, renderer, project: (p) => transform(orbit.matrix(canvas.width / canvas.height), p) };
}

function fail(error) {
  const stage = byId("stage");
  stage.classList.remove("running");
  stage.classList.add("failed");
  byId("stage-note").textContent =
    `The interactive view cannot run here (${error.message}). This picture stands in for it.`;
}

start().then((view) => { window.sceneView = view; }, fail);
