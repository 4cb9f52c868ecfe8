//! Faults planted in a device are found, each with a small counterexample: a certificate that cannot turn red says
//! nothing.

use radcomp::certify::{Campaign, Outcome, Waivers, certify};
use radcomp::device::{Answer, Builtin, Device, DeviceFault};
use radcomp::judge::{Budget, Grade};
use radcomp_spec::parameters::{CornerOwner, OuterCorner, Parameters, StartUpLost};
use radcomp_spec::profile::Profile;
use radcomp_spec::{Block, Compensation, Movement, Segment};
use rug::Rational;

type Blocks = Vec<Block<Rational>>;

/// The implementation behind a fault: what it is told, and what becomes of its answer.
#[derive(Clone, Copy)]
struct Faulty {
    parameters: fn(&mut Parameters),
    program: fn(&mut Blocks),
    answer: fn(&mut Answer),
}

const SOUND: Faulty = Faulty { parameters: |_| {}, program: |_| {}, answer: |_| {} };

impl Device for Faulty {
    fn name(&self) -> &str {
        "faulty"
    }

    fn answer(&mut self, parameters: &Parameters, blocks: &[Block<Rational>]) -> Result<Answer, DeviceFault> {
        let (mut parameters, mut blocks) = (*parameters, blocks.to_vec());
        (self.parameters)(&mut parameters);
        (self.program)(&mut blocks);
        let mut answer = Builtin.answer(&parameters, &blocks)?;
        (self.answer)(&mut answer);
        Ok(answer)
    }
}

fn campaign(device: Faulty) -> Outcome {
    let campaign = Campaign {
        profile: Profile::builtin("yasnac-lx").expect("built in"),
        seed: 1,
        programs: 3_000,
        budget: Budget { grade: Grade::Binary64, least_increment: 0.001, delta: 1e-6 },
        waivers: Waivers::default(),
        threads: 2,
    };
    certify(&campaign, || device, |_| {})
}

#[track_caller]
fn is_found(device: Faulty) {
    let outcome = campaign(device);
    assert!(outcome.tally.red() > 0, "the fault is not found");
    let smallest = outcome.groups.iter().map(|(_, _, failure)| failure.blocks.len()).min().expect("a cause");
    assert!(smallest <= 6, "the smallest counterexample has {smallest} blocks");
}

/// Every coordinate of a path, to be changed.
fn ends(answer: &mut Answer) -> impl Iterator<Item = &mut [f64; 2]> {
    answer.steps.iter_mut().filter_map(|step| match &mut step.segment {
        Segment::Line { end } | Segment::Arc { end, .. } => Some(end),
        Segment::Hold => None,
    })
}

#[test]
fn the_sound_device_is_green() {
    assert_eq!(campaign(SOUND).tally.red(), 0);
}

#[test]
fn the_wrong_side() {
    is_found(Faulty {
        program: |blocks| {
            for block in blocks {
                if let Some(Compensation::On(side)) = &mut block.compensation {
                    *side = side.other();
                }
            }
        },
        ..SOUND
    });
}

#[test]
fn a_swapped_corner_rule() {
    is_found(Faulty {
        parameters: |parameters| parameters.outer_corner = OuterCorner::Arc,
        program: |blocks| blocks.iter_mut().for_each(|block| block.corner = None),
        ..SOUND
    });
}

#[test]
fn look_ahead_one_block_too_short() {
    is_found(Faulty {
        parameters: |parameters| parameters.non_moving_allowed = parameters.non_moving_allowed.map(|count| count - 1),
        ..SOUND
    });
}

#[test]
fn look_ahead_one_block_too_long() {
    is_found(Faulty {
        parameters: |parameters| parameters.non_moving_allowed = parameters.non_moving_allowed.map(|count| count + 1),
        ..SOUND
    });
}

#[test]
fn a_dummy_with_the_other_sign() {
    is_found(Faulty {
        program: |blocks| {
            for block in blocks {
                if let Movement::Dummy { vector } = &mut block.movement {
                    *vector = vector.clone().map(|value| -value);
                }
            }
        },
        ..SOUND
    });
}

#[test]
fn a_start_up_that_ends_without_its_vector() {
    is_found(Faulty { parameters: |parameters| parameters.start_up_lost = StartUpLost::NoVector, ..SOUND });
}

#[test]
fn corner_moves_of_the_wrong_block() {
    is_found(Faulty { parameters: |parameters| parameters.corner_owner = CornerOwner::Previous, ..SOUND });
}

#[test]
fn drift_by_two_millionths() {
    is_found(Faulty { answer: |answer| ends(answer).for_each(|end| end[0] += 2e-6), ..SOUND });
}

#[test]
fn arcs_run_the_other_way() {
    is_found(Faulty {
        answer: |answer| {
            for step in &mut answer.steps {
                if let Segment::Arc { direction, .. } = &mut step.segment {
                    *direction = direction.reversed();
                }
            }
        },
        ..SOUND
    });
}

#[test]
fn numbers_that_are_none() {
    is_found(Faulty { answer: |answer| ends(answer).skip(1).for_each(|end| end[1] = f64::NAN), ..SOUND });
}

#[test]
fn silence() {
    is_found(Faulty { answer: |answer| answer.steps.clear(), ..SOUND });
}

#[test]
fn alarms_kept_back() {
    is_found(Faulty { answer: |answer| answer.alarm = None, ..SOUND });
}

#[test]
fn a_block_without_movement_forgotten() {
    is_found(Faulty { answer: |answer| answer.steps.retain(|step| step.segment != Segment::Hold), ..SOUND });
}

#[test]
fn a_crash() {
    is_found(Faulty { answer: |answer| assert!(answer.alarm.is_none(), "planted"), ..SOUND });
}
