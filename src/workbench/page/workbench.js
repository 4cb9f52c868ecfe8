// The workbench: what is typed is asked, and what is answered is shown. One request is on its way at a time; while the
// slider is dragged, the latest radius waits for its turn.

import { Drawing, LEGEND } from "./drawing.js";
import { Editor } from "./editor.js";
import { MOST_CHARACTERS, decode, encode } from "./link.js";
import { Story, make } from "./story.js";

const id = (name) => document.getElementById(name);
const MOST_BYTES = 4 * 1024 * 1024;
/** How many radii the strip below the slider tries at a time. */
const TRIED = 50;
/** The fields of a state that are the values of controls. */
const VALUES = { profile: "profile", profile_file: "profile-file", tools: "tools", radius: "radius", device: "answer" };

const rules = await (await fetch("/rules.json")).json();
const editor = new Editor(id("program"), id("gutter"), (line) => chooseLine(line));
const drawing = new Drawing(id("view"), (block) => choose(block, true));
const story = new Story(rules, {
  state: id("state"), blocks: id("blocks"), pathPart: id("path-part"), pathCount: id("path-count"), table: id("path"),
}, choose, async (path, more) => (await post(path, { ...answered, device: "", ...more })).json());
let outcome = null;
/** What `outcome` answers. */
let answered = null;
let fresh = true;

// What is asked.

function state() {
  const kind = id("device").value;
  return {
    program: editor.text,
    profile: id("profile").value,
    profile_file: id("profile-file").value,
    tools: id("tools").value,
    offset: Number(id("offset").value) || 0,
    radius: id("radius").value.trim(),
    orientation: id("orientation").value === "" ? null : Number(id("orientation").value),
    block_delete: id("block-delete").checked,
    device: kind === "answer" ? id("answer").value : kind,
  };
}

/** Puts a state into the controls; what it leaves out takes its default. */
function restore(given) {
  const text = (name) => (typeof given[name] === "string" ? given[name] : "");
  editor.text = text("program");
  for (const [name, control] of Object.entries(VALUES)) if (name !== "profile") id(control).value = text(name);
  const known = rules.profiles.some((profile) => profile.name === given.profile);
  id("profile").value = known ? given.profile : rules.profiles[0].name;
  id("offset").value = Number.isInteger(given.offset) && given.offset > 0 ? given.offset : 1;
  id("orientation").value = Number.isInteger(given.orientation) ? given.orientation : "";
  id("block-delete").checked = given.block_delete === true;
  const device = text("device");
  id("device").value = device === "" || device === "builtin" ? device : "answer";
  id("answer").value = id("device").value === "answer" ? device : "";
  id("answer-part").hidden = id("device").value !== "answer";
  id("device-part").open = device !== "";
  id("tools-part").open = text("tools") + text("profile_file") !== "";
  drawing.chosen = null;
  fresh = true;
  scaleSlider();
  changed();
}

async function post(path, body, signal) {
  const response = await fetch(path, {
    method: "POST", headers: { "content-type": "application/json" }, body: JSON.stringify(body), signal,
  });
  if (response.ok) return response;
  const problem = await response.json().catch(() => null);
  throw new Error(problem?.error ?? `the workbench answers with status ${response.status}`);
}

let busy = false;
let again = false;
let stripTimer = 0;
let stripAsked = null;
/** What the strip tells of. */
let stripTold = "";

/** Asks for the state that the controls show. */
async function run() {
  if (busy) { again = true; return; }
  busy = true;
  do {
    again = false;
    const asked = state();
    try {
      const answer = await (await post("/run", { ...asked, safety: true })).json();
      const changed = answered?.program !== asked.program;
      answered = asked;
      show(answer, changed);
    } catch (problem) {
      failed(problem);
    }
    remember(asked);
  } while (again);
  busy = false;
  const about = stripAbout();
  if (about !== stripTold) {
    // What was told of another program no longer holds.
    stripTold = "";
    id("strip").replaceChildren();
    id("strip-text").textContent = "";
    clearTimeout(stripTimer);
    stripTimer = setTimeout(() => strip(about), 350);
  }
  document.body.dataset.settled = String(Number(document.body.dataset.settled ?? 0) + 1);
}

let timer = 0;
function changed(wait = 0) {
  clearTimeout(timer);
  timer = setTimeout(run, wait);
  clearTimeout(stripTimer);
  stripAsked?.abort();
}

// What is answered.

function show(answer, changed) {
  outcome = answer;
  document.body.classList.remove("stale");
  const { refused } = answer;
  fault(refused);
  drawing.show(answer, { other: fresh, changed });
  story.show(answer);
  id("count").textContent = `${answer.blocks.length} blocks`;
  legend(answer);
  fresh = answer.path.length === 0;
  if (drawing.chosen !== null) mark(drawing.chosen, false);
}

function failed(problem) {
  document.body.classList.add("stale");
  fault(null);
  const text = problem instanceof TypeError ? "the workbench does not answer: is `radcomp serve` still running?" : problem.message;
  const shape = text.includes("\n") ? make("pre", {}, text) : make("p", {}, text);
  id("state").replaceChildren(make("div", { class: "card fail problem" }, make("b", {}, "Not computed"), shape));
}

/** The reader's diagnostic, at its line and column. */
function fault(refused) {
  const place = id("fault");
  place.hidden = !refused;
  editor.mark("wrong", refused?.line);
  id("program").setAttribute("aria-invalid", String(Boolean(refused)));
  if (!refused) return;
  const where = `line ${refused.line}, column ${refused.column}`;
  const go = () => editor.select(refused.line, refused.column, refused.length);
  const line = editor.text.split("\n")[refused.line - 1] ?? "";
  const from = Math.max(0, refused.column - 30);
  const part = [...line].slice(from, refused.column + 40).join("").replaceAll("\t", " ");
  const caret = " ".repeat(refused.column - 1 - from) + "^".repeat(Math.min(refused.length, 41));
  const clause = refused.clause && rules.clauses[refused.clause];
  place.replaceChildren(make("b", {}, refused.title), " at ", make("button", { type: "button", class: "go", onclick: go }, where),
    make("pre", {}, part + "\n" + caret), make("p", {}, refused.text + (refused.help ? `; ${refused.help}` : "")),
    clause ? make("p", { class: "quiet" }, make("code", {}, refused.clause), ` ${clause.title}`) : "");
}

function legend({ programmed, path, device, tools }) {
  const traces = new Set([...programmed, ...path].map((part) => part.shape?.trace));
  if (device?.path) traces.add("device");
  if (tools.length) traces.add("swept");
  const entry = ([trace, words]) => {
    const item = make("li", {}, words);
    const style = { swept: '<g class="swept"><path d="M4 6H26" stroke-width="10"/></g>', device: '<g class="device"><path d="M1 6H29"/></g>' };
    item.insertAdjacentHTML("afterbegin",
      `<svg class="drawing" viewBox="0 0 30 12" aria-hidden="true">${style[trace] ?? `<path class="${trace}" d="M1 6H29"/>`}</svg>`);
    return item;
  };
  id("legend").replaceChildren(...LEGEND.filter(([trace]) => traces.has(trace)).map(entry));
}

// A block that is pointed at is marked everywhere.

function mark(block, open) {
  drawing.highlight(block);
  story.highlight(block, open);
  editor.mark("chosen", outcome?.blocks[block]?.line);
}

function choose(block, go) {
  mark(block, go);
  const line = outcome?.blocks[block]?.line;
  if (go && line) editor.show(line);
}

function chooseLine(line) {
  const block = outcome?.blocks.find((each) => each.line === line);
  if (block) mark(block.block, false);
}

id("view").addEventListener("keydown", (event) => {
  const step = { PageDown: 1, PageUp: -1 }[event.key];
  if (!step || !outcome) return;
  const next = (drawing.chosen ?? (step > 0 ? -1 : outcome.blocks.length)) + step;
  if (outcome.blocks[next]) choose(next, true);
  event.preventDefault();
});

// The radius and its slider.

const short = (value) => String(Number(value.toFixed(6)));

/** The slider reaches to a round number beyond twice the radius. */
function scaleSlider() {
  const radius = Number(id("radius").value);
  const slider = id("slider");
  slider.disabled = id("radius").value.trim() === "" || !Number.isFinite(radius) || radius < 0;
  if (slider.disabled) return;
  if (!(radius > slider.max / 10 && radius <= slider.max * 0.9)) {
    const wanted = 2 * radius || 10;
    const power = 10 ** Math.floor(Math.log10(wanted));
    const most = [1, 2, 5, 10].map((step) => step * power).find((step) => step >= wanted * 0.999);
    slider.max = short(most);
    slider.step = short(most / 200);
  }
  slider.value = radius;
}

id("slider").addEventListener("input", () => { id("radius").value = short(Number(id("slider").value)); changed(); });
id("radius").addEventListener("input", () => { scaleSlider(); changed(150); });

/** How the program ends with radii that part an interval evenly. */
async function tryRadii(from, to) {
  const radii = Array.from({ length: TRIED }, (_, index) => short(from + (index + 1) * (to - from) / TRIED));
  return (await post("/radii", { ...state(), device: "", radii }, stripAsked.signal)).json();
}

/** All that the strip depends on: the radius itself is not among it. */
const stripAbout = () => JSON.stringify({ ...state(), radius: "", device: "", most: id("slider").disabled ? 0 : id("slider").max });

/** Tries radii all along the slider, and shows where there is an alarm; then once more where the first one begins. */
async function strip(about) {
  const [slider, place, words] = [id("slider"), id("strip"), id("strip-text")];
  const most = Number(slider.max);
  stripAsked = new AbortController();
  let [tried, first, text] = [[], -1, ""];
  try {
    const few = outcome !== null && !outcome.refused && outcome.blocks.length * TRIED <= rules.most_blocks;
    if (few && !slider.disabled) tried = await tryRadii(0, most);
    first = tried.findIndex(({ alarm }) => alarm);
    if (tried.length > 0 && first < 0) text = `No alarm up to ${short(most)} mm.`;
    if (first >= 0) {
      const before = first > 0 ? Number(tried[first - 1].radius) : 0;
      const nearer = await tryRadii(before, Number(tried[first].radius));
      const at = nearer.findIndex(({ alarm }) => alarm);
      const below = at > 0 ? nearer[at - 1].radius : short(before);
      text = `${nearer[at].alarm}, line ${nearer[at].line}: begins between ${below} and ${nearer[at].radius} mm.`;
    }
  } catch (problem) {
    if (problem.name === "AbortError") return;
  }
  place.replaceChildren(...tried.flatMap(({ alarm }, index) => {
    if (!alarm) return [];
    const bar = make("i");
    bar.style.left = 100 * (index + 0.5) / TRIED + "%";
    bar.style.width = 100 / TRIED + "%";
    return [bar];
  }));
  words.textContent = text;
  stripTold = about;
}

// Links, files.

/** Keeps the state in the address, so that it survives a reload. */
function remember(asked) {
  const link = "#" + encode(asked);
  if (link.length < MOST_CHARACTERS && link !== location.hash) history.replaceState(null, "", link);
}

function follow() {
  if (location.hash.length < 2) return false;
  try {
    restore(decode(location.hash.slice(1)));
  } catch (problem) {
    failed(problem);
  }
  return true;
}

async function share() {
  const link = location.href.split("#")[0] + "#" + encode(state());
  const button = id("share");
  if (link.length >= MOST_CHARACTERS) {
    button.textContent = "Too long for a link";
  } else {
    history.replaceState(null, "", link);
    const copied = await navigator.clipboard?.writeText(link).then(() => true, () => false);
    button.textContent = copied ? "Copied" : "It is in the address bar";
  }
  setTimeout(() => { button.textContent = "Copy link"; }, 2500);
}

function save(name, type, text) {
  const url = URL.createObjectURL(new Blob([text], { type }));
  make("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** Takes a file's bytes: an answer, a tool table, or a program. */
async function take(file) {
  try {
    if (file.size > MOST_BYTES) throw new Error(`${file.name} is larger than ${MOST_BYTES / 1024 / 1024} MiB`);
    let text;
    try {
      text = new TextDecoder("utf-8", { fatal: true }).decode(await file.arrayBuffer());
    } catch {
      throw new Error(`${file.name} is not text`);
    }
    if (/\.jsonl?$/i.test(file.name) || text.trimStart().startsWith("{")) {
      id("device-part").open = true;
      id("device").value = "answer";
      id("answer-part").hidden = false;
      id("answer").value = text;
    } else if (/\.toml$/i.test(file.name)) {
      id("tools-part").open = true;
      id(/^\s*(name|extends)\s*=/m.test(text) ? "profile-file" : "tools").value = text;
    } else {
      editor.text = text;
      fresh = true;
    }
    changed();
  } catch (problem) {
    failed(problem);
  }
}

id("share").addEventListener("click", share);
id("open").addEventListener("click", () => id("file").click());
id("file").addEventListener("change", () => { if (id("file").files[0]) take(id("file").files[0]); id("file").value = ""; });
id("save").addEventListener("click", async () => {
  const style = await (await fetch("/drawing.css")).text();
  const title = `profile ${outcome?.profile ?? ""}, tool radius ${id("radius").value} mm`;
  save("workbench.svg", "image/svg+xml", drawing.file(style, title, "radcomp " + rules.radcomp + "\n" + editor.text));
});
id("request").addEventListener("click", async () => {
  try {
    save("request.jsonl", "application/json", await (await post("/request", { ...state(), device: "" })).text());
  } catch (problem) {
    failed(problem);
  }
});
let depth = 0;
const files = (event) => event.dataTransfer?.types.includes("Files");
window.addEventListener("dragenter", (event) => { if (files(event)) { depth++; id("drop").hidden = false; } });
window.addEventListener("dragleave", (event) => { if (files(event) && --depth <= 0) { depth = 0; id("drop").hidden = true; } });
window.addEventListener("dragover", (event) => { if (files(event)) event.preventDefault(); });
window.addEventListener("drop", (event) => {
  if (!files(event)) return;
  event.preventDefault();
  depth = 0;
  id("drop").hidden = true;
  if (event.dataTransfer.files[0]) take(event.dataTransfer.files[0]);
});

// The controls.

for (const profile of rules.profiles) id("profile").append(make("option", { value: profile.name }, `${profile.name}: ${profile.title}`));
rules.examples.forEach((example, index) => id("example").append(make("option", { value: index }, example.title)));
for (let number = 0; number <= 9; number++) id("orientation").append(make("option", { value: number }, String(number)));
for (const name of ["program", "answer", "tools", "profile-file"]) id(name).addEventListener("input", () => changed(150));
for (const name of ["profile", "offset", "orientation", "block-delete"]) id(name).addEventListener("input", () => changed());
id("device").addEventListener("input", () => { id("answer-part").hidden = id("device").value !== "answer"; changed(); });
id("example").addEventListener("input", () => {
  const example = rules.examples[id("example").value];
  if (example) restore(example);
  id("example").value = "";
});
for (const name of ["swept", "tools", "names"]) {
  id("show-" + name).addEventListener("input", (event) => { drawing.shown[name] = event.target.checked; drawing.visible(); });
}
for (const button of document.querySelectorAll("[data-zoom]")) {
  button.addEventListener("click", () => drawing.zoom(Number(button.dataset.zoom)));
}
window.addEventListener("hashchange", follow);
if (!follow()) restore(rules.examples[0]);
