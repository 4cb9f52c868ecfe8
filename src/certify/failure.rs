//! One program that a device failed.

use std::fmt;

use radcomp_spec::profile::Profile;
use radcomp_spec::{Alarm, Block};
use rug::Rational;
use serde::{Deserialize, Serialize};

use super::plan::Place;
use crate::gcode::{Listing, print_blocks};
use crate::judge::{self, Difference, Divergence, Stroke, Verdict};
use crate::report::Case;

/// A failed program.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// Where it stands in its campaign.
    pub place: Place,
    /// What failures with one cause have in common: the clause, and the kind of difference.
    pub group: String,
    /// What is wrong, in words.
    pub told: String,
    /// Its blocks.
    pub blocks: Vec<Block<Rational>>,
    /// What the answer does to the part, in words; of the smallest failure of a cause.
    pub safety: Option<String>,
    /// Program, answer and divergence, for the report.
    pub case: Box<Case>,
}

/// A failed program in words.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Told {
    /// Where it stands in its campaign.
    pub place: Place,
    /// Name, verdict and what is wrong.
    pub text: String,
}

impl Failure {
    /// A failure whose path has not been judged for safety. `case` is that of the verdict.
    pub fn new(place: Place, verdict: &Verdict, blocks: Vec<Block<Rational>>, case: Case) -> Failure {
        let told = format!("{} {}", case.name, Words(verdict));
        Failure { place, group: group(verdict), told, blocks, safety: None, case: Box::new(case) }
    }

    /// The program's name: a vector's, a boundary's, or `#` and the number of a generated program.
    pub fn name(&self) -> &str {
        &self.case.name
    }

    /// The failure in words.
    pub fn told(&self) -> Told {
        Told { place: self.place, text: self.told.clone() }
    }

    /// Of two failures with one cause the one with the lower rank is told: fewer blocks, then the earlier one.
    pub(super) fn rank(&self) -> (usize, Place) {
        (self.blocks.len(), self.place)
    }

    /// The program as G-code with its tools; why not, if its profile cannot write it.
    pub fn listing(&self, profile: &Profile) -> Result<Listing, String> {
        print_blocks(&self.blocks, profile).map_err(|error| format!("{error}"))
    }
}

/// The cause that failures with such a verdict have in common: the clause, and the kind of difference.
pub fn group(verdict: &Verdict) -> String {
    match verdict {
        Verdict::Inadmissible(divergence) | Verdict::ForkLimit(divergence) => {
            format!("{} {}", divergence.clause, kind(&divergence.difference))
        }
        other => other.id().to_owned(),
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.told)
    }
}

impl fmt::Display for Told {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// A verdict in words.
struct Words<'a>(&'a Verdict);

impl fmt::Display for Words<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0.id())?;
        match self.0 {
            Verdict::Inadmissible(divergence) | Verdict::ForkLimit(divergence) => {
                write!(f, " {}", Divergent(divergence))
            }
            Verdict::Fault(fault) => write!(f, ": {}", fault.text()),
            Verdict::Exact | Verdict::Admissible(_) | Verdict::AdmissibleWithoutWitness(_) => Ok(()),
        }
    }
}

/// A divergence in words.
struct Divergent<'a>(&'a Divergence);

impl fmt::Display for Divergent<'_> {
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
            let point = |stroke: &Stroke| match (&divergence.difference, &stroke.shape) {
                (Difference::Centre(_), judge::Shape::Arc { centre, .. }) => *centre,
                _ => stroke.to,
            };
            let ([a, b], [c, d]) = (point(expected), point(observed));
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
