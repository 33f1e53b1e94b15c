// A section with phrases or items that show their objects in the view and in the list: the request, where each tells
// what became of it, and what a model saw.
class Mentions {
  constructor(section, items, show) {
    this.items = items;
    this.show = show;
    this.detail = byId(`${section}-detail`);
    this.marks = [...document.querySelectorAll(`#${section} [data-items]`)];
    for (const mark of this.marks) {
      const tell = () => this.tell(mark);
      const rest = () => this.tell(this.pressed() || null);
      mark.addEventListener("click", () => this.press(mark));
      mark.addEventListener("keydown", (event) => {
        if (event.key !== "Enter" && event.key !== " ") return;
        event.preventDefault();
        this.press(mark);
      });
      mark.addEventListener("mouseenter", tell);
      mark.addEventListener("focus", tell);
      mark.addEventListener("mouseleave", rest);
      mark.addEventListener("blur", rest);
    }
    document.addEventListener("keydown", (event) => {
      if (event.key === "Escape" && this.pressed()) this.press(this.pressed());
    });
  }

  pressed() {
    return this.marks.find((mark) => mark.getAttribute("aria-pressed") === "true");
  }

  of(mark) {
    return mark.dataset.items.split(" ").map((k) => this.items[Number(k)]);
  }

  tell(mark) {
    if (!this.detail) return;
    this.detail.replaceChildren();
    for (const item of mark ? this.of(mark) : []) this.detail.append(element("span", item.status, item.text));
  }

  // Presses a mark, or lets it go when it is pressed. The objects are those of its first item that has any.
  press(mark) {
    const on = mark.getAttribute("aria-pressed") !== "true";
    this.release();
    mark.setAttribute("aria-pressed", String(on));
    this.tell(on ? mark : null);
    const found = on ? this.of(mark).find((item) => item.objects.length) : null;
    this.show(found ? found.objects : [], this);
  }

  release() {
    this.tell(null);
    for (const other of this.marks) other.setAttribute("aria-pressed", "false");
  }
}
