//! Cases made of choices.

use radcomp_spec::parameters::*;
use radcomp_spec::profile::Profile;
use radcomp_spec::{AlarmKind, Block, Centre, Compensation, Direction, Movement, OuterCorner, Side};
use rug::Rational;

/// A program, and the choices of a control.
#[derive(Clone, Debug)]
pub struct Case {
    pub parameters: Parameters,
    pub blocks: Vec<Block<Rational>>,
}

struct Choices<'a>(std::iter::Copied<std::slice::Iter<'a, u16>>);

impl Choices<'_> {
    /// One of so many, 0 when the choices are used up.
    fn below(&mut self, count: usize) -> usize {
        usize::from(self.0.next().unwrap_or(0)) % count
    }

    /// True once in so many times.
    fn once_in(&mut self, times: usize) -> bool {
        self.below(times) == 1
    }

    fn value<T: Copy>(&mut self, values: &[(&str, T)]) -> T {
        values[self.below(values.len())].1
    }

    fn ratio(&mut self, values: &[(u32, u32)]) -> Ratio {
        let (numerator, denominator) = values[self.below(values.len())];
        Ratio { numerator, denominator }
    }

    fn side(&mut self) -> Side {
        if self.below(2) == 0 { Side::Left } else { Side::Right }
    }

    fn coordinate(&mut self) -> i32 {
        self.below(15) as i32 - 7
    }
}

impl Case {
    pub fn new(choices: &[u16]) -> Case {
        let mut choices = Choices(choices.iter().copied());
        let parameters = parameters(&mut choices);
        let mut blocks = vec![Block { radius: Some(Rational::from(1 + choices.below(3))), ..Block::empty() }];
        let mut position = [0, 0];
        for _ in 0..14 {
            blocks.push(block(&mut choices, &mut position));
        }
        Case { parameters, blocks }
    }

    /// The program seen from the other side of the first axis.
    pub fn mirrored(&self) -> Vec<Block<Rational>> {
        let point = |[a, b]: &[Rational; 2]| [a.clone(), Rational::from(-b)];
        let block = |block: &Block<Rational>| {
            let movement = match &block.movement {
                Movement::None => Movement::None,
                Movement::Line { end } => Movement::Line { end: point(end) },
                Movement::HeldVector { end } => Movement::HeldVector { end: point(end) },
                Movement::Dummy { vector } => Movement::Dummy { vector: point(vector) },
                Movement::NewVector { vector } => Movement::NewVector { vector: point(vector) },
                Movement::CornerArc { vector } => Movement::CornerArc { vector: vector.as_ref().map(point) },
                Movement::Arc { end, centre, direction } => {
                    let centre = match centre {
                        Centre::FromStart(vector) => Centre::FromStart(point(vector)),
                        Centre::Radius(radius) => Centre::Radius(radius.clone()),
                    };
                    Movement::Arc { end: point(end), centre, direction: direction.reversed() }
                }
            };
            let vector = block.vector.as_ref().map(point);
            Block { movement, vector, compensation: exchanged(block.compensation), ..block.clone() }
        };
        self.blocks.iter().map(block).collect()
    }

    /// The program with every radius negated and G41 and G42 exchanged.
    pub fn negated(&self) -> Vec<Block<Rational>> {
        let block = |block: &Block<Rational>| Block {
            radius: block.radius.as_ref().map(|radius| Rational::from(-radius)),
            compensation: exchanged(block.compensation),
            ..block.clone()
        };
        self.blocks.iter().map(block).collect()
    }
}

fn exchanged(compensation: Option<Compensation>) -> Option<Compensation> {
    match compensation {
        Some(Compensation::On(side)) => Some(Compensation::On(side.other())),
        other => other,
    }
}

/// Any choice of every parameter.
fn parameters(choices: &mut Choices<'_>) -> Parameters {
    let seed = Profile::builtin("seed-mill").expect("a built-in profile").parameters;
    Parameters {
        start_up: choices.value(StartUp::VALUES),
        start_up_lost: choices.value(StartUpLost::VALUES),
        cancel: choices.value(Cancel::VALUES),
        outer_corner: choices.value(OuterCorner::VALUES),
        reversal: choices.value(Reversal::VALUES),
        side_change: choices.value(SideChange::VALUES),
        side_change_after_start_up: choices.value(SideChangeAfterStartUp::VALUES),
        non_moving_allowed: [Some(0), Some(1), Some(2), None][choices.below(4)],
        corner_owner: choices.value(CornerOwner::VALUES),
        reversed_path: choices.value(ReversedPath::VALUES),
        start_up_b: choices.value(StartUpB::VALUES),
        start_up_without_movement: choices.value(StartUpWithoutMovement::VALUES),
        start_up_arc: choices.value(StartUpArc::VALUES),
        cancel_without_movement: choices.value(CancelWithoutMovement::VALUES),
        corner_limit_cosine: choices.ratio(&[(0, 1), (3, 5), (1, 2), (1, 1)]),
        arc_extension: choices.value(ArcExtension::VALUES),
        smallest_corner_cosine: choices.ratio(&[(0, 1), (3, 5), (1, 2)]),
        straight_band_cosine: choices.ratio(&[(0, 1), (0, 1), (24, 25), (1, 2)]),
        arc_on_rapid: choices.value(ArcOnRapid::VALUES),
        small_vector_limit: choices.ratio(&[(0, 1), (1, 1), (2, 1)]),
        same_code: choices.value(SameCode::VALUES),
        pending_at_alarm: choices.value(PendingAtAlarm::VALUES),
        side_code_vector: choices.value(SideCodeVector::VALUES),
        cancel_vector: choices.value(CancelVector::VALUES),
        offset_change: choices.value(OffsetChange::VALUES),
        negative_radius: choices.value(NegativeRadius::VALUES),
        equal_radius: choices.value(EqualRadius::VALUES),
        zero_length_move: choices.value(ZeroLengthMove::VALUES),
        ..seed
    }
}

fn block(choices: &mut Choices<'_>, position: &mut [i32; 2]) -> Block<Rational> {
    let compensation = match choices.below(8) {
        0 => Some(Compensation::Off),
        1 | 2 => Some(Compensation::On(choices.side())),
        _ => None,
    };
    let radius = choices.once_in(20).then(|| Rational::from(choices.below(4) as i32 - 1));
    Block {
        movement: movement(choices, position),
        rapid: choices.once_in(4),
        compensation,
        vector: choices.once_in(6).then(|| exact([choices.coordinate(), 1 + choices.below(4) as i32])),
        radius,
        corner: choices.once_in(20).then(|| choices.value(OuterCorner::VALUES)),
        approach: choices.once_in(20).then(|| choices.value(Approach::VALUES)),
        stops_look_ahead: choices.once_in(20),
        not_in_mode: choices.once_in(80).then_some(AlarmKind::ToolChangeInMode),
    }
}

fn exact([a, b]: [i32; 2]) -> [Rational; 2] {
    [Rational::from(a), Rational::from(b)]
}

fn movement(choices: &mut Choices<'_>, position: &mut [i32; 2]) -> Movement<Rational> {
    match choices.below(13) {
        0 | 1 => Movement::None,
        // Few, as they end a program that is not in mode.
        12 => match choices.below(4) {
            0 => {
                *position = [choices.coordinate(), choices.coordinate()];
                Movement::HeldVector { end: exact(*position) }
            }
            1 => Movement::NewVector { vector: exact([choices.coordinate(), 1 + choices.below(4) as i32]) },
            2 => Movement::CornerArc { vector: Some(exact([1 + choices.below(4) as i32, choices.coordinate()])) },
            _ => Movement::CornerArc { vector: None },
        },
        2 => Movement::Dummy { vector: exact([choices.coordinate(), choices.coordinate()]) },
        3 => Movement::Line { end: exact(*position) },
        kind @ 4..8 => {
            let direction = if choices.below(2) == 0 { Direction::Clockwise } else { Direction::Counterclockwise };
            let vector = [choices.coordinate() / 2, choices.coordinate() / 2];
            let centre = [position[0] + vector[0], position[1] + vector[1]];
            if kind == 4 {
                *position = centre;
                let radius = Rational::from(choices.coordinate());
                return Movement::Arc { end: exact(centre), centre: Centre::Radius(radius), direction };
            }
            // Quarter turns, so that the end lies on the arc; none is a full circle.
            let mut ray = [-vector[0], -vector[1]];
            for _ in 0..choices.below(4) {
                ray = [-ray[1], ray[0]];
            }
            // Now and then it does not.
            let off = i32::from(choices.once_in(20));
            *position = [centre[0] + ray[0] + off, centre[1] + ray[1]];
            Movement::Arc { end: exact(*position), centre: Centre::FromStart(exact(vector)), direction }
        }
        _ => {
            *position = [choices.coordinate(), choices.coordinate()];
            Movement::Line { end: exact(*position) }
        }
    }
}
