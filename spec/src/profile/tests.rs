use super::*;
use crate::AlarmKind;
use crate::clause;

/// A whole profile file of its own name.
fn whole() -> String {
    BUILTIN
        .iter()
        .find(|(name, _)| *name == "mori-lathe")
        .unwrap()
        .1
        .replace("name = \"mori-lathe\"", "name = \"mine\"")
}

#[test]
fn the_built_in_profiles_are_read() {
    for (name, text) in BUILTIN {
        let profile = Profile::builtin(name).unwrap();
        assert_eq!(profile.name, *name);
        assert_eq!(Profile::parse(text, "copy.toml").unwrap(), profile);
        let keys: Vec<_> = profile.provenance.iter().map(|entry| entry.parameter).collect();
        assert_eq!(keys, PARAMETERS.iter().map(|parameter| parameter.key).collect::<Vec<_>>());
    }
    assert!(Profile::builtin("other").is_none());
}

#[test]
fn values_go_to_their_fields() {
    let lathe = Profile::builtin("mori-lathe").unwrap();
    assert_eq!(lathe.machine.plane, Plane::Zx);
    assert_eq!(lathe.machine.least_increment, Ratio { numerator: 1, denominator: 1000 });
    assert_eq!(lathe.parameters.non_moving_allowed, Some(4));
    assert_eq!(lathe.parameters.arc_end_tolerance, Ratio { numerator: 1, denominator: 100 });
    assert_eq!(lathe.parameters.far_intersection, Ratio { numerator: 5, denominator: 1 });
    use Activation::{Absent, Cancel, Left, Right};
    assert_eq!(lathe.activation, [Cancel, Left, Right, Absent, Absent]);
    let entry = lathe.provenance_of("compensation.non-moving-allowed").unwrap();
    assert_eq!((entry.source.as_str(), entry.clause), ("S:seed001", clause::TRC_LOOK_02));
}

/// Each word of each parameter, put into a file, changes one field or none; no two words give the same profile.
#[test]
fn every_word_has_a_value_of_its_own() {
    for parameter in PARAMETERS {
        let table::Values::Word { words, .. } = parameter.values else { continue };
        let mut read: Vec<Profile> = Vec::new();
        for word in words() {
            let clause = parameter.clause.id();
            let text = format!(
                "name = \"a\"\ntitle = \"a\"\nextends = \"seed-mill\"\n[{}]\n{} = {{ value = {word:?}, source = \"D\", clause = {clause:?} }}",
                parameter.table(),
                parameter.name()
            );
            let mut profile = Profile::parse(&text, "a.toml").unwrap();
            assert_eq!(profile.provenance_of(parameter.key).unwrap().value, word);
            profile.provenance.clear();
            assert!(!read.contains(&profile), "{} {word}", parameter.key);
            read.push(profile);
        }
    }
}

#[test]
fn an_extension_changes_what_it_gives_and_nothing_else() {
    let text = r#"
        name = "mine"
        title = "Mine"
        extends = "yasnac-lx"
        [compensation]
        corner-owner = { value = "previous", source = "S:p. 3, D", clause = "TRC-CORNER-12" }
    "#;
    let (mine, base) = (Profile::parse(text, "mine.toml").unwrap(), Profile::builtin("yasnac-lx").unwrap());
    assert_eq!(mine.machine, base.machine);
    assert_eq!(mine.activation, base.activation);
    let owner = crate::parameters::CornerOwner::Previous;
    assert_eq!(mine.parameters, Parameters { corner_owner: owner, ..base.parameters });
    assert_eq!(mine.provenance.len(), base.provenance.len());
    assert_eq!(mine.provenance_of("compensation.corner-owner").unwrap().source, "S:p. 3, D");
}

#[test]
fn a_parameter_left_out_is_missing() {
    for parameter in PARAMETERS {
        let start = format!("{} ", parameter.name());
        let text: Vec<String> = whole().lines().filter(|line| !line.starts_with(&start)).map(String::from).collect();
        let error = Profile::parse(&text.join("\n"), "mine.toml").unwrap_err();
        let missing = ProfileErrorKind::Missing { key: parameter.key.into(), allowed: parameter.allowed() };
        assert_eq!(*error.kind, missing);
        assert_eq!(error.source_line, format!("[{}]", parameter.table()));
    }
}

/// `to` in place of `from` in a whole file: the message must be the one given and point at the text given.
#[test]
fn faults_say_what_would_be_right() {
    #[rustfmt::skip]
    let cases = [
        (r#"value = "zx","#, r#"value = "zy","#, r#""zy""#, r#"`machine.plane` cannot be "zy"; it can be "xy", "zx", "yz""#),
        (r#"value = "zx","#, "value = 18,", "18", r#"`machine.plane` cannot be 18; it can be "xy", "zx", "yz""#),
        (r#"value = "0.001","#, "value = 0.001,", "0.001", r#"`machine.least-increment` cannot be 0.001; it can be a decimal in quotes, greater than 0, such as "0.001""#),
        (r#"value = "0.001","#, r#"value = "0.000","#, r#""0.000""#, r#"`machine.least-increment` cannot be "0.000"; it can be a decimal in quotes, greater than 0, such as "0.001""#),
        (r#"value = "0.01","#, r#"value = "-0.01","#, r#""-0.01""#, r#"`compensation.arc-end-tolerance` cannot be "-0.01"; it can be a decimal in quotes, 0 or greater, such as "0.001""#),
        (r#"value = "0.01","#, r#"value = "1/100","#, r#""1/100""#, r#"`compensation.arc-end-tolerance` cannot be "1/100"; it can be a decimal in quotes, 0 or greater, such as "0.001""#),
        ("value = 4,", "value = 9,", "9", r#"`compensation.non-moving-allowed` cannot be 9; it can be a whole number from 0 to 8, or "unbounded""#),
        (r#"clause = "TRC-LOOK-02""#, r#"clause = "TRC-LOOK-03""#, r#""TRC-LOOK-03""#, r#"`compensation.non-moving-allowed` belongs to the clause "TRC-LOOK-02", not to "TRC-LOOK-03""#),
        (r#"source = "S:seed001", clause = "TRC-LOOK-02""#, r#"source = "S:, D", clause = "TRC-LOOK-02""#, r#""S:, D""#, r#"`compensation.non-moving-allowed` has the source "S:, D"; sources are "S:…" (read in that source), "K" (known), "I" (derived), "D" (decided), separated by commas"#),
        (r#", clause = "TRC-LOOK-02""#, "", r#"{ value = 4,                     source = "S:seed001" }"#, r#"`compensation.non-moving-allowed.clause` is missing; it can be "TRC-LOOK-02""#),
        ("corner-owner ", "corner-ownre ", "corner-ownre", "`compensation.corner-ownre` is not a key of a profile; possible here: `start-up`, `start-up-lost`, `cancel`, `outer-corner`, `reversal`, `side-change`, `side-change-after-start-up`, `non-moving-allowed`, `corner-owner`, `reversed-path`, `arc-end-tolerance`, `far-intersection`, `start-up-b`, `start-up-without-movement`, `start-up-arc`, `cancel-without-movement`, `corner-limit-cosine`, `arc-extension`, `smallest-corner-cosine`, `straight-band-cosine`, `arc-on-rapid`, `small-vector-limit`, `same-code`, `negative-radius`, `equal-radius`, `zero-length-move`, `pending-at-alarm`, `side-code-vector`, `cancel-vector`, `offset-change`, `chord-tolerance`, `centre-tolerance`, `interference`, `interference-blocks`, `interference-boundary`"),
        ("[machine]", "[machines]", "machines", "`machines` is not a key of a profile; possible here: `name`, `title`, `extends`, `machine`, `activation`, `compensation`, `tips`, `alarms`"),
        (r#"name = "mine""#, r#"name = "my mill""#, r#""my mill""#, r#"`name` cannot be "my mill"; it can be lower-case letters, digits and hyphens"#),
        (r#"name = "mine""#, r#"name = "seed-mill""#, r#""seed-mill""#, r#""seed-mill" is a built-in profile that says something else; give the profile a name of its own"#),
        (r#"name = "mine""#, "name = \"mine\"\nextends = \"fanuc\"", r#""fanuc""#, r#"`extends` cannot be "fanuc"; it can be "fanuc-16", "fanuc-30i", "fanuc-30i-b", "haas-a", "haas-b", "linuxcnc", "mitsubishi-m700", "mori-lathe", "okuma-osp", "seed-mill", "siemens-840d", "siemens-840d-g451", "siemens-840d-kont", "siemens-840d-kont-g451", "yasnac-lx""#),
        (r#"name = "mine""#, "name = ", "", "this is not TOML: string values must be quoted, expected literal string"),
    ];
    for (from, to, marked, message) in cases {
        let text = whole().replacen(from, to, 1);
        let error = Profile::parse(&text, "mine.toml").unwrap_err();
        assert_eq!(error.to_string(), format!("mine.toml:{}:{}: {message}", error.line, error.column));
        assert_eq!(text.lines().nth(error.line as usize - 1).unwrap(), error.source_line);
        let (start, length) = (error.column as usize - 1, error.length as usize);
        let found: String = error.source_line.chars().skip(start).take(length).collect();
        assert_eq!(found, marked, "{error}");
    }
}

/// An alarm needs a number or a place in the list of those without; an extension inherits both.
#[test]
fn every_alarm_is_numbered_or_listed() {
    let haas = Profile::builtin("haas-b").unwrap();
    assert_eq!(haas.alarm_number(AlarmKind::ArcAtCancel), Some("341"));
    assert_eq!(haas.alarm_number(AlarmKind::Reversal), None);
    for profile in BUILTIN.iter().map(|(name, _)| Profile::builtin(name).unwrap()) {
        let kinds: Vec<_> = profile.alarms.iter().map(|alarm| alarm.kind).collect();
        assert_eq!(kinds, AlarmKind::ALL, "{}", profile.name);
    }
    let fault = |text: String| Profile::parse(&text, "mine.toml").unwrap_err().kind.to_string();
    assert!(fault(whole().replace("\"reversal\", ", "")).starts_with("`alarms.reversal` is missing"));
    assert!(fault(whole().replace("\"reversal\", ", "\"revresal\", ")).starts_with("`alarms.unnumbered` cannot be"));
    let both = whole().replace("[alarms]\n", "[alarms]\nreversal = { value = \"1\", source = \"D\" }\n");
    assert!(fault(both).contains("not both"));
}

#[test]
fn a_file_that_is_not_there_is_named() {
    let error = Profile::load(Path::new("/nowhere/p.toml")).unwrap_err();
    assert!(error.to_string().starts_with("/nowhere/p.toml: the profile cannot be read: "));
}
