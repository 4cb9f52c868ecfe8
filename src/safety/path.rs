//! The path of the tool's centre, in pieces, beside the stretch that it runs along.

use radcomp_spec::{Direction, Segment, Step};

use super::LARGEST;
use super::contour::Stretch;
use super::curve::Curve;
use super::interval::{Spot, spot};
use super::piece::{Piece, Turn};
use super::side::is_about;

/// A piece of one path element.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Move {
    /// The piece.
    pub(crate) piece: Piece,
    /// Index of the block.
    pub(crate) block: usize,
}

/// The moves beside one stretch.
#[derive(Clone, Debug, Default)]
pub(crate) struct Beside {
    /// In offset mode.
    pub(crate) offset: Vec<Move>,
    /// The same as whole elements in plain f64.
    pub(crate) curves: Vec<(usize, Curve)>,
    /// Of the start-up block.
    pub(crate) start_up: Vec<Move>,
    /// Of the cancel block, and of blocks between G40 and it.
    pub(crate) cancel: Vec<Move>,
    /// How many moves lead over a change of side.
    pub(crate) crossings: usize,
}

/// Gives every path element to the stretch that its block belongs to; elements in cancel mode belong to none.
///
/// # Errors
///
/// The block of the first element with a number that is not finite or beyond [`LARGEST`].
pub(crate) fn beside(stretches: &[Stretch], path: &[Step<f64>], budget: f64) -> Result<Vec<Beside>, usize> {
    let mut all = vec![Beside::default(); stretches.len()];
    let mut at = [0.0, 0.0];
    for step in path {
        let from = at;
        let (numbers, whole) = match step.segment {
            Segment::Hold => continue,
            Segment::Line { end } => {
                at = end;
                ([end, end], (end != from).then_some(Curve::Line { start: from, end }))
            }
            Segment::Arc { end, centre, direction, full } => {
                at = end;
                let ccw = direction == Direction::Counterclockwise;
                ([end, centre], (full || end != from).then(|| Curve::arc(centre, from, end, ccw, full)))
            }
        };
        if !numbers.iter().flatten().all(|value| value.abs() <= LARGEST) {
            return Err(step.block);
        }
        let Some(curve) = whole else { continue };
        let pieces = match step.segment {
            Segment::Arc { end, centre, direction, full } => Piece::of_turn(&Turn {
                start: spot(from),
                end: spot(end),
                centre: spot(centre),
                ccw: direction == Direction::Counterclockwise,
                full,
            }),
            _ => vec![Piece::line(spot(from), spot(at))],
        };
        let moves = pieces.into_iter().map(|piece| Move { piece, block: step.block });
        // The stretches are in the order of their blocks; start-up and cancel blocks of neighbours may be one block.
        let next = stretches.partition_point(|stretch| first_block(stretch) <= step.block);
        for place in next.saturating_sub(2)..next {
            let (stretch, beside) = (&stretches[place], &mut all[place]);
            if stretch.start_up == Some(step.block) {
                beside.start_up.extend(moves.clone());
            } else if stretch.cancel.as_ref().is_some_and(|blocks| blocks.contains(&step.block)) {
                beside.cancel.extend(moves.clone());
            } else if stretch.blocks.contains(&step.block) {
                if moves.clone().all(|each| crosses(stretch, &each, budget)) {
                    beside.crossings += 1;
                } else {
                    beside.offset.extend(moves.clone());
                    beside.curves.push((step.block, curve));
                }
            }
        }
    }
    Ok(all)
}

fn first_block(stretch: &Stretch) -> usize {
    stretch.start_up.unwrap_or(*stretch.blocks.start())
}

/// Whether a move leads over a change of side at an end of a stretch: it belongs to a block beside that change, and all
/// of it lies within the radius of the point where the side changes.
fn crosses(stretch: &Stretch, each: &Move, budget: f64) -> bool {
    let (Some(first), Some(last)) = (stretch.elements.first(), stretch.elements.last()) else { return false };
    let reach = stretch.radius.high + budget + 1e-12 * (1.0 + stretch.radius.high);
    let about = |point: Spot| is_about(&each.piece, &point, reach);
    (stretch.enters && each.block <= first.block && about(first.ends()[0]))
        || (stretch.leaves && each.block >= last.block && about(last.ends()[1]))
}
