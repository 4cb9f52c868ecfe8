//! Whether two vectors interfere. [TRC-INT-02]

use core::cmp::Ordering;

use crate::element::Element;
use crate::interference::HeldBack;
use crate::plane::{Vector, direction, dot, greater, magnitude};
use crate::sign::sign;
use crate::wedge::sweeps;

/// What lies between two vectors.
pub(crate) enum Compared<'a> {
    /// One block, which is looked at by itself.
    Block(&'a Element),
    /// Several blocks, from one programmed point to the other; `scale` bounds their coordinates.
    Points { from: Vector, to: Vector, scale: f64 },
    /// One block that is not looked at by itself. [TRC-INT-01]
    Nothing,
}

impl<'a> Compared<'a> {
    /// One block.
    pub fn block(block: &'a HeldBack) -> Compared<'a> {
        Compared::element(&block.element, block.own.full || block.is_point())
    }

    /// One element; `apart` when it is run as a full circle, or its offset curve is a point.
    pub fn element(element: &'a Element, apart: bool) -> Compared<'a> {
        if apart { Compared::Nothing } else { Compared::Block(element) }
    }

    /// Whether the vectors `v` and `w` at the two points interfere.
    pub fn interfere(&self, v: Vector, w: Vector, inclusive: bool) -> bool {
        match *self {
            Compared::Nothing => false,
            Compared::Block(element) if element.arc.is_some() => on_arc(element, v, w, inclusive),
            Compared::Block(element) => led_back(element.start, element.end, element.scale, v, w, inclusive),
            Compared::Points { from, to, scale } => led_back(from, to, scale, v, w, inclusive),
        }
    }
}

/// Whether the way from `v` to `w` leads against that from one programmed point to the other.
fn led_back(from: Vector, to: Vector, scale: f64, v: Vector, w: Vector, inclusive: bool) -> bool {
    if from == to {
        return false;
    }
    let (along, length) = direction(to - from);
    let way = w - v;
    let scale = greater(greater(scale, magnitude(to)), greater(magnitude(v), magnitude(w)));
    // The direction is a difference of coordinates, and its error grows with the way.
    match sign(dot(along, way), scale + magnitude(way) * (1.0 + scale / length)) {
        Ordering::Less => true,
        Ordering::Equal => inclusive,
        Ordering::Greater => false,
    }
}

/// Whether the programmed sweep and that from `v` to `w` about the centre differ by more than 180°.
fn on_arc(element: &Element, v: Vector, w: Vector, inclusive: bool) -> bool {
    let Some(arc) = &element.arc else { return false };
    let scale = greater(element.scale, greater(magnitude(v), magnitude(w)));
    let at_centre = |point: Vector| sign(magnitude(point - arc.centre), scale) == Ordering::Equal;
    if element.start == element.end || at_centre(v) || at_centre(w) {
        return false;
    }
    match sweeps(arc, element.first_error + element.last_error, v, w, scale) {
        (Ordering::Greater, _) => true,
        (difference, closed) => inclusive && (difference == Ordering::Equal || closed),
    }
}
