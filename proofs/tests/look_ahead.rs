//! The look-ahead over every sequence of events and every answer of geometry.
//!
//! What a window does next depends on its state alone, and of a state only the blocks still owed matter, not how many
//! came before. So the search goes from state to state instead of from sequence to sequence, and ends when no event and
//! no answer leads to a new one: the sequences may then be of any length. Where any number of blocks may wait there is no
//! end of states, and the search ends after eight events. How many sequences of eight events the states stand for is
//! counted along the edges.

use std::collections::HashMap;
use std::thread;

use proptest::prelude::*;
use radcomp_proofs::choice::{Bytes, Choice, Exhaustive, Visited};
use radcomp_proofs::engine::plain;
use radcomp_proofs::look_ahead::{LookAhead, PLACES, event, parameters, programs, programs_under};
use radcomp_spec::Parameters;
use radcomp_spec::parameters::*;

/// The events of the sequences that are counted, and of those that are searched where there is no end of states.
const EVENTS: usize = 8;

/// The states that sequences of events lead to, and which lead to which.
#[derive(Default)]
struct Graph {
    numbers: HashMap<String, usize>,
    states: Vec<LookAhead>,
    /// Per state, the next states, once for each event and answers that lead there without an alarm.
    next: Vec<HashMap<usize, u64>>,
    /// Per state, how many events and answers end in an alarm.
    alarms: Vec<u64>,
    /// After how many events the last new state appeared.
    depth: usize,
    /// Events read, each from another state or with other answers.
    transitions: u64,
    /// Blocks of both rates are read, not only blocks at feed rate.
    rates: bool,
}

impl Graph {
    /// Searches until nothing new is found, or so many events have been read.
    fn explore(start: LookAhead, rates: bool, events: usize, visited: &mut Visited) -> Graph {
        let mut graph = Graph { rates, ..Graph::default() };
        graph.number(start);
        let mut done = 0;
        while done < graph.states.len() && graph.depth < events {
            graph.depth += 1;
            let level = graph.states.len();
            while done < level {
                graph.expand(done, visited);
                done += 1;
            }
        }
        graph
    }

    fn expand(&mut self, number: usize, visited: &mut Visited) {
        let state = self.states[number].clone();
        let before = visited.runs;
        let (mut next, mut alarms) = (HashMap::new(), 0);
        Exhaustive::search_on(&[], visited, |choice| {
            let mut state = state.clone();
            match state.read(event(&state, choice, self.rates), choice) {
                Ok(()) => *next.entry(self.number(state)).or_default() += 1,
                Err(_) => alarms += 1,
            }
        });
        self.transitions += visited.runs - before;
        self.next.push(next);
        self.alarms.push(alarms);
        Exhaustive::search_on(&[], visited, |choice| {
            let state = state.clone();
            if choice.flag() { state.finish(choice) } else { state.fault(choice) }
        });
    }

    fn number(&mut self, state: LookAhead) -> usize {
        let new = self.states.len();
        let number = *self.numbers.entry(state.key()).or_insert(new);
        if number == new {
            self.states.push(state);
        }
        number
    }

    /// How many sequences of so many events, with the answers to them, there are: those that an alarm cuts short among
    /// them.
    fn sequences(&self, events: usize) -> u128 {
        let mut reached = HashMap::from([(0, 1_u128)]);
        let mut cut_short = 0;
        for _ in 0..events {
            let mut after = HashMap::new();
            for (state, count) in reached {
                cut_short += count * u128::from(self.alarms[state]);
                for (next, ways) in &self.next[state] {
                    *after.entry(*next).or_default() += count * u128::from(*ways);
                }
            }
            reached = after;
        }
        cut_short + reached.values().sum::<u128>()
    }
}

/// Every combination of the parameters, with at most so many blocks without movement allowed, or any number.
fn all_parameters(allowed: u8) -> Vec<Parameters> {
    let mut all = Vec::new();
    Exhaustive::search(&[], |choice| all.push(parameters(choice, allowed)));
    all
}

/// Plain rules, and a set with the other rules of start-up and cancel, with so many blocks without movement allowed.
fn two_sets(non_moving_allowed: Option<u8>) -> [Parameters; 2] {
    let one = Parameters { zero_length_move: ZeroLengthMove::BreaksLookAhead, non_moving_allowed, ..plain() };
    let other = Parameters {
        start_up_lost: StartUpLost::NoVector,
        start_up_without_movement: StartUpWithoutMovement::Shift,
        start_up_arc: StartUpArc::MovedCentre,
        cancel: Cancel::TypeB,
        cancel_without_movement: CancelWithoutMovement::Shift,
        same_code: SameCode::Normal,
        side_code_vector: SideCodeVector::RightAngles,
        cancel_vector: CancelVector::ImaginaryLine,
        offset_change: OffsetChange::EndOfBlock,
        zero_length_move: ZeroLengthMove::StartsAndCancels,
        pending_at_alarm: PendingAtAlarm::Lost,
        non_moving_allowed,
        ..plain()
    };
    [one, other]
}

/// What several searches have found.
#[derive(Default)]
struct Total {
    visited: Visited,
    sets: usize,
    states: usize,
    transitions: u64,
    sequences: u128,
    depth: usize,
}

impl Total {
    /// Searches under each of the parameters, on all cores.
    fn of(all: &[Parameters], rates: bool) -> Total {
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let mut total = Total::default();
        thread::scope(|scope| {
            let shares = (0..cores).map(|core| all.iter().skip(core).step_by(cores));
            let searches: Vec<_> = shares.map(|share| scope.spawn(move || Total::in_turn(share, rates))).collect();
            searches.into_iter().for_each(|search| total.add(search.join().expect("no promise is broken")));
        });
        assert!(total.visited.reached.iter().eq(&PLACES), "{:?}", total.visited.reached);
        total
    }

    fn in_turn<'a>(all: impl Iterator<Item = &'a Parameters>, rates: bool) -> Total {
        let mut total = Total::default();
        for parameters in all {
            let events = if parameters.non_moving_allowed.is_some() { usize::MAX } else { EVENTS };
            let graph = Graph::explore(LookAhead::new(parameters), rates, events, &mut total.visited);
            total.sets += 1;
            total.states += graph.states.len();
            total.transitions += graph.transitions;
            total.sequences += graph.sequences(EVENTS);
            total.depth = total.depth.max(graph.depth);
            // Each block without movement that is held doubles the rates that can be owed.
            let held = parameters.non_moving_allowed.unwrap_or(EVENTS as u8 - 1);
            assert!(graph.states.len() > if rates { 1 << held } else { usize::from(held) });
        }
        total
    }

    fn add(&mut self, other: Total) {
        self.visited.runs += other.visited.runs;
        self.visited.reached.extend(other.visited.reached);
        self.sets += other.sets;
        self.states += other.states;
        self.transitions += other.transitions;
        self.sequences += other.sequences;
        self.depth = self.depth.max(other.depth);
    }

    fn tell(&self, what: &str) {
        println!(
            "look-ahead, {what}: {} sets of parameters, {} states, {} transitions; the last new state after {} events; \
             {:.2e} sequences of {EVENTS} events with their answers",
            self.sets, self.states, self.transitions, self.depth, self.sequences as f64
        );
    }
}

#[test]
fn every_sequence_under_every_profile() {
    let all = all_parameters(2);
    assert_eq!(all.len(), 2 * 2 * 2 * 2 * 2 * 2 * 3 * 3 * 4 + 2 * 2 * 2 * 3 * 4);
    let bounded: Vec<_> = all.into_iter().filter(|parameters| parameters.non_moving_allowed.is_some()).collect();
    Total::of(&bounded, false).tell("sequences of any length at feed rate");
}

#[test]
fn every_sequence_with_every_count_allowed() {
    let all: Vec<_> = (0..=MOST_NON_MOVING).flat_map(|count| two_sets(Some(count))).collect();
    Total::of(&all, false).tell("up to 8 blocks without movement, sequences of any length at feed rate");
    let rated: Vec<_> = (0..=6).flat_map(|count| two_sets(Some(count))).collect();
    Total::of(&rated, true).tell("up to 6 blocks without movement, sequences of any length at both rates");
    Total::of(&two_sets(None), true).tell("any number of blocks without movement, 8 events at both rates");
}

/// The search by states against a plain one, sequence by sequence.
#[test]
fn states_stand_for_sequences() {
    let mut sequences = 0;
    for parameters in &two_sets(Some(1)) {
        let mut plain = 0;
        Exhaustive::search(&[], |choice| {
            let mut state = LookAhead::new(parameters);
            let _ = (0..3).try_for_each(|_| state.read(event(&state, choice, false), choice));
            plain += 1;
        });
        let graph = Graph::explore(LookAhead::new(parameters), false, usize::MAX, &mut Visited::default());
        assert_eq!(graph.sequences(3), plain);
        sequences += plain;
    }
    println!("look-ahead: the states stand for {sequences} sequences of 3 events");
}

/// The harness that Kani runs, over all its choices under some profiles.
#[test]
fn every_program_of_three_events() {
    let mut visited = Visited::default();
    for parameters in &two_sets(Some(1)) {
        Exhaustive::search_on(&[], &mut visited, |choice| programs_under(choice, parameters, 3, false));
    }
    println!("look-ahead, sequence by sequence: {} programs of at most 3 events", visited.runs);
    assert!(visited.reached.iter().eq(&PLACES), "{:?}", visited.reached);
}

/// A false twin: one block less than it may hold.
#[test]
#[should_panic(expected = "more held than the capacity")]
fn a_smaller_capacity_is_refuted() {
    let [parameters, _] = two_sets(Some(3));
    Graph::explore(LookAhead::new(&parameters).claiming(3), false, usize::MAX, &mut Visited::default());
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 20_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn long_programs(bytes in prop::collection::vec(any::<u8>(), 0..600)) {
        programs(&mut Bytes(&bytes), 100, MOST_NON_MOVING);
    }
}
