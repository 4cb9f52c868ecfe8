//! The normative text as it was last agreed to: a hash for each clause and each chapter's introduction, and how often
//! `spec/CHANGES.md` named it then. A text may change only together with a line there that names it.

use std::collections::BTreeMap;

use radcomp_spec::catalogue::Catalogue;

use super::hash_of_words;

/// The hash of a normative text: its line breaks do not count.
pub fn normative_hash(text: &str) -> String {
    hash_of_words(text)
}

/// Hashes and counts by the id of a clause, or the file of a chapter for its introduction.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Lock {
    entries: BTreeMap<String, (String, usize)>,
}

const HEAD: &str = "\
# The normative text, as it was last agreed to: id, SHA-256 of its words, lines of CHANGES.md that name it.
# Made by `RADCOMP_BLESS=1 cargo test --release --test ledger`, which refuses a change that CHANGES.md does not name.
";

impl Lock {
    /// The text of this toolkit, with what `spec/CHANGES.md` names.
    pub fn current(changes: &str) -> Lock {
        let catalogue = Catalogue::builtin();
        let named = |name: &str| changes.lines().filter(|line| line.contains(name)).count();
        let introductions = catalogue.chapters.iter().map(|chapter| {
            let text = format!("{} {}", chapter.title, chapter.introduction);
            (chapter.file.to_owned(), (normative_hash(&text), named(chapter.file)))
        });
        let clauses = catalogue.clauses.iter().map(|clause| {
            let text = format!("{} {}", clause.title, clause.text);
            (clause.clause.id().to_owned(), (normative_hash(&text), named(clause.clause.id())))
        });
        Lock { entries: introductions.chain(clauses).collect() }
    }

    /// Reads the file.
    ///
    /// # Errors
    ///
    /// A line that is none, with its number.
    pub fn parse(text: &str) -> Result<Lock, String> {
        let mut entries = BTreeMap::new();
        for (number, line) in (1..).zip(text.lines()).filter(|(_, line)| !line.starts_with('#') && !line.is_empty()) {
            let words: Vec<&str> = line.split(' ').collect();
            let [name, hash, count] = words[..] else { return Err(format!("line {number}: id, hash and count")) };
            let count = count.parse().map_err(|_| format!("line {number}: {count} is no count"))?;
            entries.insert(name.to_owned(), (hash.to_owned(), count));
        }
        Ok(Lock { entries })
    }

    /// The file.
    pub fn to_text(&self) -> String {
        let line = |(name, (hash, count)): (&String, &(String, usize))| format!("{name} {hash} {count}\n");
        HEAD.to_owned() + &self.entries.iter().map(line).collect::<String>()
    }

    /// What changed from this text to another without a line that says so.
    pub fn unnamed_changes(&self, now: &Lock) -> Vec<String> {
        let mut faults = Vec::new();
        for (name, (hash, count)) in &now.entries {
            let (what, before) = match self.entries.get(name) {
                Some((agreed, _)) if agreed == hash => continue,
                Some((_, before)) => ("its normative text changed", *before),
                None => ("it is new", 0),
            };
            if *count <= before {
                faults.push(format!("{name}: {what}, and no new line of spec/CHANGES.md names it"));
            }
        }
        let gone = self.entries.keys().filter(|name| !now.entries.contains_key(*name));
        faults.extend(gone.map(|name| format!("{name}: it is gone; an id is never reused, nor taken away")));
        faults
    }

    /// What differs from another text, whether `spec/CHANGES.md` names it or not.
    pub fn differences(&self, now: &Lock) -> Vec<String> {
        let hash = |lock: &Lock, name: &str| lock.entries.get(name).map(|(hash, _)| hash.clone());
        let names = self.entries.keys().chain(now.entries.keys().filter(|name| !self.entries.contains_key(*name)));
        names.filter(|name| hash(self, name) != hash(now, name)).cloned().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lock(lines: &[&str]) -> Lock {
        Lock::parse(&lines.join("\n")).unwrap()
    }

    #[test]
    fn a_change_needs_a_new_line() {
        let agreed = lock(&["# head", "TRC-A a1 1", "TRC-B b1 0"]);
        assert!(agreed.unnamed_changes(&agreed).is_empty() && agreed.differences(&agreed).is_empty());
        let silent = lock(&["TRC-A a2 1", "TRC-B b1 0"]);
        assert_eq!(agreed.unnamed_changes(&silent).len(), 1);
        let said = lock(&["TRC-A a2 2", "TRC-B b1 0"]);
        assert!(agreed.unnamed_changes(&said).is_empty());
        assert_eq!(agreed.differences(&said), ["TRC-A"]);
    }

    #[test]
    fn what_is_new_is_named_and_nothing_goes() {
        let agreed = lock(&["TRC-A a1 1"]);
        assert_eq!(agreed.unnamed_changes(&lock(&["TRC-A a1 1", "TRC-C c1 0"])).len(), 1);
        assert!(agreed.unnamed_changes(&lock(&["TRC-A a1 1", "TRC-C c1 1"])).is_empty());
        assert_eq!(agreed.unnamed_changes(&lock(&[])).len(), 1);
        assert!(Lock::parse("TRC-A a1\n").is_err());
    }

    #[test]
    fn the_text_reads_back() {
        let current = Lock::current("[TRC-PLANE-01] changed");
        assert_eq!(Lock::parse(&current.to_text()), Ok(current));
    }

    #[test]
    fn line_breaks_are_no_change() {
        assert_eq!(normative_hash("a  b\nc"), normative_hash("a b c"));
        assert_ne!(normative_hash("a b c"), normative_hash("a b d"));
    }
}
