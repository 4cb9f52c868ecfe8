//! Reading numbers: `10 + 5*sqrt(2)`, `-3/4`, `1.25`, and what closed forms print.
//!
//! ```text
//! sum     = product { ("+" | "-") product }
//! product = factor { ("*" | "·" | "/") factor }
//! factor  = ("+" | "-") factor | decimal | "(" sum ")" | ("√" | "sqrt") factor without sign
//! ```

use core::fmt;

use super::Real;
use super::decimal::parse_decimal;

/// Parentheses, signs and roots may be nested this deep.
const DEEPEST: usize = 100;

/// Why a text is not a number. `at` counts bytes from the start of the text.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ParseRealError {
    /// The text ends where a number, a root or a parenthesis should stand.
    UnexpectedEnd,
    /// Something else stands where a number, a root, an operator or a parenthesis should.
    Unexpected {
        /// Where it stands.
        at: usize,
        /// What it is.
        found: char,
    },
    /// A divisor is exactly zero.
    DivisionByZero {
        /// Where the divisor ends.
        at: usize,
    },
    /// A radicand is negative.
    NegativeRadicand {
        /// Where the radicand ends.
        at: usize,
    },
    /// Parentheses, signs or roots are nested more than a hundred deep.
    TooDeep {
        /// Where the limit is passed.
        at: usize,
    },
}

impl fmt::Display for ParseRealError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ParseRealError::UnexpectedEnd => write!(f, "the number is incomplete"),
            ParseRealError::Unexpected { at, found } => {
                write!(f, "unexpected `{found}` at byte {at}")
            }
            ParseRealError::DivisionByZero { at } => write!(f, "division by zero before byte {at}"),
            ParseRealError::NegativeRadicand { at } => {
                write!(f, "root of a negative number before byte {at}")
            }
            ParseRealError::TooDeep { at } => {
                write!(f, "nested more than {DEEPEST} deep at byte {at}")
            }
        }
    }
}

impl core::error::Error for ParseRealError {}

impl Real {
    /// Reads a number: decimals, `+ - * · /`, parentheses, and roots as `√2`, `√(…)` or `sqrt(…)`.
    ///
    /// # Exactness
    ///
    /// Exact: a decimal is the rational it spells.
    ///
    /// # Errors
    ///
    /// If the text is not such an expression, divides by zero or takes the root of a negative number.
    pub fn parse(text: &str) -> Result<Real, ParseRealError> {
        let mut reader = Reader { text, at: 0, depth: 0 };
        let value = reader.sum()?;
        match reader.peek() {
            None => Ok(value),
            Some(found) => Err(ParseRealError::Unexpected { at: reader.at, found }),
        }
    }
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
    depth: usize,
}

impl Reader<'_> {
    fn sum(&mut self) -> Result<Real, ParseRealError> {
        let mut value = self.product()?;
        loop {
            if self.take("+") {
                value = value + self.product()?;
            } else if self.take("-") || self.take("−") {
                value = value - self.product()?;
            } else {
                return Ok(value);
            }
        }
    }

    fn product(&mut self) -> Result<Real, ParseRealError> {
        let mut value = self.factor()?;
        loop {
            if self.take("*") || self.take("·") || self.take("×") {
                value = value * self.factor()?;
            } else if self.take("/") {
                let divisor = self.factor()?;
                value = value.checked_div(&divisor).ok_or(ParseRealError::DivisionByZero { at: self.at })?;
            } else {
                return Ok(value);
            }
        }
    }

    fn factor(&mut self) -> Result<Real, ParseRealError> {
        self.nested(|reader| {
            if reader.take("-") || reader.take("−") {
                Ok(-reader.factor()?)
            } else if reader.take("+") {
                reader.factor()
            } else {
                reader.unsigned()
            }
        })
    }

    fn unsigned(&mut self) -> Result<Real, ParseRealError> {
        if self.take("√") || self.take("sqrt") {
            let radicand = self.nested(Reader::unsigned)?;
            return radicand.sqrt().ok_or(ParseRealError::NegativeRadicand { at: self.at });
        }
        if self.take("(") {
            let value = self.nested(Reader::sum)?;
            return if self.take(")") { Ok(value) } else { Err(self.unexpected()) };
        }
        self.decimal()
    }

    fn decimal(&mut self) -> Result<Real, ParseRealError> {
        self.peek();
        let rest = &self.text[self.at..];
        let length = rest.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(rest.len());
        let value = parse_decimal(&rest[..length]).ok_or_else(|| self.unexpected())?;
        self.at += length;
        Ok(Real::rational(value))
    }

    /// Reads a part one level deeper.
    fn nested(&mut self, part: impl FnOnce(&mut Self) -> Result<Real, ParseRealError>) -> Result<Real, ParseRealError> {
        if self.depth == DEEPEST {
            return Err(ParseRealError::TooDeep { at: self.at });
        }
        self.depth += 1;
        let value = part(self);
        self.depth -= 1;
        value
    }

    /// The next character that is not a space; the reader stands before it.
    fn peek(&mut self) -> Option<char> {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start().len();
        self.text[self.at..].chars().next()
    }

    /// Passes over a token, if it is next.
    fn take(&mut self, token: &str) -> bool {
        self.peek();
        let found = self.text[self.at..].starts_with(token);
        if found {
            self.at += token.len();
        }
        found
    }

    fn unexpected(&mut self) -> ParseRealError {
        match self.peek() {
            Some(found) => ParseRealError::Unexpected { at: self.at, found },
            None => ParseRealError::UnexpectedEnd,
        }
    }
}
