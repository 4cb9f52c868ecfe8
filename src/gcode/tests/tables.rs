//! What a tool table takes, and what it tells of itself.

use rug::Rational;

use crate::gcode::Tools;
use crate::gcode::word::MOST_DIGITS;

#[test]
fn a_table_tells_its_numbers_up_to_eight() {
    let with =
        |count: u32| (1..=count).fold(Tools::empty(), |table, number| table.with_radius(number, Rational::new()));
    assert_eq!(with(0).listed(), "it has none");
    assert_eq!(with(8).listed(), "it has 1, 2, 3, 4, 5, 6, 7, 8");
    assert_eq!(with(9).listed(), "it has 1, 2, 3, 4, 5, 6, 7, 8, …");
}

#[test]
fn a_size_has_as_many_digits_as_a_number() {
    let digits = "1".repeat(MOST_DIGITS);
    for (size, fits) in [
        (format!("{digits}.{digits}"), true),
        (format!("-{digits}"), true),
        (format!("1{digits}"), false),
        (format!("0.{digits}1"), false),
    ] {
        let text = format!("[[tool]]\nnumber = 1\nradius = \"{size}\"\n");
        assert_eq!(Tools::parse(&text, "tools.toml").is_ok(), fits, "{size}");
    }
}
