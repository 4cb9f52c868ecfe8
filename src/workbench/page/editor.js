// The program's text with its line numbers.

export class Editor {
  /** `choose` is called with the line, from 1, that a person goes to. */
  constructor(area, gutter, choose) {
    this.area = area;
    this.gutter = gutter;
    this.marks = new Map();
    this.lines = 0;
    area.addEventListener("input", () => this.number());
    area.addEventListener("scroll", () => { gutter.scrollTop = area.scrollTop; });
    new ResizeObserver(() => { gutter.style.height = area.offsetHeight + "px"; }).observe(area);
    const lineAtCaret = () => area.value.slice(0, area.selectionStart).split("\n").length;
    area.addEventListener("click", () => choose(lineAtCaret()));
    area.addEventListener("keyup", (event) => {
      if (event.key.startsWith("Arrow") || event.key.startsWith("Page")) choose(lineAtCaret());
    });
    gutter.addEventListener("click", (event) => {
      const line = Number(event.target.dataset.line);
      if (line) choose(line);
    });
  }

  get text() { return this.area.value; }

  set text(text) {
    this.area.value = text;
    this.area.scrollTop = 0;
    this.number();
  }

  /** Numbers the lines; those that are there already stay. */
  number() {
    const lines = Math.min(this.area.value.split("\n").length, 20000);
    while (this.lines > lines) { this.gutter.lastChild.remove(); this.lines--; }
    const more = document.createDocumentFragment();
    while (this.lines < lines) {
      const number = document.createElement("div");
      number.textContent = number.dataset.line = ++this.lines;
      more.append(number);
    }
    this.gutter.append(more);
    this.gutter.scrollTop = this.area.scrollTop;
  }

  /** Marks one line with a class, and no other. */
  mark(name, line) {
    const before = this.gutter.children[(this.marks.get(name) ?? 0) - 1];
    before?.classList.remove(name);
    this.marks.set(name, line ?? 0);
    this.gutter.children[(line ?? 0) - 1]?.classList.add(name);
  }

  /** Selects characters of a line, line and column from 1, and goes there. */
  select(line, column, length) {
    const lines = this.area.value.split("\n");
    const before = lines.slice(0, line - 1).join("\n").length + (line > 1 ? 1 : 0);
    // Columns count characters, positions UTF-16 units.
    const units = (count) => [...(lines[line - 1] ?? "")].slice(0, count).join("").length;
    this.area.focus();
    this.area.setSelectionRange(before + units(column - 1), before + units(column - 1 + length));
    this.show(line);
  }

  /** Scrolls a line into view. */
  show(line) {
    const height = this.gutter.firstChild?.offsetHeight ?? 20;
    const top = (line - 1) * height;
    if (top < this.area.scrollTop || top > this.area.scrollTop + this.area.clientHeight - 2 * height) {
      this.area.scrollTop = Math.max(0, top - this.area.clientHeight / 3);
    }
    this.gutter.scrollTop = this.area.scrollTop;
  }
}
