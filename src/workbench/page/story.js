// What is said of a program: cards above the picture, the story of each block, the table of the path.

/** An element with children, which are nodes or texts. */
export function make(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith("on")) made.addEventListener(key.slice(2), value);
    else made.setAttribute(key, value);
  }
  made.append(...children.filter((child) => child !== null && child !== undefined && child !== ""));
  return made;
}

const named = (record) => (record.n ? `N${record.n}, line ${record.line}` : `line ${record.line}`);

/** Whether a decimal of twelve digits tells all that a closed form tells: a fraction whose denominator is of twos and fives. */
function told(exact) {
  const fraction = /^-?\d+(?:\/(\d+))?$/.exec(exact);
  if (!fraction) return false;
  let below = BigInt(fraction[1] ?? 1);
  for (const prime of [2n, 5n]) while (below % prime === 0n) below /= prime;
  return below === 1n && (fraction[1] ?? "").length <= 12;
}

export class Story {
  /** `rules` as the server gives them; `choose` is called with the block that a person goes to; `ask` asks the server
      for more about the outcome that is shown. */
  constructor(rules, places, choose, ask) {
    this.rules = rules;
    this.places = places;
    this.choose = choose;
    this.ask = ask;
    places.pathPart.addEventListener("toggle", () => this.table());
  }

  show(outcome) {
    const same = this.outcome?.blocks.length === outcome.blocks.length
      && outcome.blocks.every((block, index) => block.text === this.outcome.blocks[index].text && block.line === this.outcome.blocks[index].line);
    const chips = this.chips(outcome);
    this.outcome = outcome;
    this.cards();
    if (same) {
      // While the radius is dragged, only what the lines end with changes, and what is open.
      [...this.places.blocks.children].forEach((details, block) => this.change(details, chips.get(block) ?? []));
    } else {
      this.places.blocks.replaceChildren(...outcome.blocks.map((block) => this.block(block, chips.get(block.block) ?? [])));
    }
    this.fill();
    this.places.pathCount.textContent = `(${outcome.path.length} elements)`;
    this.table();
  }

  change(details, chips) {
    const place = details.querySelector(".chips");
    if (place.textContent !== chips.map((chip) => chip.textContent).join("")) place.replaceChildren(...chips);
    if (details.dataset.told) {
      while (details.children.length > 1) details.lastChild.remove();
      delete details.dataset.told;
    }
  }

  card(kind, title, ...more) {
    return make("div", { class: "card " + kind }, make("b", {}, title), ...more);
  }

  go(block, text) {
    return make("button", { type: "button", class: "go", onclick: () => this.choose(block, true) }, text);
  }

  sentence(id) {
    const clause = this.rules.clauses[id];
    if (!clause) return make("p", {}, make("code", {}, id));
    // Formulas stand between backticks.
    const parts = clause.sentence.split("`").map((part, index) => (index % 2 ? make("code", {}, part) : part));
    return make("p", { class: "clause-text" }, make("code", {}, id), ` ${clause.title}: `, ...parts);
  }

  cards() {
    const { alarm, refused, warnings, safety, device, blocks, path, milliseconds } = this.outcome;
    const cards = [];
    const count = (of, one) => `${of} ${one}${of === 1 ? "" : "s"}`;
    if (alarm) {
      const number = alarm.number ? make("p", { class: "quiet" }, `The control calls it: ${alarm.number}`) : null;
      cards.push(this.card("fail alarm", `Alarm ${alarm.alarm}`, " at ", this.go(alarm.block, named(alarm)), ": " + alarm.text + ".",
        this.sentence(alarm.clause), number));
    } else if (!refused) {
      cards.push(this.card("pass", "No alarm", make("p", { class: "quiet" },
        `${count(blocks.length, "block")}, ${count(path.length, "path element")}; computed in ${milliseconds.toFixed(1)} ms`)));
    }
    if (refused) {
      cards.push(this.card("neutral", `Read as far as line ${refused.line}`, make("p", { class: "quiet" },
        `${count(blocks.length, "block")} before the fault; the last corner is open.`)));
    }
    for (const warning of warnings.slice(0, 4)) {
      const exact = warning.amount.exact && !told(warning.amount.exact) ? ` = ${warning.amount.exact}` : "";
      cards.push(this.card("expected", `Warning ${warning.advisory}`, " at ", this.go(warning.block, named(warning)),
        `: ${warning.text}: ${warning.amount.decimal} mm${exact}.`, this.sentence(warning.clause)));
    }
    if (warnings.length > 4) cards.push(this.card("expected", `${warnings.length - 4} more warnings`, " stand at their blocks."));
    if (safety) cards.push(this.safety(safety, "Safety"));
    if (device) cards.push(...this.device(device));
    this.places.state.replaceChildren(...cards);
  }

  safety(safety, title) {
    const kind = { safe: "pass", gouges: "fail" }[safety.state] ?? "expected";
    const more = [];
    for (const [name, part] of [["Start-up block", safety.start_up], ["Cancel block", safety.cancel]]) {
      if (part && part.state !== "safe") more.push(make("p", { class: "quiet" }, `${name}, as programmed: ${part.text}.`));
    }
    if (safety.uncut) more.push(make("p", { class: "quiet" }, safety.uncut.text + " where the tool has room."));
    const place = safety.block === undefined ? "" : this.go(safety.block, "show");
    return this.card(kind, `${title}: ${safety.state}`, `; ${safety.text}. `, place, ...more);
  }

  device(device) {
    if (device.fault) return [this.card("fail device", `Device, ${device.name}`, make("p", {}, device.fault))];
    const { verdict, alarm } = device;
    const kind = verdict.id === null ? "neutral" : verdict.green ? "pass" : "fail";
    const more = verdict.block === null || verdict.block === undefined ? "" : this.go(verdict.block, "show");
    const stopped = alarm ? make("p", {}, `It stops with ${alarm.alarm} at ${alarm.at}.`) : null;
    const clause = verdict.clause ? this.sentence(verdict.clause) : null;
    const title = `Device, ${device.name}: ${verdict.id ?? "drawn"}`;
    const cards = [this.card(kind + " device", title, `; ${verdict.text}. `, more, stopped, clause)];
    if (device.safety) cards.push(this.safety(device.safety, "Safety of the device's path"));
    return cards;
  }

  /** What stands at the end of a block's line: its alarm, its warnings, its clauses. */
  chips({ path, warnings, alarm }) {
    const chips = new Map();
    const add = (block, kind, text) => {
      const list = chips.get(block) ?? [];
      if (!list.some((chip) => chip.textContent === text)) list.push(make("span", { class: "chip " + kind }, text));
      chips.set(block, list);
    };
    if (alarm) add(alarm.block, "fail", "alarm");
    for (const { block } of warnings) add(block, "expected", "warning");
    for (const { block, clause } of [...path, ...warnings, ...(alarm ? [alarm] : [])]) add(block, "clause", clause.replace("TRC-", ""));
    return chips;
  }

  block(block, chips) {
    const summary = make("summary", { onclick: () => this.choose(block.block, false) },
      make("span", { class: "at" }, String(block.line)), make("code", { class: "text" }, block.text.trim()), make("span", { class: "chips" }, ...chips));
    const details = make("details", { class: "block", "data-block": block.block, "data-line": block.line }, summary);
    details.addEventListener("toggle", () => this.fill());
    return details;
  }

  /** Asks for what is open and not told yet. */
  async fill() {
    if (this.filling) return;
    this.filling = true;
    await Promise.resolve();
    for (;;) {
      const empty = [...this.places.blocks.querySelectorAll("details[open]:not([data-told])")];
      if (empty.length === 0) break;
      const lines = empty.map((details) => Number(details.dataset.line));
      for (const details of empty) details.dataset.told = "asked";
      const { outcome } = this;
      const told = await this.ask("/blocks", { lines }).catch((problem) => problem);
      if (outcome !== this.outcome) {
        for (const details of empty) delete details.dataset.told;
        continue;
      }
      const bodies = told instanceof Error ? new Map() : new Map(told.map((block) => [block.line, block]));
      for (const details of empty) {
        const block = bodies.get(Number(details.dataset.line));
        const why = told instanceof Error ? told.message : "The tool stops before this block is read.";
        details.append(...(block ? this.body(block) : [make("p", { class: "told quiet" }, why)]));
      }
    }
    this.filling = false;
  }

  body(block) {
    const list = make("dl", { class: "told" });
    for (const row of block.rows) {
      const kind = { ALARM: "fail", WARNING: "expected" }[row.name] ?? "";
      const words = make("dd", { class: kind }, row.words);
      if (row.clause) words.append(" ", make("code", {}, row.clause));
      if (row.margin) {
        const exact = row.margin.exact ? ` = ${row.margin.exact}` : "";
        words.append(make("span", { class: "margin" }, `margin ${row.margin.decimal} mm${exact}`));
      }
      if (row.exact) words.append(make("span", { class: "exact" }, row.exact));
      list.append(make("dt", { class: kind }, row.name), words);
    }
    if (block.clauses.length === 0) return [list];
    return [list, make("div", { class: "clauses" }, ...block.clauses.map((id) => this.sentence(id)))];
  }

  /** Fills the table of the path, when it is open. */
  async table() {
    const { outcome } = this;
    if (!this.places.pathPart.open || !outcome || this.tabled === outcome) return;
    this.tabled = outcome;
    const path = await this.ask("/path", {}).catch(() => null);
    if (!path || this.outcome !== outcome) return;
    const axes = Object.keys(path.find((step) => step.end)?.end ?? {});
    const head = ["Line", "N", "Element", ...axes.map((axis) => axis + ", mm"), "Clause"];
    const cells = head.map((title) => make("th", { scope: "col" }, title));
    this.places.table.tHead.replaceChildren(make("tr", {}, ...cells));
    this.places.table.tBodies[0].replaceChildren(...path.map((step) => this.row(step, axes)));
    this.places.table.dataset.radius = String(outcome.radius);
  }

  row(step, axes) {
    let kind = step.kind === "arc" ? (step.full ? "circle " : "arc ") + step.direction : step.kind;
    if (step.rapid) kind = "rapid";
    if (step.main === false) kind = "corner " + kind;
    const value = (axis) => {
      const at = step.end?.[axis];
      const cell = make("td", { class: "number", "data-axis": axis }, at?.decimal ?? "");
      if (at?.exact && !told(at.exact)) cell.append(make("small", {}, at.exact));
      return cell;
    };
    return make("tr", { "data-block": step.block }, make("td", {}, String(step.line)), make("td", {}, step.n ?? ""),
      make("td", {}, kind), ...axes.map(value), make("td", {}, make("code", {}, step.clause)));
  }

  /** Marks a block, opens it if asked, and shows it. */
  highlight(block, open) {
    for (const place of [this.places.blocks, this.places.table.tBodies[0]]) {
      place.querySelectorAll(".chosen").forEach((chosen) => chosen.classList.remove("chosen"));
      place.querySelectorAll(`[data-block="${block}"]`).forEach((chosen) => chosen.classList.add("chosen"));
    }
    const details = this.places.blocks.querySelector(`[data-block="${block}"]`);
    if (open && details) {
      details.open = true;
      details.scrollIntoView({ block: "nearest" });
    }
  }
}
