//! `radcomp explain`.

use super::{complaint, mill, printed, radcomp};

const FIRST: [&str; 6] = ["explain", "examples/first.nc", "-p", "seed-mill", "-t", "examples/tools.toml"];

#[test]
fn every_block_is_told_with_its_corner_its_margin_and_its_clause() {
    let text = printed(radcomp(&FIRST));
    let squeezed = text.split_whitespace().collect::<Vec<_>>().join(" ");
    for part in [
        "line 1 | N10 G90 G17 G00 X-20 Y-15",
        "rapid, straight to X -20 Y -15 [TRC-MODE-01]",
        "compensation on, tool left of the path",
        "tool radius 5 mm",
        "with line 9: inner corner: the path turns by 126.8699° to the tool's side; margin 20 mm [TRC-CORNER-01]",
        "it turns by more than 90°: an acute corner; margin 15 mm [TRC-CORNER-08]",
        "Y = 38 + √29",
        "[TRC-CORNER-03] Inner corner of two lines At an inner corner of two lines the vector is the intersection",
        "the tool fits inside the arc; margin 10 mm [TRC-ARC-05]",
    ] {
        assert!(squeezed.contains(part), "{part} is not in:\n{text}");
    }
    assert_eq!(text.lines().filter(|line| line.starts_with("line ")).count(), 12);
}

#[test]
fn one_block_is_told_alone() {
    for choice in [["--block", "40"], ["--block", "N0040"], ["--line", "4"]] {
        let text = printed(radcomp(&[&FIRST[..], &choice].concat()));
        assert!(text.starts_with("line 4 | N40 X25 Y50\n"), "{text}");
        assert_eq!(text.lines().filter(|line| line.starts_with("line ")).count(), 1);
    }
    let complaint = complaint(radcomp(&[&FIRST[..], &["--block", "41"]].concat()), 2);
    assert!(complaint.contains("no block N41 was reached"), "{complaint}");
}

#[test]
fn a_block_that_is_told_alone_is_not_hurt_by_what_follows() {
    printed(mill("explain", &["--line", "1"], "G01 X10 F1\nX20\nX X\n"));
}

#[test]
fn an_alarm_and_an_advisory_stand_in_their_blocks() {
    let program = "G41 D1 G01 X10 F1\nX50\nX10 Y1\nG02 X20 Y1 R2\n";
    let output = mill("explain", &[], program).assert().code(1).get_output().clone();
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("WARNING      far-intersection: the intersection lies far from the corner: "), "{text}");
    assert!(text.contains("ALARM        no-such-arc: no single arc"), "{text}");
    assert!(String::from_utf8(output.stderr).unwrap().contains("[TRC-ARC-06]"));
}

#[test]
fn a_side_change_and_a_straight_corner_have_words_of_their_own() {
    let text = printed(mill("explain", &[], "G41 D1 G01 X10 F1\nX20\nX30\nG42 Y40\nG40 X0\n"));
    assert!(text.contains("tangent: the path goes straight on"), "{text}");
    assert!(text.contains("the path turns by 90° where the side changes"), "{text}");
}

#[test]
fn a_lathe_program_is_told_in_diameters() {
    let text = printed(radcomp(&[
        "explain",
        "examples/turning.nc",
        "-p",
        "yasnac-lx",
        "-r",
        "0.8",
        "-t",
        "examples/tools.toml",
        "--block",
        "60",
    ]));
    assert!(text.contains("programmed   straight, X 20 Z -2 to X 20 Z -15, 13 mm"), "{text}");
    assert!(text.contains("straight to X 21.6 Z -15 [TRC-CORNER-02]"), "{text}");
}
