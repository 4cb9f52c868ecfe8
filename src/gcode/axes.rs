//! The axes of the three planes ([TRC-PLANE-01]).

use radcomp_spec::parameters::Plane;

/// The letters of the axes.
pub(super) const AXES: [char; 3] = ['X', 'Y', 'Z'];
/// The letters of the centre words and dummy words, in the order of [`AXES`].
pub(super) const CENTRES: [char; 3] = ['I', 'J', 'K'];

/// Indices into [`AXES`]: the plane's first axis, its second, and its normal.
pub(super) const fn axes_of(plane: Plane) -> [usize; 3] {
    match plane {
        Plane::Xy => [0, 1, 2],
        Plane::Zx => [2, 0, 1],
        Plane::Yz => [1, 2, 0],
    }
}

/// The code that chooses a plane, and its axes, for people.
pub(super) const fn name_of(plane: Plane) -> &'static str {
    match plane {
        Plane::Xy => "G17 (X, Y)",
        Plane::Zx => "G18 (Z, X)",
        Plane::Yz => "G19 (Y, Z)",
    }
}
