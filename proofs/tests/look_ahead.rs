//! The look-ahead over every sequence of events and every answer of geometry, of any length.
//!
//! What a window does next depends on its state alone, and of a state only the blocks still owed matter, not how many
//! came before. So the search goes from state to state instead of from sequence to sequence, and ends when no event and
//! no answer leads to a new one. How many sequences of eight events the states stand for is counted along the edges.

use std::collections::HashMap;

use proptest::prelude::*;
use radcomp_proofs::choice::{Bytes, Choice, Exhaustive, Visited};
use radcomp_proofs::look_ahead::{LookAhead, PLACES, event, parameters, programs};
use radcomp_spec::Parameters;
use radcomp_spec::parameters::MOST_NON_MOVING;

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
}

impl Graph {
    /// Searches until nothing new is found.
    fn explore(start: LookAhead, visited: &mut Visited) -> Graph {
        let mut graph = Graph::default();
        graph.number(start);
        let mut done = 0;
        while done < graph.states.len() {
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
            match state.read(event(choice), choice) {
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

/// Every combination of the parameters.
fn all_parameters() -> Vec<Parameters> {
    let mut all = Vec::new();
    Exhaustive::search(&[], |choice| all.push(parameters(choice, MOST_NON_MOVING)));
    all
}

#[test]
fn every_sequence_of_any_length() {
    let (mut visited, mut states, mut transitions, mut sequences, mut depth) = (Visited::default(), 0, 0, 0, 0);
    let all = all_parameters();
    assert_eq!(all.len(), 2 * 3 * 2 * 9);
    for parameters in &all {
        let graph = Graph::explore(LookAhead::new(parameters), &mut visited);
        states += graph.states.len();
        transitions += graph.transitions;
        sequences += graph.sequences(8);
        depth = depth.max(graph.depth);
        // Each block without movement that is held doubles the rates that can be owed.
        assert!(graph.states.len() > 1 << parameters.non_moving_allowed);
    }
    println!(
        "look-ahead: {} sets of parameters, {states} states, {transitions} transitions; nothing new after {depth} events; \
         {sequences} sequences of 8 events with their answers",
        all.len()
    );
    assert!(visited.reached.iter().eq(&PLACES), "{:?}", visited.reached);
}

/// The search by states against a plain one, sequence by sequence.
#[test]
fn states_stand_for_sequences() {
    for parameters in all_parameters().iter().filter(|parameters| parameters.non_moving_allowed == 1) {
        let mut plain = 0;
        Exhaustive::search(&[], |choice| {
            let mut state = LookAhead::new(parameters);
            let _ = (0..3).try_for_each(|_| state.read(event(choice), choice));
            plain += 1;
        });
        assert_eq!(Graph::explore(LookAhead::new(parameters), &mut Visited::default()).sequences(3), plain);
    }
}

/// The harness that Kani runs, over all its choices.
#[test]
fn every_program_of_three_events() {
    let visited = Exhaustive::search(&[], |choice| programs(choice, 3, 1));
    println!("look-ahead, sequence by sequence: {} programs of at most 3 events", visited.runs);
    assert!(visited.reached.iter().eq(&PLACES), "{:?}", visited.reached);
}

/// A false twin: one block less than it may hold.
#[test]
#[should_panic(expected = "more held than the capacity")]
fn a_smaller_capacity_is_refuted() {
    let parameters = all_parameters().pop().unwrap();
    let capacity = usize::from(parameters.non_moving_allowed);
    Graph::explore(LookAhead::new(&parameters).claiming(capacity), &mut Visited::default());
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 20_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn long_programs(bytes in prop::collection::vec(any::<u8>(), 0..600)) {
        programs(&mut Bytes(&bytes), 100, MOST_NON_MOVING);
    }
}
