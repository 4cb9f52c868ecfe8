//! Values that are written as strings.

use std::fmt;

use serde::Deserializer;
use serde::de::{Error, Visitor};

/// Reads a string that `parse` understands. An error names the line and column of the string itself.
pub(super) fn read<'de, D: Deserializer<'de>, T>(
    deserializer: D,
    what: &str,
    parse: impl FnOnce(&str) -> Option<T>,
) -> Result<T, D::Error> {
    deserializer.deserialize_str(Text { what, parse })
}

struct Text<'a, F> {
    what: &'a str,
    parse: F,
}

impl<T, F: FnOnce(&str) -> Option<T>> Visitor<'_> for Text<'_, F> {
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.what)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<T, E> {
        (self.parse)(text).ok_or_else(|| {
            let shown: String = text.chars().take(40).collect();
            E::custom(format!("{shown:?} is not {}", self.what))
        })
    }
}
