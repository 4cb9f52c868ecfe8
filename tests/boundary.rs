//! Boundary synthesis: the triples lie where they say, and the builtin device answers them admissibly.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::time::Instant;

use radcomp::boundary::{self, Triple};
use radcomp::device::{Answer, Builtin, Device, DeviceFault};
use radcomp::gcode::print_blocks;
use radcomp::generate::Reach;
use radcomp::judge::{Budget, Grade, Verdict, judge};
use radcomp_model::{Decision, Run, run};
use radcomp_spec::parameters::Parameters;
use radcomp_spec::profile::{BUILTIN, Profile};
use radcomp_spec::{Block, DecisionKind, Movement};
use rug::Rational;

const SEED: u64 = 1;
const PER_KIND: u64 = 60;
const BUDGET: Budget = Budget { grade: Grade::Binary64, least_increment: 0.001, delta: 1e-6 };

/// Limits with decimal angles, which no built-in profile has, and rules that none has together.
const OWN: &[(&str, &str)] = &[
    (
        "type-b-small",
        r#"start-up = "type-b"; cancel = "type-b"; smallest-corner-cosine = "0.6"; start-up-b = "direct""#,
    ),
    ("cancel-b-small", r#"cancel = "type-b"; smallest-corner-cosine = "0.28""#),
    ("limit", r#"outer-corner = "limit-angle"; corner-limit-cosine = "0.6""#),
    ("limit-0", r#"outer-corner = "limit-angle"; arc-extension = "curve""#),
    ("band", r#"straight-band-cosine = "0.96"; outer-corner = "arc""#),
    ("small", r#"small-vector-limit = "4""#),
    ("curve", r#"arc-extension = "curve"; side-change = "intersection""#),
    ("avoid", r#"interference = "avoid""#),
    ("avoid-far", r#"interference = "avoid"; interference-blocks = "8"; outer-corner = "arc""#),
    ("tolerances", r#"centre-tolerance = "0.002"; chord-tolerance = "0.005""#),
    ("entry", r#"start-up = "entry-normal"; start-up-arc = "moved-centre""#),
];

fn own(name: &str, changes: &str) -> Profile {
    let changes = changes.split("; ").filter_map(|change| change.split_once(" = "));
    Profile::changed("seed-mill", name, changes).expect("a profile")
}

fn profiles() -> impl Iterator<Item = Profile> {
    let built_in = BUILTIN.iter().map(|(name, _)| Profile::builtin(name).expect("built in"));
    built_in.chain(OWN.iter().map(|(name, changes)| own(name, changes)))
}

#[test]
fn every_decision_is_asked_by_a_profile() {
    for kind in DecisionKind::ALL {
        assert!(profiles().any(|profile| boundary::is_asked(*kind, Reach::of(&profile))), "{}", kind.id());
    }
}

/// The decisions of a kind, each with its block and its place among those of that block.
fn decisions(run: &Run, kind: DecisionKind) -> Vec<((usize, usize), &Decision)> {
    let mut seen: BTreeMap<usize, usize> = BTreeMap::new();
    let of_kind = run.decisions.iter().map(|(decision, _)| decision).filter(|decision| decision.kind == kind);
    of_kind
        .map(|decision| {
            let place = seen.entry(decision.block).or_default();
            *place += 1;
            ((decision.block, *place), decision)
        })
        .collect()
}

/// Why a triple does not lie as it says; nothing if it does.
fn misplaced(triple: &Triple, profile: &Profile) -> Option<String> {
    let [below, on, above] = triple.programs.each_ref();
    misplaced_about(on, [below, above], triple, profile).or_else(|| {
        let [below, above] = triple.beside.as_ref()?;
        misplaced_about(on, [below, above], triple, profile)
    })
}

fn misplaced_about(
    on: &[Block<Rational>],
    neighbours: [&Vec<Block<Rational>>; 2],
    triple: &Triple,
    profile: &Profile,
) -> Option<String> {
    let runs = [neighbours[0], on, neighbours[1]].map(|blocks| run(&profile.parameters, blocks));
    let [below, on, above] = runs.each_ref().map(|run| decisions(run, triple.kind));
    let wanted = if triple.two_sided { Ordering::Less } else { Ordering::Greater };
    let mut seen = Vec::new();
    for (place, _) in on.iter().filter(|(_, decision)| decision.margin.is_zero()) {
        let sign = |decisions: &[((usize, usize), &Decision)]| {
            decisions.iter().find(|(other, _)| other == place).map(|(_, decision)| decision.margin.sign())
        };
        let signs = (sign(&below), sign(&above));
        if signs == (Some(wanted), Some(Ordering::Greater)) {
            return None;
        }
        seen.push(signs);
    }
    Some(format!("{} ({}): {seen:?}", triple.kind.id(), triple.family))
}

fn listing(blocks: &[Block<Rational>], profile: &Profile) -> String {
    print_blocks(blocks, profile).map_or_else(|error| error.to_string(), |listing| listing.program)
}

#[test]
fn every_triple_lies_on_its_decision() {
    for profile in profiles() {
        for kind in DecisionKind::ALL {
            let reach = Reach::of(&profile);
            for number in (0..PER_KIND).filter(|_| boundary::is_asked(*kind, reach)) {
                let triple = boundary::with_beside(*kind, SEED, number, reach).expect("a contour is found");
                let wrong = misplaced(&triple, &profile);
                assert_eq!(wrong, None, "{} #{number}\n{}", profile.name, listing(&triple.programs[1], &profile));
            }
        }
    }
}

#[test]
fn every_program_has_three_decimals_or_six_and_can_be_written() {
    for profile in profiles() {
        let reach = Reach::of(&profile);
        for kind in DecisionKind::ALL {
            let plain = |number| boundary::triples(*kind, SEED, number, reach);
            let any_size = |number| boundary::with_beside(*kind, SEED, number, reach);
            (0..PER_KIND / 3).filter_map(plain).for_each(|triple| assert_written(&triple, 1_000, &profile));
            (0..PER_KIND / 3).filter_map(any_size).for_each(|triple| assert_written(&triple, 1_000_000, &profile));
        }
    }
}

/// Every number is a whole number of such parts of a millimetre.
fn assert_written(triple: &Triple, parts: u32, profile: &Profile) {
    let is_whole = |value: &Rational| *Rational::from(value * parts).denom() == 1;
    for blocks in &triple.programs {
        print_blocks(blocks, profile).unwrap_or_else(|error| panic!("{} {error}", triple.kind.id()));
        for block in blocks {
            let end = match &block.movement {
                Movement::Line { end } | Movement::Arc { end, .. } => end.as_slice(),
                _ => &[],
            };
            assert!(end.iter().chain(&block.radius).all(is_whole), "{block:?}");
        }
    }
}

/// What lies far outside of the band would not tell a device that compares with a tolerance of its own.
#[test]
fn the_programs_beside_lie_just_outside_of_the_band() {
    let profile = Profile::builtin("seed-mill").expect("built in");
    let (mut beside, mut outside) = (0, 0);
    for triple in boundary::all(SEED, PER_KIND / 3, Reach::of(&profile)) {
        for blocks in triple.beside.iter().flatten() {
            let beta = BUDGET.beta(blocks);
            let run = run(&profile.parameters, blocks);
            let nearest =
                decisions(&run, triple.kind).iter().map(|(_, taken)| taken.margin.abs().to_f64()).fold(1.0, f64::min);
            assert!(nearest < 1e6 * beta, "{}: {nearest} mm, β is {beta}", triple.kind.id());
            beside += 1;
            outside += u64::from(nearest > beta);
        }
    }
    // Angles move less than points do.
    assert!(outside * 100 >= beside * 95, "{outside} of {beside}");
}

#[test]
fn one_seed_gives_the_same_triples() {
    let reach = Reach::of(&Profile::builtin("seed-mill").expect("built in"));
    let triples = |seed| boundary::all(seed, 3, reach).collect::<Vec<_>>();
    assert_eq!(triples(7), triples(7));
    assert_ne!(triples(7), triples(8));
}

#[test]
fn the_builtin_device_answers_every_triple_admissibly() {
    for profile in profiles() {
        for triple in boundary::all(SEED, PER_KIND, Reach::of(&profile)) {
            let names = Triple::NAMES.iter().chain(&Triple::BESIDE);
            for (name, blocks) in names.zip(triple.programs.iter().chain(triple.beside.iter().flatten())) {
                let verdict = judge(&mut Builtin, &profile.parameters, blocks, &BUDGET).verdict;
                let what = format!("{} {} {name} ({})", profile.name, triple.kind.id(), triple.family);
                assert!(!verdict.is_red(), "{what}: {verdict:?}\n{}", listing(blocks, &profile));
            }
        }
    }
}

/// A device that answers another program than the one it is asked.
struct Mistaken<'a>(&'a [Block<Rational>]);

impl Device for Mistaken<'_> {
    fn name(&self) -> &str {
        "mistaken"
    }

    fn answer(&mut self, parameters: &Parameters, _: &[Block<Rational>]) -> Result<Answer, DeviceFault> {
        Builtin.answer(parameters, self.0)
    }
}

#[test]
fn a_device_that_is_one_increment_off_is_caught() {
    let profile = Profile::builtin("seed-mill").expect("built in");
    let (mut asked, mut caught) = (0, 0);
    let reach = Reach::of(&profile);
    let triples = DecisionKind::ALL
        .iter()
        .flat_map(|kind| (0..PER_KIND / 3).filter_map(move |number| boundary::triples(*kind, SEED, number, reach)));
    for triple in triples {
        for answered in [0, 2] {
            let mut device = Mistaken(&triple.programs[answered]);
            asked += 1;
            caught += u64::from(judge(&mut device, &profile.parameters, &triple.programs[1], &BUDGET).verdict.is_red());
        }
    }
    // Where both programs end in the same alarm, or the nudged number shapes no path, the answers are one.
    assert!(caught * 10 >= asked * 9, "{caught} of {asked}");
}

/// What lies beside the boundary taken for what lies on it: seen wherever the clause goes another way there, and not where
/// both ways lead to one path to within δ, as at a tangent.
#[test]
fn a_device_with_a_tolerance_of_its_own_is_caught() {
    let mut caught: BTreeMap<&str, (u32, u32)> = BTreeMap::new();
    for profile in profiles() {
        for triple in boundary::all(SEED, PER_KIND / 6, Reach::of(&profile)) {
            let counts = caught.entry(triple.kind.id()).or_default();
            for blocks in triple.beside.iter().flatten() {
                let mut device = Mistaken(&triple.programs[1]);
                counts.0 += u32::from(judge(&mut device, &profile.parameters, blocks, &BUDGET).verdict.is_red());
                counts.1 += 1;
            }
        }
    }
    let never = caught.iter().filter(|(_, counts)| counts.0 == 0 && counts.1 > 0).map(|(kind, _)| *kind);
    assert_eq!(never.collect::<Vec<_>>(), [""; 0], "{caught:?}");
}

/// Exactly fitting slots, arcs of exactly the tool's radius, exact reversals and tangent joins: ten thousand of them,
/// turned, mirrored and moved by up to ten metres, and their neighbours.
#[test]
#[ignore = "thirty thousand programs"]
fn ten_thousand_exact_fits_are_admissible() {
    const EACH: u64 = 2_500;
    let profile = Profile::builtin("seed-mill").expect("built in");
    let reach = Reach::of(&profile);
    let kinds = [DecisionKind::LineForward, DecisionKind::ArcForward, DecisionKind::ToolFitsArc, DecisionKind::Turn];
    let mut verdicts: BTreeMap<&str, [u64; 3]> = BTreeMap::new();
    let mut bare = Vec::new();
    let started = Instant::now();
    for kind in kinds {
        let others = ["side change straight on", "side change on a reversal", "sweeps half a turn apart"];
        let exact_fit = |triple: &Triple| !others.contains(&triple.family);
        let triples = (0..).filter_map(|number| boundary::triples(kind, SEED + 1, number, reach)).filter(exact_fit);
        for triple in triples.take(EACH as usize) {
            for (place, blocks) in triple.programs.iter().enumerate() {
                let verdict = judge(&mut Builtin, &profile.parameters, blocks, &BUDGET).verdict;
                verdicts.entry(verdict.id()).or_default()[place] += 1;
                let what = format!("{} {} ({})", kind.id(), Triple::NAMES[place], triple.family);
                assert!(!verdict.is_red(), "{what}: {verdict:?}\n{}", listing(blocks, &profile));
                if let Verdict::AdmissibleWithoutWitness(flips) = &verdict {
                    bare.push(format!("{what}: {flips:?}\n{}", listing(blocks, &profile)));
                }
            }
        }
    }
    let programs = verdicts.values().flatten().sum::<u64>();
    let speed = programs as f64 / started.elapsed().as_secs_f64();
    println!("{programs} programs, {speed:.0} a second: {verdicts:?}\n{}", bare[..bare.len().min(5)].join("\n"));
    assert!(bare.len() as u64 * 100 < programs, "{} without witness", bare.len());
}
