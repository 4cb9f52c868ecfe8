//! A real browser without a window, for tests that open pages.

use std::path::Path;
use std::process::Command;
use std::{env, fs};

/// The browser, if it is installed. In continuous integration its absence is a failure.
pub fn browser() -> Option<&'static str> {
    let found = ["chromium", "chromium-browser", "google-chrome"]
        .into_iter()
        .find(|name| Command::new(name).arg("--version").output().is_ok_and(|output| output.status.success()));
    if found.is_none() {
        assert!(env::var_os("CI").is_none(), "no Chromium: scripts/setup --test installs it");
        eprintln!("SKIPPED: no Chromium on PATH; scripts/setup --test installs it");
    }
    found
}

/// What the page's title says after it was opened in a window of this width and had so many seconds of its own time.
pub fn title_after(browser: &str, file: &Path, width: u32, dark: bool, seconds: u32) -> String {
    let folder = tempfile::tempdir().unwrap();
    let mut command = Command::new(browser);
    command.args(["--headless", "--no-sandbox", "--disable-gpu"]);
    command.arg(format!("--virtual-time-budget={}", seconds * 1000));
    if dark {
        command.arg("--blink-settings=preferredColorScheme=0");
    }
    command.arg(format!("--user-data-dir={}", folder.path().join("profile").display()));
    command.arg(format!("--window-size={width},900")).arg("--dump-dom").arg(format!("file://{}", file.display()));
    let output = command.output().expect("the browser");
    let dom = String::from_utf8_lossy(&output.stdout);
    let title = dom.split_once("<title>").and_then(|(_, rest)| rest.split_once("</title>"));
    title.map_or_else(|| format!("no title in {dom}"), |(title, _)| title.to_owned())
}

/// The same for the text of one page.
#[allow(dead_code, reason = "not every test has its page as text")]
pub fn title_of(browser: &str, html: &str, width: u32, dark: bool) -> String {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("page.html");
    fs::write(&file, html).unwrap();
    title_after(browser, &file, width, dark, 4)
}
