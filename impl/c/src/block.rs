//! Blocks as C sees them.

use crate::step::{RADCOMP_NAME, kind, name};
use radcomp_spec::{Approach, Block, Centre, Compensation, Direction, Movement, OuterCorner, Side};

/// No movement in the plane.
pub const RADCOMP_NONE: u32 = 0;
/// A straight move to `end`.
pub const RADCOMP_LINE: u32 = 1;
/// A circular move to `end`; `centre` is the vector from the start to the centre.
pub const RADCOMP_ARC: u32 = 2;
/// A circular move to `end`; `centre[0]` is the R word, negative for the arc of more than a half turn.
pub const RADCOMP_ARC_RADIUS: u32 = 3;
/// A dummy block: `end` is its vector.
pub const RADCOMP_DUMMY: u32 = 4;
/// G38 with a straight move to `end`: the vector is held.
pub const RADCOMP_HELD_VECTOR: u32 = 5;
/// G38 with I, J, K: a new vector, at right angles to `end`, which is incremental.
pub const RADCOMP_NEW_VECTOR: u32 = 6;
/// G39 with a direction: a corner arc to the vector at right angles to `end`, which is incremental.
pub const RADCOMP_CORNER_TO_VECTOR: u32 = 7;
/// G39 alone: a corner arc to the next element.
pub const RADCOMP_CORNER_TO_NEXT: u32 = 8;

/// G02.
pub const RADCOMP_CLOCKWISE: u32 = 0;
/// G03.
pub const RADCOMP_COUNTERCLOCKWISE: u32 = 1;

/// The block has no such code.
pub const RADCOMP_UNCHANGED: u32 = 0;
/// Compensation off.
pub const RADCOMP_OFF: u32 = 1;
/// Compensation on, the tool left of the path.
pub const RADCOMP_LEFT: u32 = 2;
/// Compensation on, the tool right of the path.
pub const RADCOMP_RIGHT: u32 = 3;
/// Outer corners by intersection.
pub const RADCOMP_INTERSECTION: u32 = 1;
/// Outer corners by an arc.
pub const RADCOMP_CORNER_ARC: u32 = 2;
/// Outer corners by intersection down to the limit angle of the profile, by an arc below it.
pub const RADCOMP_LIMIT_ANGLE: u32 = 3;

/// NORM: start-up and cancel of type A.
pub const RADCOMP_NORM: u32 = 1;
/// KONT: start-up and cancel of type B.
pub const RADCOMP_KONT: u32 = 2;

/// One block of a program, modal codes, units and diameters resolved.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct radcomp_block {
    /// RADCOMP_NONE, RADCOMP_LINE, RADCOMP_ARC, RADCOMP_ARC_RADIUS, RADCOMP_DUMMY, RADCOMP_HELD_VECTOR,
    /// RADCOMP_NEW_VECTOR, RADCOMP_CORNER_TO_VECTOR or RADCOMP_CORNER_TO_NEXT.
    pub movement: u32,
    /// RADCOMP_CLOCKWISE or RADCOMP_COUNTERCLOCKWISE, of an arc.
    pub direction: u32,
    /// Not 0: at rapid traverse.
    pub rapid: u32,
    /// RADCOMP_UNCHANGED, RADCOMP_OFF, RADCOMP_LEFT or RADCOMP_RIGHT.
    pub compensation: u32,
    /// RADCOMP_UNCHANGED, RADCOMP_INTERSECTION, RADCOMP_CORNER_ARC or RADCOMP_LIMIT_ANGLE.
    pub corner: u32,
    /// RADCOMP_UNCHANGED, RADCOMP_NORM or RADCOMP_KONT.
    pub approach: u32,
    /// Not 0: a code that loses the look-ahead.
    pub stops_look_ahead: u32,
    /// Not 0: the block puts `radius` in force.
    pub has_radius: u32,
    /// The tool radius.
    pub radius: f64,
    /// The end point, absolute.
    pub end: [f64; 2],
    /// The centre of an arc.
    pub centre: [f64; 2],
    /// Not 0: I, J, K stand beside the compensation code, and `vector` is theirs.
    pub has_vector: u32,
    /// The incremental vector beside the compensation code.
    pub vector: [f64; 2],
    /// The alarm of a code that is not for offset mode, such as "tool-change-in-mode", with a zero at its end; empty for
    /// none.
    pub not_in_mode: [core::ffi::c_char; RADCOMP_NAME],
}

impl Default for radcomp_block {
    fn default() -> Self {
        radcomp_block {
            movement: RADCOMP_NONE,
            direction: RADCOMP_CLOCKWISE,
            rapid: 0,
            compensation: RADCOMP_UNCHANGED,
            corner: RADCOMP_UNCHANGED,
            approach: RADCOMP_UNCHANGED,
            stops_look_ahead: 0,
            has_radius: 0,
            radius: 0.0,
            end: [0.0; 2],
            centre: [0.0; 2],
            has_vector: 0,
            vector: [0.0; 2],
            not_in_mode: [0; RADCOMP_NAME],
        }
    }
}

impl radcomp_block {
    /// The block in the words of the specification; none if a value is none.
    pub fn block(&self) -> Option<Block<f64>> {
        let direction = match self.direction {
            RADCOMP_CLOCKWISE => Direction::Clockwise,
            RADCOMP_COUNTERCLOCKWISE => Direction::Counterclockwise,
            _ => return None,
        };
        let movement = match self.movement {
            RADCOMP_NONE => Movement::None,
            RADCOMP_LINE => Movement::Line { end: self.end },
            RADCOMP_ARC => Movement::Arc { end: self.end, centre: Centre::FromStart(self.centre), direction },
            RADCOMP_ARC_RADIUS => Movement::Arc { end: self.end, centre: Centre::Radius(self.centre[0]), direction },
            RADCOMP_DUMMY => Movement::Dummy { vector: self.end },
            RADCOMP_HELD_VECTOR => Movement::HeldVector { end: self.end },
            RADCOMP_NEW_VECTOR => Movement::NewVector { vector: self.end },
            RADCOMP_CORNER_TO_VECTOR => Movement::CornerArc { vector: Some(self.end) },
            RADCOMP_CORNER_TO_NEXT => Movement::CornerArc { vector: None },
            _ => return None,
        };
        let compensation = match self.compensation {
            RADCOMP_UNCHANGED => None,
            RADCOMP_OFF => Some(Compensation::Off),
            RADCOMP_LEFT => Some(Compensation::On(Side::Left)),
            RADCOMP_RIGHT => Some(Compensation::On(Side::Right)),
            _ => return None,
        };
        let corner = match self.corner {
            RADCOMP_UNCHANGED => None,
            RADCOMP_INTERSECTION => Some(OuterCorner::Intersection),
            RADCOMP_CORNER_ARC => Some(OuterCorner::Arc),
            RADCOMP_LIMIT_ANGLE => Some(OuterCorner::LimitAngle),
            _ => return None,
        };
        let approach = match self.approach {
            RADCOMP_UNCHANGED => None,
            RADCOMP_NORM => Some(Approach::Norm),
            RADCOMP_KONT => Some(Approach::Kont),
            _ => return None,
        };
        let radius = (self.has_radius != 0).then_some(self.radius);
        let vector = (self.has_vector != 0).then_some(self.vector);
        let not_in_mode = kind(&self.not_in_mode).ok()?;
        let (rapid, stops_look_ahead) = (self.rapid != 0, self.stops_look_ahead != 0);
        Some(Block { movement, rapid, compensation, vector, radius, corner, approach, stops_look_ahead, not_in_mode })
    }
}

impl From<&Block<f64>> for radcomp_block {
    fn from(block: &Block<f64>) -> Self {
        let mut out = radcomp_block {
            rapid: u32::from(block.rapid),
            compensation: match block.compensation {
                None => RADCOMP_UNCHANGED,
                Some(Compensation::Off) => RADCOMP_OFF,
                Some(Compensation::On(Side::Left)) => RADCOMP_LEFT,
                Some(Compensation::On(Side::Right)) => RADCOMP_RIGHT,
            },
            corner: match block.corner {
                None => RADCOMP_UNCHANGED,
                Some(OuterCorner::Intersection) => RADCOMP_INTERSECTION,
                Some(OuterCorner::Arc) => RADCOMP_CORNER_ARC,
                Some(OuterCorner::LimitAngle) => RADCOMP_LIMIT_ANGLE,
            },
            approach: match block.approach {
                None => RADCOMP_UNCHANGED,
                Some(Approach::Norm) => RADCOMP_NORM,
                Some(Approach::Kont) => RADCOMP_KONT,
            },
            stops_look_ahead: u32::from(block.stops_look_ahead),
            not_in_mode: block.not_in_mode.map_or([0; RADCOMP_NAME], name),
            has_radius: u32::from(block.radius.is_some()),
            radius: block.radius.unwrap_or_default(),
            has_vector: u32::from(block.vector.is_some()),
            vector: block.vector.unwrap_or_default(),
            ..radcomp_block::default()
        };
        match &block.movement {
            Movement::None => {}
            Movement::Line { end } => (out.movement, out.end) = (RADCOMP_LINE, *end),
            Movement::Dummy { vector } => (out.movement, out.end) = (RADCOMP_DUMMY, *vector),
            Movement::HeldVector { end } => (out.movement, out.end) = (RADCOMP_HELD_VECTOR, *end),
            Movement::NewVector { vector } => (out.movement, out.end) = (RADCOMP_NEW_VECTOR, *vector),
            Movement::CornerArc { vector: Some(vector) } => {
                (out.movement, out.end) = (RADCOMP_CORNER_TO_VECTOR, *vector);
            }
            Movement::CornerArc { vector: None } => out.movement = RADCOMP_CORNER_TO_NEXT,
            Movement::Arc { end, centre, direction } => {
                out.end = *end;
                out.direction = u32::from(*direction == Direction::Counterclockwise);
                match centre {
                    Centre::FromStart(vector) => (out.movement, out.centre) = (RADCOMP_ARC, *vector),
                    Centre::Radius(radius) => (out.movement, out.centre) = (RADCOMP_ARC_RADIUS, [*radius, 0.0]),
                }
            }
        }
        out
    }
}
