// The picture: millimetres as units, the second axis up, so that y is its negative. What keeps its size on the screen
// (arrows, names, marks) is a pin, set again whenever the picture is zoomed.

const SPACE = "http://www.w3.org/2000/svg";
const MOST_TOOLS = 300;
const MOST_PINS = 1500;
/** So many names are placed; those after them are left out, until the picture shows less of the program. */
const MOST_NAMES = 250;

export const LEGEND = [
  ["programmed", "programmed contour"], ["lead", "programmed start-up, cancel"], ["compensated", "tool centre, compensated"],
  ["corner", "corner move"], ["uncompensated", "tool centre, uncompensated"], ["rapid", "rapid traverse"],
  ["refused", "block with the alarm"], ["swept", "swept by the tool"], ["device", "the device's path"],
];

function element(name, attributes = {}, parent = null) {
  const made = document.createElementNS(SPACE, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  parent?.append(made);
  return made;
}

const number = (value) => String(Math.round(value * 1e6) / 1e6);
const place = ([x, y]) => number(x) + " " + number(-y);

/** The point of a shape at a part of its length, and the heading there in radians. */
function along(shape, part) {
  if (!shape.about) {
    const [dx, dy] = [shape.to[0] - shape.from[0], shape.to[1] - shape.from[1]];
    return { at: [shape.from[0] + dx * part, shape.from[1] + dy * part], heading: Math.atan2(dy, dx) };
  }
  const angle = Math.atan2(shape.from[1] - shape.about[1], shape.from[0] - shape.about[0]) + shape.sweep * part;
  const at = [shape.about[0] + shape.radius * Math.cos(angle), shape.about[1] + shape.radius * Math.sin(angle)];
  return { at, heading: angle + Math.sign(shape.sweep) * Math.PI / 2 };
}

const long = (shape) => shape.about
  ? Math.abs(shape.sweep) * shape.radius : Math.hypot(shape.to[0] - shape.from[0], shape.to[1] - shape.from[1]);

/** Path data that goes on from the shape's start; arcs in two halves, so that a whole circle is drawn too. */
function onward(shape) {
  if (!shape.about) return "L" + place(shape.to);
  const arc = `A${number(shape.radius)} ${number(shape.radius)} 0 0 ${shape.sweep < 0 ? 1 : 0} `;
  return arc + place(along(shape, 0.5).at) + arc + place(shape.to);
}

const data = (shape) => "M" + place(shape.from) + onward(shape);

/** The box that holds everything. */
function bounds(outcome, moved) {
  let [left, low, right, high] = [0, 0, 0, 0];
  const hold = ([x, y], by = 0) => {
    [left, right] = [Math.min(left, x - by), Math.max(right, x + by)];
    [low, high] = [Math.min(low, y - by), Math.max(high, y + by)];
  };
  for (const { shape } of [...outcome.programmed, ...moved, ...(outcome.device?.path ?? [])]) {
    hold(shape.from);
    hold(shape.to);
    if (shape.about) for (let part = 1; part < 16; part++) hold(along(shape, part / 16).at);
  }
  for (const tool of outcome.tools) hold(tool.at, tool.radius);
  for (const { shape, tool } of moved) {
    if (tool) { hold(shape.from, tool); hold(shape.to, tool); }
  }
  const size = Math.max(right - left, high - low, 1e-3);
  const edge = size * 0.06;
  return [left - edge, -high - edge, right - left + 2 * edge, high - low + 2 * edge];
}

/** Whether a box lies in another. */
const within = ([x, y, wide, tall], [left, top, width, height]) =>
  x >= left && y >= top && x + wide <= left + width && y + tall <= top + height;

export class Drawing {
  /** `choose` is called with the block that a person points at. */
  constructor(view, choose) {
    this.view = view;
    this.svg = element("svg", { class: "drawing", xmlns: SPACE, preserveAspectRatio: "xMidYMid meet" });
    view.append(this.svg);
    this.pins = [];
    this.shown = { swept: true, tools: false, names: true };
    this.whole = [0, 0, 100, 100];
    this.fit();
    this.chosen = null;
    this.svg.addEventListener("click", (event) => {
      const block = event.target.dataset?.block;
      if (block !== undefined && !this.dragged) choose(Number(block));
    });
    this.listen();
    new ResizeObserver(() => this.pin()).observe(view);
  }

  /** Draws an outcome. What a person has zoomed to stays, unless the program is another one; a picture of the whole that
      no longer holds all, or is of a program that was changed, is made to fit. */
  show(outcome, { other, changed }) {
    const moved = outcome.path.filter((step) => step.shape);
    this.outcome = outcome;
    this.pins = [];
    this.svg.replaceChildren();
    const zoomed = this.box.some((value, index) => value !== this.fitted[index]);
    this.whole = bounds(outcome, moved);
    if (other || (!zoomed && (changed || !within(this.whole, this.box)))) this.fit();
    const group = (name) => element("g", { class: name }, this.svg);
    const reach = 4 * Math.max(this.whole[2], this.whole[3]) + Math.abs(this.whole[0]) + Math.abs(this.whole[1]);
    element("path", { class: "grid", d: `M${-reach} 0H${reach}M0 ${-reach}V${reach}` }, group("axes"));
    this.swept(group("swept"), moved);
    this.tools(group("tools"), outcome.tools);
    const lines = group("lines");
    const line = ({ block, shape }) => element("path", { class: shape.trace, d: data(shape), "data-line": block }, lines);
    outcome.programmed.filter(({ shape }) => shape.trace !== "followed").forEach(line);
    moved.forEach(line);
    const device = group("device");
    for (const { shape } of outcome.device?.path ?? []) element("path", { d: data(shape) }, device);
    for (const safety of [outcome.safety, outcome.device?.safety]) this.gouge(lines, safety);
    this.hits(group("hit"), moved);
    this.collect(group("pins"), moved);
    this.highlight(this.chosen);
    this.svg.setAttribute("viewBox", this.box.map(number).join(" "));
    this.visible();
  }

  /** The area that the tool sweeps in offset mode is the path, as wide as the tool. */
  swept(group, moved) {
    let open = null;
    const lines = [];
    for (const { shape, tool } of moved) {
      const cutting = shape.trace === "compensated" || shape.trace === "corner";
      const radius = tool ?? open?.radius;
      if (!cutting || !radius) { open = null; continue; }
      if (!open || open.radius !== radius) {
        const line = element("path", { "stroke-width": number(2 * radius) }, group);
        open = { radius, line, data: ["M" + place(shape.from)] };
        lines.push(open);
      }
      open.data.push(onward(shape));
    }
    for (const { line, data } of lines) line.setAttribute("d", data.join(""));
  }

  tools(group, tools) {
    const step = Math.max(1, Math.ceil(tools.length / MOST_TOOLS));
    tools.filter((_, index) => index % step === 0).forEach(({ at, radius, block }) => {
      element("circle", { class: "tool", cx: number(at[0]), cy: number(-at[1]), r: number(radius), "data-tool": block }, group);
    });
  }

  gouge(group, safety) {
    if (safety?.state !== "gouges") return;
    element("circle", { class: "gouge", cx: number(safety.centre[0]), cy: number(-safety.centre[1]), r: number(this.outcome.radius) }, group);
  }

  /** Broad unseen lines that are easy to hit. */
  hits(group, moved) {
    for (const { block, shape } of [...this.outcome.programmed, ...moved]) {
      const hit = element("path", { d: data(shape), "data-block": block }, group);
      const told = this.outcome.blocks[block];
      if (told) element("title", {}, hit).textContent = told.text.trim();
    }
  }

  /** What keeps its size: arrows, ends with their names, marks, the start. */
  collect(group, moved) {
    const pin = (name, at, more) => {
      if (this.pins.length < MOST_PINS) this.pins.push({ node: element(name, more, group), at, ...more.pin });
    };
    for (const { shape } of moved) {
      const { at, heading } = along(shape, 0.5);
      const corner = shape.trace === "corner" ? " corner" : "";
      this.pins.length < MOST_PINS && this.pins.push({
        node: element("path", { class: "arrow" + corner, d: "M7 0L-5 4.5V-4.5Z" }, group), at, turn: -heading, length: long(shape),
      });
    }
    for (const { block, shape } of this.outcome.programmed) {
      pin("circle", shape.to, { class: "end", r: 2.4 });
      const told = this.outcome.blocks[block];
      const name = element("text", { "text-anchor": "middle" }, group);
      name.textContent = told ? (told.n ? "N" + told.n : "line " + told.line) : "";
      this.pins.push({ node: name, at: shape.to, name: name.textContent });
    }
    pin("circle", moved[0]?.shape.from ?? [0, 0], { class: "start", r: 5 });
    for (const mark of this.outcome.marks) {
      const alarm = mark.kind === "alarm";
      pin("path", mark.at, { class: alarm ? "cross" : "warning", d: alarm ? "M-7 -7L7 7M-7 7L7 -7" : "M0 -9L8 6H-8Z" });
      const text = element("text", { class: alarm ? "alarm-text" : "warning-text", "text-anchor": "middle" }, group);
      text.textContent = mark.text;
      this.pins.push({ node: text, at: mark.at, name: mark.text, first: true });
    }
  }

  /** Hides what is not wanted. */
  visible() {
    const hide = (name, shown) => { this.svg.querySelector("." + name)?.toggleAttribute("hidden", !shown); };
    hide("swept", this.shown.swept);
    hide("tools", this.shown.tools);
    this.pin();
  }

  highlight(block) {
    this.chosen = block;
    for (const line of this.svg.querySelectorAll(".lines > [data-line]")) {
      line.classList.toggle("chosen", Number(line.dataset.line) === block);
    }
  }

  /** Millimetres of a pixel. */
  scale() {
    const { width, height } = this.svg.getBoundingClientRect();
    return Math.max(this.box[2] / Math.max(width, 1), this.box[3] / Math.max(height, 1));
  }

  zoomed() {
    this.svg.setAttribute("viewBox", this.box.map(number).join(" "));
    this.pin();
  }

  /** Sets the pins; a name that would cover another is left out. */
  pin() {
    const scale = this.scale();
    const taken = [];
    const [left, top, wide, tall] = this.box;
    const seen = ([x, y]) => x > left - wide && x < left + 2 * wide && -y > top - tall && -y < top + 2 * tall;
    const free = (box) => taken.every((other) => box[0] > other[2] || box[2] < other[0] || box[1] > other[3] || box[3] < other[1]);
    for (const pin of [...this.pins].sort((a, b) => (b.first ?? false) - (a.first ?? false))) {
      let [x, y] = [pin.at[0], -pin.at[1]];
      let hidden = !seen(pin.at) || (pin.length !== undefined && pin.length / scale < 34);
      if (pin.name !== undefined && !pin.first && (taken.length >= MOST_NAMES || !this.shown.names)) {
        hidden = true;
      } else if (pin.name !== undefined && !hidden) {
        const [half, high] = [pin.name.length * 3.6 + 2, 7];
        const spots = [[0, -13], [0, 17], [half + 8, 0], [-half - 8, 0], [half, -14], [-half, -14], [half, 18], [-half, 18]];
        const boxed = ([right, down]) => [x / scale + right - half, y / scale + down - high, x / scale + right + half, y / scale + down + high];
        const spot = spots.find((spot) => free(boxed(spot)));
        hidden = !pin.first && !spot;
        const [right, down] = spot ?? spots[0];
        if (!hidden) taken.push(boxed([right, down]));
        [x, y] = [x + right * scale, y + (down + 4) * scale];
      }
      pin.node.toggleAttribute("hidden", hidden);
      if (hidden) continue;
      const turn = pin.turn === undefined ? "" : ` rotate(${number(pin.turn * 180 / Math.PI)})`;
      pin.node.setAttribute("transform", `translate(${number(x)} ${number(y)}) scale(${scale})${turn}`);
    }
  }

  /** Shows the whole. */
  fit() {
    this.box = this.whole.slice();
    this.fitted = this.whole;
  }

  /** Zooms about a point of the view, its parts from 0 to 1; 0 times shows the whole. */
  zoom(times, [right, down] = [0.5, 0.5]) {
    if (!times) {
      this.fit();
    } else {
      const [x, y, wide, tall] = this.box;
      const part = Math.min(4 * this.whole[2], Math.max(this.whole[2] / 2000, wide / times)) / wide;
      this.box = [x + wide * (1 - part) * right, y + tall * (1 - part) * down, wide * part, tall * part];
    }
    this.zoomed();
  }

  move(right, down) {
    this.box = [this.box[0] + right, this.box[1] + down, this.box[2], this.box[3]];
    this.zoomed();
  }

  listen() {
    const { view, svg } = this;
    view.addEventListener("keydown", (event) => {
      const step = Math.max(this.box[2], this.box[3]) / 10;
      const keys = {
        ArrowLeft: () => this.move(-step, 0), ArrowRight: () => this.move(step, 0), ArrowUp: () => this.move(0, -step),
        ArrowDown: () => this.move(0, step), "+": () => this.zoom(1.5), "=": () => this.zoom(1.5), "-": () => this.zoom(1 / 1.5),
        0: () => this.zoom(0),
      };
      const action = event.ctrlKey || event.metaKey || event.altKey ? null : keys[event.key];
      if (action) { action(); event.preventDefault(); }
    });
    view.addEventListener("wheel", (event) => {
      if (!event.ctrlKey && document.activeElement !== view) return;
      const place = svg.getBoundingClientRect();
      const at = [(event.clientX - place.left) / place.width, (event.clientY - place.top) / place.height];
      this.zoom(event.deltaY < 0 ? 1.2 : 1 / 1.2, at);
      event.preventDefault();
    }, { passive: false });
    let last = null;
    svg.addEventListener("pointerdown", (event) => { last = [event.clientX, event.clientY]; this.dragged = false; });
    window.addEventListener("pointerup", () => { last = null; });
    window.addEventListener("pointermove", (event) => {
      if (!last) return;
      const [right, down] = [last[0] - event.clientX, last[1] - event.clientY];
      if (!this.dragged && Math.hypot(right, down) < 4) return;
      this.dragged = true;
      this.move(right * this.scale(), down * this.scale());
      last = [event.clientX, event.clientY];
    });
  }

  /** The picture as it is seen, as a file of its own with that style sheet. */
  file(style, title, description) {
    const copy = this.svg.cloneNode(true);
    copy.querySelector(".hit").remove();
    for (const hidden of copy.querySelectorAll("[hidden]")) hidden.remove();
    const { width, height } = this.svg.getBoundingClientRect();
    copy.setAttribute("width", Math.round(width));
    copy.setAttribute("height", Math.round(height));
    const ground = element("rect", { x: this.box[0] - 2 * this.box[2], y: this.box[1] - 2 * this.box[3], width: 5 * this.box[2], height: 5 * this.box[3], fill: "#fff" });
    const head = [["title", title], ["desc", description], ["style", style]].map(([name, text]) => {
      const made = element(name);
      made.textContent = text;
      return made;
    });
    copy.prepend(...head, ground);
    return new XMLSerializer().serializeToString(copy);
  }
}
