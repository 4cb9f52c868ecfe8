//! The two number kernels, on expressions made for the purpose: random ones, and zeros that nobody wrote as 0.

use std::cell::RefCell;
use std::cmp::Ordering;

use proptest::prelude::*;
use radcomp_model::number::Real;
use radcomp_model::tower::{Number, Refusal, Tower};
use rug::{Integer, Rational};

/// One number in both kernels, each of which did every operation itself.
#[derive(Clone, Debug)]
struct Both {
    real: Real,
    number: Number,
}

/// The operations in both kernels. They must give numbers of one sign, and refuse the same operands.
struct Kernels(RefCell<Tower>);

impl Kernels {
    fn new(most_roots: usize) -> Kernels {
        Kernels(RefCell::new(Tower::new(most_roots)))
    }

    fn agreed(&self, real: Real, number: Number) -> Both {
        assert_eq!(real.sign(), number.sign(), "{number}");
        Both { real, number }
    }

    fn ratio(&self, numerator: i64, denominator: i64) -> Both {
        let value = Rational::from((numerator, denominator));
        self.agreed(Real::rational(value.clone()), Number::rational(value))
    }

    fn whole(&self, value: i64) -> Both {
        self.ratio(value, 1)
    }

    fn add(&self, a: &Both, b: &Both) -> Both {
        self.agreed(&a.real + &b.real, &a.number + &b.number)
    }

    fn sub(&self, a: &Both, b: &Both) -> Both {
        self.agreed(&a.real - &b.real, &a.number - &b.number)
    }

    fn mul(&self, a: &Both, b: &Both) -> Both {
        self.agreed(&a.real * &b.real, &a.number * &b.number)
    }

    fn negate(&self, a: &Both) -> Both {
        self.agreed(-&a.real, -&a.number)
    }

    fn square(&self, a: &Both) -> Both {
        self.agreed(a.real.square(), a.number.square())
    }

    fn abs(&self, a: &Both) -> Both {
        self.agreed(a.real.abs(), a.number.abs())
    }

    /// The quotient; none if both kernels see a zero divisor.
    fn div(&self, a: &Both, b: &Both) -> Option<Both> {
        let (real, number) = (a.real.checked_div(&b.real), a.number.checked_div(&b.number));
        assert_eq!(real.is_some(), number.is_some(), "1 over {}", b.number);
        Some(self.agreed(real?, number?))
    }

    /// The root; none if both kernels see a negative number, or if the tower is as high as it may be.
    fn sqrt(&self, a: &Both) -> Option<Both> {
        let (real, number) = (a.real.sqrt(), self.0.borrow_mut().sqrt(&a.number));
        if number == Err(Refusal::TooManyRoots) {
            return None;
        }
        assert_eq!(real.is_none(), number == Err(Refusal::NegativeRadicand), "√{}", a.number);
        Some(self.agreed(real?, number.ok()?))
    }

    /// Two numbers that are equal, and what the smallest change makes of them.
    fn assert_equal(&self, left: &Both, right: &Both) {
        let zero = self.sub(left, right);
        assert_eq!(zero.number.sign(), Ordering::Equal, "{}", zero.number);
        assert_eq!(self.0.borrow_mut().convert(&zero.real).expect("of the same roots").sign(), Ordering::Equal);
        for bits in [20, 300] {
            let little = Rational::from((1, Integer::from(1) << bits));
            let little = self.agreed(Real::rational(little.clone()), Number::rational(little));
            // Not the zero and a little: kernels may remember that a number is zero.
            let (more, less) = (self.add(left, &little), self.sub(left, &little));
            assert_eq!(self.sub(&more, right).number.sign(), Ordering::Greater);
            assert_eq!(self.sub(&less, right).number.sign(), Ordering::Less);
        }
    }
}

/// One step of a random expression: an operation and the places of its operands among the numbers so far.
#[derive(Clone, Debug)]
enum Step {
    Rational(i64, i64),
    Add(usize, usize),
    Sub(usize, usize),
    Mul(usize, usize),
    Div(usize, usize),
    Square(usize),
    Negate(usize),
    /// Of the absolute value.
    Root(usize),
}

fn step() -> impl Strategy<Value = Step> {
    let place = 0..64_usize;
    prop_oneof![
        1 => (-60..60_i64, prop_oneof![Just(1_i64), Just(10), 1..12_i64]).prop_map(|(n, d)| Step::Rational(n, d)),
        2 => (place.clone(), place.clone()).prop_map(|(a, b)| Step::Add(a, b)),
        2 => (place.clone(), place.clone()).prop_map(|(a, b)| Step::Sub(a, b)),
        2 => (place.clone(), place.clone()).prop_map(|(a, b)| Step::Mul(a, b)),
        1 => (place.clone(), place.clone()).prop_map(|(a, b)| Step::Div(a, b)),
        1 => place.clone().prop_map(Step::Square),
        1 => place.clone().prop_map(Step::Negate),
        3 => place.prop_map(Step::Root),
    ]
}

/// The numbers of an expression in both kernels; a step that both refuse, or that has too many roots, is left out.
fn evaluate(steps: &[Step], kernels: &Kernels) -> Vec<Both> {
    let mut numbers = vec![kernels.whole(2), kernels.ratio(-7, 5)];
    for step in steps {
        let of = |place: usize| &numbers[place % numbers.len()];
        let next = match *step {
            Step::Rational(numerator, denominator) => Some(kernels.ratio(numerator, denominator)),
            Step::Add(a, b) => Some(kernels.add(of(a), of(b))),
            Step::Sub(a, b) => Some(kernels.sub(of(a), of(b))),
            Step::Mul(a, b) => Some(kernels.mul(of(a), of(b))),
            Step::Div(a, b) => kernels.div(of(a), of(b)),
            Step::Square(a) => Some(kernels.square(of(a))),
            Step::Negate(a) => Some(kernels.negate(of(a))),
            Step::Root(a) => {
                let radicand = kernels.abs(of(a));
                kernels.sqrt(&radicand)
            }
        };
        numbers.extend(next);
    }
    numbers
}

/// A positive number of a random expression.
fn positive(steps: &[Step], kernels: &Kernels) -> Both {
    let numbers = evaluate(steps, kernels);
    let last = numbers.iter().rev().find(|both| !both.real.is_zero()).expect("2 is not zero");
    kernels.abs(last)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, ..ProptestConfig::default() })]

    #[test]
    fn random_expressions(steps in prop::collection::vec(step(), 1..12)) {
        let kernels = Kernels::new(4);
        let numbers = evaluate(&steps, &kernels);
        for both in &numbers {
            // What the model hands out of its number is that number.
            if let Ok(converted) = Number::from_real(&both.real, 4) {
                prop_assert_eq!(&converted, &both.number);
            }
        }
        for pair in numbers.windows(2) {
            prop_assert_eq!(pair[0].real.cmp(&pair[1].real), pair[0].number.cmp(&pair[1].number));
        }
    }

    #[test]
    fn identities(
        first in prop::collection::vec(step(), 0..5),
        second in prop::collection::vec(step(), 0..5),
        which in 0..IDENTITIES.len(),
    ) {
        let kernels = Kernels::new(5);
        let (a, b) = (positive(&first, &kernels), positive(&second, &kernels));
        if let Some((left, right)) = IDENTITIES[which](&kernels, &a, &b) {
            kernels.assert_equal(&left, &right);
        }
    }
}

/// Two equal numbers made of any two positive numbers a and b; none if they take too many roots or divide by zero.
type Equation = fn(&Kernels, &Both, &Both) -> Option<(Both, Both)>;

const IDENTITIES: &[Equation] = &[
    // √a·√b = √(ab)
    |k, a, b| {
        let (root_a, root_b, root) = (k.sqrt(a)?, k.sqrt(b)?, k.sqrt(&k.mul(a, b))?);
        Some((k.mul(&root_a, &root_b), root))
    },
    // √(a + b + 2√(ab)) = √a + √b, the outermost root first
    |k, a, b| {
        let root = k.sqrt(&k.mul(a, b))?;
        let nested = k.sqrt(&k.add(&k.add(a, b), &k.add(&root, &root)))?;
        let sum = k.add(&k.sqrt(a)?, &k.sqrt(b)?);
        Some((nested, sum))
    },
    // √(a + b - 2√(ab)) = |√a - √b|
    |k, a, b| {
        let difference = k.sub(&k.sqrt(a)?, &k.sqrt(b)?);
        let root = k.sqrt(&k.mul(a, b))?;
        let nested = k.sqrt(&k.sub(&k.add(a, b), &k.add(&root, &root)))?;
        Some((nested, k.abs(&difference)))
    },
    // (√a + √b)(√a - √b) = a - b
    |k, a, b| {
        let (root_a, root_b) = (k.sqrt(a)?, k.sqrt(b)?);
        Some((k.mul(&k.add(&root_a, &root_b), &k.sub(&root_a, &root_b)), k.sub(a, b)))
    },
    // 1/(√a + √b) = (√a - √b)/(a - b)
    |k, a, b| {
        let (root_a, root_b) = (k.sqrt(a)?, k.sqrt(b)?);
        let direct = k.div(&k.whole(1), &k.add(&root_a, &root_b))?;
        let conjugate = k.div(&k.sub(&root_a, &root_b), &k.sub(a, b))?;
        Some((direct, conjugate))
    },
    // √(a/b) = √(ab)/b
    |k, a, b| {
        let (quotient, product) = (k.div(a, b)?, k.mul(a, b));
        let (root, other) = (k.sqrt(&quotient)?, k.sqrt(&product)?);
        Some((root, k.div(&other, b)?))
    },
    // 1/(a + √b) + 1/(a - √b) = 2a/(a² - b): conjugates add up to a trace
    |k, a, b| {
        let root = k.sqrt(b)?;
        let one = k.whole(1);
        let sum = k.add(&k.div(&one, &k.add(a, &root))?, &k.div(&one, &k.sub(a, &root))?);
        Some((sum, k.div(&k.add(a, a), &k.sub(&k.square(a), b))?))
    },
    // √(a + √(a² + b²)) · √(√(a² + b²) - a) = b: half angles
    |k, a, b| {
        let length = k.sqrt(&k.add(&k.square(a), &k.square(b)))?;
        let (cosine, sine) = (k.sqrt(&k.add(&length, a))?, k.sqrt(&k.sub(&length, a))?);
        Some((k.mul(&cosine, &sine), b.clone()))
    },
];

/// A corner of two lines with rational directions and its mitre V = r·(n₁ + n₂)/(1 + n₁·n₂).
struct Mitre {
    normals: [[Both; 2]; 2],
    vector: [Both; 2],
    radius: Both,
}

impl Mitre {
    fn new(k: &Kernels, directions: [[i64; 2]; 2], radius: [i64; 2]) -> Option<Mitre> {
        let normal = |[x, y]: [i64; 2]| {
            let length = k.sqrt(&k.whole(x * x + y * y))?;
            Some([k.div(&k.whole(-y), &length)?, k.div(&k.whole(x), &length)?])
        };
        let normals = [normal(directions[0])?, normal(directions[1])?];
        let [one, other] = &normals;
        let radius = k.ratio(radius[0], radius[1]);
        let factor = k.div(&radius, &k.add(&k.whole(1), &dot(k, one, other)))?;
        let vector = [0, 1].map(|axis| k.mul(&factor, &k.add(&one[axis], &other[axis])));
        Some(Mitre { normals, vector, radius })
    }
}

fn dot(k: &Kernels, [ax, ay]: &[Both; 2], [bx, by]: &[Both; 2]) -> Both {
    k.add(&k.mul(ax, bx), &k.mul(ay, by))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, ..ProptestConfig::default() })]

    /// The mitre is at the radius from both lines, its length is r·√(2/(1 + n₁·n₂)), and it bisects.
    #[test]
    fn mitres(directions in prop::array::uniform2(prop::array::uniform2(-900..900_i64)), radius in 1..5000_i64) {
        let k = &Kernels::new(4);
        let Some(Mitre { normals, vector, radius }) = Mitre::new(k, directions, [radius, 1000]) else { return Ok(()) };
        for normal in &normals {
            k.assert_equal(&dot(k, &vector, normal), &radius);
        }
        let cosine = dot(k, &normals[0], &normals[1]);
        let ratio = k.div(&k.whole(2), &k.add(&k.whole(1), &cosine)).expect("the mitre exists");
        let lengths = [k.sqrt(&dot(k, &vector, &vector)), k.sqrt(&ratio)];
        let [Some(length), Some(factor)] = lengths else { unreachable!("at most 3 roots") };
        k.assert_equal(&length, &k.mul(&radius, &factor));
        k.assert_equal(&dot(k, &vector, &normals[0]), &dot(k, &vector, &normals[1]));
    }
}

/// Shanks: √5 + √(22 + 2√5) = √(11 + 2√29) + √(16 - 2√29 + 2√(55 - 10√29)).
#[test]
fn an_incredible_identity() {
    let k = &Kernels::new(4);
    let root = |k: &Kernels, radicand: &Both| k.sqrt(radicand).expect("of at most four independent roots");
    let five = root(k, &k.whole(5));
    let left = root(k, &k.add(&k.whole(22), &k.add(&five, &five)));
    let twenty_nine = root(k, &k.whole(29));
    let twice = k.add(&twenty_nine, &twenty_nine);
    let first = root(k, &k.add(&k.whole(11), &twice));
    let inner = root(k, &k.sub(&k.whole(55), &k.mul(&k.whole(5), &twice)));
    let second = root(k, &k.add(&k.sub(&k.whole(16), &twice), &k.add(&inner, &inner)));
    k.assert_equal(&k.add(&five, &left), &k.add(&first, &second));
}

/// √n + √(n + 2) against 2√(n + 1): a difference of about n^(-3/2)/4, and never zero.
#[test]
fn near_misses() {
    for exponent in (0..60).chain([100, 400, 1600]) {
        let k = &Kernels::new(3);
        let roots = [0, 1, 2].map(|more| {
            let radicand = Rational::from((Integer::from(1) << exponent) + more);
            let radicand = k.agreed(Real::rational(radicand.clone()), Number::rational(radicand));
            k.sqrt(&radicand).expect("at most three roots")
        });
        let difference = k.sub(&k.add(&roots[0], &roots[2]), &k.add(&roots[1], &roots[1]));
        assert_eq!(difference.number.sign(), Ordering::Less, "2^{exponent}");
    }
}

/// An expression a hundred thousand operations deep.
#[test]
fn deep_expressions() {
    let root = Real::integer(2).sqrt().expect("positive");
    let sum = (0..100_000).fold(Real::zero(), |sum, _| &sum + &root);
    let converted = Number::from_real(&sum, 1).expect("one root");
    assert_eq!(converted.square(), Number::integer(20_000_000_000));
}
