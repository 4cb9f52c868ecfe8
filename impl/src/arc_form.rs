//! The form of an arc: its centre, its radii, and the alarms of an arc that does not exist. [TRC-ARC-01] to
//! [TRC-ARC-07]

use core::cmp::Ordering;

use radcomp_spec::{AlarmKind, Centre, Direction};

use crate::element::Element;
use crate::plane::{Vector, direction, greater, lesser, magnitude, perp};
use crate::sign::sign;

/// An arc that exists.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Arc {
    /// Its centre, in absolute coordinates.
    pub centre: Vector,
    /// Unit vector from the centre to the start.
    pub start_ray: Vector,
    /// Unit vector from the centre to the end.
    pub end_ray: Vector,
    /// Unit vector from the programmed centre to the programmed start: `start_ray`, but for an entry move.
    /// [TRC-START-09]
    pub swept_from: Vector,
    /// Distance of the start from the centre.
    pub start_radius: f64,
    /// Distance of the end from the centre; the two differ within the tolerance. [TRC-ARC-04]
    pub end_radius: f64,
    /// δ: +1 for G03, -1 for G02. [TRC-PLANE-04]
    pub sense: f64,
    /// Its end is its start. [TRC-ARC-07]
    pub full: bool,
}

/// By how much the words of an arc may disagree, in millimetres.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tolerances {
    /// How far its end may lie off the arc about its centre. [TRC-ARC-03]
    pub end: f64,
    /// How far from its start or its end a centre counts as lying there. [TRC-ARC-02]
    pub centre: f64,
    /// By how much half its chord may exceed its radius. [TRC-ARC-06]
    pub chord: f64,
}

/// How much of the chord's rounding reaches the rays of an arc with R at most: nearer to a half turn the inputs
/// themselves no longer tell the tangent, and a wider band would be a tolerance.
const MOST_AMPLIFIED: f64 = 8.0;

impl Arc {
    /// The direction as the vocabulary has it.
    pub fn direction(&self) -> Direction {
        if self.sense > 0.0 { Direction::Counterclockwise } else { Direction::Clockwise }
    }
}

impl Element {
    /// Checks the form of an arc from `start` to `end`, finds its centre, and makes this that arc. All numbers are
    /// within range ([TRC-MODE-07]).
    ///
    /// # Errors
    /// [TRC-ARC-06] for an arc with R, then [TRC-ARC-02], and [TRC-ARC-03] for one with centre words.
    #[inline(always)]
    pub fn set_arc(
        &mut self,
        start: Vector,
        end: Vector,
        centre: &Centre<f64>,
        direction: Direction,
        tolerances: Tolerances,
    ) -> Result<(), AlarmKind> {
        let sense = match direction {
            Direction::Counterclockwise => 1.0,
            Direction::Clockwise => -1.0,
        };
        match *centre {
            Centre::FromStart([a, b]) => self.set_about(start, end, Vector::new(a, b), sense, tolerances),
            Centre::Radius(radius) => self.set_with_radius(start, end, radius, sense, tolerances),
        }
    }

    #[inline(always)]
    fn set_about(
        &mut self,
        start: Vector,
        end: Vector,
        to_centre: Vector,
        sense: f64,
        tolerances: Tolerances,
    ) -> Result<(), AlarmKind> {
        if to_centre == Vector::zeros() {
            return Err(AlarmKind::CentreAtEnd);
        }
        let full = start == end;
        let (toward, start_radius) = direction(to_centre);
        // The vector to the centre is an input, whatever the coordinates are.
        if sign(start_radius - tolerances.centre, start_radius) != Ordering::Greater {
            return Err(AlarmKind::CentreAtEnd);
        }
        let scale = greater(greater(magnitude(start), magnitude(end)), start_radius);
        let to_end = (end - start) - to_centre;
        let (end_ray, end_radius) = direction(to_end);
        if !full && sign(end_radius - tolerances.centre, scale) != Ordering::Greater {
            return Err(AlarmKind::CentreAtEnd);
        }
        if sign((start_radius - end_radius).abs() - tolerances.end, scale) == Ordering::Greater {
            return Err(AlarmKind::EndOffArc);
        }
        let centre = start + to_centre;
        let arc =
            Arc { centre, start_ray: -toward, end_ray, swept_from: -toward, start_radius, end_radius, sense, full };
        // The vector to the centre is an input; that from the centre to the end is a difference of coordinates.
        let end_error = if full { 1.0 } else { 1.0 + scale / end_radius };
        self.set_round(start, end, arc, scale, [1.0, end_error]);
        Ok(())
    }

    #[inline(never)]
    fn set_with_radius(
        &mut self,
        start: Vector,
        end: Vector,
        radius: f64,
        sense: f64,
        tolerances: Tolerances,
    ) -> Result<(), AlarmKind> {
        let mut size = radius.abs();
        if start == end || size + tolerances.chord == 0.0 {
            return Err(AlarmKind::NoSuchArc);
        }
        let scale = greater(greater(magnitude(start), magnitude(end)), size);
        let (along, chord) = direction(end - start);
        let half = 0.5 * chord;
        let left = if radius > 0.0 { sense } else { -sense };
        let (halfway, height, amplified) = match sign(size - half, scale) {
            Ordering::Less if sign(half - size - tolerances.chord, scale) == Ordering::Greater => {
                return Err(AlarmKind::NoSuchArc);
            }
            Ordering::Less => {
                size = half;
                (1.0, 0.0, 0.0)
            }
            // The chord is a diameter: the centre is its midpoint, whatever rounding left of the difference.
            Ordering::Equal => {
                size = if size > 0.0 { size } else { half };
                (1.0, 0.0, 0.0)
            }
            Ordering::Greater => {
                let height = libm::sqrt((size - half) * (size + half));
                (half / size, height / size, lesser(half / height, MOST_AMPLIFIED))
            }
        };
        if tolerances.centre > 0.0 && sign(size - tolerances.centre, scale) != Ordering::Greater {
            return Err(AlarmKind::CentreAtEnd);
        }
        let along_part = along * halfway;
        let across_part = perp(along) * (left * height);
        let start_ray = -(along_part + across_part);
        let arc = Arc {
            centre: start + (end - start) * 0.5 + across_part * size,
            start_ray,
            end_ray: along_part - across_part,
            swept_from: start_ray,
            start_radius: size,
            end_radius: size,
            sense,
            full: false,
        };
        self.set_round(start, end, arc, scale, [1.0 + scale / size * (1.0 + amplified); 2]);
        Ok(())
    }

    #[inline(always)]
    fn set_round(&mut self, start: Vector, end: Vector, arc: Arc, scale: f64, errors: [f64; 2]) {
        (self.start, self.end) = (start, end);
        (self.first, self.last) = (perp(arc.start_ray) * arc.sense, perp(arc.end_ray) * arc.sense);
        (self.length, self.scale) = (0.0, scale);
        [self.first_error, self.last_error] = errors;
        self.arc = Some(arc);
    }
}
