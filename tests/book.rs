//! The book: it builds, its links resolve, a browser opens it, and the commands of its guides run.

#[path = "book/browser.rs"]
mod browser;
#[path = "browser/mod.rs"]
mod chromium;
#[path = "book/guides.rs"]
mod guides;
#[path = "book/links.rs"]
mod links;

use std::path::Path;
use std::sync::LazyLock;
use std::time::Instant;

use radcomp::book::Book;
use radcomp::evidence::Ledger;
use radcomp::vectors;

static BOOK: LazyLock<Book> = LazyLock::new(|| {
    let start = Instant::now();
    let ledger = Ledger::gather(Path::new(env!("CARGO_MANIFEST_DIR")), &[]).unwrap();
    let book = Book::build(&ledger).unwrap();
    println!("the book took {:.1} s", start.elapsed().as_secs_f64());
    assert!(start.elapsed().as_secs() < 120, "the book takes longer than two minutes");
    book
});

#[test]
fn every_example_is_executed_and_every_clause_stands_in_its_chapter() {
    assert_eq!(BOOK.examples(), vectors::all().len());
    assert!(BOOK.figures() > 500, "{} figures", BOOK.figures());
    let chapters: String = BOOK
        .files()
        .iter()
        .filter(|(name, _)| name.starts_with(|first: char| first.is_ascii_digit()))
        .map(|(_, text)| text.as_str())
        .collect();
    for (clause, title) in radcomp_spec::clause::ALL {
        assert!(chapters.contains(&format!("<section class=\"clause\" id=\"{clause}\"")), "{clause}");
        assert!(chapters.contains(title), "{title}");
    }
}

#[test]
fn the_pass_page_and_the_certificate_say_the_same() {
    let page = BOOK.files()["pass.html"].replace("&#x27;", "'").replace("&#x2f;", "/");
    for limit in radcomp::certificate::LIMITS {
        assert!(page.contains(limit), "{limit}");
    }
    assert!(page.contains("numbers differ from its own by no more than the band of the grade"));
}

#[test]
fn the_command_builds_the_book() {
    let folder = tempfile::tempdir().unwrap();
    let output = |arguments: &[&str]| {
        let mut command = assert_cmd::Command::cargo_bin("radcomp").unwrap();
        command.args(arguments).current_dir(folder.path()).output().unwrap()
    };
    let root = env!("CARGO_MANIFEST_DIR");
    let made = output(&["book", "--output", "site", "--root", root]);
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    println!("{}", String::from_utf8_lossy(&made.stdout).trim());
    for (name, text) in BOOK.files() {
        assert_eq!(
            std::fs::read_to_string(folder.path().join("site").join(name)).as_deref().ok(),
            Some(text.as_str()),
            "{name}"
        );
    }
    let elsewhere = output(&["book", "--output", "site"]);
    assert_eq!(elsewhere.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&elsewhere.stderr).contains("--root names a source tree"));
    let ledger = output(&["ledger", "--json", "--root", root]);
    assert!(ledger.status.success());
    let ledger: serde_json::Value = serde_json::from_slice(&ledger.stdout).unwrap();
    assert_eq!(ledger["rows"].as_array().map(Vec::len), Some(radcomp_spec::clause::ALL.len()));
}
