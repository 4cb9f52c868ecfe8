//! One program that a device failed.

use std::fmt;

use radcomp_spec::profile::Profile;
use radcomp_spec::{Alarm, Block};
use rug::Rational;

use super::safety::Safety;
use crate::gcode::{Listing, print_blocks};
use crate::judge::{Difference, Divergence, Verdict};
use crate::report::Case;

/// A failed program.
#[derive(Clone, Debug)]
pub struct Failure {
    /// The program's name: a vector's, or `#` and the number of a generated program.
    pub name: String,
    /// The verdict.
    pub verdict: Verdict,
    /// Its blocks.
    pub blocks: Vec<Block<Rational>>,
    /// What the answer does to the part; of the smallest failure of a cause.
    pub safety: Option<Safety>,
    /// Program, answer and divergence, for the report; of the smallest failure of a cause.
    pub case: Option<Box<Case>>,
}

impl Failure {
    /// A failure whose path has not been judged for safety.
    pub fn new(name: String, verdict: Verdict, blocks: Vec<Block<Rational>>) -> Failure {
        Failure { name, verdict, blocks, safety: None, case: None }
    }

    /// What failures with one cause have in common: the clause, and the kind of difference.
    pub fn group(&self) -> String {
        match &self.verdict {
            Verdict::Inadmissible(divergence) | Verdict::ForkLimit(divergence) => {
                format!("{} {}", divergence.clause, kind(&divergence.difference))
            }
            other => other.id().to_owned(),
        }
    }

    /// The program as G-code with its tools; why not, if its profile cannot write it.
    pub fn listing(&self, profile: &Profile) -> Result<Listing, String> {
        print_blocks(&self.blocks, profile).map_err(|error| format!("{error}"))
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.name, self.verdict.id())?;
        match &self.verdict {
            Verdict::Inadmissible(divergence) | Verdict::ForkLimit(divergence) => write!(f, " {}", Told(divergence)),
            Verdict::Fault(fault) => write!(f, ": {}", fault.text()),
            Verdict::Exact | Verdict::Admissible(_) | Verdict::AdmissibleWithoutWitness(_) => Ok(()),
        }
    }
}

/// A divergence in words.
struct Told<'a>(&'a Divergence);

impl fmt::Display for Told<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let divergence = self.0;
        write!(f, "{} at N{}: ", divergence.clause, divergence.block + 1)?;
        match &divergence.difference {
            Difference::End(off) => write!(f, "end point off by {off:.6} mm")?,
            Difference::Centre(off) => write!(f, "arc centre off by {off:.6} mm")?,
            Difference::Place(off) => write!(f, "executed {off:.6} mm from its place")?,
            Difference::NotFinite => write!(f, "a number that is not finite")?,
            Difference::Missing => write!(f, "the path ends too early")?,
            Difference::Surplus => write!(f, "the path goes on too far")?,
            Difference::Kind => write!(f, "another kind of element")?,
            Difference::Block => write!(f, "an element of another block")?,
            Difference::Alarm(expected, observed) => {
                return write!(f, "expected {}, got {}", alarm(*expected), alarm(*observed));
            }
        }
        if let (Some(expected), Some(observed)) = (&divergence.expected, &divergence.observed) {
            let [a, b] = expected.to;
            let [c, d] = observed.to;
            write!(f, "; expected ({a:.6}, {b:.6}), got ({c:.6}, {d:.6})")?;
        }
        Ok(())
    }
}

fn alarm(alarm: Option<Alarm>) -> String {
    alarm.map_or_else(|| "no alarm".to_owned(), |alarm| format!("alarm {} at N{}", alarm.kind.id(), alarm.block + 1))
}

/// The kind of a difference, in words.
pub(super) fn kind(difference: &Difference) -> &'static str {
    match difference {
        Difference::NotFinite => "not finite",
        Difference::Missing => "path too short",
        Difference::Surplus => "path too long",
        Difference::Kind => "kind of element",
        Difference::Block => "owner of an element",
        Difference::End(_) => "end point",
        Difference::Centre(_) => "arc centre",
        Difference::Place(_) => "place of a block without movement",
        Difference::Alarm(_, None) => "alarm missing",
        Difference::Alarm(None, _) => "alarm without cause",
        Difference::Alarm(..) => "another alarm",
    }
}
