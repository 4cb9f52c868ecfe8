//! Properties: what is printed reads back, and no bytes make the reader panic.

use proptest::prelude::*;
use radcomp_spec::parameters::{
    ApproachCodes, CancelVector, CornerCodes, InMode, ReadAheadStop, SideCodeVector, ToolChange, VectorCodes,
};
use radcomp_spec::profile::{BUILTIN, Machine, Profile};
use radcomp_spec::{AlarmKind, Approach, Block, Centre, Compensation, Direction, Movement, OuterCorner, Side};
use rug::Rational;

use super::tools;
use crate::gcode::{PrintError, Program, Tools, print, print_blocks, read};

fn profile() -> impl Strategy<Value = Profile> {
    (0..BUILTIN.len()).prop_map(|index| Profile::builtin(BUILTIN[index].0).unwrap())
}

/// A decimal with up to eight places, so that a doubled diameter has one to spare.
fn decimal() -> impl Strategy<Value = Rational> {
    let places = prop_oneof![Just(1_i64), Just(1_000), Just(100_000_000)];
    (-400_000_000_i64..=400_000_000, places).prop_map(|(numerator, places)| Rational::from((numerator, places)))
}

fn point() -> impl Strategy<Value = [Rational; 2]> {
    [decimal(), decimal()]
}

fn movement() -> impl Strategy<Value = Movement<Rational>> {
    let centre = prop_oneof![point().prop_map(Centre::FromStart), decimal().prop_map(Centre::Radius)];
    let direction = prop_oneof![Just(Direction::Clockwise), Just(Direction::Counterclockwise)];
    prop_oneof![
        2 => Just(Movement::None),
        5 => point().prop_map(|end| Movement::Line { end }),
        3 => (point(), centre, direction).prop_map(|(end, centre, direction)| Movement::Arc { end, centre, direction }),
        1 => point().prop_map(|vector| Movement::Dummy { vector }),
        1 => point().prop_map(|end| Movement::HeldVector { end }),
        1 => point().prop_map(|vector| Movement::NewVector { vector }),
        1 => prop::option::of(point()).prop_map(|vector| Movement::CornerArc { vector }),
    ]
}

fn block() -> impl Strategy<Value = Block<Rational>> {
    let compensation = prop_oneof![
        6 => Just(None),
        1 => Just(Some(Compensation::Off)),
        1 => Just(Some(Compensation::On(Side::Left))),
        1 => Just(Some(Compensation::On(Side::Right))),
    ];
    let radius = prop::option::weighted(0.2, (-20_i32..20).prop_map(|tenths| Rational::from((tenths, 10))));
    let corner = prop_oneof![
        8 => Just(None),
        1 => Just(Some(OuterCorner::Arc)),
        1 => Just(Some(OuterCorner::Intersection)),
        1 => Just(Some(OuterCorner::LimitAngle)),
    ];
    let not_in_mode = prop_oneof![
        12 => Just(None),
        1 => Just(Some(AlarmKind::PlaneChangeInMode)),
        1 => Just(Some(AlarmKind::ReferenceReturnInMode)),
        1 => Just(Some(AlarmKind::MachineCoordinatesInMode)),
        1 => Just(Some(AlarmKind::SetCoordinatesInMode)),
        1 => Just(Some(AlarmKind::ToolChangeInMode)),
        1 => Just(Some(AlarmKind::CannedCycleInMode)),
    ];
    let approach = prop_oneof![6 => Just(None), 1 => Just(Some(Approach::Norm)), 1 => Just(Some(Approach::Kont))];
    let stops = prop::bool::weighted(0.1);
    let vector = prop::option::weighted(0.5, point());
    (movement(), any::<bool>(), compensation, vector, radius, (corner, approach), stops, not_in_mode).prop_map(
        |(movement, rapid, compensation, vector, radius, (corner, approach), stops_look_ahead, not_in_mode)| Block {
            movement,
            rapid,
            compensation,
            vector,
            radius,
            corner,
            approach,
            stops_look_ahead,
            not_in_mode,
        },
    )
}

/// Takes out of the blocks what has no G-code under the profile.
fn expressible(mut blocks: Vec<Block<Rational>>, profile: &Profile) -> Vec<Block<Rational>> {
    let machine = &profile.machine;
    let mut on = false;
    let mut position = [Rational::new(), Rational::new()];
    for block in &mut blocks {
        vectors(block, &position, profile);
        block.corner = block.corner.filter(|corner| match machine.corner_codes {
            CornerCodes::None => false,
            CornerCodes::M96M97 => *corner != OuterCorner::LimitAngle,
            CornerCodes::G450G451 => *corner != OuterCorner::Intersection,
        });
        block.approach = block.approach.filter(|_| machine.approach_codes == ApproachCodes::NormKont);
        if matches!(block.movement, Movement::Dummy { .. }) {
            block.movement = Movement::None;
        }
        block.rapid &= !matches!(block.movement, Movement::Arc { .. });
        block.stops_look_ahead &= machine.read_ahead_stop == ReadAheadStop::BreaksLookAhead;
        on = block.compensation.map_or(on, |code| code != Compensation::Off);
        block.not_in_mode = block.not_in_mode.filter(|kind| on && has_alarm(machine, *kind));
        if block.not_in_mode.is_some() {
            // Its movement is not looked at.
            (block.movement, block.rapid, block.vector) = (Movement::None, false, None);
        }
        if let Movement::Line { end } | Movement::Arc { end, .. } | Movement::HeldVector { end } = &block.movement {
            position = end.clone();
        }
    }
    blocks
}

/// Takes out of a block the vectors that have no G-code under the profile.
fn vectors(block: &mut Block<Rational>, position: &[Rational; 2], profile: &Profile) {
    let zero = |vector: &[Rational; 2]| vector.iter().all(Rational::is_zero);
    let is_code = match &block.movement {
        Movement::HeldVector { .. } | Movement::CornerArc { vector: None } => true,
        Movement::NewVector { vector } | Movement::CornerArc { vector: Some(vector) } => {
            block.movement = if zero(vector) { Movement::None } else { block.movement.clone() };
            true
        }
        _ => false,
    };
    if is_code && (profile.machine.vector_codes == VectorCodes::None || block.compensation.is_some()) {
        block.movement = Movement::None;
    }
    let has_meaning = match (block.compensation, &block.movement) {
        (Some(Compensation::Off), Movement::None | Movement::Line { .. }) => {
            profile.parameters.cancel_vector != CancelVector::Refused
        }
        // An imaginary line stands at start-up alone, words without a move in mode alone.
        (Some(Compensation::On(_)), Movement::Line { end }) => {
            profile.parameters.side_code_vector == SideCodeVector::RightAngles && end != position
        }
        _ => false,
    };
    block.vector = block.vector.take().filter(|vector| has_meaning && !zero(vector));
}

/// Whether the profile has this alarm for a code in mode.
fn has_alarm(machine: &Machine, kind: AlarmKind) -> bool {
    match kind {
        AlarmKind::PlaneChangeInMode => machine.plane_change == InMode::Alarm,
        AlarmKind::ReferenceReturnInMode => machine.reference_return == InMode::Alarm,
        AlarmKind::MachineCoordinatesInMode => machine.machine_coordinates == InMode::Alarm,
        AlarmKind::SetCoordinatesInMode => machine.set_coordinates == InMode::Alarm,
        AlarmKind::ToolChangeInMode => machine.tool_change == ToolChange::Alarm,
        AlarmKind::CannedCycleInMode => machine.canned_cycle == InMode::Alarm,
        _ => false,
    }
}

/// A thousand cases of each, unless `PROPTEST_CASES` says how many.
fn cases() -> ProptestConfig {
    let given = ProptestConfig::default();
    if std::env::var_os("PROPTEST_CASES").is_some() { given } else { ProptestConfig { cases: 1000, ..given } }
}

proptest! {
    #![proptest_config(cases())]

    #[test]
    fn what_is_printed_reads_back(profile in profile(), blocks in prop::collection::vec(block(), 0..12)) {
        let blocks = expressible(blocks, &profile);
        let listing = print_blocks(&blocks, &profile).unwrap();
        let tools = Tools::parse(&listing.tool_table, "tools.toml").unwrap();
        prop_assert_eq!(&tools, &listing.tools);
        let program = read("a.nc", listing.program.as_bytes(), &profile, &tools).unwrap();
        let mut unset = true;
        prop_assert_eq!(program.blocks.len(), blocks.len());
        for (read, block) in program.blocks.iter().zip(&blocks) {
            let mut expected = block.clone();
            unset &= block.radius.is_none();
            if unset && matches!(block.compensation, Some(Compensation::On(_))) {
                // The one liberty: the radius 0 that is in force before any offset is written out.
                (expected.radius, unset) = (Some(Rational::new()), false);
            }
            prop_assert_eq!(&read.block, &expected);
        }
        // A program prints with its sequence numbers.
        let again = print(&program, &profile).unwrap();
        let reread = read("a.nc", again.program.as_bytes(), &profile, &again.tools).unwrap();
        prop_assert_eq!(reread, program);
    }

    /// Blocks of any kind print, or say why not; what prints has been read back by `print_blocks` itself.
    #[test]
    fn any_blocks_print_or_are_refused(profile in profile(), blocks in prop::collection::vec(block(), 0..12)) {
        match print_blocks(&blocks, &profile) {
            Ok(listing) => prop_assert_eq!(listing.program.lines().count(), blocks.len() + 3),
            // A code that is not for offset mode reads as nothing outside it.
            Err(PrintError::Refused(_) | PrintError::NoCode { .. } | PrintError::Different { .. }) => {}
            Err(error) => prop_assert!(false, "{}", error),
        }
    }

    #[test]
    fn no_bytes_make_the_reader_panic(profile in profile(), bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        if let Err(fault) = read("a.nc", &bytes, &profile, &tools()) {
            let _ = fault.to_string();
        }
    }

    #[test]
    fn no_text_makes_the_table_panic(text in "\\PC{0,60}") {
        for text in [text.clone(), format!("[[tool]]\nnumber = 1\nradius = \"{text}\"\n")] {
            if let Err(fault) = Tools::parse(&text, "tools.toml") {
                let _ = fault.to_string();
            }
        }
    }

    /// Text that looks like G-code gets far into the reader. Faults lie within their line, and blocks print again.
    #[test]
    fn words_at_random_read_or_are_refused_in_place(
        profile in profile(),
        text in "((G0?[0-4]|G1[789]|G2[01]|G4[0-4]|G9[0-2]|G28|G3[89]|G53|G81|G45[01]|M9[67]|M0[016]|M30|D[0-4]|T0?10[0134]|N1|F9|/|%|\\(a\\)|;|[XYZIJKRPUé]-?[0-9]{1,2}(\\.[05])?)[ \n]){0,30}",
    ) {
        match read("a.nc", text.as_bytes(), &profile, &tools()) {
            Ok(program) => {
                let listing = print(&program, &profile).unwrap();
                let reread = read("a.nc", listing.program.as_bytes(), &profile, &listing.tools).unwrap();
                let blocks = |program: Program| program.blocks.into_iter().map(|read| read.block).collect::<Vec<_>>();
                prop_assert_eq!(blocks(reread), blocks(program));
            }
            Err(fault) => {
                prop_assert!(fault.line >= 1 && (fault.line as usize) <= text.matches('\n').count() + 1);
                let columns = fault.source_line.chars().count() as u32;
                prop_assert!(fault.column >= 1 && fault.column + fault.length <= columns + 2);
                prop_assert!(fault.to_string().contains(&fault.message));
            }
        }
    }
}

#[test]
fn a_dummy_block_prints_in_offset_mode_only() {
    let profile = Profile::builtin("yasnac-lx").unwrap();
    let point = |a: i32, b: i32| [Rational::from(a), Rational::from(b)];
    let mut blocks = vec![
        Block::moving(Movement::Line { end: point(10, 0) }),
        Block::moving(Movement::Dummy { vector: point(1, 2) }),
        Block::moving(Movement::Line { end: point(11, 2) }),
    ];
    assert!(matches!(print_blocks(&blocks, &profile), Err(PrintError::Refused(_))));
    blocks[0].compensation = Some(Compensation::On(Side::Right));
    blocks[0].radius = Some(Rational::from((4, 5)));
    let listing = print_blocks(&blocks, &profile).unwrap();
    let expected = "%\n(profile yasnac-lx, plane G18)\nN1 G42 T0101 G01 Z10 X0\nN2 G01 K1 I2\nN3 G01 Z11 X4\n%\n";
    assert_eq!(listing.program, expected);
    assert_eq!(listing.tool_table, "[[tool]]\nnumber = 1\nradius = \"0.8\"\n");
}

#[test]
fn what_has_no_g_code_is_refused_with_its_block() {
    let mill = Profile::builtin("seed-mill").unwrap();
    let third = Block::moving(Movement::Line { end: [Rational::from((1, 3)), Rational::new()] });
    let blocks = [Block::empty(), third];
    let number = PrintError::Number { block: 1, value: Rational::from((1, 3)) };
    assert_eq!(print_blocks(&blocks, &mill), Err(number));
    let corner = Block { corner: Some(OuterCorner::Arc), ..Block::empty() };
    let refused = print_blocks(&[corner], &mill);
    assert_eq!(refused, Err(PrintError::NoCode { block: 0, wanted: "this choice of the outer corner" }));
}
