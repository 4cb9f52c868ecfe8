//! The model against the implementation: two readings of one text, on generated programs, under every profile and
//! under every value of every parameter.

use std::path::Path;

use radcomp::certify::{Campaign, Level, Outcome, Waivers, certify};
use radcomp::device::Builtin;
use radcomp::judge::{Budget, Grade};
use radcomp_spec::profile::{BUILTIN, PARAMETERS, Parameter, Profile};

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

/// A profile that changes these parameters of a built-in one, given as `name = value`, by their names in the profile.
fn changed(base: &str, changes: &[String]) -> Profile {
    let changes = changes.iter().map(|change| change.split_once(" = ").expect("name = value"));
    Profile::changed(base, "changed", changes).unwrap_or_else(|error| panic!("{error}"))
}

/// Every value of every parameter, each with others that it meets.
const VARIANTS: &[&str] = &[
    r#"start-up-lost = "no-vector"; non-moving-allowed = 0"#,
    r#"outer-corner = "arc"; non-moving-allowed = 8"#,
    r#"reversal = "alarm"; non-moving-allowed = 1"#,
    r#"side-change = "two-normals"; non-moving-allowed = "unbounded""#,
    r#"side-change = "forbidden""#,
    r#"side-change-after-start-up = "allowed""#,
    r#"side-change = "forbidden"; side-change-after-start-up = "allowed""#,
    r#"side-change = "intersection"; negative-radius = "swaps-sides"; side-change-after-start-up = "allowed""#,
    r#"side-change = "crossing"; negative-radius = "swaps-sides""#,
    r#"corner-owner = "previous""#,
    r#"corner-owner = "previous"; reversed-path = "alarm"; read-ahead-stop = "breaks-look-ahead""#,
    r#"reversed-path = "alarm"; outer-corner = "arc""#,
    r#"arc-end-tolerance = "0""#,
    r#"arc-end-tolerance = "0.005"; far-intersection = "2""#,
    r#"start-up = "type-b"; cancel = "type-b""#,
    r#"start-up = "type-b"; cancel = "type-b"; start-up-b = "direct"; smallest-corner-cosine = "0.6""#,
    r#"start-up = "type-b"; cancel = "type-b"; outer-corner = "arc"; corner-owner = "previous"; reversal = "alarm""#,
    r#"start-up = "type-b"; cancel = "type-b"; arc-extension = "curve"; start-up-lost = "no-vector""#,
    r#"start-up = "type-b"; cancel = "type-b"; outer-corner = "limit-angle"; corner-limit-cosine = "0.6""#,
    r#"start-up = "entry-normal"; negative-radius = "swaps-sides""#,
    r#"start-up = "entry-normal"; start-up-arc = "moved-centre"; side-change = "intersection"; reversed-path = "alarm""#,
    r#"start-up-arc = "moved-centre"; start-up-lost = "no-vector"; same-code = "normal""#,
    r#"start-up = "type-b"; start-up-arc = "moved-centre"; side-change-after-start-up = "allowed""#,
    r#"start-up-without-movement = "shift"; cancel-without-movement = "shift""#,
    r#"start-up-without-movement = "shift"; same-code = "normal"; zero-length-move = "breaks-look-ahead""#,
    r#"start-up-without-movement = "shift"; start-up-lost = "no-vector"; read-ahead-stop = "breaks-look-ahead""#,
    r#"cancel-without-movement = "shift"; cancel = "type-b"; corner-owner = "previous""#,
    r#"outer-corner = "limit-angle"; corner-limit-cosine = "0.6"; reversal = "outer""#,
    r#"outer-corner = "limit-angle"; corner-limit-cosine = "1"; arc-extension = "curve""#,
    r#"arc-extension = "curve"; corner-owner = "previous""#,
    r#"straight-band-cosine = "0.96"; reversed-path = "alarm""#,
    r#"straight-band-cosine = "0.6"; outer-corner = "arc"; arc-on-rapid = "line""#,
    r#"outer-corner = "arc"; arc-on-rapid = "line"; corner-owner = "previous""#,
    r#"small-vector-limit = "0.5""#,
    r#"small-vector-limit = "5"; corner-owner = "previous""#,
    r#"same-code = "normal"; zero-length-move = "breaks-look-ahead"; non-moving-allowed = "unbounded""#,
    r#"same-code = "alarm"; plane-change = "alarm"; reference-return = "alarm"; machine-coordinates = "alarm""#,
    r#"tool-change = "alarm"; canned-cycle = "alarm"; set-coordinates = "alarm"; corner-codes = "g450-g451""#,
    r#"equal-radius = "degenerate-point""#,
    r#"equal-radius = "degenerate-point"; arc-extension = "curve"; negative-radius = "swaps-sides""#,
    r#"equal-radius = "degenerate-point"; side-change = "intersection"; reversed-path = "alarm""#,
    r#"offset-zero = "cancel"; read-ahead-stop = "breaks-look-ahead""#,
    r#"vector-codes = "g38-g39"; corner-owner = "previous"; zero-length-move = "breaks-look-ahead""#,
    r#"vector-codes = "g38-g39"; side-change = "intersection"; same-code = "normal"; reversed-path = "alarm""#,
    r#"side-code-vector = "imaginary-line"; cancel-vector = "imaginary-line"; cancel = "type-b""#,
    r#"side-code-vector = "imaginary-point"; cancel-vector = "imaginary-line"; side-change-after-start-up = "allowed""#,
    r#"side-code-vector = "right-angles"; start-up = "type-b"; cancel-without-movement = "shift""#,
    r#"offset-change = "end-of-block"; negative-radius = "swaps-sides"; side-change = "intersection""#,
    r#"offset-change = "end-of-block"; equal-radius = "degenerate-point"; start-up-without-movement = "shift""#,
    r#"approach-codes = "norm-kont"; outer-corner = "arc"; smallest-corner-cosine = "0.6""#,
    r#"chord-tolerance = "0.5"; centre-tolerance = "0.5"; zero-length-move = "starts-and-cancels""#,
    r#"pending-at-alarm = "lost"; zero-length-move = "starts-and-cancels"; start-up-without-movement = "shift""#,
    r#"interference = "remove-vectors"; interference-boundary = "inclusive""#,
    r#"interference = "remove-vectors"; corner-owner = "previous"; offset-change = "end-of-block""#,
    r#"interference = "alarm"; interference-blocks = "3"; interference-boundary = "inclusive""#,
    r#"interference = "alarm"; interference-blocks = "8"; pending-at-alarm = "lost"; outer-corner = "arc""#,
    r#"interference = "alarm"; interference-blocks = "4"; corner-owner = "previous"; side-change = "intersection""#,
    r#"interference = "avoid"; interference-blocks = "3"; outer-corner = "arc"; same-code = "normal""#,
    r#"interference = "avoid"; interference-blocks = "6"; corner-owner = "previous"; vector-codes = "g38-g39""#,
    r#"interference = "avoid"; interference-blocks = "7"; interference-boundary = "inclusive"; cancel = "type-b""#,
];

fn variants() -> impl Iterator<Item = (&'static str, Profile)> {
    VARIANTS.iter().map(|variant| {
        let changes: Vec<_> = variant.split("; ").map(str::to_owned).collect();
        (*variant, changed("yasnac-lx", &changes))
    })
}

#[test]
fn every_value_of_every_parameter_agrees() {
    for (index, (variant, profile)) in variants().enumerate() {
        assert_green(&run(profile, 100 + index as u64, 6_000), variant);
    }
}

/// The words that a parameter can be; none for a number.
fn words(parameter: &Parameter) -> Vec<String> {
    let allowed = parameter.allowed();
    if allowed.starts_with('"') {
        allowed.split(", ").map(|word| word.trim_matches('"').to_owned()).collect()
    } else {
        Vec::new()
    }
}

/// What compensation and the generator read; the rest is the program reader's, whose tests are data.
fn matters(parameter: &Parameter) -> bool {
    let of_the_reader = ["machine.plane", "machine.x-words", "machine.dummy-first-axis"];
    matches!(parameter.table(), "machine" | "compensation") && !of_the_reader.contains(&parameter.key)
}

#[test]
fn the_variants_and_the_built_in_profiles_have_every_value() {
    let built_in = BUILTIN.iter().map(|(name, _)| Profile::builtin(name).expect("built in"));
    let profiles: Vec<_> = built_in.chain(variants().map(|(_, profile)| profile)).collect();
    let mut missing = Vec::new();
    for parameter in PARAMETERS.iter().filter(|parameter| matters(parameter)) {
        for word in words(parameter) {
            let has = |profile: &Profile| profile.provenance_of(parameter.key).is_some_and(|entry| entry.value == word);
            if !profiles.iter().any(has) {
                missing.push(format!("{} = {word}", parameter.key));
            }
        }
    }
    assert_eq!(missing, Vec::<String>::new());
}

/// The profiles of `tests/combinations`: rules that no control has together meet too.
fn combinations() -> Vec<Profile> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/combinations");
    let mut files: Vec<_> = std::fs::read_dir(folder).expect("is there").map(|file| file.expect("is").path()).collect();
    files.sort();
    files.iter().map(|file| Profile::load(file).unwrap_or_else(|error| panic!("{error}"))).collect()
}

/// A quarter of the programs of level 1: `make certify-pairs` runs all.
#[test]
fn combinations_of_values_agree() {
    for (index, profile) in combinations().into_iter().enumerate() {
        let name = profile.name.clone();
        assert_green(&run(profile, 500 + index as u64, 6_000), &name);
    }
}

#[test]
fn any_two_values_of_two_parameters_meet_in_a_combination() {
    let combinations = combinations();
    let values: Vec<(&str, Vec<String>)> = PARAMETERS
        .iter()
        .filter(|parameter| matters(parameter) && !of_the_reader_alone(parameter))
        .map(|parameter| (parameter.key, words(parameter)))
        .collect();
    let has = |profile: &Profile, key, word: &str| profile.provenance_of(key).is_some_and(|entry| entry.value == word);
    let mut missing = Vec::new();
    for (index, (one, words)) in values.iter().enumerate() {
        for (other, other_words) in &values[..index] {
            for (word, other_word) in words.iter().flat_map(|word| other_words.iter().map(move |other| (word, other))) {
                if !combinations.iter().any(|profile| has(profile, one, word) && has(profile, other, other_word)) {
                    missing.push(format!("{one} = {word} and {other} = {other_word}"));
                }
            }
        }
    }
    assert!(missing.is_empty(), "{} pairs: {:?}", missing.len(), missing.iter().take(10).collect::<Vec<_>>());
}

/// Codes that the reader refuses or turns into an alarm, and nothing else.
fn of_the_reader_alone(parameter: &Parameter) -> bool {
    let names = [
        "plane-change",
        "reference-return",
        "machine-coordinates",
        "set-coordinates",
        "canned-cycle",
        "offset-zero",
        "tool-change",
    ];
    names.contains(&parameter.name())
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
