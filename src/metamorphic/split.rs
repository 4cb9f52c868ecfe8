//! Splitting a straight block.

use radcomp_model::Run;
use radcomp_spec::parameters::Interference;
use radcomp_spec::{Block, Clause, Compensation, Movement, Parameters, clause};
use rug::Rational;

/// Whether a rule that looks at whole blocks made a point of the path.
pub fn is_by_whole_blocks(run: &Run) -> bool {
    const WHOLE_BLOCKS: [Clause; 6] = [
        clause::TRC_SIDE_02,
        clause::TRC_SIDE_03,
        clause::TRC_SIDE_05,
        clause::TRC_SIDE_06,
        clause::TRC_INT_03,
        clause::TRC_INT_05,
    ];
    run.steps.iter().any(|step| WHOLE_BLOCKS.contains(&step.clause))
}

/// The program with one compensated line split in the middle, if that may not change its path: not in a program whose
/// sides change or whose tool runs backwards somewhere, since those rules look at whole blocks, nor where vectors interfere.
pub fn split(parameters: &Parameters, blocks: &[Block<Rational>], exact: &Run) -> Option<Vec<Block<Rational>>> {
    // Start-up, cancel and settled junctions look at the block next to them.
    let mut plain = vec![clause::TRC_CORNER_03, clause::TRC_CORNER_04, clause::TRC_CORNER_06];
    // A line that starts at a vector before the last one, which was dropped, is not its own offset.
    if parameters.small_vector_limit.numerator == 0 {
        plain.push(clause::TRC_CORNER_08);
    }
    // How many blocks are read together counts ([TRC-INT-04]).
    let over_several = matches!(parameters.interference, Interference::Alarm | Interference::Avoid);
    if is_by_whole_blocks(exact) || over_several || super::runs_backwards(exact) {
        return None;
    }
    let index = exact.steps.iter().enumerate().skip(1).find_map(|(index, step)| {
        let before = exact.steps.get(index - 1)?;
        let here = step.main && plain.contains(&step.clause) && plain.contains(&before.clause);
        let line = matches!(blocks.get(step.block)?.movement, Movement::Line { .. });
        let plainly = blocks[step.block].vector.is_none() && blocks[step.block].radius.is_none();
        (here && line && plainly && blocks[step.block].compensation != Some(Compensation::Off)).then_some(step.block)
    })?;
    let start = start_of(blocks, index)?;
    let Movement::Line { end } = &blocks[index].movement else { return None };
    let middle = [0, 1].map(|axis| Rational::from(&start[axis] + &end[axis]) / 2_u32);
    let mut program = blocks.to_vec();
    let first = Block { movement: Movement::Line { end: middle }, stops_look_ahead: false, ..blocks[index].clone() };
    let rest = Block { compensation: None, radius: None, corner: None, approach: None, ..blocks[index].clone() };
    program.splice(index..=index, [first, rest]);
    Some(program)
}

/// Where the program stands before a block.
fn start_of(blocks: &[Block<Rational>], index: usize) -> Option<[Rational; 2]> {
    blocks[..index].iter().rev().find_map(|block| match &block.movement {
        Movement::Line { end } | Movement::Arc { end, .. } | Movement::HeldVector { end } => Some(end.clone()),
        Movement::None | Movement::Dummy { .. } | Movement::NewVector { .. } | Movement::CornerArc { .. } => None,
    })
}
