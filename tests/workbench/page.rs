//! What the page does in a real browser.

use std::env;
use std::path::Path;
use std::process::Command;

use serde_json::{Value, json};

use crate::browser::Browser;
use crate::server::{RADCOMP, Server};

/// A browser on the workbench; none if there is no browser.
fn open() -> Option<(Server, Browser)> {
    let mut browser = Browser::open()?;
    let server = Server::start(&["--time-limit", "60"]);
    browser.go(&format!("http://{}/", server.address));
    Some((server, browser))
}

/// Puts a value into a control, as a person does.
fn set(id: &str, value: &str) -> String {
    let (id, value) = (json!(id), json!(value));
    format!(
        "{{ const control = document.getElementById({id}); control.value = {value}; \
         control.dispatchEvent(new Event('input', {{ bubbles: true }})); }}"
    )
}

/// Types a program in the place of the one that is there.
fn type_program(browser: &mut Browser, program: &str) {
    let before = browser.value("Number(document.body.dataset.settled)");
    browser.value("document.getElementById('program').focus(), document.getElementById('program').select()");
    browser.type_text(program);
    browser.wait(&format!("Number(document.body.dataset.settled) > {before}"));
}

/// The rows of the path's table: cells by name, and its closed forms where they are shown.
fn shown_path(browser: &mut Browser) -> Value {
    browser.value("document.getElementById('path-part').open = true");
    browser.wait("document.querySelectorAll('#path tbody tr').length > 0");
    browser.value(
        "[...document.querySelectorAll('#path tbody tr')].map((row) => { \
           const point = {}; \
           for (const cell of row.querySelectorAll('[data-axis]')) if (cell.firstChild) point[cell.dataset.axis] = \
             [cell.firstChild.textContent, cell.querySelector('small')?.textContent ?? null]; \
           return { line: Number(row.cells[0].textContent), n: row.cells[1].textContent, \
             clause: row.querySelector('code').textContent, point }; })",
    )
}

/// The path that `radcomp run` prints.
fn printed_path(program: &str, profile: &str, radius: &str) -> Value {
    let file = tempfile::NamedTempFile::new().unwrap();
    std::fs::write(file.path(), program).unwrap();
    let arguments = ["--profile", profile, "--radius", radius, "--format", "json"];
    let output = Command::new(RADCOMP).arg("run").arg(file.path()).args(arguments).output().unwrap();
    let document: Value = serde_json::from_slice(&output.stdout).unwrap();
    document["events"].as_array().unwrap().iter().filter(|event| event["kind"] != "advisory").cloned().collect()
}

/// The numbers on the page are those of the command: decimals all, and closed forms wherever the page gives one.
fn assert_same_path(shown: &Value, printed: &Value) {
    let (shown, printed) = (shown.as_array().unwrap(), printed.as_array().unwrap());
    assert_eq!(shown.len(), printed.len());
    assert!(!shown.is_empty());
    for (row, event) in shown.iter().zip(printed) {
        assert_eq!(row["line"], event["line"]);
        assert_eq!(row["n"].as_str().unwrap(), event["n"].as_str().unwrap_or_default());
        assert_eq!(row["clause"], event["clause"]);
        let Some(end) = event["end"].as_object() else { continue };
        for (axis, value) in end {
            assert_eq!(row["point"][axis][0], value["decimal"], "{row} {event}");
            let exact = &row["point"][axis][1];
            assert!(exact.is_null() || *exact == value["exact"], "{row} {event}");
            // What no decimal tells is told.
            assert!(!exact.is_null() || !value["exact"].as_str().unwrap_or_default().contains('√'), "{row} {event}");
        }
    }
}

const ACUTE: &str =
    "N10 G00 X-20 Y-20\nN20 G41 D1 G01 X0 Y0 F300\nN30 X10 Y40\nN40 X37.5 Y-3\nN50 X60 Y31.7\nN60 G40 X80 Y-20\n";

#[test]
fn a_typed_program_gives_the_path_of_radcomp_run() {
    let Some((_server, mut browser)) = open() else { return };
    type_program(&mut browser, ACUTE);
    let first = shown_path(&mut browser);
    assert_same_path(&first, &printed_path(ACUTE, "seed-mill", "5"));
    assert!(first.to_string().contains('√'), "a program with roots: {first}");

    // The slider moves the path, and a finger on it is followed.
    browser.settle(&set("slider", "3.5"));
    browser.wait("document.getElementById('path').dataset.radius === '3.5'");
    assert_eq!(browser.text("document.getElementById('radius').value"), "3.5");
    let second = shown_path(&mut browser);
    assert_ne!(first, second);
    assert_same_path(&second, &printed_path(ACUTE, "seed-mill", "3.5"));

    // A radius is exact: what no double holds is not rounded.
    browser.settle(&set("radius", "0.1"));
    browser.wait("document.getElementById('path').dataset.radius === '0.1'");
    assert_same_path(&shown_path(&mut browser), &printed_path(ACUTE, "seed-mill", "0.1"));

    // Another control, another path.
    browser.settle(&set("radius", "5"));
    browser.settle(&set("profile", "fanuc-30i-b"));
    browser.wait("document.getElementById('path').dataset.radius === '5'");
    assert_same_path(&shown_path(&mut browser), &printed_path(ACUTE, "fanuc-30i-b", "5"));
    assert_eq!(browser.said(), [""; 0]);
}

#[test]
fn blocks_alarms_and_faults_are_told_with_their_clauses() {
    let Some((_server, mut browser)) = open() else { return };
    // A block opens, with its clause, its sentence, its margins and closed forms.
    type_program(&mut browser, ACUTE);
    browser.value("document.querySelector('#blocks [data-line=\"3\"]').open = true");
    browser.wait("document.querySelector('#blocks [data-line=\"3\"] .told')");
    let told = browser.text("document.querySelector('#blocks [data-line=\"3\"]').innerText");
    for words in ["outer corner", "TRC-CORNER-08", "margin", "squared off", "√"] {
        assert!(told.to_lowercase().contains(&words.to_lowercase()), "{words}: {told}");
    }

    // The slot is too narrow: the alarm is told, at its block, with its sentence; and where it begins.
    let example =
        "[...document.querySelectorAll('#example option')].find((option) => option.text.includes('slot')).value";
    let slot = browser.text(example);
    browser.settle(&set("example", &slot));
    let alarm = browser.text("document.querySelector('#state .alarm').innerText");
    for words in ["interference", "N50, line 6", "TRC-INT-04", "would lead the tool backwards"] {
        assert!(alarm.contains(words), "{words}: {alarm}");
    }
    assert_eq!(browser.value("document.querySelectorAll('.drawing .cross').length"), 1);
    assert_eq!(browser.value("document.querySelectorAll('.drawing .lines .refused').length"), 1);
    browser.wait("document.getElementById('strip-text').textContent.includes('begins between')");
    let words = browser.text("document.getElementById('strip-text').textContent");
    let numbers: Vec<f64> = words.split(' ').filter_map(|word| word.parse().ok()).collect();
    assert!(numbers[0] <= 6.0 && 6.0 <= numbers[1] && numbers[1] - numbers[0] < 1.0, "{words}");
    assert!(browser.value("document.querySelectorAll('#strip i').length").as_u64() > Some(5));
    browser.settle(&set("slider", "5"));
    assert_eq!(browser.value("document.querySelector('#state .alarm')"), Value::Null);
    assert_eq!(browser.value("document.querySelectorAll('.drawing .cross').length"), 0);

    // A fault of the program, at its line and column, and a way there.
    type_program(&mut browser, "G01 X5\nG41 D1 X10 Y1O\nX3");
    let fault = browser.text("document.getElementById('fault').innerText");
    assert!(fault.contains("line 2, column 13") || fault.contains("line 2, column 14"), "{fault}");
    browser.value("document.querySelector('#fault .go').click()");
    let column = browser.value("document.getElementById('program').selectionStart");
    assert!([19, 20].contains(&column.as_u64().unwrap()), "{column}");
    assert_eq!(browser.value("document.querySelector('.gutter .wrong').textContent"), "2");

    // What the server refuses is told, and the page goes on.
    let large = format!("G01\n{}", "X1\nX2\n".repeat(5_100));
    browser.settle(&set("program", &large));
    browser.wait("document.querySelector('#state .problem')");
    let problem = browser.text("document.querySelector('#state .problem').innerText");
    assert!(problem.contains("at most 10000 blocks"), "{problem}");
    type_program(&mut browser, ACUTE);
    assert_eq!(browser.value("document.querySelector('#state .problem')"), Value::Null);
    // The browser notes the status of what was refused; nothing else was said.
    let said: Vec<_> = browser.said().into_iter().filter(|line| !line.contains("413")).collect();
    assert_eq!(said, [""; 0]);
}

#[test]
fn a_link_carries_the_program_and_a_device_is_laid_over_it() {
    let Some((server, mut browser)) = open() else { return };
    let program = format!("(Übergröße ⌀ 7,2 – 100 %)\n{ACUTE}");
    type_program(&mut browser, &program);
    browser.settle(&set("radius", "4.25"));
    browser.settle(&set("profile", "haas-b"));
    browser.settle(&set("device", "builtin"));
    let link = browser.text("location.href");
    let path = shown_path(&mut browser);
    assert!(link.starts_with(&format!("http://{}/#1", server.address)) && !link.contains('%'), "{link}");
    browser.go(&link);
    assert_eq!(browser.text("document.getElementById('program').value"), program);
    assert_eq!(browser.text("document.getElementById('radius').value"), "4.25");
    assert_eq!(browser.text("document.getElementById('profile').value"), "haas-b");
    assert_eq!(shown_path(&mut browser), path);

    // The device of the link.
    let device = "document.querySelector('#state .device')";
    assert!(browser.text(&format!("{device}.innerText")).contains("builtin: exact"));
    assert!(browser.value("document.querySelectorAll('.drawing .device path').length").as_u64() > Some(3));

    // A link that was cut off is told, and one that tries to be a script is a text.
    browser.value(&format!("location.hash = {}.slice(0, 60)", json!(link.split_once('#').unwrap().1)));
    browser.wait("document.getElementById('state').innerText.includes('this link is damaged')");

    // An answer is pasted: the request as a device is asked it, answered by a device.
    browser.go(&link);
    let asked = json!({ "program": program, "profile": "haas-b", "offset": 1, "radius": "4.25" }).to_string();
    let request = server.post("/request", asked.as_bytes());
    assert_eq!(request.status, 200);
    let answer = answered(&request.body);
    browser.settle(&set("device", "answer"));
    browser.settle(&set("answer", &answer));
    assert!(browser.text(&format!("{device}.innerText")).contains("exact"));
    let mut spoilt: Value = serde_json::from_str(&answer).unwrap();
    let end = &mut spoilt["steps"][2]["end"][0];
    *end = json!(end.as_f64().unwrap() + 0.25);
    browser.settle(&set("answer", &spoilt.to_string()));
    let verdict = browser.text(&format!("{device}.innerText"));
    assert!(verdict.contains("inadmissible") && verdict.contains("0.25") && verdict.contains("TRC-"), "{verdict}");
    browser.settle(&set("answer", "{\"id\": \"workbench\", \"steps\": 5}"));
    assert!(browser.text(&format!("{device}.innerText")).contains("garbled"));
    browser.settle(&set("answer", "<img src=x onerror=alert(1)>"));
    assert!(browser.text(&format!("{device}.innerText")).contains("not an answer"));
    assert_eq!(browser.said(), [""; 0]);
}

/// The answer of `radcomp answer` to a request.
fn answered(request: &str) -> String {
    let file = tempfile::NamedTempFile::new().unwrap();
    std::fs::write(file.path(), request).unwrap();
    let input = std::fs::File::open(file.path()).unwrap();
    let output = Command::new(RADCOMP).arg("answer").stdin(input).output().unwrap();
    String::from_utf8(output.stdout).unwrap()
}

/// What stands out of a window, what no key reaches, and what has no name.
const FLAWS: &str = "(() => { \
  const scrolls = (element) => element.closest('.wide, pre, svg, .skip, textarea, .gutter, [hidden]'); \
  const flaws = [...document.querySelectorAll('body *')] \
    .filter((element) => !scrolls(element) && element.getBoundingClientRect().right > WIDTH + 0.5) \
    .map((element) => 'too wide: ' + element.outerHTML.slice(0, 80)); \
  if (document.documentElement.scrollWidth > WIDTH) flaws.push('scrolls sideways: ' + document.documentElement.scrollWidth); \
  for (const element of document.querySelectorAll('button, input:not([hidden]), select, textarea, summary')) { \
    if (element.tabIndex < 0) flaws.push('not reachable: ' + element.outerHTML.slice(0, 80)); \
    const name = element.getAttribute('aria-label') ?? element.labels?.[0]?.textContent ?? element.textContent; \
    if (!name.trim()) flaws.push('without a name: ' + element.outerHTML.slice(0, 80)); \
  } \
  return flaws; })()";

/// The flaws in a window of that width. A phone's window grows with what stands out of it, so it is not asked for its own.
fn flaws(browser: &mut Browser, width: u32) -> Value {
    browser.value(&FLAWS.replace("WIDTH", &width.to_string()))
}

#[test]
fn the_page_fits_a_phone_and_is_reached_by_keys() {
    let Some((_server, mut browser)) = open() else { return };
    let slot = "[...document.querySelectorAll('#example option')].find((option) => option.text.includes('slot')).value";
    for (width, dark) in [(1280, false), (380, false), (380, true)] {
        browser.window(width, 800, dark);
        browser.value("document.querySelectorAll('details').forEach((details) => { details.open = true; })");
        browser
            .wait("document.querySelectorAll('#blocks .told').length > 5 && document.querySelector('#path tbody tr')");
        assert_eq!(flaws(&mut browser, width), json!([]), "{width} pixels");
        let example = browser.text(slot);
        browser.settle(&set("example", &example));
        browser.settle(&set("program", "G41 X0 Q"));
        assert_eq!(flaws(&mut browser, width), json!([]), "{width} pixels, with a fault");
        browser.settle(&set("example", "0"));
        let ground = browser.text("getComputedStyle(document.body).backgroundColor");
        assert_eq!(ground == "rgb(255, 255, 255)", !dark, "{ground}");
    }
    // The trial can fail.
    browser.value("document.getElementById('save').style.minWidth = '900px'");
    assert_ne!(flaws(&mut browser, 380), json!([]));
    browser.value("document.getElementById('save').style.minWidth = ''");

    // From the start of the page the tabulator key reaches the picture; there, keys zoom, and choose a block.
    browser.window(1280, 900, false);
    browser.value("document.querySelectorAll('details').forEach((details) => { details.open = false; })");
    browser.value("document.activeElement.blur(), getSelection().removeAllRanges(), scrollTo(0, 0)");
    let mut reached = Vec::new();
    for _ in 0..40 {
        browser.press("Tab");
        reached.push(browser.text("document.activeElement.id"));
    }
    for id in ["example", "open", "share", "program", "profile", "radius", "slider", "show-swept", "save", "view"] {
        assert!(reached.iter().any(|each| each == id), "{id} is not among {reached:?}");
    }
    browser.value("document.getElementById('view').focus()");
    let whole = browser.text("document.querySelector('.drawing').getAttribute('viewBox')");
    browser.press("+");
    assert_ne!(browser.text("document.querySelector('.drawing').getAttribute('viewBox')"), whole);
    browser.press("0");
    assert_eq!(browser.text("document.querySelector('.drawing').getAttribute('viewBox')"), whole);
    browser.press("PageDown");
    browser.press("PageDown");
    browser.wait("document.querySelector('#blocks .chosen[open] .told')");
    assert_eq!(browser.value("document.querySelector('#blocks .chosen').dataset.block"), "1");
    assert_eq!(browser.value("document.querySelector('.gutter .chosen').textContent"), "2");
    browser.value("document.getElementById('slider').focus()");
    let radius = browser.text("document.getElementById('radius').value");
    browser.press("ArrowRight");
    browser.wait(&format!("document.getElementById('radius').value !== {}", json!(radius)));
    assert_eq!(browser.said(), [""; 0]);
}

#[test]
fn a_saved_picture_stands_alone() {
    let Some((_server, mut browser)) = open() else { return };
    // The file that is saved, caught on its way to the disk.
    browser.value(
        "window.saved = []; URL.createObjectURL = (blob) => { window.saved.push(blob); return '#saved'; }; \
         HTMLAnchorElement.prototype.click = function () {};",
    );
    browser.value("document.getElementById('save').click()");
    browser.wait("window.saved.length === 1");
    let svg = browser.text("window.saved[0].text()");
    assert!(svg.starts_with("<svg ") && svg.contains("<style") && svg.contains("N20 G41 D1"), "{svg}");
    assert_eq!(browser.said(), [""; 0]);
    let shape = browser.value(
        "(async () => { const text = await window.saved[0].text(); \
           const page = new DOMParser().parseFromString(text, 'image/svg+xml'); \
           return { fault: page.querySelector('parsererror')?.textContent ?? null, \
             scripts: page.querySelectorAll('script').length, swept: page.querySelectorAll('.swept path').length, \
             width: Number(page.querySelector('.swept path').getAttribute('stroke-width')), \
             path: page.querySelectorAll('.lines .compensated').length }; })()",
    );
    assert_eq!(shape["fault"], Value::Null);
    assert_eq!(shape["scripts"], 0);
    // The swept area is as wide as the tool: twice the radius of 5 mm.
    assert_eq!(shape["width"], 10);
    assert!(shape["path"].as_u64() > Some(8), "{shape}");
    // The page's policy keeps a style from taking effect here; a page's errors are heard.
    assert!(browser.said().iter().all(|line| line.contains("inline style")));
    browser.value("console.error('trial')");
    assert!(browser.said()[0].contains("trial"));
}

#[test]
fn the_page_for_a_look() {
    let Some(folder) = env::var_os("RADCOMP_PICTURES") else { return };
    let Some((_server, mut browser)) = open() else { return };
    let slot = "[...document.querySelectorAll('#example option')].find((option) => option.text.includes('slot')).value";
    for (width, dark) in [(1280, false), (1280, true), (380, false), (380, true)] {
        let tone = if dark { "dark" } else { "light" };
        browser.window(width, if width < 500 { 2400 } else { 1300 }, dark);
        let look = |browser: &mut Browser, name: &str| {
            browser.picture(&Path::new(&folder).join(format!("workbench-{name}-{width}-{tone}.png")));
        };
        browser.settle(&set("example", "0"));
        browser.value("document.querySelectorAll('#blocks details')[7].open = true");
        browser.wait("document.querySelector('#blocks .told')");
        look(&mut browser, "path");
        let example = browser.text(slot);
        browser.settle(&set("example", &example));
        browser.wait("document.getElementById('strip-text').textContent.includes('begins')");
        look(&mut browser, "alarm");
        browser
            .settle(&set("program", "N10 G90 G00 X-20 Y-15\nN20 G41 D1 G01 X0 Y0 F300\nN30 Y40\nN40 X25 Y5O\nN50 X70"));
        look(&mut browser, "fault");
        browser.settle(&set("example", "2"));
        browser.settle(&set("device", "builtin"));
        browser.value("document.getElementById('path-part').open = true");
        browser.wait("document.querySelectorAll('#path tbody tr').length > 0");
        look(&mut browser, "device");
    }
}
