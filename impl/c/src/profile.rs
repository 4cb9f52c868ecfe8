//! The parameters of a profile as text: a line `name = value` for each, so that the interface stays as it is when there
//! are more of them.

use radcomp_spec::Parameters;
use radcomp_spec::parameters::{
    ArcExtension, ArcOnRapid, Cancel, CancelVector, CancelWithoutMovement, CornerOwner, EqualRadius, Interference,
    InterferenceBlocks, InterferenceBoundary, MOST_NON_MOVING, NegativeRadius, OffsetChange, OuterCorner,
    PendingAtAlarm, Ratio, Reversal, ReversedPath, SameCode, SideChange, SideChangeAfterStartUp, SideCodeVector,
    StartUp, StartUpArc, StartUpB, StartUpLost, StartUpWithoutMovement, ZeroLengthMove,
};

/// Every name.
const NAMES: [&str; 35] = [
    "start-up",
    "start-up-lost",
    "cancel",
    "outer-corner",
    "reversal",
    "side-change",
    "side-change-after-start-up",
    "non-moving-allowed",
    "corner-owner",
    "reversed-path",
    "arc-end-tolerance",
    "far-intersection",
    "start-up-b",
    "start-up-without-movement",
    "start-up-arc",
    "cancel-without-movement",
    "corner-limit-cosine",
    "arc-extension",
    "smallest-corner-cosine",
    "straight-band-cosine",
    "arc-on-rapid",
    "small-vector-limit",
    "same-code",
    "negative-radius",
    "equal-radius",
    "zero-length-move",
    "pending-at-alarm",
    "side-code-vector",
    "cancel-vector",
    "offset-change",
    "chord-tolerance",
    "centre-tolerance",
    "interference",
    "interference-blocks",
    "interference-boundary",
];

/// The parameters that a text gives: each of the compensation's parameters once, by the names and values of
/// `spec/PARAMETERS.md`, decimals without quotes. Empty lines are passed over. None if a line is anything else, or a
/// parameter is missing.
pub fn parameters(text: &str) -> Option<Parameters> {
    let mut count = 0;
    for (name, _) in entries(text) {
        if !NAMES.contains(&name?) {
            return None;
        }
        count += 1;
    }
    // As many as there are, and each is found below: none stands twice.
    if count != NAMES.len() {
        return None;
    }
    Some(Parameters {
        start_up: word(text, "start-up", StartUp::VALUES)?,
        start_up_lost: word(text, "start-up-lost", StartUpLost::VALUES)?,
        cancel: word(text, "cancel", Cancel::VALUES)?,
        outer_corner: word(text, "outer-corner", OuterCorner::VALUES)?,
        reversal: word(text, "reversal", Reversal::VALUES)?,
        side_change: word(text, "side-change", SideChange::VALUES)?,
        side_change_after_start_up: word(text, "side-change-after-start-up", SideChangeAfterStartUp::VALUES)?,
        non_moving_allowed: match value(text, "non-moving-allowed")? {
            "unbounded" => None,
            count => Some(count.parse().ok().filter(|count| *count <= MOST_NON_MOVING)?),
        },
        corner_owner: word(text, "corner-owner", CornerOwner::VALUES)?,
        reversed_path: word(text, "reversed-path", ReversedPath::VALUES)?,
        arc_end_tolerance: ratio(value(text, "arc-end-tolerance")?)?,
        far_intersection: ratio(value(text, "far-intersection")?)?,
        start_up_b: word(text, "start-up-b", StartUpB::VALUES)?,
        start_up_without_movement: word(text, "start-up-without-movement", StartUpWithoutMovement::VALUES)?,
        start_up_arc: word(text, "start-up-arc", StartUpArc::VALUES)?,
        cancel_without_movement: word(text, "cancel-without-movement", CancelWithoutMovement::VALUES)?,
        corner_limit_cosine: ratio(value(text, "corner-limit-cosine")?)?,
        arc_extension: word(text, "arc-extension", ArcExtension::VALUES)?,
        smallest_corner_cosine: ratio(value(text, "smallest-corner-cosine")?)?,
        straight_band_cosine: ratio(value(text, "straight-band-cosine")?)?,
        arc_on_rapid: word(text, "arc-on-rapid", ArcOnRapid::VALUES)?,
        small_vector_limit: ratio(value(text, "small-vector-limit")?)?,
        same_code: word(text, "same-code", SameCode::VALUES)?,
        negative_radius: word(text, "negative-radius", NegativeRadius::VALUES)?,
        equal_radius: word(text, "equal-radius", EqualRadius::VALUES)?,
        zero_length_move: word(text, "zero-length-move", ZeroLengthMove::VALUES)?,
        pending_at_alarm: word(text, "pending-at-alarm", PendingAtAlarm::VALUES)?,
        side_code_vector: word(text, "side-code-vector", SideCodeVector::VALUES)?,
        cancel_vector: word(text, "cancel-vector", CancelVector::VALUES)?,
        offset_change: word(text, "offset-change", OffsetChange::VALUES)?,
        chord_tolerance: ratio(value(text, "chord-tolerance")?)?,
        centre_tolerance: ratio(value(text, "centre-tolerance")?)?,
        interference: word(text, "interference", Interference::VALUES)?,
        interference_blocks: word(text, "interference-blocks", InterferenceBlocks::VALUES)?,
        interference_boundary: word(text, "interference-boundary", InterferenceBoundary::VALUES)?,
    })
}

/// Names and values; a name is none where a line has no `=`.
fn entries(text: &str) -> impl Iterator<Item = (Option<&str>, &str)> {
    text.lines().map(str::trim).filter(|line| !line.is_empty()).map(|line| match line.split_once('=') {
        Some((name, value)) => (Some(name.trim()), value.trim()),
        None => (None, line),
    })
}

fn value<'t>(text: &'t str, wanted: &str) -> Option<&'t str> {
    entries(text).find(|(name, _)| *name == Some(wanted)).map(|(_, value)| value)
}

fn word<T: Copy>(text: &str, name: &str, values: &[(&str, T)]) -> Option<T> {
    let id = value(text, name)?;
    values.iter().find(|(known, _)| *known == id).map(|(_, value)| *value)
}

/// Reads a decimal such as `0.01`, or a ratio such as `1/3`: digits, with at most one point or stroke between two of them.
/// None if the text is anything else, a part of it is more than 2³² - 1, or the denominator is zero.
pub fn ratio(text: &str) -> Option<Ratio> {
    if let Some((numerator, denominator)) = text.split_once('/') {
        let (numerator, denominator) = (digits(numerator, 0)?, digits(denominator, 0)?);
        return (denominator > 0).then_some(Ratio { numerator, denominator });
    }
    match text.split_once('.') {
        None => Some(Ratio { numerator: digits(text, 0)?, denominator: 1 }),
        Some((whole, decimals)) => {
            let numerator = digits(decimals, digits(whole, 0)?)?;
            Some(Ratio { numerator, denominator: 10_u32.checked_pow(u32::try_from(decimals.len()).ok()?)? })
        }
    }
}

/// The number that has these digits, of which there is at least one, after those of `before`.
fn digits(text: &str, before: u32) -> Option<u32> {
    let mut value = before;
    for byte in text.bytes() {
        let digit = char::from(byte).to_digit(10)?;
        value = value.checked_mul(10)?.checked_add(digit)?;
    }
    (!text.is_empty()).then_some(value)
}
