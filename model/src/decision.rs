//! Decisions, and who listens to them.

use core::cmp::Ordering;

use radcomp_spec::{Advisory, Alarm, Clause, DecisionKind, Step};

use crate::number::Real;

/// One branch that the rules took on exact geometry.
#[derive(Clone, Debug)]
pub struct Decision {
    /// Index of the block being read when it was taken.
    pub block: usize,
    /// Which branch.
    pub kind: DecisionKind,
    /// Its exact sign; zero is decided by the clause's own text.
    pub exact: Ordering,
    /// Its exact signed margin, in millimetres, with the sign of [`Decision::exact`].
    pub margin: Real,
}

impl Decision {
    /// The clause whose sentence it decides.
    pub fn clause(&self) -> Clause {
        self.kind.clause()
    }
}

/// Receives what the engine answers, in program order.
///
/// Every method has a default, so that a listener takes only what it needs.
pub trait Sink {
    /// A path element is settled.
    fn step(&mut self, step: Step<Real>) {
        let _ = step;
    }

    /// A warning that does not stop the tool.
    fn advisory(&mut self, advisory: Advisory<Real>) {
        let _ = advisory;
    }

    /// A decision is taken. The answer is the branch to follow; the reference answer, and the default, is
    /// [`Decision::exact`].
    fn decide(&mut self, decision: Decision) -> Ordering {
        decision.exact
    }
}

/// Why the path ended before the program did.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The rules raise an alarm.
    Alarm(Alarm),
    /// A [`Sink`] answered decisions in a way that no geometry satisfies. Exact answers never lead here.
    Contradiction,
}

impl Stop {
    /// The alarm, if it is one.
    pub fn alarm(self) -> Option<Alarm> {
        match self {
            Stop::Alarm(alarm) => Some(alarm),
            Stop::Contradiction => None,
        }
    }
}

/// The branches that a junction or a check takes on behalf of one block.
pub(crate) struct Judgement<'a> {
    pub(crate) sink: &'a mut dyn Sink,
    pub(crate) block: usize,
}

impl Judgement<'_> {
    /// Takes the decision whose sign is that of `sign`, with `margin` the same sign in millimetres.
    pub(crate) fn decide(&mut self, kind: DecisionKind, sign: &Real, margin: Real) -> Ordering {
        self.settle(kind, sign.sign(), margin)
    }

    /// Takes a decision whose exact sign is known.
    pub(crate) fn settle(&mut self, kind: DecisionKind, exact: Ordering, margin: Real) -> Ordering {
        self.sink.decide(Decision { block: self.block, kind, exact, margin })
    }

    /// Gives a warning.
    pub(crate) fn advise(&mut self, kind: radcomp_spec::AdvisoryKind, amount: Real) {
        self.sink.advisory(Advisory { block: self.block, kind, amount });
    }
}
