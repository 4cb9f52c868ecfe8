//! Where the choices of a harness come from.

use std::collections::BTreeSet;

/// A source of choices.
pub trait Choice {
    /// A number below `bound`, which is at least 1.
    fn below(&mut self, bound: u8) -> u8;
    /// A number, of any bit pattern that the source has.
    fn number(&mut self) -> f64;
    /// One of the values, of which there is at least one.
    fn of<T: Copy>(&mut self, values: &[T]) -> T {
        // The number is below the length, which is far below 256 in every harness.
        values[usize::from(self.below(values.len() as u8))]
    }
    /// Yes or no.
    fn flag(&mut self) -> bool {
        self.below(2) == 1
    }
    /// The run has come to a place that must be reachable; see [`crate::reached`].
    fn reached(&mut self, _what: &'static str) {}
}

/// All values of every choice, one combination a run, in the order of an odometer.
#[derive(Debug)]
pub struct Exhaustive {
    /// The value and the bound of each choice of the present run.
    trail: Vec<(u8, u8)>,
    made: usize,
    numbers: &'static [f64],
}

/// What an exhaustive search has visited.
#[derive(Debug, Default)]
pub struct Visited {
    /// Runs, each with another combination of choices.
    pub runs: u64,
    /// The places of [`crate::reached`] that some run has come to.
    pub reached: BTreeSet<&'static str>,
}

/// An exhaustive source together with the places that it has seen reached.
#[derive(Debug)]
pub struct Run<'a> {
    source: &'a mut Exhaustive,
    visited: &'a mut Visited,
}

impl Exhaustive {
    /// Runs the harness once for each combination of its choices; every number is one of `numbers`.
    pub fn search(numbers: &'static [f64], harness: impl FnMut(&mut Run)) -> Visited {
        let mut visited = Visited::default();
        Exhaustive::search_on(numbers, &mut visited, harness);
        visited
    }

    /// The same, adding to what other searches have visited.
    pub fn search_on(numbers: &'static [f64], visited: &mut Visited, mut harness: impl FnMut(&mut Run)) {
        let mut source = Exhaustive { trail: Vec::new(), made: 0, numbers };
        loop {
            source.made = 0;
            visited.runs += 1;
            harness(&mut Run { source: &mut source, visited });
            if !source.advance() {
                return;
            }
        }
    }

    /// Goes to the next combination, if there is one.
    fn advance(&mut self) -> bool {
        self.trail.truncate(self.made);
        while let Some((value, bound)) = self.trail.pop() {
            if value + 1 < bound {
                self.trail.push((value + 1, bound));
                return true;
            }
        }
        false
    }
}

impl Choice for Run<'_> {
    fn below(&mut self, bound: u8) -> u8 {
        let Exhaustive { trail, made, .. } = &mut *self.source;
        if *made == trail.len() {
            trail.push((0, bound));
        }
        let (value, known) = trail[*made];
        assert_eq!(known, bound, "a harness makes the same choices again until one differs");
        *made += 1;
        value
    }

    fn number(&mut self) -> f64 {
        let numbers = self.source.numbers;
        self.of(numbers)
    }

    fn reached(&mut self, what: &'static str) {
        self.visited.reached.insert(what);
    }
}

/// Choices taken from bytes, such as a property test or a fuzzer draws; zeros follow the last one.
#[derive(Debug)]
pub struct Bytes<'a>(pub &'a [u8]);

impl Bytes<'_> {
    fn next(&mut self) -> u8 {
        let Some((&first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        first
    }
}

impl Choice for Bytes<'_> {
    fn below(&mut self, bound: u8) -> u8 {
        self.next() % bound
    }

    /// Small whole numbers, which make degenerate geometry, extreme ones, and every bit pattern.
    fn number(&mut self) -> f64 {
        const EXTREME: [f64; 8] = [1e9, -1e9, 1e-9, 5e-324, -1e-200, f64::MAX, f64::NAN, f64::NEG_INFINITY];
        match self.next() {
            kind @ 0..=199 => f64::from(kind % 13) - 6.0,
            kind @ 200..=215 => EXTREME[usize::from(kind % 8)],
            _ => f64::from_bits(u64::from_le_bytes(std::array::from_fn(|_| self.next()))),
        }
    }
}
