//! Blocks whose tool path would run backwards. [TRC-WEDGE-02], [TRC-WEDGE-03]

use core::cmp::Ordering;

use radcomp_spec::AlarmKind;

use crate::arc_form::Arc;
use crate::element::Element;
use crate::plane::{Vector, cross, dot, greater, magnitude};
use crate::sign::sign;

/// The alarm of a compensated element on which the tool's centre would run backwards from `from` to `to`; `full` when
/// it is run as a full circle.
#[inline(always)]
pub(crate) fn reversed(element: &Element, from: Vector, to: Vector, full: bool) -> Option<AlarmKind> {
    let scale = greater(element.scale, greater(magnitude(from), magnitude(to)));
    match &element.arc {
        None => {
            let travel = dot(to - from, element.last);
            (sign(travel, scale) == Ordering::Less).then_some(AlarmKind::ReversedLine)
        }
        Some(_) if full => None,
        Some(arc) => {
            let (difference, _) = sweeps(arc, element.first_error + element.last_error, from, to, scale);
            (difference == Ordering::Greater).then_some(AlarmKind::ReversedArc)
        }
    }
}

/// An angle as cosine and sine, times a length, and where it lies: the sine's sign without its rounding.
struct Sweep {
    x: f64,
    y: f64,
    half: Ordering,
}

impl Sweep {
    /// From one ray to the other in the arc's sense; `scale` bounds the terms of the sine.
    fn between(from: Vector, to: Vector, sense: f64, scale: f64) -> Sweep {
        let y = sense * cross(from, to);
        Sweep { x: dot(from, to), y, half: sign(y, scale) }
    }

    /// The rays are one.
    fn is_closed(&self) -> bool {
        self.half == Ordering::Equal && self.x >= 0.0
    }
}

/// How far the programmed sweep G in (0°, 360°] and the tool's sweep T in [0°, 360°) from `from` to `to` differ, against
/// 180°, and whether T is 0: a tool that would run past a full turn takes the short way instead, [TRC-SIDE-08]. `error` is
/// that of the arc's rays together, in units of rounding.
#[inline]
pub(crate) fn sweeps(arc: &Arc, error: f64, from: Vector, to: Vector, scale: f64) -> (Ordering, bool) {
    let programmed = Sweep::between(arc.swept_from, arc.end_ray, arc.sense, error);
    let (start, end) = (from - arc.centre, to - arc.centre);
    let bound = scale * (magnitude(start) + magnitude(end));
    let tool = Sweep::between(start, end, arc.sense, bound);
    if programmed.half == tool.half && tool.half != Ordering::Equal {
        // Both in one half turn.
        return (Ordering::Less, false);
    }
    // sin(T - G), of which both lengths are left in the product.
    let difference = programmed.x * tool.y - programmed.y * tool.x;
    let order = sign(difference, bound + (magnitude(start) * magnitude(end)) * error);
    match (programmed.is_closed(), tool.is_closed()) {
        // 360° against 0°.
        (true, true) => (Ordering::Greater, true),
        (true, false) => (tool.half, false),
        (false, true) => (programmed.half.reverse(), true),
        (false, false) => match (programmed.half, tool.half) {
            // G < 180° < T: T - G > 180° when its sine is negative.
            (Ordering::Greater, Ordering::Less) => (order.reverse(), false),
            // T < 180° < G: G - T > 180° when the sine of T - G is positive.
            (Ordering::Less, Ordering::Greater) => (order, false),
            // One of them 180° exactly, neither a whole turn.
            _ => (Ordering::Less, false),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arc_form::Tolerances;
    use crate::plane::perp;
    use radcomp_spec::{Centre, Direction};

    fn ray(degrees: f64) -> Vector {
        Vector::new(degrees.to_radians().cos(), degrees.to_radians().sin())
    }

    #[test]
    fn sweeps_against_angles() {
        let tolerances = Tolerances { end: 0.01, centre: 0.0, chord: 0.0 };
        for sense in [1.0, -1.0] {
            for programmed in (10_i32..360).step_by(25) {
                for swept in (0..360).step_by(15) {
                    let direction = if sense > 0.0 { Direction::Counterclockwise } else { Direction::Clockwise };
                    let (start, end) = (ray(20.0) * 5.0, ray(20.0 + sense * f64::from(programmed)) * 5.0);
                    let centre = Centre::FromStart([-start.x, -start.y]);
                    let mut element = Element::unused();
                    element.set_arc(start, end, &centre, direction, tolerances).unwrap();
                    let (from, to) = (ray(50.0) * 4.0, ray(50.0 + sense * f64::from(swept)) * 4.0);
                    let expected = (programmed - swept).abs() > 180;
                    let alarm = reversed(&element, from, to, false);
                    assert_eq!(alarm.is_some(), expected, "{programmed} {swept}");
                }
            }
        }
        assert_eq!(perp(ray(0.0)), Vector::new(-0.0, 1.0));
    }
}
