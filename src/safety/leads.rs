//! Leads: the elements before and after a contour that returns to where it began.
//!
//! Programs run on past the point where the contour began, or come to it and leave it on arcs of their own. Those
//! elements are compensated, but what lies behind them is not the part: it has been cut away, or is about to be.

use super::contour::{Element, ElementShape, Stretch, corner_between};
use super::curve::{Curve, distance};
use super::interval::{Interval, Spot, middle, minus, spot, times};
use super::piece::Turn;

/// Most elements that a lead has at either end.
const LONGEST: usize = 2;

/// The stretch without its leads, closed, if an element near its end meets one near its start within a distance.
pub(crate) fn without_leads(stretch: &Stretch, near: f64) -> Option<Stretch> {
    let count = stretch.elements.len();
    if stretch.closed || count < 3 {
        return None;
    }
    // The longest contour that closes: as few elements cut away as possible.
    for cut in 0..=2 * LONGEST {
        for head in cut.saturating_sub(LONGEST)..=cut.min(LONGEST) {
            let tail = cut - head;
            if head + tail + 3 > count {
                continue;
            }
            let (first, last) = (&stretch.elements[head], &stretch.elements[count - 1 - tail]);
            if let Some((from, to)) = meeting(&first.curve, &last.curve, near) {
                return Some(cut_to(stretch, head..count - tail, from, to));
            }
        }
    }
    None
}

/// Where the last element meets the first one, as fractions of the first and of the last.
fn meeting(first: &Curve, last: &Curve, near: f64) -> Option<(f64, f64)> {
    let (off, to) = last.nearest(first.at(0.0));
    if off <= near {
        return Some((0.0, to));
    }
    let (off, from) = first.nearest(last.at(1.0));
    if off <= near {
        return Some((from, 1.0));
    }
    let mut found = Vec::new();
    match *first {
        Curve::Line { start, end } => {
            let length = distance(start, end);
            last.meets_line(start, [(end[0] - start[0]) / length, (end[1] - start[1]) / length], &mut found);
        }
        Curve::Arc { centre, radius, .. } => last.meets_circle(centre, radius, &mut found),
    }
    let places = found.into_iter().map(|to| (first.nearest(last.at(to)), to));
    places.filter(|((off, _), _)| *off <= near.max(1e-9 * last.length())).map(|((_, from), to)| (from, to)).next()
}

fn cut_to(stretch: &Stretch, kept: std::ops::Range<usize>, from: f64, to: f64) -> Stretch {
    let mut elements = stretch.elements[kept].to_vec();
    let meet = elements[0].curve.at(from);
    // A cut at an end of an element leaves the element, and its exact numbers, as they are.
    if let Some(first) = elements.first_mut()
        && from > 0.0
    {
        *first = part(first, meet, false);
    }
    if let Some(last) = elements.last_mut()
        && to < 1.0
    {
        *last = part(last, meet, true);
    }
    // Nothing is left of an element that only touches the meeting point.
    elements.retain(|element| element.curve.length() > 1e-9 * (1.0 + meet[0].abs() + meet[1].abs()));
    let mut closed = Stretch { elements, closed: true, ..stretch.clone() };
    if let (Some(first), Some(last)) = (closed.elements.first().copied(), closed.elements.last_mut()) {
        last.corner = corner_between(&last.tangents[1], &first.tangents[0], stretch.side);
    }
    closed
}

/// The part of an element from a point on it to its end, or, `up_to`, from its start to the point.
fn part(element: &Element, at: [f64; 2], up_to: bool) -> Element {
    // The point is known to a few units in the last place of the coordinates.
    let width = 8.0 * f64::EPSILON * (1.0 + at[0].abs() + at[1].abs());
    let cut: Spot = at.map(|value| Interval::between(value - width, value + width));
    let [start, end] = element.ends();
    let ends = if up_to { [start, cut] } else { [cut, end] };
    let middles = ends.map(|end| middle(&end));
    match element.shape {
        ElementShape::Line(_) => Element {
            shape: ElementShape::Line(ends),
            curve: Curve::Line { start: middles[0], end: middles[1] },
            ..*element
        },
        ElementShape::Arc(turn) => {
            let turn = Turn { start: ends[0], end: ends[1], full: false, ..turn };
            let centre = middle(&turn.centre);
            let arm = minus(&spot(at), &turn.centre);
            let left = [-arm[1], arm[0]];
            let tangent = if turn.ccw { left } else { times(&left, Interval::of(-1.0)) };
            let tangents = if up_to { [element.tangents[0], tangent] } else { [tangent, element.tangents[1]] };
            Element {
                shape: ElementShape::Arc(turn),
                curve: Curve::arc(centre, middles[0], middles[1], turn.ccw, false),
                tangents,
                ..*element
            }
        }
    }
}
