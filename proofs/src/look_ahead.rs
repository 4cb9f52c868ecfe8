//! The look-ahead under every answer of geometry, consistent or not: it neither loses, duplicates nor reorders a block,
//! holds no more than its capacity, and hands each block on within that bound. [TRC-LOOK-02], [TRC-MODE-06]
//!
//! Geometry, with its square roots and quotients, is replaced by arbitrary answers: whether the tool fits, whether a
//! junction is formed, whether the pending element may be emitted. What it is asked to emit is watched.

use radcomp_impl::geometry::{Begin, End, Event, Geometry, Kind, Meeting};
use radcomp_impl::window::Window;
use radcomp_spec::parameters::*;
use radcomp_spec::{Alarm, AlarmKind, Clause, Compensation, Parameters, Side};

use crate::{Choice, reached};

/// What has been emitted, and what is owed.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Watch {
    /// The block whose own steps come next.
    next: usize,
    /// The block read.
    read: usize,
    /// The block of the pending element.
    pending: Option<usize>,
    /// The rapid flag of block n, at bit n modulo 16: no more than ten blocks are ever owed.
    rapid: u16,
}

/// The look-ahead with what is watched of it.
#[derive(Clone, Debug)]
pub struct LookAhead {
    window: Window,
    watch: Watch,
    /// The most blocks that it may hold.
    capacity: usize,
}

/// The geometry: answers as it is told, and watches.
struct Answers<'a, C> {
    watch: &'a mut Watch,
    choice: &'a mut C,
}

impl LookAhead {
    /// The look-ahead at the start of a program.
    #[must_use]
    pub fn new(parameters: &Parameters) -> LookAhead {
        let watch = Watch { next: 0, read: 0, pending: None, rapid: 0 };
        LookAhead { window: Window::new(parameters), watch, capacity: 1 + usize::from(parameters.non_moving_allowed) }
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
        let LookAhead { window, watch, capacity } = self;
        let block = watch.read;
        watch.set_rapid(block, event.rapid);
        let result = window.read(block, event, &mut Answers { watch, choice });
        match result {
            Err(alarm) => {
                reached!(choice, "an alarm");
                watch.stopped(alarm);
            }
            Ok(()) => {
                watch.read += 1;
                assert!(window.held() <= *capacity, "more held than the capacity");
                assert!(watch.next + window.held() == watch.read, "every block is handed on or held");
                assert!(watch.pending.is_some() == (window.held() > 0), "an element is pending when blocks are held");
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

    /// Raises an alarm of the block's own form.
    ///
    /// # Panics
    /// When a promise is broken.
    pub fn fault(mut self, choice: &mut impl Choice) {
        let LookAhead { window, watch, .. } = &mut self;
        let alarm = window.fault(watch.read, AlarmKind::OutOfRange, &mut Answers { watch, choice });
        watch.stopped(alarm.expect_err("a fault is an alarm"));
    }

    /// The state but for how many blocks came before: two states with the same key behave alike from here on.
    #[must_use]
    pub fn key(&self) -> String {
        let Watch { next, read, pending, .. } = self.watch;
        let owed = (next..read).map(|block| self.watch.rapid(block));
        let owed: String = owed.map(|rapid| if rapid { 'r' } else { 'f' }).collect();
        // The one number of a block in the window's state is that of the pending element, the first block owed.
        assert!(pending.is_none_or(|pending| pending == next));
        let window = format!("{:?}", self.window).replace(&format!("block: {next},"), "block: first,");
        format!("{window} {owed}")
    }
}

impl Watch {
    fn emit(&mut self, block: usize) {
        assert!(block == self.next, "blocks are handed on in order, none lost and none twice");
        self.next += 1;
    }

    /// All before the alarm's block has been handed on, and nothing of it or after it.
    fn stopped(&self, alarm: Alarm) {
        assert!(alarm.block <= self.read && self.next == alarm.block, "an alarm stops before its block");
    }

    fn rapid(&self, block: usize) -> bool {
        self.rapid >> (block % 16) & 1 == 1
    }

    fn set_rapid(&mut self, block: usize, rapid: bool) {
        let bit = 1 << (block % 16);
        self.rapid = if rapid { self.rapid | bit } else { self.rapid & !bit };
    }
}

impl<C: Choice> Geometry for Answers<'_, C> {
    type Junction = ();

    fn tool_fits(&mut self, _: Side) -> bool {
        self.choice.flag()
    }

    fn junction(&mut self, _: Meeting, _: Side) -> Result<(), AlarmKind> {
        assert!(self.watch.pending.is_some(), "a junction has an element before it");
        if self.choice.flag() { Ok(()) } else { Err(AlarmKind::NoIntersection) }
    }

    fn settle(&mut self, _: End<()>, _: bool) -> Result<(), AlarmKind> {
        let pending = self.watch.pending.take().expect("an element is pending");
        if self.choice.flag() {
            self.watch.emit(pending);
            Ok(())
        } else {
            reached!(self.choice, "an alarm at the pending block");
            Err(AlarmKind::ReversedLine)
        }
    }

    fn hold(&mut self, block: usize, rapid: bool, _: Clause) {
        assert!(rapid == self.watch.rapid(block), "a block keeps its rate");
        if block < self.watch.read {
            reached!(self.choice, "a block held and handed on later");
        }
        self.watch.emit(block);
    }

    fn dummy(&mut self) {
        reached!(self.choice, "corner moves of a dummy block");
        assert!(self.watch.next == self.watch.read, "a dummy block's corner moves come at its place");
    }

    fn follow(&mut self, _: Clause) {
        self.watch.emit(self.watch.read);
    }

    fn begin(&mut self, _: Begin, _: Side) {
        assert!((self.watch.pending, self.watch.next) == (None, self.watch.read), "one element pends at a time");
        self.watch.pending = Some(self.watch.read);
    }
}

/// Any event.
pub fn event(choice: &mut impl Choice) -> Event {
    let (left, right) = (Compensation::On(Side::Left), Compensation::On(Side::Right));
    Event {
        kind: choice.of(&[Kind::Still, Kind::Dummy, Kind::Line, Kind::Arc]),
        code: choice.of(&[None, Some(Compensation::Off), Some(left), Some(right)]),
        other_radius: choice.flag(),
        rapid: choice.flag(),
    }
}

/// Any parameters that the look-ahead reads, with at most `allowed` blocks without movement; the others are fixed.
pub fn parameters(choice: &mut impl Choice, allowed: u8) -> Parameters {
    Parameters {
        start_up: StartUp::TypeA,
        start_up_lost: choice.of(&[StartUpLost::Normal, StartUpLost::NoVector]),
        cancel: Cancel::TypeA,
        outer_corner: OuterCorner::Intersection,
        reversal: Reversal::Outer,
        side_change: choice.of(&[SideChange::IntersectionWithin, SideChange::TwoNormals, SideChange::Forbidden]),
        side_change_after_start_up: choice.of(&[SideChangeAfterStartUp::Alarm, SideChangeAfterStartUp::Allowed]),
        non_moving_allowed: choice.below(allowed + 1),
        corner_owner: CornerOwner::Next,
        reversed_path: ReversedPath::Advisory,
        arc_end_tolerance: Ratio { numerator: 1, denominator: 100 },
        far_intersection: Ratio { numerator: 5, denominator: 1 },
    }
}

/// Harness: any program of at most `events` blocks, under any of the parameters and any answers of geometry.
pub fn programs(choice: &mut impl Choice, events: u8, allowed: u8) {
    let mut look_ahead = LookAhead::new(&parameters(choice, allowed));
    for _ in 0..events {
        if choice.flag() {
            break;
        }
        if look_ahead.read(event(choice), choice).is_err() {
            return;
        }
    }
    if choice.flag() { look_ahead.finish(choice) } else { look_ahead.fault(choice) }
}

/// The places that [`programs`] must reach.
pub const PLACES: [&str; 5] = [
    "a block held and handed on later",
    "an alarm",
    "an alarm at the pending block",
    "an end without alarm",
    "corner moves of a dummy block",
];
