//! Reports made by hand, and by judging a device.

use radcomp::certify::Tally;
use radcomp::device::{Answer, Builtin, Device, DeviceFault};
use radcomp::generate::{Reach, program};
use radcomp::judge::{Budget, Grade, judge};
use radcomp::report::{
    AnswerRecord, Binary, BlockRecord, Bucket, Case, Cases, Cause, DeviceRecord, Head, Report, case,
};
use radcomp_model::run;
use radcomp_spec::profile::Profile;
use radcomp_spec::{Block, Compensation, Movement, Parameters, Segment, Side};
use rug::Rational;

/// δ of every report here, β being 0.0005.
pub const DELTA: f64 = 1e-6;

pub fn profile() -> Profile {
    Profile::builtin("yasnac-lx").expect("built in")
}

fn budget() -> Budget {
    Budget { grade: Grade::Resolution, least_increment: 0.001, delta: DELTA }
}

/// A straight move.
pub fn line(a: i64, b: i64) -> Block<Rational> {
    Block::moving(Movement::Line { end: [Rational::from(a), Rational::from(b)] })
}

/// Start-up to (10, 0) on the left with radius 2, an inner corner at (30, 0), (30, 20), then cancel.
pub fn inner() -> Vec<Block<Rational>> {
    let mut blocks = vec![line(10, 0), line(30, 0), line(30, 20), line(0, 50)];
    blocks[0].compensation = Some(Compensation::On(Side::Left));
    blocks[0].radius = Some(Rational::from(2));
    blocks[3].compensation = Some(Compensation::Off);
    blocks
}

/// The outcome of a program, rounded.
pub fn answer(blocks: &[Block<Rational>]) -> Answer {
    Answer::from(&run(&profile().parameters, blocks))
}

/// The end of a straight step, to be changed.
pub fn end(answer: &mut Answer, step: usize) -> &mut [f64; 2] {
    match &mut answer.steps[step].segment {
        Segment::Line { end } => end,
        other => panic!("{other:?} is not straight"),
    }
}

/// A case by hand.
pub fn by_hand(verdict: &str, blocks: &[Block<Rational>], answer: &Answer) -> Case {
    Case {
        name: "by hand".to_owned(),
        verdict: verdict.to_owned(),
        beta_mm: Binary(0.0005),
        delta_mm: Binary(DELTA),
        program: blocks.iter().map(BlockRecord::from).collect(),
        witness: None,
        change_mm: None,
        flips: Vec::new(),
        answer: Some(AnswerRecord::from(answer)),
        fault: None,
        divergence: None,
        waiver: None,
    }
}

/// An admissible case by hand.
pub fn with_witness(blocks: &[Block<Rational>], witness: &[Block<Rational>], answer: &Answer) -> Case {
    let witness = Some(witness.iter().map(BlockRecord::from).collect());
    Case { witness, ..by_hand("admissible", blocks, answer) }
}

/// The report of some cases, its counts in order.
pub fn report(list: Vec<Case>) -> Report {
    let (mut tally, mut cases) = (Tally::default(), Cases::default());
    for case in list {
        tally.programs += 1;
        if let Some(change) = case.change_mm {
            tally.greatest_share = tally.greatest_share.max(change.0 / case.beta_mm.0);
        }
        let known = ["exact", "admissible", "admissible-without-witness", "inadmissible", "fork-limit", "crash"];
        let id = known.into_iter().find(|id| *id == case.verdict).expect("a verdict");
        *tally.verdicts.entry(id).or_default() += 1;
        tally.counts.count(if ["exact", "admissible", "admissible-without-witness"].contains(&id) {
            Bucket::Pass
        } else {
            Bucket::Fail
        });
        if ["inadmissible", "fork-limit"].contains(&id) {
            tally.clauses.entry("TRC-CORNER-03").or_default().failed += 1;
        }
        cases.add(case);
    }
    let (profile, device) = (profile(), DeviceRecord::named("by hand"));
    let budget = budget();
    let head =
        Head { device: &device, level: None, profile: &profile, seed: 0, generated_programs: 0, budget: &budget };
    Report::new(head, &tally, one_cause(&tally), Vec::new(), cases)
}

/// The implementation, with something done to its answers.
pub struct Tampered(pub fn(&mut Answer));

impl Device for Tampered {
    fn name(&self) -> &str {
        "tampered"
    }

    fn answer(&mut self, parameters: &Parameters, blocks: &[Block<Rational>]) -> Result<Answer, DeviceFault> {
        let mut answer = Builtin.answer(parameters, blocks)?;
        (self.0)(&mut answer);
        Ok(answer)
    }
}

/// The report of judging a device on generated programs.
pub fn judged(device: &mut dyn Device, budget: &Budget, programs: u64) -> Report {
    let profile = profile();
    let (mut tally, mut cases) = (Tally::default(), Cases::default());
    for number in 0..programs {
        let blocks = program(7, number, Reach::of(&profile));
        let judged = judge(device, &profile.parameters, &blocks, budget);
        tally.add(&blocks, &judged, budget.beta(&blocks));
        let case = case(&format!("#{number}"), &blocks, &judged, budget, budget.beta(&blocks));
        case.into_iter().for_each(|case| cases.add(case));
    }
    let device = DeviceRecord::named(device.name());
    let head = Head { device: &device, level: None, profile: &profile, seed: 7, generated_programs: programs, budget };
    Report::new(head, &tally, one_cause(&tally), Vec::new(), cases)
}

/// Every failure under one cause; none if there is no failure.
fn one_cause(tally: &Tally) -> Vec<Cause> {
    let cause = Cause {
        cause: "any".to_owned(),
        programs: tally.counts.fail,
        smallest: String::new(),
        clause: None,
        sentence: None,
        nearest: None,
        safety: None,
        program: None,
        tools: None,
        case: None,
    };
    if cause.programs > 0 { vec![cause] } else { Vec::new() }
}
