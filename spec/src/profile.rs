//! Profiles: the choices that the rules leave to a control, read from TOML files that say where each choice comes from.
//!
//! A profile gives every parameter, with a value, a source tag and the clause that the parameter belongs to. Nothing has
//! a default: a file that leaves a parameter out is refused, unless it says `extends` and names a built-in profile to
//! take the rest from. [`PARAMETERS`] is the one table of names, meanings, values and clauses. Each alarm has the
//! control's own number with its source, or is listed as unnumbered.
//!
//! ```
//! use radcomp_spec::profile::Profile;
//! let text = r#"
//!     name = "my-lathe"
//!     title = "Our LX lathe, G43 tried out on the machine"
//!     extends = "yasnac-lx"
//!     [activation]
//!     G43 = { value = "left", source = "D", clause = "TRC-PLANE-05" }
//! "#;
//! let profile = Profile::parse(text, "my-lathe.toml")?;
//! assert_eq!(profile.parameters, Profile::builtin("yasnac-lx").unwrap().parameters);
//! # Ok::<(), radcomp_spec::profile::ProfileError>(())
//! ```

mod alarms;
#[cfg(test)]
mod dialects;
mod error;
#[cfg(test)]
mod page;
mod read;
mod table;
#[cfg(test)]
mod tests;

use std::path::Path;

pub use error::{ProfileError, ProfileErrorKind};
pub use table::{PARAMETERS, Parameter};

use crate::clause::Clause;
use crate::outcome::AlarmKind;
use crate::parameters::{
    Activation, ApproachCodes, CornerCodes, Dummy, InMode, Measure, OffsetZero, Parameters, Plane, Ratio,
    ReadAheadStop, Tip, ToolChange, VectorCodes,
};

/// A control, as far as compensation can tell it from others.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Profile {
    /// The name that commands and reports use: lower-case letters, digits and hyphens.
    pub name: String,
    /// What the profile describes, for people.
    pub title: String,
    /// What the program reader asks.
    pub machine: Machine,
    /// What G40, G41, G42, G43 and G44 mean, in this order ([TRC-PLANE-05]).
    pub activation: [Activation; 5],
    /// What compensation asks.
    pub parameters: Parameters,
    /// Where the imaginary tip of each orientation T0 to T9 stands ([TRC-TIP-01]).
    pub tips: [Tip; 10],
    /// The control's own name of each alarm: one entry for each of [`AlarmKind::ALL`], in its order.
    pub alarms: Vec<AlarmNumber>,
    /// Where each value comes from: one entry for each of [`PARAMETERS`], in its order.
    pub provenance: Vec<Provenance>,
}

/// The parameters that say how programs are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Machine {
    /// Plane in force when a program starts ([TRC-PLANE-01]).
    pub plane: Plane,
    /// X words as radius or diameter values ([TRC-PLANE-03]).
    pub x_words: Measure,
    /// The least input increment, in millimetres; positive.
    pub least_increment: Ratio,
    /// Whether there are dummy blocks ([TRC-DUMMY-01]).
    pub dummy: Dummy,
    /// The I word of a dummy block as radius or diameter value ([TRC-DUMMY-05]).
    pub dummy_first_axis: Measure,
    /// Which codes choose the outer corner ([TRC-CORNER-11]).
    pub corner_codes: CornerCodes,
    /// Codes that choose start-up and cancel.
    pub approach_codes: ApproachCodes,
    /// A change of plane in mode ([TRC-MODE-08]).
    pub plane_change: InMode,
    /// G28, G29 and G30 in mode ([TRC-MODE-08]).
    pub reference_return: InMode,
    /// G53 in mode ([TRC-MODE-08]).
    pub machine_coordinates: InMode,
    /// G92, or G50 of a lathe, in mode ([TRC-MODE-08]).
    pub set_coordinates: InMode,
    /// M06 in mode ([TRC-MODE-08]).
    pub tool_change: ToolChange,
    /// Canned cycles in mode ([TRC-MODE-08]).
    pub canned_cycle: InMode,
    /// M00, M01, M02 and M30 in mode ([TRC-LOOK-08]).
    pub read_ahead_stop: ReadAheadStop,
    /// Offset number 0 ([TRC-CANCEL-07]).
    pub offset_zero: OffsetZero,
    /// Whether there are G38 and G39 ([TRC-VEC-01]).
    pub vector_codes: VectorCodes,
}

/// What the control itself calls an alarm.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AlarmNumber {
    /// The alarm.
    pub kind: AlarmKind,
    /// The control's number or text; none if the sources give none, or the control has no such alarm.
    pub number: Option<String>,
    /// The source tags of the number; empty if there is none.
    pub source: String,
}

/// Where the value of one parameter comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Provenance {
    /// The parameter's key, such as `compensation.corner-owner`.
    pub parameter: &'static str,
    /// The value, as the file writes it.
    pub value: String,
    /// The source tags: `S:…` read in that source, `K` known, `I` derived, `D` decided by this project.
    pub source: String,
    /// The clause that says what the parameter does.
    pub clause: Clause,
}

/// The built-in profiles: name and file text.
pub const BUILTIN: &[(&str, &str)] = &[
    ("fanuc-16", include_str!("../profiles/fanuc-16.toml")),
    ("fanuc-30i", include_str!("../profiles/fanuc-30i.toml")),
    ("fanuc-30i-b", include_str!("../profiles/fanuc-30i-b.toml")),
    ("haas-a", include_str!("../profiles/haas-a.toml")),
    ("haas-b", include_str!("../profiles/haas-b.toml")),
    ("linuxcnc", include_str!("../profiles/linuxcnc.toml")),
    ("mitsubishi-m700", include_str!("../profiles/mitsubishi-m700.toml")),
    ("mori-lathe", include_str!("../profiles/mori-lathe.toml")),
    ("okuma-osp", include_str!("../profiles/okuma-osp.toml")),
    ("seed-mill", include_str!("../profiles/seed-mill.toml")),
    ("siemens-840d", include_str!("../profiles/siemens-840d.toml")),
    ("siemens-840d-g451", include_str!("../profiles/siemens-840d-g451.toml")),
    ("siemens-840d-kont", include_str!("../profiles/siemens-840d-kont.toml")),
    ("siemens-840d-kont-g451", include_str!("../profiles/siemens-840d-kont-g451.toml")),
    ("yasnac-lx", include_str!("../profiles/yasnac-lx.toml")),
];

impl Profile {
    /// The built-in profile of this name.
    pub fn builtin(name: &str) -> Option<Profile> {
        let (name, text) = BUILTIN.iter().find(|(builtin, _)| *builtin == name)?;
        // A test parses every one of these constant texts.
        Some(read::read(text, name).expect("a built-in profile is well-formed"))
    }

    /// Reads a profile from the text of its file; `file_name` is only for messages.
    ///
    /// # Errors
    ///
    /// The first fault of the file, with its place and what would be right there. A file that has the name of a
    /// built-in profile but differs from it is refused too: a report that names the profile would mislead.
    pub fn parse(text: &str, file_name: &str) -> Result<Profile, ProfileError> {
        read::read_foreign(text, file_name)
    }

    /// Reads a profile from a file.
    ///
    /// # Errors
    ///
    /// As [`Profile::parse`], and when the file cannot be read or is not UTF-8.
    pub fn load(path: &Path) -> Result<Profile, ProfileError> {
        let file_name = path.display().to_string();
        match std::fs::read_to_string(path) {
            Ok(text) => Profile::parse(&text, &file_name),
            Err(reason) => Err(ProfileError::unreadable(&file_name, &reason)),
        }
    }

    /// A built-in profile with other values of some parameters: pairs of a parameter's name and its value as a profile's
    /// file has it, `("start-up", "\"type-b\"")`.
    ///
    /// # Errors
    ///
    /// As [`Profile::parse`]; the messages speak of a file with the profile's name, one line for each change after three.
    pub fn changed<N: AsRef<str>, V: core::fmt::Display>(
        base: &str,
        name: &str,
        changes: impl IntoIterator<Item = (N, V)>,
    ) -> Result<Profile, ProfileError> {
        let mut text = format!("name = {name:?}\ntitle = {name:?}\nextends = {base:?}\n");
        for (parameter, value) in changes {
            let ends = format!(".{}", parameter.as_ref());
            let known = PARAMETERS.iter().find(|known| known.key.ends_with(&ends));
            let (key, clause) = match known {
                Some(known) => (known.key, known.clause.id()),
                None => (parameter.as_ref(), ""),
            };
            text += &format!("{key} = {{ value = {value}, source = \"D\", clause = {clause:?} }}\n");
        }
        Profile::parse(&text, name)
    }

    /// What the control itself calls an alarm, where its sources say so.
    pub fn alarm_number(&self, kind: AlarmKind) -> Option<&str> {
        self.alarms.iter().find(|alarm| alarm.kind == kind)?.number.as_deref()
    }

    /// Where the value of the parameter with this key comes from; none if there is no such parameter.
    pub fn provenance_of(&self, key: &str) -> Option<&Provenance> {
        self.provenance.iter().find(|entry| entry.parameter == key)
    }
}
