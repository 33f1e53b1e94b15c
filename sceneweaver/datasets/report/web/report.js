"use strict";
(() => {
  const form = document.getElementById("filter");
  if (!form) return;
  const STEP = 48;
  const cards = [...document.querySelectorAll("#wall > figure")];
  const more = document.getElementById("more");
  let shown = STEP;

  function update() {
    const kind = form.kind.value, grade = Number(form.grade.value), objects = Number(form.objects.value);
    form["grade-shown"].value = form.grade.value;
    form["objects-shown"].value = form.objects.value;
    let fitting = 0;
    for (const card of cards) {
      const data = card.dataset;
      const fits = (!kind || data.kind === kind) && Number(data.grade) >= grade && Number(data.objects) <= objects;
      card.hidden = !fits || fitting >= shown;
      fitting += fits;
    }
    document.getElementById("count").textContent = `${fitting} of ${cards.length} plans`;
    more.hidden = fitting <= shown;
  }

  form.addEventListener("input", () => { shown = STEP; update(); });
  form.addEventListener("submit", (event) => event.preventDefault());
  more.addEventListener("click", () => { shown += 2 * STEP; update(); });
  update();
})();
