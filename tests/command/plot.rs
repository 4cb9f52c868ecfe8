//! `radcomp plot`.

use super::{complaint, mill, printed, radcomp};

#[test]
fn a_picture_is_written_to_a_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("first.svg");
    let name = path.to_str().unwrap();
    let options = ["plot", "examples/first.nc", "-p", "seed-mill", "-t", "examples/tools.toml", "-o", name];
    assert_eq!(printed(radcomp(&options)), "");
    let picture = std::fs::read_to_string(&path).unwrap();
    assert!(picture.starts_with("<svg "), "{picture}");
    for part in
        ["examples/first.nc", "N90", "corner move", "rapid traverse", "10 mm", "fill=\"white\"", "stroke-dasharray"]
    {
        assert!(picture.contains(part), "{part}");
    }
    assert!(!picture.contains("NaN") && !picture.contains("inf"));
    printed(radcomp(&options));
    assert_eq!(picture, std::fs::read_to_string(&path).unwrap(), "the picture is the same every time");
}

#[test]
fn the_picture_in_the_examples_is_up_to_date() {
    let options = ["plot", "examples/first.nc", "-p", "seed-mill", "-t", "examples/tools.toml", "-o", "-"];
    assert_eq!(printed(radcomp(&options)).trim_end(), super::example("first.svg").trim_end());
}

#[test]
fn a_lathe_is_drawn_with_z_to_the_right() {
    let options = ["plot", "examples/turning.nc", "-p", "yasnac-lx", "-t", "examples/tools.toml", "-o", "-"];
    let picture = printed(radcomp(&options));
    assert!(picture.contains("plane G18 (Z, X), tool radius 0.8 mm"), "{picture}");
}

#[test]
fn an_alarm_is_drawn_and_told() {
    let program = "G41 D1 G01 X10 F1\nY20\nG02 X20 Y20 R2\nG01 X40\n";
    let output = mill("plot", &["-o", "-"], program).assert().code(1).get_output().clone();
    let picture = String::from_utf8(output.stdout).unwrap();
    assert!(picture.contains("no-such-arc at line 3") && picture.contains("alarm: the tool stops"), "{picture}");
    assert!(String::from_utf8(output.stderr).unwrap().contains("[TRC-ARC-06]"));
}

#[test]
fn programs_that_hardly_move_are_drawn() {
    for program in ["", "G04 P1\n", "G01 X1 F1\n", "G01 X0.001 F1\n", "G01 X999999999 F1\n", "G02 X0 Y0 I1 J0 F1\n"] {
        let picture = printed(mill("plot", &["-o", "-"], program));
        assert!(picture.trim_end().ends_with("</svg>") && !picture.contains("NaN"), "{program}");
    }
}

#[test]
fn a_long_program_says_what_is_left_out() {
    let mut program = "G41 D1 G01 X-10 F1\n".to_owned();
    for index in 0..200 {
        program.push_str(&format!("X{} Y{}\n", index * 20, index % 2 * 15));
    }
    let picture = printed(mill("plot", &["-o", "-"], &program));
    assert!(picture.contains("The tool is drawn at 60 of its "), "{picture}");
    assert!(picture.contains("80 of 201 blocks are named."));
}

#[test]
fn a_picture_that_cannot_be_written_is_told() {
    let complaint = complaint(mill("plot", &["-o", "/nowhere/a.svg"], "G01 X1 F1\n"), 2);
    assert!(complaint.contains("/nowhere/a.svg cannot be written"), "{complaint}");
}
