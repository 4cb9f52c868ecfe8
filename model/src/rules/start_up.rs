//! Start-up: `spec/clauses/03-start-up.md`.

use core::cmp::Ordering;

use radcomp_spec::clause;
use radcomp_spec::parameters::{StartUp, StartUpB};
use radcomp_spec::{AlarmKind, DecisionKind, Side};

use super::junction::{Junction, Refused, Setting};
use super::{corner, vector};
use crate::decision::Judgement;
use crate::element::{Arm, Element, EntryArc, Shape};
use crate::geometry::Vector;
use crate::number::Real;

/// The junction after a start-up block of type A or B, or of one with the direction of an imaginary line.
pub(crate) fn junction(
    (before, imaginary): (&Element, Option<&Vector>),
    next: &Element,
    side: Side,
    setting: Setting<'_>,
    judgement: &mut Judgement<'_>,
) -> Result<Junction, Refused> {
    let after = next.first_arm();
    if let Some(line) = imaginary.and_then(|along| Arm::imaginary(&before.end, along)) {
        // [TRC-START-11]
        if let Some(vector) = vector::meet(&line, &after, side, setting.radius, judgement)? {
            return Ok(Junction::single(clause::TRC_START_11, vector));
        }
    } else if setting.parameters.start_up == StartUp::TypeB {
        // [TRC-START-06]
        let before = before.last_arm();
        if let Some(outer) = corner::of_type_b(&before, &after, side, setting, judgement)? {
            let via = setting.parameters.start_up_b == StartUpB::ViaNormal;
            let normal = via.then(|| before.normal(side, setting.radius));
            return Ok(outer.junction_of_type_b(clause::TRC_START_06, normal, None));
        }
    }
    // [TRC-START-02] the vector at right angles to the next element at its start.
    Ok(Junction::single(clause::TRC_START_02, after.normal(side, setting.radius)))
}

/// [TRC-START-08] where a start-up block without movement leads: to the normal of the next element at its start.
pub(crate) fn shift(next: &Element, side: Side, radius: &Real) -> Vector {
    next.first_arm().normal(side, radius)
}

/// [TRC-START-07] the distance from the programmed start to the end must be greater than the tool radius; [TRC-START-09]
/// so must that of an arc's end from the tool.
pub(crate) fn long_enough(
    start: &Vector,
    end: &Vector,
    radius: &Real,
    judgement: &mut Judgement<'_>,
) -> Result<(), AlarmKind> {
    let margin = end.minus(start).length() - radius;
    match judgement.decide(DecisionKind::EntryLength, &margin, margin.clone()) {
        Ordering::Greater => Ok(()),
        _ => Err(AlarmKind::EntryTooShort),
    }
}

/// [TRC-START-09] an arc with the tool's own arc of its entry move, or the alarm. Its length and the fit of the tool
/// inside it have been seen to.
pub(crate) fn entry_arc(
    mut element: Element,
    tool: &Vector,
    side: Side,
    radius: &Real,
    judgement: &mut Judgement<'_>,
) -> Result<Element, AlarmKind> {
    let end = element.last_arm().normal(side, radius);
    let Shape::Arc { centre, entry, .. } = &mut element.shape else { return Ok(element) };
    let (to_start, to_centre) = (tool.minus(&end), centre.minus(&end));
    let toward = to_start.dot(&to_centre);
    let distance = to_centre.length();
    // At a distance of zero the product is zero too.
    let margin = toward.checked_div(&distance).unwrap_or_else(Real::zero);
    if judgement.decide(DecisionKind::EntryArc, &toward, margin) != Ordering::Greater {
        return Err(AlarmKind::NoEntryArc);
    }
    // A judge may have taken the other branch at a product of zero: there is no arc then.
    let factor = to_start.length_squared().checked_div(&(&toward * &Real::integer(2))).ok_or(AlarmKind::NoEntryArc)?;
    *entry = Some(Box::new(EntryArc {
        start: tool.clone(),
        centre: end.along(&to_centre, &factor),
        radius: (&distance * &factor).abs(),
        end,
    }));
    Ok(element)
}
