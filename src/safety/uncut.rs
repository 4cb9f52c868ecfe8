//! Material left uncut: parts of the contour that the tool has room to touch and did not.

use radcomp_spec::Side;

use super::contour::Stretch;
use super::curve::Curve;
use super::index::Index;
use super::verdict::Uncut;

/// Shorter parts are not reported, in millimetres: the ends of a part are roots that f64 knows this well.
const SHORTEST: f64 = 1e-6;

/// The longest uncut part of a stretch, given the path elements beside it.
pub(crate) fn longest(stretch: &Stretch, path: &[(usize, Curve)], budget: f64) -> Option<Uncut> {
    let radius = stretch.radius.middle();
    let reach = radius + budget.max(1e-9 * radius);
    let of_path = Index::new(path.iter().map(|(_, curve)| extent(curve)));
    let of_contour = Index::new(stretch.elements.iter().map(|element| extent(&element.curve)));
    let mut longest: Option<Uncut> = None;
    for (own, element) in stretch.elements.iter().enumerate() {
        let curve = &element.curve;
        let shortest = longest.map_or(SHORTEST.max(budget), |uncut| uncut.length) / curve.length();
        let mut left = vec![[0.0, 1.0]];
        let mut take_out = |moves: &mut dyn Iterator<Item = usize>| {
            for each in moves {
                if is_longer(&left, shortest) {
                    remove(&mut left, &curve.within(&path[each].1, reach));
                }
            }
            is_longer(&left, shortest)
        };
        // The moves of the element's own block and the next ones mostly reach all of it.
        let place = path.partition_point(|(block, _)| *block < element.block);
        if take_out(&mut (place.saturating_sub(1)..(place + 3).min(path.len()))) {
            take_out(&mut of_path.near(extent(curve), reach).into_iter());
        }
        if !is_longer(&left, shortest) {
            continue;
        }
        let to_left = if stretch.side == Side::Left { radius } else { -radius };
        let Some(ideal) = curve.moved_left(to_left) else { continue };
        let room = (radius - budget).max(0.0) * (1.0 - 1e-9);
        for other in of_contour.near(extent(&ideal), room) {
            if other != own {
                remove(&mut left, &ideal.within(&stretch.elements[other].curve, room));
            }
        }
        for [from, to] in left.iter().filter(|[from, to]| to - from > shortest) {
            let length = (to - from) * curve.length();
            if longest.is_none_or(|uncut| uncut.length < length) {
                let middle = curve.at(0.5 * (from + to));
                let nearest = path.iter().map(|(_, curve)| curve.nearest(middle).0).fold(f64::INFINITY, f64::min);
                longest = Some(Uncut {
                    length,
                    from: curve.at(*from),
                    to: curve.at(*to),
                    contour_block: element.block,
                    thickness: nearest - radius,
                });
            }
        }
    }
    longest
}

fn is_longer(parts: &[[f64; 2]], length: f64) -> bool {
    parts.iter().any(|[from, to]| to - from > length)
}

/// Takes intervals out of intervals.
fn remove(parts: &mut Vec<[f64; 2]>, out: &[[f64; 2]]) {
    for [from, to] in out {
        let cut = |part: &[f64; 2]| [[part[0], part[1].min(*from)], [part[0].max(*to), part[1]]];
        *parts = parts.iter().flat_map(cut).filter(|part| part[1] > part[0]).collect();
    }
}

/// A box that holds a curve: an arc's is that of its circle where it may reach it.
fn extent(curve: &Curve) -> [[f64; 2]; 2] {
    let ends = [curve.at(0.0), curve.at(1.0)];
    let mut extent = [[0, 1].map(|k| ends[0][k].min(ends[1][k])), [0, 1].map(|k| ends[0][k].max(ends[1][k]))];
    if let Curve::Arc { centre, radius, sweep, .. } = *curve {
        // No point of the arc is farther from its middle than from an end, or than a diameter.
        let middle = curve.at(0.5);
        let reach = if sweep.abs() >= std::f64::consts::PI {
            2.0 * radius
        } else {
            super::curve::distance(middle, ends[0]).max(super::curve::distance(middle, ends[1]))
        };
        for axis in 0..2 {
            extent[0][axis] = (middle[axis] - reach).max(centre[axis] - radius);
            extent[1][axis] = (middle[axis] + reach).min(centre[axis] + radius);
        }
    }
    extent
}
