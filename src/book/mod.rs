//! The specification as a book: a static site that needs no network.
//!
//! Every worked example and every vector is executed by the exact model while the book is built, and its figure drawn from
//! what the model answers: an example that does not hold is an error, with its file and line. Nothing of the book is
//! kept by hand beside the text of the clauses and guides.

mod chapter;
mod documents;
mod exhibit;
mod formula;
mod index;
mod ledger;
mod links;
mod pass;
mod profiles;
mod prose;
mod sentence;
mod site;
mod variation;

use std::collections::BTreeMap;
use std::io;
use std::path::Path;

use crate::evidence::Ledger;
use links::Links;
use site::Site;

/// A book, as files by their names; all stand in one folder.
#[derive(Clone, Debug)]
pub struct Book {
    files: BTreeMap<String, String>,
    figures: usize,
    examples: usize,
}

impl Book {
    /// Builds the book; the page of the evidence shows this ledger.
    ///
    /// # Errors
    ///
    /// The first worked example or vector that does not hold, with its file and line; or a template that fails, which is
    /// a fault of the toolkit.
    pub fn build(ledger: &Ledger) -> Result<Book, String> {
        let vectors = documents::vectors()?;
        let links = Links::new(vectors.iter().map(|vector| vector.name.as_str()));
        let mut site = Site::new(&links)?;
        let mut index = index::Index::default();
        documents::front(&mut site, ledger)?;
        documents::reading(&mut site, &mut index)?;
        chapter::chapters(&mut site, &mut index, ledger)?;
        profiles::pages(&mut site, &mut index)?;
        documents::vector_page(&mut site, &mut index, &vectors)?;
        documents::seeds(&mut site, &mut index)?;
        pass::page(&mut site, &mut index)?;
        ledger::page(&mut site, ledger)?;
        documents::guides(&mut site, &mut index)?;
        documents::changes(&mut site)?;
        site.add("search-index.js", index.script()?);
        Ok(site.into_book())
    }

    /// The files by their names.
    pub fn files(&self) -> &BTreeMap<String, String> {
        &self.files
    }

    /// How many figures there are.
    pub fn figures(&self) -> usize {
        self.figures
    }

    /// How many worked examples and vectors were executed.
    pub fn examples(&self) -> usize {
        self.examples
    }

    /// Writes the files into a folder, which is made if it is not there.
    ///
    /// # Errors
    ///
    /// If the folder or a file cannot be written.
    pub fn write(&self, folder: &Path) -> io::Result<()> {
        std::fs::create_dir_all(folder)?;
        self.files.iter().try_for_each(|(name, text)| std::fs::write(folder.join(name), text))
    }
}
