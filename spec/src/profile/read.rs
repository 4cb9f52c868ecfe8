//! Reading a profile file.

use core::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::error::{ProfileError, ProfileErrorKind, shown};
use super::table::{PARAMETERS, Parameter, Values};
use super::{BUILTIN, Machine, Profile, Provenance};
use crate::parameters::*;

/// Reads a file that is not built in, and so may not pass for one that is.
pub(super) fn read_foreign(text: &str, file: &str) -> Result<Profile, ProfileError> {
    let (profile, name) = Source { text, file }.profile()?;
    match Profile::builtin(&profile.name) {
        Some(builtin) if builtin != profile => {
            Err(ProfileError::at(file, text, name, ProfileErrorKind::NameTaken(profile.name)))
        }
        _ => Ok(profile),
    }
}

/// Reads a profile file.
pub(super) fn read(text: &str, file: &str) -> Result<Profile, ProfileError> {
    Ok(Source { text, file }.profile()?.0)
}

/// A file that is being read.
pub(super) struct Source<'a> {
    pub(super) text: &'a str,
    file: &'a str,
}

/// A table whose keys and values have places.
pub(super) type Table<'a> = DeTable<'a>;

impl Source<'_> {
    /// The profile, and where its name stands.
    fn profile(&self) -> Result<(Profile, Range<usize>), ProfileError> {
        let document = DeTable::parse(self.text).map_err(|error| {
            let kind = ProfileErrorKind::Malformed(error.message().to_owned());
            self.error(error.span().unwrap_or_default(), kind)
        })?;
        let root = document.get_ref();
        self.known(root, "", &["name", "title", "extends", "machine", "activation", "compensation", "tips", "alarms"])?;
        let whole = 0..0;
        let name = self.text_of(root, "name", "name", "lower-case letters, digits and hyphens, in quotes", &whole)?;
        let title = self.text_of(root, "title", "title", "a text in quotes", &whole)?;
        let mut profile = self.base(root)?.unwrap_or_else(blank);
        let simple = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
        if name.get_ref().is_empty() || !name.get_ref().chars().all(simple) {
            let allowed = "lower-case letters, digits and hyphens";
            return Err(self.wrong(name.span(), "name", allowed));
        }
        let place = name.span();
        profile.name = name.into_inner().to_owned();
        profile.title = title.into_inner().to_owned();
        for table in ["machine", "activation", "compensation", "tips"] {
            self.table(root, table, &mut profile)?;
        }
        self.alarms(root, &mut profile)?;
        Ok((profile, place))
    }

    /// The profile that the file extends.
    fn base(&self, root: &Table<'_>) -> Result<Option<Profile>, ProfileError> {
        let Some(extends) = root.get("extends") else { return Ok(None) };
        match extends.get_ref().as_str().and_then(Profile::builtin) {
            Some(base) => Ok(Some(base)),
            None => {
                let names: Vec<String> = BUILTIN.iter().map(|(name, _)| format!("{name:?}")).collect();
                Err(self.wrong(extends.span(), "extends", &names.join(", ")))
            }
        }
    }

    /// Reads the parameters of one table into the profile.
    fn table(&self, root: &Table<'_>, table: &str, profile: &mut Profile) -> Result<(), ProfileError> {
        let parameters = || PARAMETERS.iter().filter(move |parameter| parameter.table() == table);
        let found = match root.get(table) {
            None => None,
            Some(value) => match value.get_ref().as_table() {
                Some(found) => Some((found, value.span())),
                None => return Err(self.wrong(value.span(), table, "a table of parameters")),
            },
        };
        if let Some((found, _)) = &found {
            self.known(found, table, &parameters().map(Parameter::name).collect::<Vec<_>>())?;
        }
        for parameter in parameters() {
            let given = found.as_ref().and_then(|(found, _)| found.get(parameter.name()));
            if let Some(given) = given {
                self.parameter(parameter, given, profile)?;
            } else if profile.provenance_of(parameter.key).is_none() {
                let place = found.as_ref().map_or(0..0, |(_, span)| span.clone());
                return Err(self.missing(&place, parameter.key, &parameter.allowed()));
            }
        }
        Ok(())
    }

    /// The source tags at the key `source`.
    pub(super) fn source_of(&self, table: &Table<'_>, key: &str, place: &Range<usize>) -> Result<String, ProfileError> {
        let tags = "source tags in quotes, such as \"D\"";
        let source = self.text_of(table, "source", &format!("{key}.source"), tags, place)?;
        if !source.get_ref().split(',').all(|tag| is_source_tag(tag.trim())) {
            let found = shown(&self.text[source.span()]);
            return Err(self.error(source.span(), ProfileErrorKind::WrongSource { key: key.to_owned(), found }));
        }
        Ok(source.into_inner().to_owned())
    }

    /// Reads one parameter: `{ value = …, source = "…", clause = "…" }`.
    fn parameter(
        &self,
        parameter: &Parameter,
        given: &Spanned<DeValue<'_>>,
        profile: &mut Profile,
    ) -> Result<(), ProfileError> {
        let key = parameter.key;
        let Some(table) = given.get_ref().as_table() else {
            let clause = parameter.clause.id();
            let allowed = format!(
                "{{ value = …, source = \"D\", clause = {clause:?} }}, the value being {}",
                parameter.allowed()
            );
            return Err(self.wrong(given.span(), key, &allowed));
        };
        self.known(table, key, &["value", "source", "clause"])?;
        let Some(value) = table.get("value") else {
            return Err(self.missing(&given.span(), &format!("{key}.value"), &parameter.allowed()));
        };
        let Some(written) = assign(parameter, value.get_ref(), profile) else {
            return Err(self.wrong(value.span(), key, &parameter.allowed()));
        };
        let source = self.source_of(table, key, &given.span())?;
        let expected = parameter.clause;
        let id = format!("{:?}", expected.id());
        let clause = self.text_of(table, "clause", &format!("{key}.clause"), &id, &given.span())?;
        if *clause.get_ref() != expected.id() {
            let found = shown(&self.text[clause.span()]);
            return Err(
                self.error(clause.span(), ProfileErrorKind::WrongClause { key: key.to_owned(), found, expected })
            );
        }
        let entry = Provenance { parameter: key, value: written, source, clause: expected };
        match profile.provenance.iter_mut().find(|entry| entry.parameter == key) {
            Some(inherited) => *inherited = entry,
            None => profile.provenance.push(entry),
        }
        Ok(())
    }

    /// Refuses keys other than these; of several the first in the file.
    pub(super) fn known(&self, table: &Table<'_>, key: &str, names: &[&str]) -> Result<(), ProfileError> {
        let unknown = table.keys().filter(|name| !names.contains(&&**name.get_ref()));
        let Some(first) = unknown.min_by_key(|name| name.span().start) else { return Ok(()) };
        let dot = if key.is_empty() { "" } else { "." };
        let allowed = names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
        let key = format!("{key}{dot}{}", shown(first.get_ref()));
        Err(self.error(first.span(), ProfileErrorKind::Unknown { key, allowed }))
    }

    /// The text at a key that must be there.
    pub(super) fn text_of<'t>(
        &self,
        table: &'t Table<'_>,
        name: &str,
        key: &str,
        allowed: &str,
        place: &Range<usize>,
    ) -> Result<Spanned<&'t str>, ProfileError> {
        let value = table.get(name).ok_or_else(|| self.missing(place, key, allowed))?;
        let text = value.get_ref().as_str().ok_or_else(|| self.wrong(value.span(), key, allowed))?;
        Ok(Spanned::new(value.span(), text))
    }

    pub(super) fn missing(&self, place: &Range<usize>, key: &str, allowed: &str) -> ProfileError {
        self.error(place.clone(), ProfileErrorKind::Missing { key: key.to_owned(), allowed: allowed.to_owned() })
    }

    pub(super) fn wrong(&self, span: Range<usize>, key: &str, allowed: &str) -> ProfileError {
        let found = shown(self.text.get(span.clone()).unwrap_or_default());
        let kind = ProfileErrorKind::WrongValue { key: key.to_owned(), found, allowed: allowed.to_owned() };
        self.error(span, kind)
    }

    fn error(&self, span: Range<usize>, kind: ProfileErrorKind) -> ProfileError {
        ProfileError::at(self.file, self.text, span, kind)
    }
}

/// Puts a value into the parameter's field and gives it back as text; none if it is not one of the allowed ones.
fn assign(parameter: &Parameter, value: &DeValue<'_>, profile: &mut Profile) -> Option<String> {
    match &parameter.values {
        Values::Word { set, .. } => {
            let word = value.as_str()?;
            set(profile, word).then(|| word.to_owned())
        }
        Values::Count { most, field } => {
            if value.as_str() == Some("unbounded") {
                *field(profile) = None;
                return Some("unbounded".to_owned());
            }
            let integer = value.as_integer()?;
            let number = u8::from_str_radix(integer.as_str(), integer.radix()).ok().filter(|number| number <= most)?;
            *field(profile) = Some(number);
            Some(format!("{number}"))
        }
        Values::Cosine { field } => {
            let text = value.as_str()?;
            let ratio = parse_ratio(text).filter(|ratio| ratio.numerator <= ratio.denominator)?;
            *field(profile) = ratio;
            Some(text.to_owned())
        }
        Values::Decimal { positive, field } => {
            let text = value.as_str()?;
            let ratio = parse_ratio(text).filter(|ratio| ratio.numerator > 0 || !positive)?;
            *field(profile) = ratio;
            Some(text.to_owned())
        }
    }
}

/// A decimal such as `0.01`, in lowest terms, so that equal values are equal ratios.
fn parse_ratio(text: &str) -> Option<Ratio> {
    let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
    let digits = |part: &str| part.bytes().all(|byte| byte.is_ascii_digit());
    if whole.is_empty() || text.ends_with('.') || !digits(whole) || !digits(fraction) {
        return None;
    }
    let numerator: u32 = format!("{whole}{fraction}").parse().ok()?;
    let denominator = 10_u32.checked_pow(u32::try_from(fraction.len()).ok()?)?;
    let divisor = greatest_common_divisor(numerator, denominator);
    Some(Ratio { numerator: numerator / divisor, denominator: denominator / divisor })
}

/// Positive, as `b` is.
fn greatest_common_divisor(a: u32, b: u32) -> u32 {
    if a == 0 { b } else { greatest_common_divisor(b % a, a) }
}

fn is_source_tag(tag: &str) -> bool {
    matches!(tag, "K" | "I" | "D") || tag.strip_prefix("S:").is_some_and(|source| !source.trim().is_empty())
}

/// A profile to read into. None of its values stays: a file gives every one, or is refused.
fn blank() -> Profile {
    let none = Ratio { numerator: 0, denominator: 1 };
    Profile {
        name: String::new(),
        title: String::new(),
        machine: Machine {
            plane: Plane::Xy,
            x_words: Measure::Radius,
            least_increment: none,
            dummy: Dummy::None,
            dummy_first_axis: Measure::Radius,
            corner_codes: CornerCodes::None,
            approach_codes: ApproachCodes::None,
            plane_change: InMode::Unsupported,
            reference_return: InMode::Unsupported,
            machine_coordinates: InMode::Unsupported,
            set_coordinates: InMode::Unsupported,
            tool_change: ToolChange::Unsupported,
            canned_cycle: InMode::Unsupported,
            read_ahead_stop: ReadAheadStop::NoMovement,
            offset_zero: OffsetZero::Refused,
            vector_codes: VectorCodes::None,
        },
        activation: [Activation::Absent; 5],
        parameters: Parameters {
            start_up: StartUp::TypeA,
            start_up_lost: StartUpLost::Normal,
            cancel: Cancel::TypeA,
            outer_corner: OuterCorner::Intersection,
            reversal: Reversal::Alarm,
            side_change: SideChange::Forbidden,
            side_change_after_start_up: SideChangeAfterStartUp::Alarm,
            non_moving_allowed: Some(0),
            corner_owner: CornerOwner::Next,
            reversed_path: ReversedPath::Alarm,
            arc_end_tolerance: none,
            far_intersection: none,
            start_up_b: StartUpB::Direct,
            start_up_without_movement: StartUpWithoutMovement::None,
            start_up_arc: StartUpArc::Alarm,
            cancel_without_movement: CancelWithoutMovement::None,
            corner_limit_cosine: none,
            arc_extension: ArcExtension::Tangent,
            smallest_corner_cosine: none,
            straight_band_cosine: none,
            arc_on_rapid: ArcOnRapid::Arc,
            small_vector_limit: none,
            same_code: SameCode::Alarm,
            negative_radius: NegativeRadius::Alarm,
            equal_radius: EqualRadius::Alarm,
            zero_length_move: ZeroLengthMove::NoMovement,
            pending_at_alarm: PendingAtAlarm::Ended,
            side_code_vector: SideCodeVector::Refused,
            cancel_vector: CancelVector::Refused,
            offset_change: OffsetChange::Alarm,
            chord_tolerance: none,
            centre_tolerance: none,
            interference: Interference::Off,
            interference_blocks: InterferenceBlocks::Three,
            interference_boundary: InterferenceBoundary::Strict,
        },
        tips: [Tip::Absent; 10],
        alarms: Vec::new(),
        provenance: Vec::new(),
    }
}
