//! The control's profile, whole: a file that reads back to it.

use std::fmt::Write;

use radcomp_spec::profile::{PARAMETERS, Profile};

/// The profile as the text of a profile file that gives every parameter with its source and clause, whatever the file it
/// was read from extends. Equal profiles have equal texts.
pub fn profile_text(profile: &Profile) -> String {
    let mut text = format!("name = {}\ntitle = {}\n", quoted(&profile.name), quoted(&profile.title));
    let mut table = "";
    for parameter in PARAMETERS {
        let Some(given) = profile.provenance_of(parameter.key) else { continue };
        if parameter.table() != table {
            table = parameter.table();
            // Writing to a string does not fail, here and below.
            let _ = write!(text, "\n[{table}]\n");
        }
        // Only counts stand without quotes; a count may have a word beside it.
        let allowed = parameter.allowed();
        let is_count = allowed.starts_with("a whole number") && given.value.bytes().all(|byte| byte.is_ascii_digit());
        let value = if allowed.contains('"') && !is_count { quoted(&given.value) } else { given.value.clone() };
        let (name, source, clause) = (parameter.name(), quoted(&given.source), quoted(given.clause.id()));
        let _ = writeln!(text, "{name} = {{ value = {value}, source = {source}, clause = {clause} }}");
    }
    let _ = write!(text, "\n[alarms]\n");
    let mut unnumbered = Vec::new();
    for alarm in &profile.alarms {
        match &alarm.number {
            Some(number) => {
                let (number, source) = (quoted(number), quoted(&alarm.source));
                let _ = writeln!(text, "{} = {{ value = {number}, source = {source} }}", alarm.kind.id());
            }
            None => unnumbered.push(quoted(alarm.kind.id())),
        }
    }
    let _ = writeln!(text, "unnumbered = [{}]", unnumbered.join(", "));
    text
}

/// A basic string of TOML.
fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for character in text.chars() {
        match character {
            '"' | '\\' => quoted.extend(['\\', character]),
            control if control.is_control() => {
                let _ = write!(quoted, "\\u{:04X}", u32::from(control));
            }
            other => quoted.push(other),
        }
    }
    quoted.push('"');
    quoted
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_profile_reads_back() {
        for (name, _) in radcomp_spec::profile::BUILTIN {
            let mut profile = Profile::builtin(name).unwrap();
            assert_eq!(Profile::parse(&profile_text(&profile), "text").unwrap(), profile);
            profile.name.push_str("-of-ours");
            profile.title = "\"quoted\" \\ and\ttabbed".to_owned();
            profile.parameters.non_moving_allowed = Some(1);
            let place = profile.provenance.iter().position(|entry| entry.parameter.ends_with("non-moving-allowed"));
            profile.provenance[place.unwrap()].value = "1".to_owned();
            assert_eq!(Profile::parse(&profile_text(&profile), "text").unwrap(), profile);
        }
    }
}
