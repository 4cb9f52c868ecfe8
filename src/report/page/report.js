"use strict";
// The clause matrix shows the rows that every filter lets through.
const find = document.getElementById("find");
const state = document.getElementById("state");
const chapter = document.getElementById("chapter");
const rows = [...document.querySelectorAll("#matrix tbody tr")];
function filter() {
  const words = find.value.trim().toLowerCase();
  let shown = 0;
  for (const row of rows) {
    const fits = (!state.value || row.dataset.state === state.value)
      && (!chapter.value || row.dataset.chapter === chapter.value)
      && row.textContent.toLowerCase().includes(words);
    row.hidden = !fits;
    shown += fits ? 1 : 0;
  }
  document.getElementById("shown").textContent = shown + " of " + rows.length + " clauses";
}
for (const control of [find, state, chapter]) control.addEventListener("input", filter);
document.querySelector(".filters").addEventListener("submit", (event) => event.preventDefault());

// Pictures: zoom about the middle or the pointer, move by dragging or with the arrow keys.
for (const picture of document.querySelectorAll(".picture")) {
  const view = picture.querySelector(".view");
  const svg = picture.querySelector("svg");
  const whole = svg.getAttribute("viewBox").split(" ").map(Number);
  let box = whole.slice();
  const show = () => svg.setAttribute("viewBox", box.join(" "));
  const zoom = (times, at = [0.5, 0.5]) => {
    const width = Math.min(whole[2], Math.max(whole[2] / 200, box[2] / times));
    const height = width * whole[3] / whole[2];
    box = [box[0] + (box[2] - width) * at[0], box[1] + (box[3] - height) * at[1], width, height];
    show();
  };
  const move = (right, down) => {
    box = [box[0] + right * box[2], box[1] + down * box[3], box[2], box[3]];
    show();
  };
  const reset = () => { box = whole.slice(); show(); };
  for (const button of picture.querySelectorAll("[data-zoom]")) {
    const times = Number(button.dataset.zoom);
    button.addEventListener("click", () => times ? zoom(times) : reset());
  }
  view.addEventListener("keydown", (event) => {
    const keys = {
      ArrowLeft: () => move(-0.1, 0), ArrowRight: () => move(0.1, 0), ArrowUp: () => move(0, -0.1),
      ArrowDown: () => move(0, 0.1), "+": () => zoom(1.5), "=": () => zoom(1.5), "-": () => zoom(1 / 1.5), 0: reset,
    };
    const action = keys[event.key];
    if (action) { action(); event.preventDefault(); }
  });
  svg.addEventListener("wheel", (event) => {
    if (!event.ctrlKey && document.activeElement !== view) return;
    const place = svg.getBoundingClientRect();
    const at = [(event.clientX - place.left) / place.width, (event.clientY - place.top) / place.height];
    zoom(event.deltaY < 0 ? 1.2 : 1 / 1.2, at);
    event.preventDefault();
  }, { passive: false });
  let last = null;
  svg.addEventListener("pointerdown", (event) => { last = [event.clientX, event.clientY]; svg.setPointerCapture(event.pointerId); });
  svg.addEventListener("pointerup", () => { last = null; });
  svg.addEventListener("pointermove", (event) => {
    if (!last) return;
    const place = svg.getBoundingClientRect();
    move((last[0] - event.clientX) / place.width, (last[1] - event.clientY) / place.height);
    last = [event.clientX, event.clientY];
  });
}
