"use strict";
// Light or dark: the system's choice until the reader makes one.
const root = document.documentElement;
const remembered = (value) => {
  try {
    if (value) localStorage.setItem("radcomp-theme", value);
    return localStorage.getItem("radcomp-theme");
  } catch {
    return value;
  }
};
if (remembered()) root.dataset.theme = remembered();
document.getElementById("theme").addEventListener("click", () => {
  const dark = root.dataset.theme ? root.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
  root.dataset.theme = dark ? "light" : "dark";
  remembered(root.dataset.theme);
});

// The contents are open where there is room beside the text.
const contents = document.getElementById("contents");
const roomy = matchMedia("(min-width: 60.01rem)");
const arrange = () => { contents.open = roomy.matches; };
roomy.addEventListener("change", arrange);
arrange();

// A clause by its id: clause.html#TRC-CORNER-08 leads to where it stands.
const lookup = document.getElementById("lookup");
const lead = () => {
  const row = document.getElementById(decodeURIComponent(location.hash.slice(1)).toUpperCase());
  if (row && lookup.contains(row)) location.replace(row.querySelector("a").href);
};
if (lookup) { lead(); addEventListener("hashchange", lead); }

// The ledger shows rows with a gap.
const gap = document.getElementById("gap");
if (gap) gap.addEventListener("input", () => {
  let shown = 0;
  for (const row of document.querySelectorAll(".row")) {
    row.hidden = gap.value !== "" && row.dataset[gap.value] !== "0";
    shown += row.hidden ? 0 : 1;
  }
  document.getElementById("shown").textContent = shown + " clauses";
});

// The search. Its index is a script of its own, loaded when it is first asked for.
const query = document.getElementById("query");
const results = document.getElementById("results");
let loading = null;
const index = () => loading ??= new Promise((resolve, reject) => {
  const script = document.createElement("script");
  script.src = "search-index.js";
  script.onload = () => {
    for (const entry of window.radcompIndex) {
      entry.heading = words(entry.title);
      entry.body = words(entry.text);
    }
    resolve(window.radcompIndex);
  };
  script.onerror = reject;
  document.head.append(script);
});
const words = (text) => text.toLowerCase().split(/[^\p{L}\p{N}-]+/u).flatMap((word) => word.includes("-") ? [word, ...word.split("-")] : [word]).filter(Boolean);
// How well a word that was asked for is met by the words of an entry: whole, as a beginning, or not.
const met = (list, word) => list.includes(word) ? 1 : word.length > 2 && list.some((known) => known.startsWith(word)) ? 0.6 : 0;
const idle = new Set("a an and are as at be by for from has if in is it its not of on or that the this to when which with".split(" "));
async function search(text) {
  const entries = await index();
  const id = text.trim().toUpperCase().replace(/^\[|\]$/g, "");
  const asked = words(text).filter((word) => !idle.has(word));
  if (asked.length === 0) return [];
  const scored = [];
  for (const entry of entries) {
    let score = 0;
    let found = 0;
    for (const word of asked) {
      const worth = Math.max(4 * met(entry.heading, word), met(entry.body, word));
      score += worth;
      found += worth > 0 ? 1 : 0;
    }
    if (entry.kind === "clause") score += 1;
    if (entry.title.toUpperCase().includes(id)) score += 10;
    if (entry.title.startsWith(id) || entry.title.startsWith("TRC-" + id)) score += 100;
    // All words come before most of them.
    if (found * 2 > asked.length) scored.push([found / asked.length * 50 + score - Math.log2(entry.body.length + 8) / 4, entry]);
  }
  scored.sort((a, b) => b[0] - a[0]);
  return scored.slice(0, 24).map(([, entry]) => entry);
}
window.radcompSearch = search;
const element = (name, text) => {
  const made = document.createElement(name);
  if (text) made.textContent = text;
  return made;
};
const excerpt = (entry, asked) => {
  const at = asked.map((word) => entry.text.toLowerCase().indexOf(word)).filter((place) => place >= 0);
  const start = Math.max(0, Math.min(...(at.length ? at : [0])) - 50);
  return (start > 0 ? "…" : "") + entry.text.slice(start, start + 170) + (entry.text.length > start + 170 ? "…" : "");
};
function show(found, text) {
  const list = element("ol");
  for (const entry of found) {
    const row = element("li");
    const link = element("a", entry.title);
    link.href = entry.target;
    row.append(link, " ", element("small", entry.kind), element("br"), element("small", excerpt(entry, words(text))));
    for (const [name, target] of entry.more ?? []) {
      const more = element("a", name);
      more.href = target;
      row.append(" ", more);
    }
    list.append(row);
  }
  results.replaceChildren(found.length ? list : element("p", "Nothing has these words."));
  results.hidden = false;
}
let latest = 0;
query.addEventListener("input", async () => {
  const turn = ++latest;
  if (!query.value.trim()) { results.hidden = true; return; }
  try {
    const found = await search(query.value);
    if (turn === latest) show(found, query.value);
  } catch {
    results.replaceChildren(element("p", "The index of the search cannot be loaded."));
    results.hidden = false;
  }
});
document.getElementById("search").addEventListener("submit", (event) => {
  event.preventDefault();
  const first = results.querySelector("a");
  if (first && !results.hidden) location.href = first.href;
});
addEventListener("keydown", (event) => {
  if (event.key === "Escape") results.hidden = true;
  if (event.key === "/" && !/^(INPUT|SELECT|TEXTAREA)$/.test(document.activeElement.tagName)) { query.focus(); event.preventDefault(); }
});
results.addEventListener("click", (event) => { if (event.target.closest("a")) results.hidden = true; });
