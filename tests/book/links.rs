//! Every link of the book leads somewhere, and nothing is loaded from elsewhere.

use std::collections::{BTreeMap, BTreeSet};

use crate::BOOK;

/// The values of an attribute.
fn values<'t>(html: &'t str, attribute: &str) -> Vec<&'t str> {
    let opening = format!(" {attribute}=\"");
    html.split(opening.as_str()).skip(1).filter_map(|rest| rest.split_once('"')).map(|(value, _)| value).collect()
}

#[test]
fn every_link_and_anchor_resolves() {
    let pages: BTreeMap<_, _> = BOOK.files().iter().filter(|(name, _)| name.ends_with(".html")).collect();
    let anchors: BTreeMap<&str, BTreeSet<&str>> =
        pages.iter().map(|(name, html)| (name.as_str(), values(html, "id").into_iter().collect())).collect();
    let (mut broken, mut count) = (Vec::new(), 0);
    for (name, html) in &pages {
        let ids = values(html, "id");
        assert_eq!(ids.len(), anchors[name.as_str()].len(), "an id stands twice in {name}");
        for target in values(html, "href").into_iter().chain(values(html, "src")) {
            count += 1;
            let (page, anchor) = target.split_once('#').map_or((target, None), |(page, anchor)| (page, Some(anchor)));
            let page = if page.is_empty() { name.as_str() } else { page };
            let found = match anchor {
                _ if target == "data:," => true,
                None => BOOK.files().contains_key(page),
                Some(anchor) => anchors.get(page).is_some_and(|ids| ids.contains(anchor)),
            };
            if !found {
                broken.push(format!("{name}: {target}"));
            }
        }
    }
    assert!(broken.is_empty(), "{} of {count}: {broken:#?}", broken.len());
    assert!(count > 5000, "{count} links");
}

#[test]
fn nothing_is_loaded_from_elsewhere() {
    for (name, text) in BOOK.files() {
        for foreign in ["http://", "https://", "@import", "url("] {
            assert!(!text.contains(foreign), "{name} has {foreign}");
        }
    }
}

#[test]
fn the_targets_of_the_search_resolve() {
    let index = &BOOK.files()["search-index.js"];
    let json = index.split_once(" = ").unwrap().1.trim_end().trim_end_matches(';');
    let entries: Vec<serde_json::Value> = serde_json::from_str(json).unwrap();
    let mut kinds = BTreeMap::new();
    for entry in &entries {
        *kinds.entry(entry["kind"].as_str().unwrap()).or_insert(0) += 1;
        let more = entry["more"].as_array().cloned().unwrap_or_default();
        for target in [&entry["target"]].into_iter().chain(more.iter().map(|more| &more[1])) {
            let (page, anchor) = target.as_str().unwrap().split_once('#').unwrap_or((target.as_str().unwrap(), ""));
            let html = BOOK.files().get(page).unwrap_or_else(|| panic!("{target}"));
            assert!(anchor.is_empty() || html.contains(&format!(" id=\"{anchor}\"")), "{target}");
        }
    }
    println!("{kinds:?}");
    assert_eq!(kinds["clause"], radcomp_spec::clause::ALL.len());
    // Every sentence of the seed documents leads to a figure, or to the refusal of a program.
    for entry in entries.iter().filter(|entry| entry["kind"] == "seed document") {
        let more = entry["more"].as_array().unwrap_or_else(|| panic!("no example: {entry}"));
        let shown = more.iter().any(|more| {
            let (page, anchor) = more[1].as_str().unwrap().split_once('#').unwrap();
            let exhibit =
                BOOK.files()[page].split_once(&format!("<figure class=\"exhibit\" id=\"{anchor}\">")).unwrap().1;
            let exhibit = exhibit.split_once("</figure>").unwrap().0;
            exhibit.contains("<svg class=\"figure\"") || exhibit.contains("Refused by the program reader")
        });
        assert!(shown, "{entry}");
    }
}
