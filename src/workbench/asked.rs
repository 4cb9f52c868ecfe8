//! What the page asks.

use radcomp_model::number::parse_decimal;
use radcomp_spec::profile::Profile;
use serde::Deserialize;

use super::Trouble;
use crate::gcode::{Diagnostic, MOST_DIGITS, Tool, Tools};

/// A program, the control that runs it, and what is to be laid over its path.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Asked {
    /// G-code.
    pub program: String,
    /// The name of a built-in profile.
    pub profile: String,
    /// The text of a profile file, instead of a built-in one.
    pub profile_file: String,
    /// The text of a tool table; may be empty.
    pub tools: String,
    /// The offset number of the tool that `radius` and `orientation` are of.
    pub offset: u32,
    /// Its radius in millimetres, a decimal; if it is empty, the tool table alone counts.
    pub radius: String,
    /// The lines, from 1, whose blocks are told.
    pub lines: Vec<u32>,
    /// The radii that are tried instead of `radius`.
    pub radii: Vec<String>,
    /// Its tip orientation, if it has one.
    pub orientation: Option<u8>,
    /// Blocks that start with `/` are skipped.
    pub block_delete: bool,
    /// The safety verdict is wanted.
    pub safety: bool,
    /// `builtin`, the text of an answer of the pipe protocol, or nothing.
    pub device: String,
}

impl Asked {
    /// Reads a request's body.
    ///
    /// # Errors
    ///
    /// Bytes that are no text, text that is no JSON, and JSON that is not this.
    pub fn read(body: &[u8]) -> Result<Asked, Trouble> {
        let text = std::str::from_utf8(body).map_err(|error| {
            let place = error.valid_up_to();
            Trouble::malformed(format!("the request is not text: byte {place}, counted from 0, is not UTF-8"))
        })?;
        serde_json::from_str(text)
            .map_err(|error| Trouble::malformed(format!("the request is not understood: {error}")))
    }

    /// The control.
    ///
    /// # Errors
    ///
    /// A name that is no profile's, and the first fault of a profile file.
    pub fn control(&self) -> Result<Profile, Trouble> {
        if !self.profile_file.trim().is_empty() {
            return Profile::parse(&self.profile_file, "profile")
                .map_err(|error| Trouble::wrong(Diagnostic::from(error).to_string()));
        }
        Profile::builtin(&self.profile)
            .ok_or_else(|| Trouble::wrong(format!("there is no profile named {:?}", self.profile)))
    }

    /// The tool table.
    ///
    /// # Errors
    ///
    /// Its first fault, and a radius that is no decimal.
    pub fn table(&self) -> Result<Tools, Trouble> {
        let tools = Tools::parse(&self.tools, "tool table").map_err(|fault| Trouble::wrong(fault.to_string()))?;
        let text = self.radius.trim();
        if text.is_empty() {
            return Ok(tools);
        }
        let (digits, decimals) = text.split_once('.').unwrap_or((text, ""));
        let short = digits.trim_start_matches('-').len() <= MOST_DIGITS && decimals.len() <= MOST_DIGITS;
        let radius = parse_decimal(text).filter(|_| short).ok_or_else(|| {
            Trouble::wrong(format!("the tool radius is a decimal of at most {MOST_DIGITS} digits and decimals"))
        })?;
        if self.offset == 0 {
            return Err(Trouble::wrong("an offset number is 1 or greater"));
        }
        if self.orientation.is_some_and(|orientation| orientation > 9) {
            return Err(Trouble::wrong("a tip orientation is a whole number from 0 to 9"));
        }
        Ok(tools.with_tool(self.offset, Tool { orientation: self.orientation, ..Tool::of_radius(radius) }))
    }
}

#[cfg(test)]
mod tests {
    use hyper::StatusCode;

    use super::*;

    #[test]
    fn what_is_no_request_is_told() {
        let status = |body: &[u8]| Asked::read(body).unwrap_err().status;
        assert_eq!(status(b"{\"program\": \"\xff\"}"), StatusCode::BAD_REQUEST);
        assert_eq!(status(b"G01 X5"), StatusCode::BAD_REQUEST);
        assert_eq!(status(b"{\"programme\": \"\"}"), StatusCode::BAD_REQUEST);
        assert!(Asked::read(b"{\"program\": \"G01 X5\", \"offset\": 1}").is_ok());
    }

    #[test]
    fn a_radius_is_exact_and_stands_over_the_table() {
        let tools = "[[tool]]\nnumber = 1\nradius = \"5\"\n".to_owned();
        let asked = Asked { tools, offset: 1, radius: "0.1".to_owned(), ..Asked::default() };
        assert_eq!(asked.table().unwrap().tool(1).unwrap().radius(), rug::Rational::from((1, 10)));
        for radius in ["five", "1e3", "."] {
            let asked = Asked { radius: radius.to_owned(), offset: 1, ..Asked::default() };
            assert_eq!(asked.table().unwrap_err().status, StatusCode::UNPROCESSABLE_ENTITY, "{radius}");
        }
    }
}
