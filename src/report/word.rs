//! Ids: clauses, alarms, decisions and choices by the names that the specification gives them.

use std::cmp::Ordering;

use radcomp_spec::clause::{self, Clause};
use radcomp_spec::parameters::{
    Approach, ArcExtension, ArcOnRapid, Cancel, CancelVector, CancelWithoutMovement, CornerOwner, EqualRadius,
    Interference, InterferenceBlocks, InterferenceBoundary, NegativeRadius, OffsetChange, OuterCorner, PendingAtAlarm,
    Reversal, ReversedPath, SameCode, SideChange, SideChangeAfterStartUp, SideCodeVector, StartUp, StartUpArc,
    StartUpB, StartUpLost, StartUpWithoutMovement, ZeroLengthMove,
};
use radcomp_spec::{AlarmKind, Compensation, DecisionKind, Direction, Side};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::text;

/// A value that has a name.
pub trait Word: Copy + PartialEq + 'static {
    /// What such a value is, for messages.
    const WHAT: &'static str;

    /// Every value with its name.
    fn all() -> Vec<(&'static str, Self)>;
}

/// A value that a report writes as its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Id<T>(pub T);

impl<T: Word> Serialize for Id<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match T::all().into_iter().find(|(_, value)| *value == self.0) {
            Some((id, _)) => serializer.serialize_str(id),
            None => Err(serde::ser::Error::custom(format!("a {} without a name", T::WHAT))),
        }
    }
}

impl<'de, T: Word> Deserialize<'de> for Id<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let find = |text: &str| T::all().into_iter().find(|(id, _)| *id == text).map(|(_, value)| Id(value));
        text::read(deserializer, &format!("the name of a {}", T::WHAT), find)
    }
}

macro_rules! choices {
    ($($type:ident = $what:literal;)*) => {$(
        impl Word for $type {
            const WHAT: &'static str = $what;

            fn all() -> Vec<(&'static str, Self)> {
                $type::VALUES.to_vec()
            }
        }
    )*};
}

choices! {
    StartUp = "start-up";
    StartUpLost = "start-up-lost";
    Cancel = "cancel";
    OuterCorner = "outer corner";
    Reversal = "reversal";
    SideChange = "side-change";
    SideChangeAfterStartUp = "side-change-after-start-up";
    CornerOwner = "corner-owner";
    ReversedPath = "reversed-path";
    Approach = "approach";
    Interference = "interference";
    InterferenceBlocks = "interference-blocks";
    InterferenceBoundary = "interference-boundary";
    StartUpB = "start-up-b";
    StartUpWithoutMovement = "start-up-without-movement";
    StartUpArc = "start-up-arc";
    CancelWithoutMovement = "cancel-without-movement";
    ArcExtension = "arc-extension";
    ArcOnRapid = "arc-on-rapid";
    SameCode = "same-code";
    PendingAtAlarm = "pending-at-alarm";
    SideCodeVector = "side-code-vector";
    CancelVector = "cancel-vector";
    OffsetChange = "offset-change";
    NegativeRadius = "negative-radius";
    EqualRadius = "equal-radius";
    ZeroLengthMove = "zero-length-move";
}

macro_rules! words {
    ($($type:ident = $what:literal: $all:expr;)*) => {$(
        impl Word for $type {
            const WHAT: &'static str = $what;

            fn all() -> Vec<(&'static str, Self)> {
                $all
            }
        }
    )*};
}

words! {
    Clause = "clause": clause::ALL.iter().map(|(clause, _)| (clause.id(), *clause)).collect();
    AlarmKind = "alarm": AlarmKind::ALL.iter().map(|kind| (kind.id(), *kind)).collect();
    DecisionKind = "decision": DecisionKind::ALL.iter().map(|kind| (kind.id(), *kind)).collect();
    Direction = "direction": vec![("cw", Direction::Clockwise), ("ccw", Direction::Counterclockwise)];
    Compensation = "compensation": vec![
        ("off", Compensation::Off),
        ("left", Compensation::On(Side::Left)),
        ("right", Compensation::On(Side::Right)),
    ];
    Ordering = "sign": vec![
        ("negative", Ordering::Less),
        ("zero", Ordering::Equal),
        ("positive", Ordering::Greater),
    ];
}
