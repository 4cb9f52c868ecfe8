//! The book in a real browser: every page at 380 pixels in the dark and at 1,200 in the light, and the search.

use std::fs;
use std::path::Path;

use radcomp_spec::clause;

use crate::BOOK;
use crate::chromium::{browser, title_after};

/// What each page does when it is opened inside the trial: it tells the trial what is wrong with it.
const PAGE: &str = r##"
const failures = [];
const expect = (holds, what) => { if (!holds) failures.push(what); };
addEventListener("error", (event) => failures.push(event.message || "cannot load " + (event.target.src || event.target.href)), true);
addEventListener("unhandledrejection", (event) => failures.push(String(event.reason)));
for (const kind of ["error", "warn"]) console[kind] = (...words) => failures.push(kind + ": " + words.join(" "));
addEventListener("load", async () => {
  const width = document.documentElement.clientWidth;
  expect(document.documentElement.scrollWidth <= width, "wider than its window: " + document.documentElement.scrollWidth + " in " + width);
  const scrolls = (e) => e.closest(".wide, .formula, pre, svg, .skip");
  const wide = [...document.querySelectorAll("body *")].filter((e) => e.getBoundingClientRect().right > width + 0.5 && !scrolls(e));
  expect(wide.length === 0, "beyond the window: " + wide.slice(0, 3).map((e) => e.outerHTML.slice(0, 80)).join(" "));
  for (const figure of document.querySelectorAll("svg.figure")) {
    const drawn = [...figure.querySelectorAll("path.path, path.corner, path.free, path.rapid, path.programmed, path.lead, path.followed, path.refused")];
    const length = drawn.reduce((sum, path) => sum + path.getTotalLength(), 0);
    const box = figure.getBoundingClientRect();
    expect(box.width > 150 && box.height > 60 && length > 5, "a figure is empty: " + figure.getAttribute("aria-label"));
  }
  const math = [...document.querySelectorAll("math")].filter((e) => e.getBoundingClientRect().width < 2);
  expect(math.filter((e) => !e.closest("details:not([open])")).length === 0, "formulas without width: " + math.length);
  const out = performance.getEntriesByType("resource").filter((e) => !e.name.startsWith("file:") && !e.name.startsWith("data:"));
  expect(out.length === 0, "loads " + out.map((e) => e.name).join(" "));
  const hidden = [...document.querySelectorAll("button, input, select, summary")].filter((e) => e.tabIndex < 0);
  expect(hidden.length === 0, "not reachable by keyboard");
  if (window.askedOfTheSearch) await searches();
  parent.postMessage({ page: location.href.split("/").pop(), failures }, "*");
});
async function searches() {
  for (const [text, wanted] of window.askedOfTheSearch) {
    const found = await window.radcompSearch(text);
    const place = found.findIndex((entry) => entry.title.startsWith(wanted));
    expect(place >= 0 && place < 5, "search for " + text + " finds " + wanted + " at " + place + ", first " + (found[0] || {}).title);
  }
  const query = document.getElementById("query");
  query.value = "outer acute corner squared off";
  query.dispatchEvent(new Event("input"));
  await new Promise((done) => setTimeout(done, 200));
  const link = document.querySelector("#results a");
  expect(link && link.getAttribute("href") === "04-corner.html#TRC-CORNER-08", "typed: " + (link && link.href));
  query.value = "zzzz";
  query.dispatchEvent(new Event("input"));
  await new Promise((done) => setTimeout(done, 200));
  expect(document.getElementById("results").textContent.includes("Nothing"), "nothing is found, and it does not say so");
}
"##;

/// Opens the pages one after the other in a frame of a width.
const TRIAL: &str = r##"<!doctype html><title>trial: not done</title><body><script>
const pages = PAGES;
const failures = [];
const frame = document.createElement("iframe");
frame.style = "border:0;height:800px;width:WIDTHpx";
document.body.append(frame);
let next = 0;
const open = () => {
  if (next < pages.length) frame.src = pages[next++];
  else document.title = "trial: " + (failures.length ? failures.join(" | ") : "all is well on " + next + " pages");
};
addEventListener("message", (event) => {
  const wanted = pages[next - 1].endsWith("clause.html#TRC-CORNER-08") ? "04-corner.html#TRC-CORNER-08" : pages[next - 1];
  // The page that finds clauses tells of itself before it leads on.
  if (wanted !== pages[next - 1] && event.data.page === pages[next - 1]) return;
  if (event.data.page !== wanted) failures.push(pages[next - 1] + " leads to " + event.data.page);
  for (const failure of event.data.failures) failures.push(event.data.page + ": " + failure);
  open();
});
open();
</script>"##;

/// Writes the book with the trial's script on every page.
fn write(folder: &Path, width: u32) {
    let mut pages = Vec::new();
    for (name, text) in BOOK.files() {
        let mut text = text.clone();
        if name.ends_with(".html") {
            let asked = if name == "index.html" { "<script src=\"asked.js\"></script>" } else { "" };
            text = text.replacen("<script", &format!("{asked}<script src=\"page.js\"></script><script"), 1);
            pages.push(name.clone());
        }
        fs::write(folder.join(name), text).unwrap();
    }
    pages.push("clause.html#TRC-CORNER-08".to_owned());
    fs::write(folder.join("page.js"), PAGE).unwrap();
    let asked = serde_json::to_string(&asked()).unwrap();
    fs::write(folder.join("asked.js"), format!("window.askedOfTheSearch = {asked};")).unwrap();
    let pages = serde_json::to_string(&pages).unwrap();
    let trial = TRIAL.replace("PAGES", &pages).replace("WIDTH", &width.to_string());
    fs::write(folder.join("trial.html"), trial).unwrap();
}

/// What is asked of the search, and how the title begins that is to be among the first five: each clause by its id and by
/// the words of its title, each sentence of the seed documents by its five longest words.
fn asked() -> Vec<(String, String)> {
    let mut asked = Vec::new();
    for (clause, title) in clause::ALL {
        asked.push((clause.id().to_lowercase(), clause.id().to_owned()));
        asked.push(((*title).to_owned(), clause.id().to_owned()));
    }
    let index = &BOOK.files()["search-index.js"];
    let json = index.split_once(" = ").unwrap().1.trim_end().trim_end_matches(';');
    let entries: Vec<serde_json::Value> = serde_json::from_str(json).unwrap();
    for entry in entries.iter().filter(|entry| entry["kind"] == "seed document") {
        let sentence = entry["title"].as_str().unwrap();
        let mut words: Vec<&str> =
            sentence.split(|character: char| !character.is_alphanumeric()).filter(|word| word.len() > 1).collect();
        words.sort_by_key(|word| (std::cmp::Reverse(word.len()), *word));
        words.dedup();
        asked.push((words[..words.len().min(5)].join(" "), sentence.to_owned()));
    }
    asked
}

#[test]
fn every_page_opens_at_380_pixels_and_wide() {
    let Some(browser) = browser() else { return };
    for (width, dark) in [(380, true), (1200, false)] {
        let folder = tempfile::tempdir().unwrap();
        write(folder.path(), width);
        let title = title_after(browser, &folder.path().join("trial.html"), 1300, dark, 120);
        let pages = BOOK.files().keys().filter(|name| name.ends_with(".html")).count() + 1;
        assert_eq!(title, format!("trial: all is well on {pages} pages"), "{width} pixels");
    }
}

#[test]
fn the_trial_can_fail() {
    let Some(browser) = browser() else { return };
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), 380);
    let page = folder.path().join("changes.html");
    let bad = "<p style=\"width:500px\">wide</p><svg class=\"figure\" aria-label=\"none\"></svg><script src=\"gone.js\"></script>";
    let html = fs::read_to_string(&page).unwrap().replace("<h1>", &format!("{bad}<h1>"));
    fs::write(&page, html).unwrap();
    let title = title_after(browser, &folder.path().join("trial.html"), 1300, false, 120);
    for wanted in ["changes.html: wider than its window", "a figure is empty: none", "cannot load"] {
        assert!(title.contains(wanted), "{wanted}: {title}");
    }
}
