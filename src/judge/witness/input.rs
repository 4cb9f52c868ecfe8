//! The numbers of a program as a list, and programs with some of them moved.

use radcomp_spec::{Block, Centre, Movement};
use rug::Rational;

/// A number of a program: the block's index, and which of its numbers.
pub(super) type Place = (usize, usize);

/// The blocks that a vector at this block's end depends on: the moving ones around it.
pub(super) fn near(blocks: &[Block<Rational>], block: usize) -> Vec<usize> {
    let moving = |index: &usize| numbers(&blocks[*index]) > 0;
    let before = (0..=block.min(blocks.len().saturating_sub(1))).rev().filter(moving).take(3);
    let after = (block + 1..blocks.len()).filter(moving).take(2);
    before.chain(after).collect()
}

/// How many numbers a block moves by, those of the vector beside its compensation code among them.
pub(super) fn numbers(block: &Block<Rational>) -> usize {
    of_movement(&block.movement) + if block.vector.is_some() { 2 } else { 0 }
}

fn of_movement(movement: &Movement<Rational>) -> usize {
    match movement {
        Movement::None | Movement::CornerArc { vector: None } => 0,
        Movement::Line { .. }
        | Movement::HeldVector { .. }
        | Movement::Dummy { .. }
        | Movement::NewVector { .. }
        | Movement::CornerArc { vector: Some(_) } => 2,
        Movement::Arc { centre: Centre::Radius(_), .. } => 3,
        Movement::Arc { centre: Centre::FromStart(_), .. } => 4,
    }
}

/// A number of the program; zero if there is none at this place.
pub(super) fn number_of(blocks: &[Block<Rational>], (index, number): Place) -> Rational {
    let mut copy = blocks[index].clone();
    place(&mut copy, number).cloned().unwrap_or_default()
}

fn place(block: &mut Block<Rational>, number: usize) -> Option<&mut Rational> {
    let beside = of_movement(&block.movement);
    if number >= beside {
        return block.vector.as_mut()?.get_mut(number - beside);
    }
    match (&mut block.movement, number) {
        (Movement::Line { end } | Movement::Arc { end, .. } | Movement::HeldVector { end }, 0 | 1) => {
            end.get_mut(number)
        }
        (
            Movement::Dummy { vector } | Movement::NewVector { vector } | Movement::CornerArc { vector: Some(vector) },
            0 | 1,
        ) => vector.get_mut(number),
        (Movement::Arc { centre: Centre::FromStart(vector), .. }, 2 | 3) => vector.get_mut(number - 2),
        (Movement::Arc { centre: Centre::Radius(radius), .. }, 2) => Some(radius),
        _ => None,
    }
}

/// Which blocks keep ending at one point.
#[derive(Clone, Copy, PartialEq)]
pub(in crate::judge) enum Ties {
    /// All that do: a path that turns back, or closes, still does so.
    All,
    /// Those one after the other: a move of no length and a full circle stay what they are.
    Row,
}

/// The blocks with one number replaced.
pub(super) fn with(
    blocks: &[Block<Rational>],
    (index, number): Place,
    value: &Rational,
    ties: Ties,
) -> Vec<Block<Rational>> {
    let mut moved = blocks.to_vec();
    for other in tied(blocks, (index, number), ties) {
        if let Some(place) = place(&mut moved[other], number) {
            place.clone_from(value);
        }
    }
    moved
}

/// The blocks in which a number is replaced together.
fn tied(blocks: &[Block<Rational>], (index, number): Place, ties: Ties) -> Vec<usize> {
    let Some(joint) = end_of(&blocks[index]).filter(|_| number < 2) else { return vec![index] };
    let among = |others: &mut dyn Iterator<Item = usize>| -> Vec<usize> {
        let ends = others.filter_map(|other| Some((other, end_of(&blocks[other])? == joint)));
        let reached = ends.take_while(|(_, is_there)| *is_there || ties == Ties::All);
        reached.filter(|(_, is_there)| *is_there).map(|(other, _)| other).collect()
    };
    let mut tied = among(&mut (0..index).rev());
    tied.push(index);
    tied.extend(among(&mut (index + 1..blocks.len())));
    tied
}

/// Whether moving the numbers of these blocks together moves others than moving them in rows.
pub(super) fn has_far_ties(blocks: &[Block<Rational>]) -> bool {
    (0..blocks.len()).any(|index| tied(blocks, (index, 0), Ties::All) != tied(blocks, (index, 0), Ties::Row))
}

/// The blocks with one number replaced, and no other.
pub(super) fn with_alone(blocks: &[Block<Rational>], (index, number): Place, value: Rational) -> Vec<Block<Rational>> {
    let mut moved = blocks.to_vec();
    if let Some(place) = place(&mut moved[index], number) {
        *place = value;
    }
    moved
}

fn end_of(block: &Block<Rational>) -> Option<[Rational; 2]> {
    match &block.movement {
        Movement::Line { end } | Movement::Arc { end, .. } | Movement::HeldVector { end } => Some(end.clone()),
        Movement::None | Movement::Dummy { .. } | Movement::NewVector { .. } | Movement::CornerArc { .. } => None,
    }
}

/// The program halfway between two that differ in their numbers alone.
pub(super) fn halfway(from: &[Block<Rational>], to: &[Block<Rational>]) -> Vec<Block<Rational>> {
    let mut middle = to.to_vec();
    for (index, block) in middle.iter_mut().enumerate() {
        for number in 0..numbers(block) {
            let start = number_of(from, (index, number));
            if let Some(value) = place(block, number) {
                *value += start;
                *value /= 2;
            }
        }
    }
    middle
}

/// The largest difference of two programs in one number.
pub(super) fn change(from: &[Block<Rational>], to: &[Block<Rational>]) -> Rational {
    let places =
        from.iter().enumerate().flat_map(|(index, block)| (0..numbers(block)).map(move |number| (index, number)));
    places.map(|place| (number_of(to, place) - number_of(from, place)).abs()).max().unwrap_or_default()
}
