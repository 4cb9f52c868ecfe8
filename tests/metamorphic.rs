//! Metamorphic checks: the implementation passes them, and devices whose answers depend on where the program stands do
//! not.

use radcomp::device::{Answer, Builtin, Device, DeviceFault};
use radcomp::generate::{self, Reach};
use radcomp::judge::{Budget, Grade};
use radcomp::metamorphic::{self, Broken};
use radcomp_spec::profile::Profile;
use radcomp_spec::{Block, Parameters, Segment};
use rug::Rational;

const BUDGET: Budget = Budget { grade: Grade::Binary64, least_increment: 0.001, delta: 1e-6 };

fn check(device: &mut dyn Device, programs: u64) -> Vec<Broken> {
    let profile = Profile::builtin("seed-mill").expect("built in");
    (0..programs)
        .flat_map(|number| {
            let blocks = generate::program(3, number, Reach::of(&profile));
            metamorphic::check(device, &profile.parameters, &blocks, &BUDGET)
        })
        .collect()
}

/// The implementation, its answers changed.
struct Changed(fn(&mut Answer));

impl Device for Changed {
    fn name(&self) -> &str {
        "changed"
    }

    fn answer(&mut self, parameters: &Parameters, blocks: &[Block<Rational>]) -> Result<Answer, DeviceFault> {
        let mut answer = Builtin.answer(parameters, blocks)?;
        (self.0)(&mut answer);
        Ok(answer)
    }
}

fn ends(answer: &mut Answer) -> impl Iterator<Item = &mut [f64; 2]> {
    answer.steps.iter_mut().filter_map(|step| match &mut step.segment {
        Segment::Line { end } | Segment::Arc { end, .. } => Some(end),
        Segment::Hold => None,
    })
}

#[test]
fn the_implementation_answers_moved_programs_alike() {
    let broken = check(&mut Builtin, 2_000);
    let told: Vec<_> = broken.iter().take(5).map(|broken| (broken.relation, &broken.difference)).collect();
    assert!(broken.is_empty(), "{} relations broken: {told:?}", broken.len());
}

#[test]
fn a_device_that_rounds_to_its_own_grid_is_found_by_moving_the_program() {
    let mut device =
        Changed(|answer| ends(answer).flatten().for_each(|value| *value = (*value * 300.0).round() / 300.0));
    let broken = check(&mut device, 60);
    assert!(broken.iter().any(|broken| broken.relation == "rotation"));
    assert!(broken.iter().any(|broken| broken.relation == "translation"));
}

#[test]
fn a_device_with_a_mistake_for_one_sense_of_turning_is_found_by_mirroring() {
    let mut device = Changed(|answer| {
        use radcomp_spec::Direction::Clockwise;
        for step in &mut answer.steps {
            if let Segment::Arc { centre, direction: Clockwise, .. } = &mut step.segment {
                centre[0] += 0.001;
            }
        }
    });
    assert!(check(&mut device, 200).iter().any(|broken| broken.relation == "mirroring"));
}

#[test]
fn a_device_with_a_mistake_at_tangent_junctions_is_found_by_splitting() {
    let mut device = Changed(|answer| {
        // The vector of a tangent junction is put one hundredth off.
        use radcomp_spec::clause;
        let tangent = answer.steps.iter().position(|step| step.clause == clause::TRC_CORNER_02);
        if let Some(end) = tangent.and_then(|at| ends(answer).nth(at)) {
            end[0] += 0.01;
        }
    });
    assert!(check(&mut device, 600).iter().any(|broken| broken.relation == "splitting a line"));
}

#[test]
fn contours_are_run_backwards() {
    let profile = Profile::builtin("seed-mill").expect("built in");
    let reversals = (0..2_000)
        .filter_map(|number| metamorphic::Reversal::of(&generate::program(3, number, Reach::of(&profile))))
        .count();
    assert!(reversals > 100, "{reversals}");
}

#[test]
fn a_device_that_ends_arcs_late_is_found_by_running_backwards() {
    let mut device = Changed(|answer| {
        for step in &mut answer.steps {
            if let Segment::Arc { end, .. } = &mut step.segment {
                end[0] += 0.002;
            }
        }
    });
    let broken = check(&mut device, 400);
    assert!(broken.iter().any(|broken| broken.relation == "running backwards"));
}

/// Where a contact of two nearly parallel offsets lies decimetres off, rounding moves it by more than δ.
#[test]
fn what_inputs_within_the_band_explain_is_no_broken_relation() {
    let profile = Profile::builtin("okuma-osp").expect("built in");
    let blocks = generate::program(1, 50_848, Reach::of(&profile));
    let broken = metamorphic::check(&mut Builtin, &profile.parameters, &blocks, &BUDGET);
    assert!(broken.is_empty(), "{:?}", broken.iter().map(|broken| &broken.difference).collect::<Vec<_>>());
}
