//! The look-ahead over all sequences of events: no block lost, doubled or out of order, never more held than allowed.

mod common;

use common::SEED_MILL;
use radcomp_impl::geometry::{Begin, End, Event, Geometry, Kind, Meeting, Part, Toward};
use radcomp_impl::window::Window;
use radcomp_spec::parameters::*;
use radcomp_spec::{Alarm, AlarmKind, Clause, Compensation, Parameters, Side};

/// Stands in for the geometry: answers as it is told, and watches the order of blocks.
#[derive(Clone)]
struct Watch {
    /// The block whose own steps come next.
    next: usize,
    /// The block read.
    read: usize,
    pending: Option<usize>,
    /// Answers that are to be bad: the tool fits, the junction, the settling.
    bad: u8,
}

fn rapid(block: usize) -> bool {
    block % 3 == 1
}

impl Watch {
    fn emit(&mut self, block: usize) {
        assert_eq!(block, self.next, "the order of blocks");
        self.next += 1;
    }
}

impl Geometry for Watch {
    type Junction = ();

    fn arc_fault(&mut self, _: Side, joins: bool) -> Option<AlarmKind> {
        assert_eq!(joins, self.pending.is_some(), "an arc joins the element before it");
        (self.bad & 1 != 0).then_some(AlarmKind::RadiusTooSmall)
    }

    fn enter(&mut self, _: Side) -> Result<(), AlarmKind> {
        assert_eq!((self.pending, self.next), (None, self.read), "an entry move follows what has been settled");
        if self.bad & 2 == 0 { Ok(()) } else { Err(AlarmKind::EntryTooShort) }
    }

    fn junction(&mut self, _: Meeting, _: Side) -> Result<(), AlarmKind> {
        assert!(self.pending.is_some());
        if self.bad & 2 == 0 { Ok(()) } else { Err(AlarmKind::NoIntersection) }
    }

    fn settle(&mut self, _: End<()>, _: Part) -> Result<(), Alarm> {
        let pending = self.pending.take().expect("an element is pending");
        assert_eq!(pending, self.next);
        if self.bad & 4 == 0 {
            self.emit(pending);
            Ok(())
        } else {
            Err(Alarm { block: pending, kind: AlarmKind::ReversedLine })
        }
    }

    fn lose(&mut self) -> Result<(), Alarm> {
        unreachable!("with `ended` no block is lost");
    }

    fn hold(&mut self, block: usize, is_rapid: bool, _: Clause) {
        assert_eq!(is_rapid, rapid(block));
        // A start-up block without movement may turn out to be none. [TRC-START-08]
        self.pending.take_if(|pending| *pending == block);
        self.emit(block);
    }

    fn corner_moves(&mut self) {
        assert_eq!(self.next, self.read, "the corner moves of a block come at its place");
    }

    fn retreat(&mut self) {
        self.emit(self.read);
    }

    fn follow(&mut self, _: Clause) {
        self.emit(self.read);
    }

    fn come_back(&mut self, _: Clause) {
        self.emit(self.read);
    }

    fn begin(&mut self, _: Begin, _: Side) {
        assert_eq!((self.pending, self.next), (None, self.read));
        self.pending = Some(self.read);
    }

    fn corner_arc(&mut self, block: usize, is_rapid: bool, toward: Toward, _: Side) {
        assert_eq!(is_rapid, rapid(block));
        assert_eq!((self.pending, toward == Toward::Vector), (None, block == self.read));
        self.emit(block);
    }

    fn new_vector(&mut self, _: Side, _: bool) {
        assert_eq!(self.pending, None, "the element before has ended");
        self.emit(self.read);
    }
}

fn events() -> Vec<Event> {
    let sides = [Side::Left, Side::Right].map(|side| Some(Compensation::On(side)));
    let codes = [None, Some(Compensation::Off), sides[0], sides[1]];
    let kinds = [Kind::Still, Kind::Dummy, Kind::Line, Kind::Arc];
    let all = codes.iter().flat_map(|code| kinds.map(|kind| (*code, kind)));
    let plain = all.map(|(code, kind)| Event { code, ..Event::of(kind) });
    let stops = kinds.map(|kind| Event { stops: true, ..Event::of(kind) });
    let zero_length = codes.map(|code| Event { code, zero_length: true, ..Event::of(Kind::Still) });
    let stopping_code = Event { stops: true, code: sides[0], ..Event::of(Kind::Still) };
    let swapped = Event { swapped: true, ..Event::of(Kind::Line) };
    let not_in_mode = Event { not_in_mode: Some(AlarmKind::ToolChangeInMode), ..Event::of(Kind::Still) };
    let vectors = [Kind::HeldVector, Kind::NewVector, Kind::CornerArc, Kind::CornerToNext].map(Event::of);
    let no_length = Event { vector_code: true, ..Event::of(Kind::Still) };
    let stopping_corner = Event { stops: true, ..Event::of(Kind::CornerToNext) };
    let beside = [Kind::Still, Kind::Line]
        .into_iter()
        .flat_map(|kind| [codes[1], codes[2]].map(|code| Event { code, vector: true, ..Event::of(kind) }));
    let given = vectors.into_iter().chain([no_length, stopping_corner]).chain(beside);
    plain.chain(stops).chain(zero_length).chain([stopping_code, swapped, not_in_mode]).chain(given).collect()
}

/// Everything before the alarm's block has been emitted, and nothing of it or after it.
fn check_alarm(alarm: Alarm, watch: &Watch) {
    assert_eq!(watch.next, alarm.block);
    assert!(alarm.block <= watch.read);
}

fn explore(window: &Window, watch: &Watch, allowed: usize, depth: u32, events: &[Event], nodes: &mut u64) {
    *nodes += 1;
    assert!(window.held() <= 1 + allowed);
    assert_eq!(watch.next + window.held(), watch.read, "every block is emitted or held");
    for bad in [0, 4] {
        let (mut window, mut watch) = (window.clone(), Watch { bad, ..watch.clone() });
        match window.finish(&mut watch) {
            Ok(()) => assert_eq!((watch.next, window.held()), (watch.read, 0)),
            Err(alarm) => assert_eq!((watch.next, bad), (alarm.block, 4)),
        }
    }
    for kind in [AlarmKind::OutOfRange, AlarmKind::NoSuchArc] {
        for event in events.iter().filter(|event| event.kind == Kind::Arc) {
            let (mut window, mut watch) = (window.clone(), watch.clone());
            let alarm = window.refuse(watch.read, *event, kind, &mut watch).expect_err("a refusal is an alarm");
            check_alarm(alarm, &watch);
        }
    }
    if depth == 0 {
        return;
    }
    for event in events {
        let event = Event { rapid: rapid(watch.read), ..*event };
        for bad in 0..8 {
            for other_radius in [false, true] {
                let (mut window, mut watch) = (window.clone(), Watch { bad, ..watch.clone() });
                let block = watch.read;
                match window.read(block, Event { other_radius, ..event }, &mut watch) {
                    Err(alarm) => check_alarm(alarm, &watch),
                    Ok(()) => {
                        watch.read += 1;
                        if bad == 0 && !other_radius {
                            explore(&window, &watch, allowed, depth - 1, events, nodes);
                        }
                    }
                }
            }
        }
    }
}

fn explore_all(parameters: &Parameters, depth: u32) {
    let watch = Watch { next: 0, read: 0, pending: None, bad: 0 };
    let mut nodes = 0;
    let allowed = parameters.non_moving_allowed.map_or(usize::MAX - 1, usize::from);
    explore(&Window::new(parameters), &watch, allowed, depth, &events(), &mut nodes);
    println!("depth {depth}: {nodes} programs");
    assert!(nodes > 1000);
}

#[test]
fn all_sequences_of_every_policy() {
    for start_up_lost in [StartUpLost::Normal, StartUpLost::NoVector] {
        for non_moving_allowed in [Some(0), Some(1), Some(2), None] {
            for side_change in [SideChange::Forbidden, SideChange::TwoNormals] {
                for side_change_after_start_up in [SideChangeAfterStartUp::Alarm, SideChangeAfterStartUp::Allowed] {
                    let parameters = Parameters {
                        start_up_lost,
                        non_moving_allowed,
                        side_change,
                        side_change_after_start_up,
                        zero_length_move: ZeroLengthMove::BreaksLookAhead,
                        ..*SEED_MILL
                    };
                    explore_all(&parameters, 3);
                }
            }
        }
    }
}

#[test]
fn all_sequences_of_every_start_and_end() {
    for start_up in [StartUp::TypeA, StartUp::EntryNormal] {
        for start_up_without_movement in [StartUpWithoutMovement::None, StartUpWithoutMovement::Shift] {
            for start_up_arc in [StartUpArc::Alarm, StartUpArc::MovedCentre] {
                for (cancel, cancel_without_movement) in
                    [(Cancel::TypeA, CancelWithoutMovement::Shift), (Cancel::TypeB, CancelWithoutMovement::None)]
                {
                    for (same_code, start_up_lost) in [
                        (SameCode::Ordinary, StartUpLost::NoVector),
                        (SameCode::Normal, StartUpLost::NoVector),
                        (SameCode::Alarm, StartUpLost::Normal),
                    ] {
                        let parameters = Parameters {
                            start_up,
                            zero_length_move: ZeroLengthMove::StartsAndCancels,
                            start_up_without_movement,
                            start_up_arc,
                            cancel,
                            cancel_without_movement,
                            same_code,
                            start_up_lost,
                            non_moving_allowed: Some(1),
                            side_change_after_start_up: SideChangeAfterStartUp::Allowed,
                            ..*SEED_MILL
                        };
                        explore_all(&parameters, 3);
                    }
                }
            }
        }
    }
}

#[test]
fn all_sequences_with_vectors_and_other_offsets() {
    for same_code in [SameCode::Ordinary, SameCode::Normal] {
        for cancel in [Cancel::TypeA, Cancel::TypeB] {
            let parameters = Parameters {
                same_code,
                cancel,
                side_code_vector: SideCodeVector::RightAngles,
                cancel_vector: CancelVector::ImaginaryLine,
                offset_change: OffsetChange::EndOfBlock,
                non_moving_allowed: Some(1),
                ..*SEED_MILL
            };
            explore_all(&parameters, 3);
        }
    }
}

#[test]
fn all_sequences_of_five() {
    for start_up_without_movement in [StartUpWithoutMovement::None, StartUpWithoutMovement::Shift] {
        let parameters = Parameters {
            start_up_without_movement,
            start_up_lost: StartUpLost::NoVector,
            non_moving_allowed: Some(1),
            side_change_after_start_up: SideChangeAfterStartUp::Allowed,
            ..*SEED_MILL
        };
        explore_all(&parameters, 5);
    }
}

#[test]
fn the_longest_run_is_held() {
    let parameters = Parameters { non_moving_allowed: Some(8), ..*SEED_MILL };
    let mut window = Window::new(&parameters);
    let mut watch = Watch { next: 0, read: 0, pending: None, bad: 0 };
    let line = Event { code: Some(Compensation::On(Side::Left)), rapid: rapid(0), ..Event::of(Kind::Line) };
    window.read(0, line, &mut watch).unwrap();
    for block in 1..=8 {
        watch.read = block;
        let event = Event { rapid: rapid(block), ..Event::of(Kind::Still) };
        window.read(block, event, &mut watch).unwrap();
        assert_eq!((window.held(), watch.next), (1 + block, 0));
    }
    watch.read = 9;
    let event = Event { rapid: rapid(9), ..Event::of(Kind::Still) };
    window.read(9, event, &mut watch).unwrap();
    assert_eq!((window.held(), watch.next), (0, 10));
}
