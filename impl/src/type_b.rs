//! Start-up and cancel of type B: over the corner, where it is an outer one. [TRC-START-06], [TRC-CANCEL-05]

use core::cmp::Ordering;

use radcomp_spec::{AlarmKind, clause};

use crate::corner;
use crate::element::Element;
use crate::junction::{Junction, Turn};
use crate::rules::Rules;

/// Forms the junction behind a start-up block.
///
/// # Errors
/// As [`corner::outer`].
#[inline(never)]
pub(crate) fn start_up(
    first: &Element,
    second: &Element,
    radius: f64,
    rules: &Rules,
    junction: &mut Junction,
) -> Result<(), AlarmKind> {
    // The corner is that of the side in force in the element after it.
    let first = &Element { side: second.side, ..*first };
    let turn = Turn::between(first, second);
    if !goes_around(turn, first.side, rules) {
        junction.set(clause::TRC_START_02, second.start_vector(radius));
        return Ok(());
    }
    corner::outer(first, second, radius, turn, rules, junction)?;
    junction.clause = clause::TRC_START_06;
    let normal = first.end_vector(radius);
    if rules.via_normal && junction.first != normal {
        junction.put_first(normal);
    }
    Ok(())
}

/// Forms the junction before a cancel block, which is taken as a line on the side of the element before it.
///
/// # Errors
/// As [`corner::outer`].
#[inline(never)]
pub(crate) fn cancel(
    first: &Element,
    second: &Element,
    radius: f64,
    rules: &Rules,
    junction: &mut Junction,
) -> Result<(), AlarmKind> {
    let turn = Turn::between(first, second);
    if !goes_around(turn, first.side, rules) {
        junction.set(clause::TRC_CANCEL_01, first.end_vector(radius));
        return Ok(());
    }
    corner::outer(first, second, radius, turn, rules, junction)?;
    junction.clause = clause::TRC_CANCEL_05;
    let normal = second.start_vector(radius);
    if rules.via_normal && junction.last().unwrap_or(junction.first) != normal {
        junction.push(normal);
    }
    Ok(())
}

/// The corner is an outer one, and not below the smallest. [TRC-CORNER-15]
fn goes_around(turn: Turn, side: f64, rules: &Rules) -> bool {
    let outer = match turn.toward_tool(side) {
        Ordering::Greater => false,
        Ordering::Equal => turn.dot < 0.0,
        Ordering::Less => true,
    };
    outer && (rules.smallest == 0.0 || turn.against(rules.smallest) != Ordering::Less)
}
