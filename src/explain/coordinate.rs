//! Coordinates as text: exact numbers of the model, and doubles of a device.

use radcomp_model::number::{Real, parse_decimal};
use rug::Rational;

/// A coordinate that can be written.
pub trait Coordinate: Clone {
    /// In decimal, with that many digits after the point, rounded to nearest.
    fn decimal(&self, digits: usize) -> String;

    /// In closed form, such as `10 + 5·√2`, if there is a short one.
    fn exact(&self) -> Option<String>;

    /// Twice the coordinate.
    fn doubled(&self) -> Self;

    /// The coordinate moved by an exact length.
    fn moved_by(&self, length: &Rational) -> Self;

    /// As a double, for drawing and for choosing how many digits to write.
    fn approximate(&self) -> f64;

    /// In decimal with at most that many digits after the point, without zeros at the end.
    fn short(&self, digits: usize) -> String {
        trimmed(&self.decimal(digits)).to_owned()
    }

    /// In closed form, if that tells more than the decimal of so many digits.
    fn closed(&self, digits: usize) -> Option<String> {
        let form = self.exact()?;
        let decimal = parse_decimal(&self.decimal(digits)).map(Real::rational);
        let told = Real::parse(&form).ok().zip(decimal).is_some_and(|(form, decimal)| form == decimal);
        (!told).then_some(form)
    }
}

/// A decimal without the zeros at its end.
pub fn trimmed(decimal: &str) -> &str {
    match decimal.contains('.') {
        true => decimal.trim_end_matches('0').trim_end_matches('.'),
        false => decimal,
    }
}

impl Coordinate for Real {
    fn decimal(&self, digits: usize) -> String {
        self.to_decimal(digits)
    }

    fn exact(&self) -> Option<String> {
        self.closed_form()
    }

    fn doubled(&self) -> Self {
        self + self
    }

    fn moved_by(&self, length: &Rational) -> Self {
        self + &Real::rational(length.clone())
    }

    fn approximate(&self) -> f64 {
        self.to_f64()
    }
}

impl Coordinate for f64 {
    fn decimal(&self, digits: usize) -> String {
        let text = format!("{self:.digits$}");
        // What rounds to zero has no sign.
        match text.strip_prefix('-') {
            Some(zero) if zero.bytes().all(|byte| matches!(byte, b'0' | b'.')) => zero.to_owned(),
            _ => text,
        }
    }

    fn exact(&self) -> Option<String> {
        None
    }

    fn doubled(&self) -> Self {
        self + self
    }

    fn moved_by(&self, length: &Rational) -> Self {
        self + length.to_f64()
    }

    fn approximate(&self) -> f64 {
        *self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_closed_form_stands_only_where_the_decimal_does_not_tell_all() {
        let half = Real::parse("19/2").unwrap();
        assert_eq!((half.short(6), half.closed(6)), ("9.5".to_owned(), None));
        assert_eq!(half.closed(0).as_deref(), Some("19/2"));
        let third = Real::parse("1/3").unwrap();
        assert_eq!(third.closed(6).as_deref(), Some("1/3"));
        let root = Real::parse("10 + 5·√2").unwrap();
        assert_eq!((root.short(3), root.closed(3)), ("17.071".to_owned(), Some("10 + 5·√2".to_owned())));
        assert_eq!(Real::integer(100).short(3), "100");
    }

    #[test]
    fn doubles_round_to_an_unsigned_zero() {
        assert_eq!((-0.0001_f64).decimal(2), "0.00");
        assert_eq!((-0.51_f64).decimal(0), "-1");
    }
}
