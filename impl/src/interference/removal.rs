//! Removal of vectors in pairs, from the inner one outward. [TRC-INT-03]

use crate::interference::Point;
use crate::interference::compare::Compared;

/// How many vectors a block's search has removed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Removed {
    /// At its start, the last ones.
    pub before: u8,
    /// At its end, the first ones.
    pub behind: u8,
}

/// Looks at the pairs of a block's vectors; nothing when the outermost pair interferes.
pub(crate) fn search(before: &Point, behind: &Point, compared: &Compared<'_>, inclusive: bool) -> Option<Removed> {
    let count = |point: &Point| point.vectors().count();
    let (m, n) = (count(before), count(behind));
    let mut removed = Removed::default();
    for place in 0..m.max(n) {
        let (left_before, left_behind) = (m.saturating_sub(place).max(1), n.saturating_sub(place).max(1));
        let (Some(v), Some(w)) = (before.vectors().nth(left_before - 1), behind.vectors().nth(n - left_behind)) else {
            break;
        };
        if !compared.interfere(v, w, inclusive) {
            break;
        }
        if left_before == 1 && left_behind == 1 {
            return None;
        }
        removed.before += u8::from(left_before > 1);
        removed.behind += u8::from(left_behind > 1);
    }
    Some(removed)
}
