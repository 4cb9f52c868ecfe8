//! Points of the plane as a program writes them.

use radcomp_spec::block::Point;
use radcomp_spec::parameters::{Measure, Plane};

use super::Coordinate;

/// The axes that a program names the points of its plane by ([TRC-PLANE-01], [TRC-PLANE-03]).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Axes {
    /// The plane.
    pub plane: Plane,
    /// What X words measure.
    pub x_words: Measure,
}

impl Axes {
    /// The letters of the plane's first and second coordinate.
    pub const fn letters(self) -> [char; 2] {
        match self.plane {
            Plane::Xy => ['X', 'Y'],
            Plane::Zx => ['Z', 'X'],
            Plane::Yz => ['Y', 'Z'],
        }
    }

    /// The code that chooses the plane.
    pub const fn code(self) -> &'static str {
        match self.plane {
            Plane::Xy => "G17",
            Plane::Zx => "G18",
            Plane::Yz => "G19",
        }
    }

    /// A point in the order X, Y, Z, X as a diameter if X words measure diameters.
    pub fn program<N: Coordinate>(self, [a, b]: &Point<N>) -> [(char, N); 2] {
        let [first, second] = self.letters();
        let x = |value: &N| match self.x_words {
            Measure::Diameter => value.doubled(),
            Measure::Radius => value.clone(),
        };
        match self.plane {
            Plane::Xy => [(first, x(a)), (second, b.clone())],
            Plane::Zx => [(second, x(b)), (first, a.clone())],
            Plane::Yz => [(first, a.clone()), (second, b.clone())],
        }
    }

    /// A point in words, such as `X 12.5 Z -3`, with up to that many digits after the decimal points.
    pub fn words<N: Coordinate>(self, point: &Point<N>, digits: usize) -> String {
        let [first, second] = self.program(point).map(|(letter, value)| format!("{letter} {}", value.short(digits)));
        format!("{first} {second}")
    }

    /// The closed forms of a point's coordinates that its decimals do not tell, such as `X = 10 + 5·√2`.
    pub fn closed_forms<N: Coordinate>(self, point: &Point<N>, digits: usize) -> Option<String> {
        let closed = self.program(point).map(|(letter, value)| Some(format!("{letter} = {}", value.closed(digits)?)));
        let forms: Vec<String> = closed.into_iter().flatten().collect();
        (!forms.is_empty()).then(|| forms.join(", "))
    }
}
