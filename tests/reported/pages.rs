//! JUnit XML and the HTML page, which a real browser opens.

use std::path::Path;
use std::{env, fs};

use radcomp::report::{Report, junit, page};

use crate::browser::{browser, title_of};
use crate::campaigns::{faulty, sound};

#[test]
fn junit_tells_what_failed() {
    let xml = junit(faulty(), "r.json").unwrap();
    assert!(xml.starts_with("<?xml"), "{xml}");
    assert!(xml.contains("name=\"TRC-CORNER-08 ") && xml.contains("<failure message="), "{xml}");
    assert!(xml.contains("name=\"no crash\"") && !xml.contains("<script>"), "{xml}");
    let green = junit(sound(), "r.json").unwrap();
    assert!(green.contains("failures=\"0\"") && !green.contains("<failure"), "{green}");
    assert!(green.contains("no program reaches it"), "{green}");
}

#[test]
fn the_page_needs_no_network_and_escapes_what_a_device_says() {
    for report in [faulty(), sound()] {
        let html = page(report, "report.json").unwrap();
        for foreign in ["http://", "https://", "<script>alert", "@import", "url(//"] {
            let html = html.replace("http://www.w3.org/2000/svg", "");
            assert!(!html.contains(foreign), "{foreign}");
        }
        assert!(html.contains("default-src 'none'"));
    }
    assert_eq!(page(faulty(), "r.json").unwrap().matches("<svg ").count(), faulty().causes.len());
}

/// What the page does, as a script of the test sees it: what it writes stands in the title.
const TRIAL: &str = r##"<script>
const failures = [];
const expect = (holds, what) => { if (!holds) failures.push(what); };
window.addEventListener("error", (event) => failures.push(event.message));
document.addEventListener("securitypolicyviolation", (event) => failures.push("blocked " + event.blockedURI));
window.addEventListener("load", () => {
  const rows = () => document.querySelectorAll("#matrix tbody tr:not([hidden])").length;
  const all = rows();
  const set = (id, value) => {
    const control = document.getElementById(id);
    control.value = value;
    control.dispatchEvent(new Event("input"));
  };
  set("state", "fail");
  expect(rows() === FAILED, "rows that fail: " + rows());
  set("state", "");
  set("find", "trc-corner-08");
  expect(rows() >= 1 && rows() < 5, "rows found: " + rows());
  set("find", "");
  expect(rows() === all && all > 40, "all rows: " + rows());
  const view = document.querySelector(".view");
  if (view) {
    const box = () => view.querySelector("svg").getAttribute("viewBox");
    const before = box();
    view.focus();
    expect(document.activeElement === view, "the picture takes no focus");
    view.dispatchEvent(new KeyboardEvent("keydown", { key: "+" }));
    expect(box() !== before, "plus does not zoom");
    view.dispatchEvent(new KeyboardEvent("keydown", { key: "0" }));
    expect(box() === before, "0 does not show the whole");
  }
  const unreachable = [...document.querySelectorAll("button, input, select, summary")].filter((e) => e.tabIndex < 0);
  expect(unreachable.length === 0, "not reachable by keyboard: " + unreachable.length);
  document.documentElement.style.width = "380px";
  const scrolls = (e) => e.closest(".wide, pre, svg, .skip");
  const wide = [...document.querySelectorAll("body *")].filter((e) => !scrolls(e) && e.getBoundingClientRect().right > 380.5);
  expect(wide.length === 0, "wider than 380 pixels: " + wide.map((e) => e.outerHTML.slice(0, 60)).join(" "));
  document.documentElement.style.width = "";
  expect(document.documentElement.scrollWidth <= window.innerWidth, "wider than the window: " + document.documentElement.scrollWidth + " in " + window.innerWidth);
  expect(performance.getEntriesByType("resource").filter((entry) => !entry.name.startsWith("data:")).length === 0, "loads something");
  document.title = "trial: " + (failures.length ? failures.join("; ") : "all is well");
});
</script>"##;

fn with_trial(report: &Report) -> String {
    let failed = report.tally.clauses.values().filter(|clause| clause.failed > 0).count();
    let trial = TRIAL.replace("FAILED", &failed.to_string());
    page(report, "report.json").unwrap().replace("</head>", &format!("{trial}</head>"))
}

#[test]
fn a_browser_opens_the_page() {
    let Some(browser) = browser() else { return };
    // The browser's window is never narrower than 500 pixels; the trial makes the page itself 380 wide.
    for (report, width, dark) in [(faulty(), 1200, false), (faulty(), 500, true), (sound(), 500, false)] {
        assert_eq!(title_of(browser, &with_trial(report), width, dark), "trial: all is well");
    }
    // The trial can fail: a page that is refused a request says so.
    let bad = with_trial(sound()).replace("<main>", "<main><img src=\"http://192.0.2.1/a.png\" alt=\"\">");
    assert!(title_of(browser, &bad, 1200, false).contains("blocked http://192.0.2.1/a.png"));
}

#[test]
fn the_page_for_a_look() {
    let Some(folder) = env::var_os("RADCOMP_PICTURES") else { return };
    for (name, report) in [("faulty", faulty()), ("sound", sound())] {
        fs::write(Path::new(&folder).join(format!("{name}.html")), page(report, "report.json").unwrap()).unwrap();
    }
}
