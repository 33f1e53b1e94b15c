// The page around the canvas: list of objects, panel of the selected one, labels and buttons. Text is only ever set
// as text, never as markup.
const byId = (id) => document.getElementById(id);

function element(tag, className, text) {
  const made = document.createElement(tag);
  if (className) made.className = className;
  if (text !== undefined) made.textContent = text;
  return made;
}

const metres = (v) => v.toFixed(2);

class Panel {
  // ``moving`` has the doors and drawers of an object by its id, and ``open`` opens some by a share of their range.
  constructor(data, select, moving, open) {
    this.data = data;
    this.select = select;
    this.moving = moving;
    this.open = open;
    this.rows = new Map();
    this.sliders = [];
    const list = byId("object-list");
    for (const id of Object.keys(data.objects)) {
      const thing = data.objects[id];
      const button = element("button", "object-row" + (thing.faults.length ? " faulty" : ""));
      button.type = "button";
      button.setAttribute("aria-pressed", "false");
      button.append(element("span", "object-id", id), element("span", "object-kind", thing.category));
      if (thing.faults.length) button.append(element("span", "object-fault", "not ok"));
      button.addEventListener("click", () => select(button.getAttribute("aria-pressed") === "true" ? null : id));
      const row = element("li");
      row.append(button);
      list.append(row);
      this.rows.set(id, button);
    }
    this.here = new Set(this.rows.keys());
    this.search = byId("object-search");
    this.search.addEventListener("input", () => this.filter());
  }

  // Lists these objects alone.
  only(ids) {
    this.here = ids;
    document.querySelector(".objects .count").textContent = String(ids.size);
    this.filter();
  }

  filter() {
    const word = this.search.value.trim().toLowerCase();
    for (const [id, button] of this.rows) {
      const text = `${id} ${this.data.objects[id].category}`.toLowerCase();
      button.parentElement.hidden = !this.here.has(id) || !text.includes(word);
    }
  }

  show(id) {
    for (const [other, button] of this.rows) {
      button.setAttribute("aria-pressed", String(other === id));
      if (other === id) this.reveal(button);
    }
    const panel = byId("object-panel");
    panel.replaceChildren();
    this.sliders = [];
    panel.hidden = id === null;
    if (id === null) return;
    const thing = this.data.objects[id];
    const close = element("button", "panel-close", "\u00d7");
    close.type = "button";
    close.setAttribute("aria-label", "Close the details");
    close.addEventListener("click", () => this.select(null));
    panel.append(close, element("h3", "", id), element("p", "panel-kind", thing.category));
    if (thing.description) panel.append(element("p", "panel-description", thing.description));
    const facts = element("dl");
    const fact = (name, value) => facts.append(element("dt", "", name), element("dd", "", value));
    const [d, w, h] = thing.size.map(metres);
    fact("Size", `${d} deep \u00d7 ${w} wide \u00d7 ${h} high m`);
    fact("Position", thing.position.map(metres).join(", ") + " m");
    fact("Yaw", `${thing.yaw.toFixed(1)}\u00b0` + (thing.tilted ? ", tilted" : ""));
    panel.append(facts);
    const links = element("dl");
    const link = (name, ids, rest) => {
      if (!ids.length) return;
      const value = element("dd");
      ids.forEach((other, k) => {
        const button = element("button", "link", other);
        button.type = "button";
        button.addEventListener("click", () => this.select(other));
        value.append(k ? ", " : "", button);
      });
      if (rest) value.append(rest);
      links.append(element("dt", "", name), value);
    };
    if (thing.support) link("Stands on", [thing.support.object], ` (${thing.support.surface})`);
    else links.append(element("dt", "", "Mounted"), element("dd", "", thing.mount));
    link("Carries", thing.carries);
    if (thing.asset) links.append(element("dt", "", "Asset"), element("dd", "asset-id", thing.asset));
    panel.append(links);
    this.doors(panel, id);
    this.rules(panel, "Relations", thing.relations);
    if (thing.faults.length) {
      const faults = element("ul", "panel-faults");
      for (const text of thing.faults) faults.append(element("li", "", text));
      panel.append(element("h4", "", "Violations"), faults);
    }
  }

  // A slider for each door, drawer and lid.
  doors(panel, id) {
    const items = this.moving(id);
    if (!items.length) return;
    const list = element("ul", "panel-doors");
    for (const item of items) {
      const label = element("label", "", item.joint.name);
      const slider = element("input");
      Object.assign(slider, { type: "range", min: "0", max: "100", step: "1", value: String(100 * item.share) });
      slider.addEventListener("input", () => this.open([item], Number(slider.value) / 100));
      label.append(slider);
      const row = element("li");
      row.append(label);
      list.append(row);
      this.sliders.push({ item, slider });
    }
    panel.append(element("h4", "", "Opens"), list);
  }

  // Puts the sliders where the doors are.
  opened() {
    for (const { item, slider } of this.sliders) slider.value = String(100 * item.share);
  }

  // The rows of some objects, the first of them in sight.
  mark(ids) {
    let first = true;
    for (const [id, button] of this.rows) {
      const lit = ids.has(id);
      button.classList.toggle("shown", lit);
      if (lit && first) this.reveal(button);
      first = first && !lit;
    }
  }

  reveal(button) {
    const list = byId("object-list"); // scrolls the list, not the page
    const top = button.offsetTop - list.offsetTop;
    if (top < list.scrollTop || top + button.offsetHeight > list.scrollTop + list.clientHeight) {
      list.scrollTop = top - list.clientHeight / 2;
    }
  }

  rules(panel, title, relations) {
    if (!relations.length) return;
    const list = element("ul", "panel-relations");
    for (const { text, held } of relations) {
      const row = element("li", held === false ? "broken" : held === true ? "held" : "");
      const mark = element("span", "mark", held === false ? "\u2717" : held === true ? "\u2713" : "\u00b7");
      mark.setAttribute("aria-label", held === false ? "does not hold" : held === true ? "holds" : "not checked");
      mark.setAttribute("role", "img");
      row.append(mark, element("span", "", text));
      list.append(row);
    }
    panel.append(element("h4", "", title), list);
  }
}

// Names over the objects; of two that would overlap only the nearer one is shown.
class Labels {
  constructor(data, select) {
    this.box = byId("labels");
    this.marks = Object.entries(data.objects).map(([id, thing]) => {
      const mark = element("button", "label", id);
      mark.type = "button";
      mark.tabIndex = -1;
      mark.addEventListener("click", () => select(id));
      this.box.append(mark);
      return { id, mark, place: thing.top, wide: 0 };
    });
  }

  draw(view, width, height, all, chosen, shown) {
    const seen = [];
    for (const label of this.marks) {
      const wanted = (all && shown(label.id)) || chosen.has(label.id);
      const [x, y, , w] = transform(view, label.place);
      const inside = wanted && w > 0 && Math.abs(x) < w && Math.abs(y) < w;
      if (!inside) label.mark.hidden = true;
      else seen.push({ ...label, x: ((x / w) * 0.5 + 0.5) * width, y: (0.5 - (y / w) * 0.5) * height, w });
    }
    seen.sort((a, b) => chosen.has(b.id) - chosen.has(a.id) || a.w - b.w);
    const taken = [];
    for (const label of seen) {
      label.mark.hidden = false;
      const half = label.mark.offsetWidth / 2 + 2;
      const clear = taken.every((t) => Math.abs(t.x - label.x) > t.half + half || Math.abs(t.y - label.y) > 20);
      label.mark.hidden = !clear;
      if (!clear) continue;
      taken.push({ x: label.x, y: label.y, half });
      label.mark.style.transform = `translate(-50%, -100%) translate(${label.x.toFixed(1)}px, ${label.y.toFixed(1)}px)`;
      label.mark.classList.toggle("chosen", chosen.has(label.id));
    }
  }
}
