//! Blocks as C sees them.

use radcomp_spec::{Block, Centre, Compensation, Direction, Movement, OuterCorner, Side};

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

/// One block of a program, modal codes, units and diameters resolved.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct radcomp_block {
    /// RADCOMP_NONE, RADCOMP_LINE, RADCOMP_ARC, RADCOMP_ARC_RADIUS or RADCOMP_DUMMY.
    pub movement: u32,
    /// RADCOMP_CLOCKWISE or RADCOMP_COUNTERCLOCKWISE, of an arc.
    pub direction: u32,
    /// Not 0: at rapid traverse.
    pub rapid: u32,
    /// RADCOMP_UNCHANGED, RADCOMP_OFF, RADCOMP_LEFT or RADCOMP_RIGHT.
    pub compensation: u32,
    /// RADCOMP_UNCHANGED, RADCOMP_INTERSECTION or RADCOMP_CORNER_ARC.
    pub corner: u32,
    /// Not 0: the block puts `radius` in force.
    pub has_radius: u32,
    /// The tool radius.
    pub radius: f64,
    /// The end point, absolute.
    pub end: [f64; 2],
    /// The centre of an arc.
    pub centre: [f64; 2],
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
            _ => return None,
        };
        let radius = (self.has_radius != 0).then_some(self.radius);
        Some(Block { rapid: self.rapid != 0, compensation, radius, corner, ..Block::moving(movement) })
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
            },
            has_radius: u32::from(block.radius.is_some()),
            radius: block.radius.unwrap_or_default(),
            ..radcomp_block::default()
        };
        match &block.movement {
            Movement::None => {}
            Movement::Line { end } => (out.movement, out.end) = (RADCOMP_LINE, *end),
            Movement::Dummy { vector } => (out.movement, out.end) = (RADCOMP_DUMMY, *vector),
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
