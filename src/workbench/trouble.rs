//! What is wrong with a request.

use std::fmt;

use hyper::StatusCode;
use serde_json::json;

/// What is wrong with a request, in words, and whose fault it is, as a status of HTTP.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Trouble {
    /// The status.
    pub status: StatusCode,
    /// The words.
    pub text: String,
}

impl Trouble {
    /// A request that is no request.
    pub fn malformed(text: impl Into<String>) -> Self {
        Trouble { status: StatusCode::BAD_REQUEST, text: text.into() }
    }

    /// A request whose content cannot be followed.
    pub fn wrong(text: impl Into<String>) -> Self {
        Trouble { status: StatusCode::UNPROCESSABLE_ENTITY, text: text.into() }
    }

    /// A request beyond a limit of size.
    pub fn too_large(text: impl Into<String>) -> Self {
        Trouble { status: StatusCode::PAYLOAD_TOO_LARGE, text: text.into() }
    }

    /// A request that took too long.
    pub fn too_long(text: impl Into<String>) -> Self {
        Trouble { status: StatusCode::SERVICE_UNAVAILABLE, text: text.into() }
    }

    /// The toolkit failed.
    pub fn own(text: impl fmt::Display) -> Self {
        Trouble { status: StatusCode::INTERNAL_SERVER_ERROR, text: format!("radcomp itself is at fault: {text}") }
    }

    /// The answer's body.
    pub fn json(&self) -> String {
        json!({ "error": self.text }).to_string()
    }
}

impl fmt::Display for Trouble {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl std::error::Error for Trouble {}
