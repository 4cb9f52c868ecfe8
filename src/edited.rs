//! Programs that a fuzzer moves: bytes name a generated program, or one on or beside a decision's boundary, and edits of it,
//! so that a mutated byte is a small change of one number, down to 10⁻⁹ mm, or of one block.

use std::sync::LazyLock;

use radcomp_spec::profile::{BUILTIN, Profile};
use radcomp_spec::{Block, Centre, Compensation, DecisionKind, Movement, Side};
use rug::Rational;

use crate::boundary;
use crate::generate::{Reach, program};

/// A program drawn from bytes.
#[derive(Clone, Debug)]
pub struct Edited {
    /// The profile that it is for.
    pub profile: Profile,
    /// Its blocks.
    pub blocks: Vec<Block<Rational>>,
}

/// Bytes that name the program before its edits: profile, seed, number; or, from [`ON_BOUNDARY`] on, profile and which of
/// a triple, decision, seed, number.
const HEAD: usize = 4;
/// First bytes that differ by this name one profile, so that bytes keep their meaning when a profile is added.
const PROFILES: u8 = 32;
/// The least first byte of a program on a boundary, followed by those below and those above it.
const ON_BOUNDARY: u8 = 160;
/// Bytes of an edit: what, which block, and by how much: a power of ten, and how often.
const EDIT: usize = 5;
/// The most edits that are made; more bytes are passed over.
const MOST_EDITS: usize = 24;
/// The most blocks that edits may lead to.
const MOST_BLOCKS: usize = 40;

impl Edited {
    /// The program that the bytes stand for; none when they are too few to name one.
    #[must_use]
    pub fn from_bytes(bytes: &[u8]) -> Option<Edited> {
        let (head, edits) = bytes.split_at_checked(HEAD)?;
        let profile = profile(usize::from(head[0] % PROFILES))?;
        let mut blocks = if head[0] < ON_BOUNDARY {
            let seed = u64::from(u16::from_le_bytes([head[1], head[2]]));
            program(seed, u64::from(head[3]), Reach::of(&profile))
        } else {
            let kind = DecisionKind::ALL[usize::from(head[1]) % DecisionKind::ALL.len()];
            let (seed, number) = (u64::from(head[2]), u64::from(head[3]));
            match boundary::triples(kind, seed, number, Reach::of(&profile)) {
                Some(triple) => {
                    let [below, on, above] = triple.programs;
                    match (head[0] - ON_BOUNDARY) / PROFILES {
                        0 => on,
                        1 => below,
                        _ => above,
                    }
                }
                // The profile never comes to that decision.
                None => program(seed, number, Reach::of(&profile)),
            }
        };
        for edit in edits.chunks_exact(EDIT).take(MOST_EDITS) {
            let times = i16::from_le_bytes([edit[3], edit[4]]);
            let amount = Rational::from((i64::from(times), 10_i64.pow(3 + u32::from(edit[2] % 7))));
            change(&mut blocks, edit[0], usize::from(edit[1]), &amount, Reach::of(&profile));
        }
        Some(Edited { profile, blocks })
    }
}

/// Limits and rules that no built-in profile has, for the numbers after theirs.
const CHANGED: [(&str, &[(&str, &str)]); 7] = [
    ("fanuc-30i-b", &[("small-vector-limit", "\"0.5\"")]),
    ("fanuc-30i-b", &[("smallest-corner-cosine", "\"0.6\""), ("start-up-b", "\"direct\"")]),
    ("siemens-840d-g451", &[("corner-limit-cosine", "\"0.6\""), ("reversal", "\"alarm\"")]),
    ("okuma-osp", &[("side-change", "\"intersection\""), ("corner-owner", "\"previous\"")]),
    ("linuxcnc", &[("straight-band-cosine", "\"0.96\""), ("arc-on-rapid", "\"line\"")]),
    ("seed-mill", &[("small-vector-limit", "\"5\""), ("equal-radius", "\"degenerate-point\"")]),
    (
        "seed-mill",
        &[
            ("vector-codes", "\"g38-g39\""),
            ("side-code-vector", "\"imaginary-line\""),
            ("cancel-vector", "\"imaginary-line\""),
            ("offset-change", "\"end-of-block\""),
        ],
    ),
];

/// A profile by its number: the built-in ones, and those that are changed.
fn profile(number: usize) -> Option<Profile> {
    static ALL: LazyLock<Vec<Option<Profile>>> = LazyLock::new(|| {
        let built_in = BUILTIN.iter().map(|(name, _)| Profile::builtin(name));
        let changed =
            CHANGED.iter().map(|(base, changes)| Profile::changed(base, "changed", changes.iter().copied()).ok());
        built_in.chain(changed).collect()
    });
    ALL[number % ALL.len()].clone()
}

/// Makes one edit, if the block has what it changes.
fn change(blocks: &mut Vec<Block<Rational>>, what: u8, which: usize, amount: &Rational, reach: Reach) {
    if blocks.is_empty() {
        return;
    }
    let which = which % blocks.len();
    // The bits above those that tell what is changed tell how.
    let how = what >> 4;
    match what % 8 {
        0..=2 => move_end(&mut blocks[which], usize::from(how & 1), amount),
        3 => move_centre(&mut blocks[which], usize::from(how & 1), amount),
        4 => move_radius(blocks, amount),
        5 => {
            blocks.remove(which);
        }
        6 if blocks.len() < MOST_BLOCKS => {
            let copy = blocks[which].clone();
            blocks.insert(which, if how & 1 == 0 { Block::empty() } else { copy });
        }
        _ if !reach.corners().is_empty() && how & 1 == 1 => {
            let corners = reach.corners();
            blocks[which].corner = Some(corners[usize::from(how >> 1 & 1) % corners.len()]);
        }
        _ => {
            // I, J, K stand beside the code that gives them a meaning; another code may give them none.
            blocks[which].compensation = next_code(blocks[which].compensation);
            blocks[which].vector = None;
        }
    }
}

fn next_code(code: Option<Compensation>) -> Option<Compensation> {
    match code {
        None => Some(Compensation::On(Side::Left)),
        Some(Compensation::On(Side::Left)) => Some(Compensation::On(Side::Right)),
        Some(Compensation::On(Side::Right)) => Some(Compensation::Off),
        Some(Compensation::Off) => None,
    }
}

fn move_end(block: &mut Block<Rational>, axis: usize, by: &Rational) {
    match &mut block.movement {
        Movement::Line { end }
        | Movement::Arc { end, .. }
        | Movement::HeldVector { end }
        | Movement::Dummy { vector: end }
        | Movement::NewVector { vector: end }
        | Movement::CornerArc { vector: Some(end) } => end[axis] += by,
        Movement::None | Movement::CornerArc { vector: None } => {}
    }
}

fn move_centre(block: &mut Block<Rational>, axis: usize, by: &Rational) {
    if let Movement::Arc { centre, .. } = &mut block.movement {
        match centre {
            Centre::FromStart(vector) => vector[axis] += by,
            Centre::Radius(radius) => *radius += by,
        }
    }
}

/// Moves the first tool radius of the program.
fn move_radius(blocks: &mut [Block<Rational>], by: &Rational) {
    if let Some(radius) = blocks.iter_mut().find_map(|block| block.radius.as_mut()) {
        *radius += by;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_is_a_profile() {
        assert!((0..usize::from(PROFILES)).all(|number| profile(number).is_some()));
    }
}
