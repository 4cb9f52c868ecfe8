//! The look-ahead under every answer of geometry, consistent or not: it neither loses, duplicates nor reorders a block,
//! holds no more than its capacity, hands each block on within that bound, and asks of geometry what fits how each
//! element was begun. [TRC-LOOK-02], [TRC-MODE-06]
//!
//! Geometry, with its square roots and quotients, is replaced by arbitrary answers: whether the tool fits, whether an
//! entry move can be made, whether a junction is formed, whether the pending element may be emitted. What it is asked to
//! emit is watched.

mod watch;

use radcomp_impl::geometry::{Begin, Event, Kind};
use radcomp_impl::window::Window;
use radcomp_spec::parameters::*;
use radcomp_spec::{Alarm, AlarmKind, Compensation, Parameters, Side};

use crate::{Choice, reached};
use watch::{Answers, Watch};

/// The look-ahead with what is watched of it.
#[derive(Clone, Debug)]
pub struct LookAhead {
    window: Window,
    watch: Watch,
    /// The most blocks that it may hold.
    capacity: usize,
    /// Blocks that give vectors are among the events.
    vectors: bool,
    zero_length_move: ZeroLengthMove,
    side_change: SideChange,
}

impl LookAhead {
    /// The look-ahead at the start of a program.
    #[must_use]
    pub fn new(parameters: &Parameters) -> LookAhead {
        let capacity = parameters.non_moving_allowed.map_or(usize::MAX, |allowed| 1 + usize::from(allowed));
        // Without them what they mean does not matter.
        let vectors = parameters.side_code_vector == SideCodeVector::RightAngles;
        let Parameters { zero_length_move, side_change, .. } = *parameters;
        let (window, watch) = (Window::new(parameters), Watch::new(parameters));
        LookAhead { window, watch, capacity, vectors, zero_length_move, side_change }
    }

    /// The same with another claim of its capacity: what a false twin holds it to.
    #[must_use]
    pub fn claiming(self, capacity: usize) -> LookAhead {
        LookAhead { capacity, ..self }
    }

    /// Reads one event, whatever geometry answers.
    ///
    /// # Errors
    /// The alarm that ends the program.
    ///
    /// # Panics
    /// When the look-ahead breaks a promise.
    pub fn read(&mut self, event: Event, choice: &mut impl Choice) -> Result<(), Alarm> {
        let LookAhead { window, watch, capacity, zero_length_move, side_change, .. } = self;
        let (block, asked) = (watch.read, watch.asked);
        watch.begin_block(event);
        let result = window.read(block, event, &mut Answers { watch, choice });
        match result {
            Err(alarm) => {
                reached!(choice, "an alarm");
                watch.stopped(alarm);
            }
            Ok(()) => {
                watch.end_block();
                assert!(window.held() <= *capacity, "more held than the capacity");
                assert!(watch.next + window.held() == watch.read, "every block is handed on or held");
                let waits = watch.pending.is_some() || watch.corner.is_some();
                assert!(waits == (window.held() > 0), "an element or a corner arc is pending when blocks are held");
                assert!(!event.vector_code || watch.asked.is_some(), "a vector block outside offset mode is an alarm");
                let moves_at_once = event.vector_code && event.kind != Kind::Still && event.kind != Kind::CornerToNext;
                assert!(!moves_at_once || window.held() == 0, "behind a vector block the junction is settled");
                assert!(event.not_in_mode.is_none(), "a code that is not for offset mode is an alarm");
                let shift = |block| watch.pending.is_some_and(|held| (held.block, held.begin) == (block, Begin::Shift));
                let zero_length = |what| event.zero_length && *zero_length_move == what;
                let breaks = event.stops || zero_length(ZeroLengthMove::BreaksLookAhead) && !shift(block);
                assert!(!breaks || window.held() == 0, "a block that breaks the look-ahead leaves nothing held");
                let changes = asked.is_some() && watch.asked.is_some() && watch.asked != asked;
                let forbidden = *side_change == SideChange::Forbidden && changes;
                assert!(!forbidden, "the code of the other side is an alarm where it is forbidden");
            }
        }
        result
    }

    /// Ends the program.
    ///
    /// # Panics
    /// When a promise is broken.
    pub fn finish(mut self, choice: &mut impl Choice) {
        let LookAhead { window, watch, .. } = &mut self;
        match window.finish(&mut Answers { watch, choice }) {
            Err(alarm) => watch.stopped(alarm),
            Ok(()) => {
                reached!(choice, "an end without alarm");
                assert!((watch.next, window.held()) == (watch.read, 0), "all is handed on at the end");
            }
        }
    }

    /// Refuses a block for its own form.
    ///
    /// # Panics
    /// When a promise is broken.
    pub fn fault(mut self, choice: &mut impl Choice) {
        let LookAhead { window, watch, .. } = &mut self;
        let code = choice.of(&[None, Some(Compensation::Off), Some(Compensation::On(Side::Left))]);
        let event = Event { code, other_radius: choice.flag(), ..Event::of(Kind::Arc) };
        let kind = choice.of(&[AlarmKind::OutOfRange, AlarmKind::NoSuchArc]);
        watch.begin_block(event);
        let alarm = window.refuse(watch.read, event, kind, &mut Answers { watch, choice });
        watch.stopped(alarm.expect_err("a refusal is an alarm"));
    }

    /// The state but for how many blocks came before: two states with the same key behave alike from here on.
    #[must_use]
    pub fn key(&self) -> String {
        let Watch { next, read, pending, corner, asked, .. } = self.watch;
        let owed = (next..read).map(|block| self.watch.rapid(block));
        let owed: String = owed.map(|rapid| if rapid { 'r' } else { 'f' }).collect();
        // The one number of a block in the window's state is that of the pending element, the first block owed.
        assert!(
            pending.map(|pending| pending.block).or(corner.map(|corner| corner.0)).is_none_or(|block| block == next)
        );
        let corner = corner.map(|(_, side)| side);
        format!("{:?} {pending:?} {corner:?} {asked:?} {owed}", self.window)
            .replace(&format!("block: {next},"), "block: first,")
    }
}

/// Any event that a block may tell this look-ahead; where `rates` is not set, all are at feed rate.
pub fn event(look_ahead: &LookAhead, choice: &mut impl Choice, rates: bool) -> Event {
    let (left, right) = (Compensation::On(Side::Left), Compensation::On(Side::Right));
    let event = Event {
        code: choice.of(&[None, Some(Compensation::Off), Some(left), Some(right)]),
        other_radius: choice.flag(),
        rapid: rates && choice.flag(),
        swapped: choice.flag(),
        stops: choice.flag(),
        ..Event::of(Kind::Still)
    };
    // Another radius is an alarm or nothing, whatever the vectors of its block.
    let vectors = look_ahead.vectors && !event.other_radius;
    let kinds = if vectors { KINDS.len() } else { 4 };
    let event = Event { code: event.code, ..merged(event, choice.of(&KINDS[..kinds])) };
    let vectors = vectors && !event.vector_code;
    let vector = vectors && event.code.is_some() && matches!(event.kind, Kind::Still | Kind::Line) && choice.flag();
    if event.kind != Kind::Still {
        return Event { vector, ..event };
    }
    if vector {
        return Event { vector, zero_length: choice.flag(), ..event };
    }
    // A move of length zero does not move, and a block with a code that is not for offset mode is not looked at further.
    let not_in_mode = choice.of(&[None, Some(AlarmKind::ToolChangeInMode)]);
    let vector_code = vectors && not_in_mode.is_none() && choice.flag();
    Event { zero_length: not_in_mode.is_none() && choice.flag(), not_in_mode, vector_code, ..event }
}

/// The kinds of movement, vector blocks behind the others.
const KINDS: [Kind; 8] = [
    Kind::Still,
    Kind::Dummy,
    Kind::Line,
    Kind::Arc,
    Kind::HeldVector,
    Kind::NewVector,
    Kind::CornerArc,
    Kind::CornerToNext,
];

/// The marks of an event on a block of this kind.
fn merged(event: Event, kind: Kind) -> Event {
    Event { kind, vector_code: Event::of(kind).vector_code, ..event }
}

/// Any parameters that the look-ahead reads, with at most `allowed` blocks without movement, or any number; the others
/// are fixed. Values that the look-ahead does not tell apart stand for each other; where changes of side are forbidden,
/// what they do after start-up does not matter, and moves of length zero and alarms have their other rules.
pub fn parameters(choice: &mut impl Choice, allowed: u8) -> Parameters {
    let (ended, lost) = (PendingAtAlarm::Ended, PendingAtAlarm::Lost);
    let (side_change, side_change_after_start_up, zero_length_move, pending_at_alarm) = choice.of(&[
        (SideChange::TwoNormals, SideChangeAfterStartUp::Allowed, ZeroLengthMove::BreaksLookAhead, ended),
        (SideChange::TwoNormals, SideChangeAfterStartUp::Alarm, ZeroLengthMove::BreaksLookAhead, ended),
        (SideChange::Forbidden, SideChangeAfterStartUp::Alarm, ZeroLengthMove::StartsAndCancels, lost),
    ]);
    let (side_code_vector, cancel_vector, offset_change) = choice.of(&[
        (SideCodeVector::Refused, CancelVector::Refused, OffsetChange::Alarm),
        (SideCodeVector::RightAngles, CancelVector::ImaginaryLine, OffsetChange::EndOfBlock),
    ]);
    // With vectors among the events the ways of start-up and cancel that they do not touch come in one mixture.
    if side_code_vector == SideCodeVector::RightAngles {
        return Parameters {
            start_up: choice.of(&[StartUp::TypeA, StartUp::EntryNormal]),
            start_up_lost: StartUpLost::NoVector,
            start_up_without_movement: StartUpWithoutMovement::Shift,
            start_up_arc: StartUpArc::MovedCentre,
            cancel: choice.of(&[Cancel::TypeA, Cancel::TypeB]),
            cancel_without_movement: CancelWithoutMovement::Shift,
            same_code: choice.of(&[SameCode::Ordinary, SameCode::Normal]),
            side_change,
            side_change_after_start_up,
            zero_length_move,
            pending_at_alarm,
            side_code_vector,
            cancel_vector,
            offset_change,
            non_moving_allowed: Some(choice.below(allowed + 2)).filter(|count| *count <= allowed),
            ..crate::engine::plain()
        };
    }
    Parameters {
        start_up: choice.of(&[StartUp::TypeA, StartUp::EntryNormal]),
        start_up_lost: choice.of(&[StartUpLost::Normal, StartUpLost::NoVector]),
        start_up_without_movement: choice.of(&[StartUpWithoutMovement::None, StartUpWithoutMovement::Shift]),
        start_up_arc: choice.of(&[StartUpArc::Alarm, StartUpArc::MovedCentre]),
        cancel: choice.of(&[Cancel::TypeA, Cancel::TypeB]),
        cancel_without_movement: choice.of(&[CancelWithoutMovement::None, CancelWithoutMovement::Shift]),
        same_code: choice.of(&[SameCode::Ordinary, SameCode::Normal, SameCode::Alarm]),
        side_change,
        side_change_after_start_up,
        zero_length_move,
        pending_at_alarm,
        side_code_vector,
        cancel_vector,
        offset_change,
        non_moving_allowed: Some(choice.below(allowed + 2)).filter(|count| *count <= allowed),
        ..crate::engine::plain()
    }
}

/// Harness: any program of at most `events` blocks, under any of the parameters and any answers of geometry.
pub fn programs(choice: &mut impl Choice, events: u8, allowed: u8) {
    let parameters = parameters(choice, allowed);
    // The rates of a run without bound are kept up to its 16th change only.
    let rates = parameters.non_moving_allowed.is_some() || events <= 16;
    programs_under(choice, &parameters, events, rates);
}

/// The same under these parameters; where `rates` is not set, all blocks are at feed rate.
pub fn programs_under(choice: &mut impl Choice, parameters: &Parameters, events: u8, rates: bool) {
    let mut look_ahead = LookAhead::new(parameters);
    for _ in 0..events {
        if choice.flag() {
            break;
        }
        if look_ahead.read(event(&look_ahead, choice, rates), choice).is_err() {
            return;
        }
    }
    if choice.flag() { look_ahead.finish(choice) } else { look_ahead.fault(choice) }
}

/// The places that [`programs`] must reach.
pub const PLACES: [&str; 23] = [
    "a block held and handed on later",
    "a cancel of type B",
    "a cancel with an imaginary line",
    "a cancel without movement",
    "a change of side",
    "a corner arc to a vector",
    "a corner arc to the next element",
    "a corner arc without a next element",
    "a corner",
    "a held vector",
    "a move of length zero that cancels",
    "a new vector",
    "a start-up without movement that is none",
    "a start-up without movement",
    "a start-up without vector",
    "a start-up",
    "a vector of a move",
    "an alarm at the pending block",
    "an alarm",
    "an end without alarm",
    "an entry move",
    "corner moves of a block that is lost",
    "corner moves that the block read owns",
];
