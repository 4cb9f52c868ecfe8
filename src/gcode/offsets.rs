//! Offset numbers: D words, and the T words of lathes ([TRC-MODE-03]).

use radcomp_spec::parameters::Plane;
use radcomp_spec::profile::Profile;

use super::arrange::Command;
use super::diagnostic::{Kind, LineFault};
use super::word::Word;

/// Whether T words select offsets: they do where the spindle turns the workpiece, which works in the plane (Z, X).
pub(super) fn t_selects_offset(profile: &Profile) -> bool {
    profile.machine.plane == Plane::Zx
}

/// The offset number that a block selects, with its word.
pub(super) fn selected<'c, 'a>(
    command: &'c Command<'a>,
    profile: &Profile,
) -> Result<Option<(u32, &'c Word<'a>)>, LineFault> {
    let tool = command.word('T').map(|word| Ok((word.whole_or_fault("a tool number")?, word))).transpose()?;
    let offset = command.word('D').map(|word| Ok((word.whole_or_fault("an offset number")?, word))).transpose()?;
    let tool = tool.filter(|_| t_selects_offset(profile));
    match (tool, offset) {
        (Some(_), Some((_, word))) => {
            let message = "the T word of this block selects an offset already";
            Err(LineFault::new(Kind::MisplacedWord, word.span.clone(), message))
        }
        (Some((number, word)), None) if matches!(word.number.len(), 2 | 4) => Ok(Some((number % 100, word))),
        (Some((_, word)), None) => {
            let message = "a T word of a lathe has 4 digits, or 2: the last two are the offset number";
            Err(LineFault::new(Kind::WrongNumber, word.span.clone(), message).helping("tool 1 with offset 1 is T0101"))
        }
        (None, offset) => Ok(offset),
    }
}
