//! The model against the implementation: two readings of one text, on generated programs, under every profile and
//! under every value of every parameter.

use radcomp::certify::{Campaign, Level, Outcome, Waivers, certify};
use radcomp::device::Builtin;
use radcomp::judge::{Budget, Grade};
use radcomp_spec::parameters::*;
use radcomp_spec::profile::{BUILTIN, Profile};

fn run(profile: Profile, seed: u64, programs: u64) -> Outcome {
    let budget = Budget { grade: Grade::Binary64, least_increment: 0.001, delta: 1e-6 };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    certify(&Campaign { profile, seed, programs, budget, waivers: Waivers::default(), threads }, || Builtin, |_| {})
}

fn assert_green(outcome: &Outcome, what: &str) {
    let failures: Vec<_> = outcome.failures.iter().take(10).map(ToString::to_string).collect();
    assert_eq!(outcome.tally.red(), 0, "{what}:\n{}", failures.join("\n"));
}

#[test]
fn a_hundred_thousand_corners_agree_under_the_built_in_profiles() {
    let mut corners = 0;
    for (name, _) in BUILTIN {
        let outcome = run(Profile::builtin(name).expect("built in"), 1, Level::One.programs());
        assert_green(&outcome, name);
        corners += outcome.tally.corners;
    }
    assert!(corners >= 100_000, "{corners} corners");
}

#[test]
fn every_value_of_every_parameter_agrees() {
    let base = Profile::builtin("yasnac-lx").expect("built in");
    let ratio = |numerator, denominator| Ratio { numerator, denominator };
    let p = base.parameters;
    let variants = [
        Parameters { start_up_lost: StartUpLost::NoVector, non_moving_allowed: 0, ..p },
        Parameters { outer_corner: OuterCorner::Arc, non_moving_allowed: MOST_NON_MOVING, ..p },
        Parameters { reversal: Reversal::Alarm, non_moving_allowed: 1, ..p },
        Parameters { side_change: SideChange::TwoNormals, ..p },
        Parameters { side_change: SideChange::Forbidden, ..p },
        Parameters { side_change_after_start_up: SideChangeAfterStartUp::Allowed, ..p },
        Parameters {
            side_change: SideChange::Forbidden,
            side_change_after_start_up: SideChangeAfterStartUp::Allowed,
            ..p
        },
        Parameters { corner_owner: CornerOwner::Previous, ..p },
        Parameters { corner_owner: CornerOwner::Previous, reversed_path: ReversedPath::Alarm, ..p },
        Parameters { reversed_path: ReversedPath::Alarm, outer_corner: OuterCorner::Arc, ..p },
        Parameters { arc_end_tolerance: ratio(0, 1), ..p },
        Parameters { arc_end_tolerance: ratio(5, 1000), far_intersection: ratio(2, 1), ..p },
    ];
    for (index, parameters) in variants.into_iter().enumerate() {
        let outcome = run(Profile { parameters, ..base.clone() }, 100 + index as u64, 6_000);
        assert_green(&outcome, &format!("{parameters:?}"));
    }
}

#[test]
fn a_seed_gives_the_same_result_on_any_number_of_threads() {
    let campaign = |threads| {
        let budget = Budget { grade: Grade::Binary64, least_increment: 0.001, delta: 1e-6 };
        let profile = Profile::builtin("seed-mill").expect("built in");
        let outcome = certify(
            &Campaign { profile, seed: 7, programs: 700, budget, waivers: Waivers::default(), threads },
            || Builtin,
            |_| {},
        );
        outcome.tally
    };
    assert_eq!(campaign(1), campaign(3));
}
