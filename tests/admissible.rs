//! What the set of admissible outcomes is: it holds the exact outcome, grows with the band, and outside of every band it
//! holds nothing else.

use std::cmp::Ordering;

use radcomp::boundary::{self, Triple};
use radcomp::device::{Answer, Device, DeviceFault};
use radcomp::generate::{self, Reach};
use radcomp::judge::{Budget, Grade, Judged, Verdict, judge};
use radcomp_model::number::Real;
use radcomp_model::{Decision, Engine, Run, Sink, run};
use radcomp_spec::profile::Profile;
use radcomp_spec::{AdvisoryKind, Block, DecisionKind, Movement, Parameters, Segment, Step};
use rug::Rational;

type Blocks = Vec<Block<Rational>>;

const DELTA: f64 = 1e-6;

/// A device that answers the exact outcome of another program.
struct ExactOf<'a>(&'a [Block<Rational>]);

impl Device for ExactOf<'_> {
    fn name(&self) -> &str {
        "exact"
    }

    fn answer(&mut self, parameters: &Parameters, _: &[Block<Rational>]) -> Result<Answer, DeviceFault> {
        Ok(rounded(&run(parameters, self.0)))
    }
}

/// A device with this answer.
struct Fixed(Answer);

impl Device for Fixed {
    fn name(&self) -> &str {
        "fixed"
    }

    fn answer(&mut self, _: &Parameters, _: &[Block<Rational>]) -> Result<Answer, DeviceFault> {
        Ok(self.0.clone())
    }
}

fn rounded(run: &Run) -> Answer {
    let point = |point: &[Real; 2]| point.each_ref().map(Real::to_f64);
    let steps = run.steps.iter().map(|step| Step {
        block: step.block,
        clause: step.clause,
        rapid: step.rapid,
        main: step.main,
        segment: match &step.segment {
            Segment::Hold => Segment::Hold,
            Segment::Line { end } => Segment::Line { end: point(end) },
            Segment::Arc { end, centre, direction, full } => {
                Segment::Arc { end: point(end), centre: point(centre), direction: *direction, full: *full }
            }
        },
    });
    Answer { steps: steps.collect(), alarm: run.alarm }
}

fn profile() -> Profile {
    Profile::builtin("seed-mill").expect("built in")
}

/// Profiles that give vectors by words of the program and change the offset value in mode.
fn profiles_with_vectors() -> impl Iterator<Item = Profile> {
    let built_in = ["fanuc-16", "mitsubishi-m700", "okuma-osp"].map(|name| Profile::builtin(name).expect("built in"));
    let changes = [("vector-codes", "\"g38-g39\""), ("side-code-vector", "\"imaginary-line\"")];
    built_in.into_iter().chain(Profile::changed("seed-mill", "changed", changes))
}

/// Generated programs and boundary programs.
fn programs(count: u64) -> impl Iterator<Item = Blocks> {
    programs_of(&profile(), count)
}

fn programs_of(profile: &Profile, count: u64) -> impl Iterator<Item = Blocks> + use<> {
    let reach = Reach::of(profile);
    let generated = (0..count).map(move |number| generate::program(11, number, reach));
    generated.chain(boundary::all(11, count / 40, reach).flat_map(|triple| triple.programs))
}

/// A budget whose band is so many millimetres wide.
fn band(beta: f64) -> Budget {
    Budget { grade: Grade::Resolution, least_increment: 2.0 * beta, delta: DELTA }
}

#[test]
fn the_exact_outcome_is_admissible_without_any_band() {
    for blocks in programs(2_000) {
        let Judged { verdict, .. } = judge(&mut ExactOf(&blocks), &profile().parameters, &blocks, &band(0.0));
        assert!(matches!(verdict, Verdict::Exact), "{verdict:?}\n{blocks:?}");
    }
}

#[test]
fn the_exact_outcome_is_admissible_where_the_program_gives_vectors() {
    for profile in profiles_with_vectors() {
        for blocks in programs_of(&profile, 600) {
            let Judged { verdict, .. } = judge(&mut ExactOf(&blocks), &profile.parameters, &blocks, &band(0.0));
            assert!(matches!(verdict, Verdict::Exact), "{}: {verdict:?}\n{blocks:?}", profile.name);
            let Judged { verdict, .. } = judge(&mut ExactOf(&blocks), &profile.parameters, &blocks, &band(1e-10));
            assert!(!verdict.is_red(), "{}: {verdict:?}\n{blocks:?}", profile.name);
        }
    }
}

/// The program with each point moved by half of the band in either coordinate, one way or the other. Points that are one
/// stay one: a move of no length has no direction that a small change could give it.
fn shaken(blocks: &[Block<Rational>], beta: f64, seed: usize) -> Blocks {
    let step = Rational::from_f64(beta * 0.5).expect("finite");
    let mut signs = seed;
    let mut shake = |value: &mut Rational| {
        signs = signs.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        if signs >> 40 & 1 == 0 { *value += &step } else { *value -= &step }
    };
    let mut known: Vec<([Rational; 2], [Rational; 2])> = Vec::new();
    let mut moved = blocks.to_vec();
    for block in &mut moved {
        if let Movement::Line { end } | Movement::Arc { end, .. } = &mut block.movement {
            let image = known.iter().find(|(point, _)| point == end).map(|(_, image)| image.clone());
            let image = image.unwrap_or_else(|| {
                let mut image = end.clone();
                image.iter_mut().for_each(&mut shake);
                image
            });
            known.push((end.clone(), image.clone()));
            *end = image;
        }
    }
    moved
}

#[test]
fn outcomes_of_inputs_within_the_band_are_admissible_and_stay_so_in_a_wider_one() {
    const BETA: f64 = 1e-10;
    let (mut exact, mut admissible) = (0, 0);
    // The centre of a half turn with R follows its ends as their square root does: the search may miss its witness.
    let half_turn = |blocks: &Blocks| {
        let exact = run(&profile().parameters, blocks);
        exact.decisions.iter().any(|(it, _)| it.kind == DecisionKind::ChordFits && it.exact == Ordering::Equal)
    };
    for (seed, blocks) in programs(40).filter(|blocks| !half_turn(blocks)).enumerate() {
        let neighbour = shaken(&blocks, BETA, seed);
        let mut before = None;
        for beta in [BETA / 16.0, BETA, 16.0 * BETA] {
            let verdict = judge(&mut ExactOf(&neighbour), &profile().parameters, &blocks, &band(beta)).verdict;
            // The neighbour lies within these bands. A full search is no refutation.
            let inside = beta >= BETA;
            let refuted = matches!(verdict, Verdict::Inadmissible(_));
            assert!(!(inside && refuted), "β = {beta}: {verdict:?}\n{blocks:?}\n{neighbour:?}");
            assert!(before != Some(true) || !refuted, "admitted by a narrower band than {beta}: {verdict:?}");
            before = Some(!verdict.is_red());
            exact += u64::from(matches!(verdict, Verdict::Exact));
            admissible += u64::from(matches!(verdict, Verdict::Admissible(_)));
        }
    }
    assert!(exact > 50 && admissible > 2, "{exact} exact, {admissible} admissible");
}

/// Whether some input within the band takes another branch.
struct AnyOpen(f64, bool);

impl Sink for AnyOpen {
    fn decide(&mut self, decision: Decision) -> Ordering {
        let (low, high) = decision.margin.reach(self.0);
        let settled = low > 0.0 || high < 0.0;
        self.1 |= decision.kind.shapes_the_path() && !settled;
        decision.exact
    }
}

fn has_open_decision(parameters: &Parameters, blocks: &[Block<Rational>], beta: f64) -> bool {
    let mut open = AnyOpen(beta, false);
    let mut engine = Engine::on_inputs(parameters);
    let ended = blocks.iter().try_for_each(|block| engine.push(block, &mut open));
    let _alarm = ended.and_then(|()| engine.finish(&mut open));
    open.1
}

/// Moves the end of an element that starts at `at` sideways by 4δ: along it, a straight move split in two would stay what
/// it is. Answers the element's extent, and moves `at` on.
fn beside(segment: &mut Segment<f64>, at: &mut [f64; 2]) -> Option<f64> {
    let from = *at;
    let (end, normal) = match segment {
        Segment::Hold => return None,
        Segment::Line { end } => {
            let normal = [from[1] - end[1], end[0] - from[0]];
            (end, normal)
        }
        Segment::Arc { end, centre, .. } => {
            let normal = [end[0] - centre[0], end[1] - centre[1]];
            (end, normal)
        }
    };
    *at = *end;
    let length = normal[0].hypot(normal[1]);
    (0..2).for_each(|axis| end[axis] += 4.0 * DELTA * normal[axis] / length);
    Some(length)
}

#[test]
fn outside_every_band_there_is_one_outcome_to_within_delta() {
    const BETA: f64 = 1e-10;
    let profile = profile();
    let mut judged = 0;
    for blocks in programs(400) {
        let exact = run(&profile.parameters, &blocks);
        // A vector far from its corner moves by more than δ with the program's numbers.
        let far = exact.advisories.iter().any(|advisory| advisory.kind == AdvisoryKind::FarIntersection);
        if far || has_open_decision(&profile.parameters, &blocks, BETA) {
            continue;
        }
        let answer = rounded(&exact);
        let mut at = [0.0, 0.0];
        for index in 0..answer.steps.len() {
            let mut off = answer.clone();
            let Some(end) = beside(&mut off.steps[index].segment, &mut at) else { continue };
            if end < 8.0 * DELTA {
                continue;
            }
            judged += 1;
            let verdict = judge(&mut Fixed(off), &profile.parameters, &blocks, &band(BETA)).verdict;
            assert!(matches!(verdict, Verdict::Inadmissible(_)), "element {index}: {verdict:?}\n{blocks:?}");
        }
    }
    assert!(judged > 1_000, "{judged}");
}

#[test]
fn a_device_that_is_off_by_more_than_the_band_is_always_caught() {
    // One least increment to either side of a decision: a million times the band. The device mistakes one neighbour for
    // the other.
    let budget = Budget { grade: Grade::Binary64, least_increment: 0.001, delta: DELTA };
    for name in ["seed-mill", "mori-lathe", "yasnac-lx"] {
        let profile = Profile::builtin(name).expect("built in");
        let (mut caught, mut alike) = (0, 0);
        for triple in boundary::all(5, 40, Reach::of(&profile)) {
            let Triple { programs: [below, _, above], .. } = &triple;
            for (asked, answered) in [(below, above), (above, below)] {
                let verdict = judge(&mut ExactOf(answered), &profile.parameters, asked, &budget).verdict;
                match verdict {
                    Verdict::Inadmissible(_) => caught += 1,
                    // Where one outcome is the other, there is nothing to catch.
                    Verdict::Exact => alike += 1,
                    other => panic!("{} ({}): {other:?}", triple.kind.id(), triple.family),
                }
            }
        }
        println!("{name}: {caught} caught, {alike} times the outcomes were one");
        assert!(caught > 10 * alike, "{name}: {caught} caught, {alike} alike");
    }
}
