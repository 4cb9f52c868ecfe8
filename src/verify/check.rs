//! One case.

use radcomp_model::number::{Real, nearest_f64};
use radcomp_model::run;
use radcomp_spec::{Block, Parameters};
use rug::Rational;

use super::branches::{self, MOST_RUNS, Reception, Search};
use super::path::Path;
use super::walk::{self, Parting, Reach};
use super::{head, witness};
use crate::device::Answer;
use crate::report::{Case, Report};

/// What came of checking a case.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Finding {
    /// The verdict stands.
    Confirmed,
    /// It does not, or could not be shown to: why.
    NotConfirmed(String),
    /// The device gave no answer, which nothing in the report can show.
    NothingToCheck,
}

/// How much nearer than said a witness may be: the judge rounds the change that it tells.
const CHANGE_ROUNDING: f64 = 1.0 + 1e-9;

/// Checks a case of a report.
pub(super) fn check(report: &Report, case: &Case) -> Finding {
    let Some(answer) = &case.answer else {
        // A verdict on an answer needs one.
        return match case.verdict.as_str() {
            "exact" | "admissible" | "admissible-without-witness" | "inadmissible" | "fork-limit" => {
                Finding::NotConfirmed("the case does not give the device's answer".to_owned())
            }
            _ => Finding::NothingToCheck,
        };
    };
    match judged(report, case, &Answer::from(answer)) {
        Ok(()) => Finding::Confirmed,
        Err(reason) => Finding::NotConfirmed(reason),
    }
}

fn judged(report: &Report, case: &Case, answer: &Answer) -> Result<(), String> {
    let parameters = Parameters::from(&report.parameters);
    let program: Vec<Block<Rational>> = case.program.iter().map(Block::from).collect();
    let question = Question {
        case,
        parameters: &parameters,
        program: &program,
        // An answer with a number that is not finite is no outcome.
        answer: Path::of_answer(answer),
        beta: band(report, case, &program)?,
        delta: delta(report, case)?,
    };
    match case.verdict.as_str() {
        "exact" => question.is_outcome_of(&program, "the program", Reach::ACCEPTING),
        "admissible" => question.is_admissible(),
        "admissible-without-witness" => match question.search(Reach::ACCEPTING) {
            Search::Found => Ok(()),
            Search::NotFound => Err("no combination of branches in the band has the answer's path".to_owned()),
            Search::TooMany => Err(format!("none of the first {MOST_RUNS} combinations of branches has its path")),
        },
        "inadmissible" => question.is_refused(true),
        "fork-limit" => question.is_refused(false),
        other => Err(format!("{other:?} is no verdict on an answer")),
    }
}

/// The case's band, which must be the one of the report's grade.
fn band(report: &Report, case: &Case, program: &[Block<Rational>]) -> Result<Rational, String> {
    let due = head::band(report, program);
    if case.beta_mm.0 != due {
        return Err(format!("β is {:?} mm, but the grade gives {due:?} mm", case.beta_mm.0));
    }
    Rational::from_f64(due).filter(|beta| !beta.is_negative()).ok_or_else(|| format!("β is {due:?} mm"))
}

/// The case's δ, which must be the report's.
fn delta(report: &Report, case: &Case) -> Result<Real, String> {
    let (given, due) = (case.delta_mm.0, report.delta_mm.0);
    if given != due {
        return Err(format!("δ is {given:?} mm, but the report's is {due:?} mm"));
    }
    let delta = Rational::from_f64(due).filter(Rational::is_positive);
    delta.map(Real::rational).ok_or_else(|| format!("δ is {due:?} mm"))
}

/// What is asked of one answer.
struct Question<'a> {
    case: &'a Case,
    parameters: &'a Parameters,
    program: &'a [Block<Rational>],
    answer: Option<Path>,
    beta: Rational,
    delta: Real,
}

impl Question<'_> {
    fn is_admissible(&self) -> Result<(), String> {
        let records = self.case.witness.as_ref().ok_or("the case gives no witness")?;
        let input: Vec<Block<Rational>> = records.iter().map(Block::from).collect();
        let change = witness::change(self.program, &input)?;
        if change > self.beta {
            let (change, beta) = (nearest_f64(&change), nearest_f64(&self.beta));
            return Err(format!("a number of the witness is {change:?} mm from the program's, β is {beta:?} mm"));
        }
        if let Some(said) = self.case.change_mm {
            let said = said.0;
            // A change that is not a number says nothing.
            if said.is_nan() || nearest_f64(&change) > said * CHANGE_ROUNDING {
                let change = nearest_f64(&change);
                return Err(format!("the witness is said to change no number by more than {said:?} mm: {change:?} mm"));
            }
        }
        self.is_outcome_of(&input, "the witness", Reach::ACCEPTING)
    }

    /// Whether the answer is the exact outcome of this program, to within δ and so many units.
    fn is_outcome_of(&self, program: &[Block<Rational>], name: &str, units: i64) -> Result<(), String> {
        let answer = self.answer.as_ref().ok_or("a number of the answer is not finite")?;
        let outcome = Path::of_run(&run(self.parameters, program));
        walk::compare(&outcome, answer, &self.reach(units), &Real::from(&self.beta)).map_err(|parting| match parting {
            Parting::Path { block, .. } => {
                format!("the answer is not the outcome of {name}: they part at N{}", block + 1)
            }
            Parting::Alarm => format!("the answer ends in another alarm than {name}"),
        })
    }

    /// Whether no outcome that was looked at is the answer; `all` of them have to be looked at.
    fn is_refused(&self, all: bool) -> Result<(), String> {
        if self.is_outcome_of(self.program, "the program", Reach::REFUSING).is_ok() {
            return Err("the answer is the exact outcome".to_owned());
        }
        match self.search(Reach::REFUSING) {
            Search::NotFound => Ok(()),
            Search::TooMany if !all => Ok(()),
            Search::Found => Err("the answer is the outcome on other branches in the band".to_owned()),
            Search::TooMany => Err(format!("there are more than {MOST_RUNS} combinations of branches in the band")),
        }
    }

    fn reach(&self, units: i64) -> Reach {
        Reach { delta: self.delta.clone(), units }
    }

    /// Whether the answer is the outcome on some combination of branches in the band, to within δ and so many units.
    fn search(&self, units: i64) -> Search {
        let Some(answer) = &self.answer else { return Search::NotFound };
        let (beta, reach) = (Real::from(&self.beta), self.reach(units));
        branches::search(self.parameters, self.program, nearest_f64(&self.beta), |run| {
            match walk::compare(&Path::of_run(run), answer, &reach, &beta) {
                Ok(()) => Reception::Accepted,
                Err(Parting::Path { moves, .. }) => Reception::Refused { moves },
                Err(Parting::Alarm) => Reception::Refused { moves: usize::MAX },
            }
        })
    }
}
