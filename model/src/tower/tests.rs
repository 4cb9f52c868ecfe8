//! Towers with dependent roots, which no public way leads to within one tower.

use core::cmp::Ordering;

use super::{Number, Refusal, Tower};

fn whole(value: i64) -> Number {
    Number::integer(value)
}

/// √2 and the dependent root √(3 + 2√2) = 1 + √2, adjoined without being looked for.
fn dependent() -> (Tower, Number, Number) {
    let mut tower = Tower::new(8);
    let two = tower.adjoin(whole(2));
    let nested = tower.adjoin(&whole(3) + &(&two + &two));
    (tower, two, nested)
}

#[test]
fn a_pair_over_a_dependent_root_may_be_zero() {
    let (_, two, nested) = dependent();
    let zero = &(&nested - &two) - &whole(1);
    assert!(!zero.is_written_zero());
    assert_eq!(zero.sign(), Ordering::Equal);
    assert_eq!((&zero * &nested).sign(), Ordering::Equal);
    assert_eq!((&zero + &whole(1)).sign(), Ordering::Greater);
    assert_eq!((&zero.square() - &whole(1)).sign(), Ordering::Less);
    assert!(zero.checked_div(&zero).is_none());
}

#[test]
fn a_divisor_of_zero_is_divided_by() {
    let (_, two, nested) = dependent();
    // Its conjugate is zero, and so is the norm; the number is 2 + 2√2.
    let divisor = &(&nested + &two) + &whole(1);
    let quotient = whole(1).checked_div(&divisor).unwrap();
    assert_eq!(&quotient * &divisor, whole(1));
    assert_eq!(quotient, whole(1).checked_div(&(&whole(2) + &(&two + &two))).unwrap());
}

#[test]
fn a_dependent_rational_root() {
    let mut tower = Tower::new(8);
    let two = tower.adjoin(whole(4));
    assert_eq!(two, whole(2));
    assert!(whole(1).checked_div(&(&two - &whole(2))).is_none());
    assert_eq!(whole(1).checked_div(&(&two + &whole(2))).unwrap(), whole(1).checked_div(&whole(4)).unwrap());
    let root = tower.sqrt(&(&two + &whole(7))).unwrap();
    assert_eq!(root, whole(3));
}

#[test]
fn a_root_is_found_where_it_exists() {
    let mut tower = Tower::new(3);
    let two = tower.sqrt(&whole(2)).unwrap();
    let three = tower.sqrt(&whole(3)).unwrap();
    assert_eq!(tower.sqrt(&whole(6)).unwrap(), &two * &three);
    assert_eq!(
        tower.sqrt(&whole(1).checked_div(&whole(24)).unwrap()).unwrap().square(),
        whole(1).checked_div(&whole(24)).unwrap()
    );
    let sum = &(&two - &three) + &whole(5);
    assert_eq!(tower.sqrt(&sum.square()).unwrap(), sum);
    let less = &(&two + &three) - &whole(5);
    assert_eq!(tower.sqrt(&less.square()).unwrap(), -&less);
    assert_eq!(tower.height(), 2);
    let nested = tower.sqrt(&(&two + &three)).unwrap();
    assert_eq!(tower.sqrt(&(&(&two + &three).square() * &nested.square())), Ok(&(&two + &three) * &nested));
    assert_eq!(tower.height(), 3);
    assert_eq!(tower.sqrt(&whole(5)), Err(Refusal::TooManyRoots));
    assert_eq!(tower.sqrt(&whole(-1)), Err(Refusal::NegativeRadicand));
    assert_eq!(tower.sqrt(&whole(0)), Ok(whole(0)));
    assert_eq!(tower.height(), 3);
}

#[test]
fn numbers_of_different_towers_mix() {
    let one = Tower::new(1).sqrt(&whole(2)).unwrap();
    let other = Tower::new(1).sqrt(&whole(2)).unwrap();
    assert_eq!(one, other);
    assert_eq!(&one * &other, whole(2));
    assert!(whole(1).checked_div(&(&one - &other)).is_none());
    let quotient = whole(1).checked_div(&(&one + &other)).unwrap();
    assert_eq!(quotient.square(), whole(1).checked_div(&whole(8)).unwrap());
}
