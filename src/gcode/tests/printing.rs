//! What the printer writes for each kind of block, word by word.

use radcomp_spec::profile::Profile;
use radcomp_spec::{AlarmKind, Block, Centre, Compensation, Direction, Movement, OuterCorner, Side};
use rug::Rational;

use crate::gcode::{PrintError, Tool, Tools, print, print_blocks, read};

fn profile(name: &str) -> Profile {
    Profile::builtin(name).unwrap()
}

fn point(a: i32, b: i32) -> [Rational; 2] {
    [Rational::from(a), Rational::from(b)]
}

fn line(a: i32, b: i32) -> Block<Rational> {
    Block::moving(Movement::Line { end: point(a, b) })
}

/// The start-up block, with a tool of 1 mm.
fn on(a: i32, b: i32) -> Block<Rational> {
    Block { compensation: Some(Compensation::On(Side::Left)), radius: Some(Rational::from(1)), ..line(a, b) }
}

/// The last block of the listing, without its number.
fn last(blocks: &[Block<Rational>], profile: &Profile) -> Result<String, PrintError> {
    let listing = print_blocks(blocks, profile)?.program;
    let line = listing.lines().rev().find(|line| line.starts_with('N')).unwrap_or_default();
    Ok(line.split_once(' ').map_or_else(String::new, |(_, words)| words.to_owned()))
}

#[test]
fn every_corner_code_prints() {
    let corner = |corner| [Block { corner: Some(corner), ..Block::empty() }];
    for (name, wanted, code) in [
        ("fanuc-16", OuterCorner::Arc, None),
        ("siemens-840d", OuterCorner::Arc, Some("G450")),
        ("siemens-840d", OuterCorner::LimitAngle, Some("G451")),
        ("haas-a", OuterCorner::Intersection, None),
    ] {
        let no_code = PrintError::NoCode { block: 0, wanted: "this choice of the outer corner" };
        assert_eq!(last(&corner(wanted), &profile(name)), code.map(str::to_owned).ok_or(no_code), "{name}");
    }
    let own = Profile::changed("seed-mill", "own", [("corner-codes", r#""m96-m97""#)]).unwrap();
    assert_eq!(last(&corner(OuterCorner::Arc), &own).unwrap(), "M96");
    assert_eq!(last(&corner(OuterCorner::Intersection), &own).unwrap(), "M97");
}

#[test]
fn codes_that_are_not_for_offset_mode_print_in_it_alone() {
    let coded = |kind| Block { not_in_mode: Some(kind), ..Block::empty() };
    let changes = [
        ("plane-change", r#""alarm""#),
        ("set-coordinates", r#""alarm""#),
        ("tool-change", r#""alarm""#),
        ("reference-return", r#""alarm""#),
    ];
    for (base, plane) in [("seed-mill", "G18"), ("okuma-osp", "G17")] {
        let own = Profile::changed(base, "own", changes).unwrap();
        for (kind, code) in [
            (AlarmKind::PlaneChangeInMode, plane),
            (AlarmKind::SetCoordinatesInMode, "G92 X0"),
            (AlarmKind::ToolChangeInMode, "M06"),
            (AlarmKind::ReferenceReturnInMode, "G28"),
        ] {
            assert_eq!(last(&[on(10, 0), line(20, 0), coded(kind)], &own).as_deref(), Ok(code), "{base}");
        }
        // Outside of offset mode the code reads as none that is forbidden.
        assert_eq!(last(&[coded(AlarmKind::ToolChangeInMode)], &own), Err(PrintError::Different { block: 0 }));
    }
}

#[test]
fn tools_are_told_apart_by_size_and_orientation() {
    let lathe = profile("okuma-osp");
    let with = |count: i32| {
        let radius = |number: i32| Some(Rational::from((number + 1, 1000)));
        let blocks = (0..count).map(|number| Block { radius: radius(number), ..line(number + 1, 0) });
        print_blocks(&blocks.collect::<Vec<_>>(), &lathe)
    };
    assert!(with(99).unwrap().program.contains("T9999"));
    assert_eq!(with(100), Err(PrintError::TooManyRadii));

    let tool = |orientation| Tool { orientation: Some(orientation), ..Tool::of_radius(Rational::from(1)) };
    let tools = Tools::empty().with_tool(1, tool(3)).with_tool(2, tool(2));
    let text = "T0101\nG42 G01 Z10 X0\nZ20\nG40 Z30\nT0202\nG42 Z40\nZ50\nG40 Z60\n";
    let program = read("part.nc", text.as_bytes(), &lathe, &tools).unwrap();
    assert_eq!(print(&program, &lathe).unwrap().tools, tools);
}

#[test]
fn what_moves_prints_with_its_words() {
    let mill = profile("seed-mill");
    let arc =
        Movement::Arc { end: point(2, 0), centre: Centre::FromStart(point(1, 0)), direction: Direction::Clockwise };
    assert_eq!(last(&[Block::moving(arc.clone())], &mill).as_deref(), Ok("G02 X2 Y0 I1 J0"));
    let rapid = Block { rapid: true, ..Block::moving(arc) };
    let refused = PrintError::NoCode { block: 1, wanted: "an arc at rapid traverse" };
    assert_eq!(refused.to_string(), "block 1: there is no code for an arc at rapid traverse");
    assert_eq!(last(&[line(1, 1), rapid], &mill), Err(refused));
    for value in [Rational::from(1_234_567_890), Rational::from((1, 10_000_000_000_u64))] {
        let far = Block::moving(Movement::Line { end: [value.clone(), Rational::new()] });
        assert_eq!(last(&[far], &mill), Err(PrintError::Number { block: 0, value }));
    }
    let vector = Block { compensation: on(0, 0).compensation, vector: Some(point(3, -4)), ..Block::empty() };
    let blocks = [on(10, 0), line(20, 0), vector];
    assert_eq!(last(&blocks, &profile("mitsubishi-m700")).as_deref(), Ok("G41 G01 I3 J-4"));
}

#[test]
fn a_dummy_blocks_first_component_may_be_a_diameter() {
    let own = Profile::changed("yasnac-lx", "own", [("dummy-first-axis", r#""diameter""#)]).unwrap();
    let dummy = Block::moving(Movement::Dummy { vector: point(1, 3) });
    assert_eq!(last(&[on(10, 0), dummy], &own).as_deref(), Ok("G01 K1 I6"));
}
