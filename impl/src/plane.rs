//! Vectors of the plane: the products of the chapter "The plane", and lengths that neither overflow nor underflow.

use nalgebra::Vector2;

/// A point or a vector in the plane, in millimetres; or a direction, without unit.
pub type Vector = Vector2<f64>;

/// `v` turned by a right angle counter-clockwise.
#[inline(always)]
pub fn perp(v: Vector) -> Vector {
    Vector::new(-v.y, v.x)
}

/// `cross(v, w)`.
#[inline(always)]
pub fn cross(v: Vector, w: Vector) -> f64 {
    v.x * w.y - v.y * w.x
}

/// `dot(v, w)`.
#[inline(always)]
pub fn dot(v: Vector, w: Vector) -> f64 {
    v.x * w.x + v.y * w.y
}

/// The greater of two numbers, neither of them NaN: what [`f64::max`] does about that takes longer than the rest.
#[inline(always)]
pub fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// The lesser of two numbers, neither of them NaN.
#[inline(always)]
pub fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// The greater magnitude of the two components.
#[inline(always)]
pub fn magnitude(v: Vector) -> f64 {
    greater(v.x.abs(), v.y.abs())
}

/// Squares of components below this would lose digits to underflow: 2⁻⁴⁰⁰.
const SMALL: f64 = f64::from_bits((1023 - 400) << 52);
/// A factor that brings every number below [`SMALL`], denormal ones too, into the safe range: 2⁶⁰⁰.
const LARGE: f64 = f64::from_bits((1023 + 600) << 52);

/// Direction and length of a vector that is not zero and within range ([TRC-MODE-07]).
///
/// # Exactness
/// Both within two units in the last place; exact for vectors along an axis.
#[inline(always)]
pub fn direction(v: Vector) -> (Vector, f64) {
    let square = dot(v, v);
    if square >= SMALL {
        let length = libm::sqrt(square);
        return (Vector::new(v.x / length, v.y / length), length);
    }
    direction_of_small(v)
}

#[cold]
fn direction_of_small(v: Vector) -> (Vector, f64) {
    let v = v * LARGE;
    let length = libm::sqrt(dot(v, v));
    (v / length, length / LARGE)
}

/// The length of a vector within range.
#[inline]
pub fn length(v: Vector) -> f64 {
    if v == Vector::zeros() { 0.0 } else { direction(v).1 }
}

/// Whether both components are finite.
#[inline(always)]
pub fn is_finite(v: Vector) -> bool {
    // A sum of finite numbers overflows only beyond 10³⁰⁷ mm, and that is out of range too.
    (v.x + v.y).abs() <= f64::MAX
}
