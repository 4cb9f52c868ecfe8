//! Motions of the whole program commute exactly with the model: translation, mirroring with the sides swapped,
//! scaling by ten, rotation by a Pythagorean angle, and reversal with the sides swapped.

use std::cmp::Ordering;

use proptest::prelude::*;
use radcomp::generate::{self, Reach};
use radcomp::metamorphic::Motion;
use radcomp_model::number::{Real, within_bits};
use radcomp_model::{Decision, Run, run};
use radcomp_spec::parameters::{Cancel, Parameters, SameCode, SideChange, StartUp};
use radcomp_spec::profile::{BUILTIN, Profile};
use radcomp_spec::{AlarmKind, Block, Centre, Compensation, DecisionKind, Movement, Segment, Side};
use rug::Rational;

/// The exact image of a point.
fn image(motion: &Motion, [a, b]: &[Real; 2]) -> [Real; 2] {
    let of = |row: usize| {
        &(Real::from(&motion.matrix[row][0]) * a)
            + &(Real::from(&motion.matrix[row][1]) * b)
            + Real::from(&motion.shift[row])
    };
    [of(0), of(1)]
}

fn moved(motion: &Motion, run: &Run) -> Vec<(usize, &'static str, Segment<Real>)> {
    let steps = run.steps.iter();
    steps
        .map(|step| {
            let segment = motion.segment(&step.segment, |point| image(motion, point));
            (step.block, step.clause.id(), segment)
        })
        .collect()
}

fn rational(numerator: i64, denominator: i64) -> Rational {
    Rational::from((numerator, denominator))
}

/// A profile by its place in the list, and a generated program of it that begins away from the origin.
fn program(profile: usize, seed: u64) -> (Parameters, Vec<Block<Rational>>) {
    let profile = Profile::builtin(BUILTIN[profile % BUILTIN.len()].0).expect("built in");
    let mut blocks = vec![Block::moving(Movement::Line { end: [rational(777, 10), rational(-333, 10)] })];
    blocks.extend(generate::program(seed, seed >> 7, Reach::of(&profile)));
    (profile.parameters, blocks)
}

fn commutes(parameters: &Parameters, blocks: &[Block<Rational>], motion: &Motion) -> Result<(), TestCaseError> {
    let images: Vec<_> = blocks.iter().map(|block| motion.block(block)).collect();
    let Some(scaled) = motion.parameters(parameters) else { return Ok(()) };
    let (before, after) = (run(parameters, blocks), run(&scaled, &images));
    prop_assert_eq!(before.alarm, after.alarm);
    let plain: Vec<_> = after.steps.iter().map(|step| (step.block, step.clause.id(), step.segment.clone())).collect();
    prop_assert_eq!(moved(motion, &before), plain);
    // The first block's length depends on where the tool stands at the start, and of two contact points, or points that
    // avoid interference, either may be looked at first.
    let comparable = |(decision, _): &&(Decision, Ordering)| {
        use DecisionKind::{ContactWithin, NearerAvoidance, NearerContact};
        let either_first = matches!(decision.kind, ContactWithin | NearerContact | NearerAvoidance);
        decision.block > 0 && !either_first
    };
    let count = |run: &Run| run.decisions.iter().filter(comparable).count();
    prop_assert_eq!(count(&before), count(&after));
    let pairs = before.decisions.iter().filter(comparable).zip(after.decisions.iter().filter(comparable));
    for ((one, _), (other, _)) in pairs {
        prop_assert_eq!(one.exact, other.exact, "{:?}", one.kind);
        // That two margins of arcs are one takes exact numbers minutes: those that agree to so many bits pass.
        let margin = &one.margin * &Real::integer(motion.scale.into());
        let order = within_bits(4096, || margin.cmp(&other.margin));
        prop_assert!(matches!(order, None | Some(Ordering::Equal)), "{:?}: {:?}", one.kind, order);
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn translation_commutes(profile in 0..BUILTIN.len(), seed: u64, a in -100_000_i64..100_000, b in -100_000_i64..100_000) {
        let (parameters, blocks) = program(profile, seed);
        commutes(&parameters, &blocks, &Motion::translation(a, b))?;
    }

    #[test]
    fn mirroring_swaps_the_sides(profile in 0..BUILTIN.len(), seed: u64) {
        let (parameters, blocks) = program(profile, seed);
        commutes(&parameters, &blocks, &Motion::mirroring())?;
    }

    #[test]
    fn scaling_by_ten_commutes(profile in 0..BUILTIN.len(), seed: u64) {
        let (parameters, blocks) = program(profile, seed);
        commutes(&parameters, &blocks, &Motion::scaling())?;
    }

    #[test]
    fn rotation_by_a_pythagorean_angle_commutes(profile in 0..BUILTIN.len(), seed: u64, which in 0_usize..3) {
        let (parameters, blocks) = program(profile, seed);
        let (a, b, c) = [(3, 4, 5), (-5, 12, 13), (0, -1, 1)][which];
        commutes(&parameters, &blocks, &Motion::rotation(a, b, c))?;
    }

    #[test]
    fn reversal_swaps_the_sides(profile in 0..BUILTIN.len(), seed: u64) {
        let (parameters, blocks) = program(profile, seed);
        if has_no_sense_of_time(&parameters) {
            reverses(&parameters, &blocks)?;
        }
    }
}

/// A contour of one run in offset mode: start, and each move with its side.
struct Contour {
    start: [Rational; 2],
    moves: Vec<(Movement<Rational>, Side)>,
    radius: Rational,
}

impl Contour {
    /// The moves of a generated program, every one of them compensated.
    fn of(blocks: &[Block<Rational>]) -> Option<Self> {
        let mut side = Side::Left;
        let mut radius = rational(0, 1);
        let mut at = [rational(0, 1), rational(0, 1)];
        let mut contour = Contour { start: at.clone(), moves: Vec::new(), radius: radius.clone() };
        for block in blocks {
            if let Some(Compensation::On(new)) = block.compensation {
                side = new;
            }
            if let Some(new) = &block.radius {
                radius = new.clone();
            }
            let (Movement::Line { end } | Movement::Arc { end, .. }) = &block.movement else { continue };
            let still = matches!(block.movement, Movement::Line { .. }) && *end == at;
            if !still {
                contour.moves.push((block.movement.clone(), side));
                at = end.clone();
            }
        }
        contour.radius = radius;
        (contour.moves.len() > 1).then_some(contour)
    }

    fn end(&self) -> [Rational; 2] {
        match self.moves.last() {
            Some((Movement::Line { end } | Movement::Arc { end, .. }, _)) => end.clone(),
            _ => self.start.clone(),
        }
    }

    fn reversed(&self) -> Contour {
        let mut moves = Vec::new();
        let mut at = self.start.clone();
        for (movement, side) in &self.moves {
            let back = match movement {
                Movement::Arc { end, centre, direction } => {
                    let centre = match centre {
                        Centre::Radius(radius) => Centre::Radius(radius.clone()),
                        Centre::FromStart([i, j]) => Centre::FromStart([
                            Rational::from(&at[0] + i) - &end[0],
                            Rational::from(&at[1] + j) - &end[1],
                        ]),
                    };
                    Movement::Arc { end: at.clone(), centre, direction: direction.reversed() }
                }
                _ => Movement::Line { end: at.clone() },
            };
            moves.push((back, side.other()));
            if let Movement::Line { end } | Movement::Arc { end, .. } = movement {
                at = end.clone();
            }
        }
        moves.reverse();
        Contour { start: self.end(), moves, radius: self.radius.clone() }
    }

    /// Approach, start-up to the contour's start, the contour, and cancel.
    fn program(&self) -> Vec<Block<Rational>> {
        let away = |point: &[Rational; 2]| [Rational::from(&point[0] - 5), Rational::from(&point[1] + 31)];
        let on = |side| Some(Compensation::On(side));
        let mut blocks = vec![
            Block::moving(Movement::Line { end: away(&self.start) }),
            Block {
                compensation: on(self.moves[0].1),
                radius: Some(self.radius.clone()),
                ..Block::moving(Movement::Line { end: self.start.clone() })
            },
        ];
        blocks.extend(
            self.moves
                .iter()
                .map(|(movement, side)| Block { compensation: on(*side), ..Block::moving(movement.clone()) }),
        );
        blocks.push(Block {
            compensation: Some(Compensation::Off),
            ..Block::moving(Movement::Line { end: away(&self.end()) })
        });
        blocks
    }
}

/// The compensated path: its points, and the move between each two.
fn path(run: &Run) -> Vec<([Real; 2], Option<Segment<Real>>)> {
    let steps: Vec<_> = run.steps.iter().filter(|step| step.segment != Segment::Hold).collect();
    // The first step is the approach, the second the start-up, the last one the cancel.
    let Some(inner) = steps.get(1..steps.len().saturating_sub(1)) else { return Vec::new() };
    inner
        .iter()
        .map(|step| match &step.segment {
            Segment::Line { end } | Segment::Arc { end, .. } => (end.clone(), Some(step.segment.clone())),
            Segment::Hold => unreachable!("filtered out"),
        })
        .collect()
}

/// The same path is run from either end: no rule of the profile looks at what comes first.
fn has_no_sense_of_time(parameters: &Parameters) -> bool {
    let ends_alike = parameters.start_up == StartUp::TypeA && parameters.cancel == Cancel::TypeA;
    let sides_alike = parameters.side_change != SideChange::Crossing;
    let codes_alike = parameters.same_code == SameCode::Ordinary;
    let corners_alike = parameters.straight_band_cosine.numerator == 0 && parameters.small_vector_limit.numerator == 0;
    ends_alike && sides_alike && codes_alike && corners_alike
}

fn reverses(parameters: &Parameters, blocks: &[Block<Rational>]) -> Result<(), TestCaseError> {
    let Some(contour) = Contour::of(blocks) else { return Ok(()) };
    let (forth, back) = (run(parameters, &contour.program()), run(parameters, &contour.reversed().program()));
    prop_assert_eq!(forth.alarm.is_some(), back.alarm.is_some(), "{:?} {:?}", forth.alarm, back.alarm);
    if forth.alarm.is_some() {
        return Ok(());
    }
    let (forth, back) = (path(&forth), path(&back));
    prop_assert_eq!(forth.len(), back.len());
    let count = forth.len();
    for (index, (point, _)) in forth.iter().enumerate() {
        prop_assert_eq!(point, &back[count - 1 - index].0);
    }
    // The move to point i + 1 is the reversed program's move to point i.
    for index in 1..count {
        let (one, other) = (&forth[index].1, &back[count - index].1);
        let alike = match (one, other) {
            (Some(Segment::Line { .. }), Some(Segment::Line { .. })) => true,
            (
                Some(Segment::Arc { centre: c1, direction: d1, full: f1, .. }),
                Some(Segment::Arc { centre: c2, direction: d2, full: f2, .. }),
            ) => c1 == c2 && *d1 == d2.reversed() && f1 == f2,
            _ => false,
        };
        prop_assert!(alike, "{:?} {:?}", one, other);
    }
    Ok(())
}

/// A groove, with so many blocks without movement between its ground and its second wall.
fn groove(width: i64, radius: i64, pauses: usize) -> Run {
    let profile = Profile::changed("seed-mill", "rows", [("interference", r#""alarm""#)]).expect("a profile");
    let line = |a: i64, b: i64| Block::moving(Movement::Line { end: [rational(a, 1000), rational(b, 1000)] });
    let mut blocks = vec![line(-5_000, 90_000), line(0, 90_000), line(0, 0), line(width, 0), line(width, 90_000)];
    (blocks[1].compensation, blocks[1].radius) = (Some(Compensation::On(Side::Left)), Some(rational(radius, 1000)));
    blocks.splice(4..4, std::iter::repeat_n(Block::empty(), pauses));
    blocks.push(Block { compensation: Some(Compensation::Off), ..line(width + 50_000, 95_000) });
    run(&profile.parameters, &blocks)
}

proptest! {
    /// [TRC-INT-01] the walls of a groove are in one row; a junction that is settled without the next element ends it.
    #[test]
    fn vectors_are_compared_within_a_row(width in 1_i64..40_000, radius in 1_i64..20_000) {
        let alarm = groove(width, radius, 0).alarm.map(|alarm| (alarm.block, alarm.kind));
        let too_narrow = width < 2 * radius;
        prop_assert_eq!(alarm, too_narrow.then_some((3, AlarmKind::Interference)));
        // Three blocks without movement are more than may stand between the ground and the second wall: the row ends at
        // the ground, on its own normal, and the second wall is not compared.
        let paused = groove(width, radius, 3).alarm.map(|alarm| (alarm.block, alarm.kind));
        prop_assert_eq!(paused, (width < radius).then_some((3, AlarmKind::Interference)));
    }
}
