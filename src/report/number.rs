//! Numbers as text.

use radcomp_model::number::{format_decimal, parse_decimal};
use rug::{Integer, Rational};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::text;

/// The most characters of one exact number.
pub const MOST_DIGITS: usize = 10_000;

/// An exact number: a decimal such as `-12.5`, or `p/q`.
///
/// # Exactness
///
/// Exact both ways.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Exact(pub Rational);

/// An `f64`: the shortest decimal that is nearest to it, such as `0.1` or `1e-6`, or `NaN`, `inf`, `-inf`.
///
/// # Exactness
///
/// Comes back bit for bit, the sign of zero included; of a NaN only that it is one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Binary(pub f64);

impl Exact {
    /// The number as a report writes it.
    pub fn text(&self) -> String {
        format_decimal(&self.0).unwrap_or_else(|| format!("{}/{}", self.0.numer(), self.0.denom()))
    }

    /// The number that a report writes so; none if it is not one.
    pub fn parse(text: &str) -> Option<Exact> {
        if text.len() > MOST_DIGITS {
            return None;
        }
        let Some((numerator, denominator)) = text.split_once('/') else { return parse_decimal(text).map(Exact) };
        let (negative, digits) = numerator.strip_prefix('-').map_or((false, numerator), |digits| (true, digits));
        let (mut p, q) = (whole(digits)?, whole(denominator)?);
        if q.is_zero() {
            return None;
        }
        if negative {
            p = -p;
        }
        Some(Exact(Rational::from((p, q))))
    }
}

fn whole(digits: &str) -> Option<Integer> {
    let plain = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    if plain { Integer::from_str_radix(digits, 10).ok() } else { None }
}

impl Binary {
    /// The number as a report writes it.
    pub fn text(self) -> String {
        format!("{:?}", self.0)
    }

    /// The number that a report writes so; none if it is not one.
    pub fn parse(text: &str) -> Option<Binary> {
        let number = |byte: u8| byte.is_ascii_digit() || matches!(byte, b'.' | b'-' | b'e');
        let plain = matches!(text, "NaN" | "inf" | "-inf") || text.bytes().all(number);
        if plain { text.parse().ok().map(Binary) } else { None }
    }
}

impl Serialize for Exact {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.text())
    }
}

impl<'de> Deserialize<'de> for Exact {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        text::read(deserializer, "an exact number: a decimal such as \"-12.5\", or \"p/q\"", Exact::parse)
    }
}

impl Serialize for Binary {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.text())
    }
}

impl<'de> Deserialize<'de> for Binary {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        text::read(deserializer, "an f64 in quotes: a decimal, \"NaN\", \"inf\" or \"-inf\"", Binary::parse)
    }
}
