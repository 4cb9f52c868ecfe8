//! `radcomp run`.

use serde_json::Value;

use super::{complaint, example, mill, printed, radcomp};

const FIRST: [&str; 6] = ["run", "examples/first.nc", "--profile", "seed-mill", "--tools", "examples/tools.toml"];

#[test]
fn text_has_a_line_for_each_path_element_with_closed_forms() {
    let text = printed(radcomp(&FIRST));
    let line = |number: usize| text.lines().nth(number).unwrap().split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(line(1), "1 N10 rapid X -20.000000 Y -15.000000 TRC-MODE-01");
    assert_eq!(line(3), "3 N30 line X -5.000000 Y 43.385165 TRC-CORNER-06 Y = 38 + √29");
    assert_eq!(line(7), "6 N60 arc ccw X 85.000000 Y 40.000000 TRC-CORNER-07 about X 85 Y 50");
    assert_eq!(line(12), "10 N100 corner line X 65.000000 Y -5.000000 TRC-CORNER-08");
    assert_eq!(line(16), "12 blocks, 15 path elements");
}

#[test]
fn digits_are_chosen() {
    let text = printed(mill("run", &["--digits", "2"], "G41 D1 G01 X10 F1\nX20 Y10\nG40 Y30\n"));
    assert!(text.contains("X      6.46   Y      3.54   TRC-START-02"), "{text}");
}

#[test]
fn a_lathe_has_its_diameters_back() {
    let text = printed(radcomp(&["run", "examples/turning.nc", "-p", "yasnac-lx", "-t", "examples/tools.toml"]));
    let facing = text.lines().find(|line| line.contains("N60 ")).unwrap();
    let words: Vec<&str> = facing.split_whitespace().collect();
    // The programmed diameter is 20, the nose 0.8: the centre runs at 21.6.
    assert_eq!(words[3..7], ["X", "21.600000", "Z", "-15.000000"]);
}

#[test]
fn the_tip_of_a_lathe_stands_under_its_nose() {
    let folder = tempfile::tempdir().unwrap();
    let tools = folder.path().join("tools.toml");
    std::fs::write(&tools, "[[tool]]\nnumber = 1\nradius = \"1.1\"\nwear = \"-0.1\"\norientation = 3\n").unwrap();
    let program = folder.path().join("a.nc");
    std::fs::write(&program, "T0101\nG00 X20 Z5\nG42 G01 Z0 F0.2\nZ-20\nG40 X40\n").unwrap();
    let run = |more: &[&str]| {
        let paths = [program.to_str().unwrap(), "-p", "mori-lathe", "-t", tools.to_str().unwrap(), "--tip"];
        printed(radcomp(&[&["run"], &paths[..], more].concat()))
    };
    let text = run(&[]);
    let tips: Vec<_> = text.lines().filter(|line| line.trim_start().starts_with("tip")).collect();
    let words = |line: &str| line.split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(words(tips[1]), "tip X 20.000000 Z -1.000000");
    assert_eq!(words(tips[3]), "tip X 40.000000 Z -20.000000");
    let document: Value = serde_json::from_str(&run(&["-f", "json", "--engine", "impl"])).unwrap();
    let events = document["events"].as_array().unwrap();
    assert_eq!((&events[3]["end"]["X"]["decimal"], &events[3]["tip"]["X"]["decimal"]), (&"22".into(), &"20".into()));
    assert_eq!(events[0]["tip"], Value::Null);
}

#[test]
fn an_alarm_has_the_number_that_the_profile_gives() {
    let program = "G41 D1 G02 X5 Y5 R5\n";
    let run = |profile: &str| {
        let arguments = ["run", "-", "--profile", profile, "--radius", "1", "-f", "json"];
        radcomp(&arguments).write_stdin(program).assert().code(1).get_output().clone()
    };
    let output = run("fanuc-30i");
    let document: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(document["alarm"]["number"], "PS0034");
    let complaint = String::from_utf8(output.stderr).unwrap();
    assert!(complaint.contains("profile fanuc-30i gives this alarm as: PS0034 (K)"), "{complaint}");
    let document: Value = serde_json::from_slice(&run("seed-mill").stdout).unwrap();
    assert_eq!(document["alarm"]["number"], Value::Null);
}

#[test]
fn json_is_one_document() {
    let text = printed(radcomp(&[&FIRST[..], &["--format", "json"]].concat()));
    let document: Value = serde_json::from_str(&text).unwrap();
    assert_eq!((&document["profile"], &document["plane"]), (&Value::from("seed-mill"), &Value::from("xy")));
    assert_eq!((&document["alarm"], &document["blocks"]), (&Value::Null, &Value::from(12)));
    let events = document["events"].as_array().unwrap();
    assert_eq!(events.len(), 15);
    assert_eq!(events[2]["end"]["Y"]["exact"], "38 + √29");
    assert_eq!(events[2]["n"], "30");
    assert_eq!(events[6]["kind"], "arc");
    assert_eq!(events[6]["direction"], "ccw");
    assert_eq!(events[6]["centre"]["X"]["decimal"], "85");
    assert_eq!(events[5]["main"], false);
}

#[test]
fn json_without_blocks_is_a_document_too() {
    let document: Value = serde_json::from_str(&printed(mill("run", &["-f", "json"], ""))).unwrap();
    assert_eq!((&document["events"], &document["blocks"]), (&Value::Array(vec![]), &Value::from(0)));
}

#[test]
fn json_says_what_stopped_the_program() {
    let stopped = |program: &str, status: i32| -> Value {
        let output = mill("run", &["-f", "json"], program).assert().code(status).get_output().stdout.clone();
        serde_json::from_slice(&output).unwrap()
    };
    let alarm = stopped("G41 D1 G01 X10 F1\nY20\nN7 G02 X20 Y20 R2\n", 1)["alarm"].clone();
    assert_eq!((&alarm["alarm"], &alarm["line"], &alarm["n"]), (&"no-such-arc".into(), &3.into(), &"7".into()));
    let refused = stopped("G01 X10 F1\nX2 X3\n", 2)["refused"].clone();
    assert_eq!((&refused["line"], &refused["column"]), (&2.into(), &4.into()));
}

#[test]
fn json_carries_advisories() {
    let program = "G41 D1 G01 X10 F1\nX50\nX10 Y1\nY40\nG40 X0\n";
    let document: Value = serde_json::from_str(&printed(mill("run", &["-f", "json"], program))).unwrap();
    let events = document["events"].as_array().unwrap();
    let advisory = events.iter().find(|event| event["kind"] == "advisory").unwrap();
    assert_eq!(advisory["advisory"], "far-intersection");
    assert_eq!(advisory["line"], 3);
    assert!(advisory["amount"]["decimal"].as_str().unwrap().parse::<f64>().unwrap() > 25.0);
}

#[test]
fn canon_is_what_rs274_prints_but_with_more_digits() {
    let canon = |digits: &[&str]| {
        let options = ["run", "examples/pocket.nc", "-p", "seed-mill", "-r", "5", "-f", "canon"];
        printed(radcomp(&[&options, digits].concat()))
    };
    let text = canon(&["--digits", "4"]);
    let calls: Vec<&str> = text.lines().collect();
    assert_eq!(calls[0], "    1 N10    STRAIGHT_TRAVERSE(40.0000, 25.0000, 0.0000, 0.0000, 0.0000, 0.0000)");
    // Moves along the normal axis alone.
    assert_eq!(calls[1], "    2 N20    STRAIGHT_TRAVERSE(40.0000, 25.0000, 5.0000, 0.0000, 0.0000, 0.0000)");
    assert_eq!(calls[2], "    3 N30    STRAIGHT_FEED(40.0000, 25.0000, -4.0000, 0.0000, 0.0000, 0.0000)");
    let arc = "    6 N60    ARC_FEED(75.0000, 8.0000, 72.0000, 8.0000, 1, -4.0000, 0.0000, 0.0000, 0.0000)";
    assert_eq!(calls[5], arc);
    assert_eq!(calls.len(), 15);
    assert!(canon(&[]).contains("STRAIGHT_FEED(72.000000000000000, 5.0000000000000000, -4.0000000000000000, "));
}

#[test]
fn canon_keeps_the_order_of_the_axes_in_every_plane() {
    let canon = |program: &str| printed(mill("run", &["-f", "canon", "--digits", "0"], program));
    let turned = canon("G18 G00 Z1 X2\nY3\nG02 Z2 X3 K1 I0 F1\n");
    assert!(turned.contains("STRAIGHT_TRAVERSE(2, 0, 1, 0, 0, 0)"), "{turned}");
    assert!(turned.contains("STRAIGHT_TRAVERSE(2, 3, 1, 0, 0, 0)"), "{turned}");
    assert!(turned.contains("N.....") && turned.contains("ARC_FEED(2, 3, 2, 2, -1, 3, 0, 0, 0)"), "{turned}");
    let upright = canon("G19 G01 Y1 Z2 F1\n");
    assert!(upright.contains("STRAIGHT_FEED(0, 1, 2, 0, 0, 0)"), "{upright}");
}

#[test]
fn corner_moves_keep_the_depth_of_the_block_before() {
    let program = "G41 D1 G01 X0 Y10 F1\nX20 Z-1\nX0 Y0 Z-2\nG40 X-9\n";
    let text = printed(mill("run", &["-f", "canon", "--digits", "0"], program));
    let depths: Vec<&str> = text.lines().map(|call| call.split(", ").nth(2).unwrap()).collect();
    assert_eq!(depths, ["0", "-1", "-1", "-2", "-2"], "{text}");
}

#[test]
fn the_implementation_runs_the_same_program() {
    let text = printed(radcomp(&[&FIRST[..], &["--engine", "impl"]].concat()));
    assert!(text.contains("X     -5.000000   Y     43.385165   TRC-CORNER-06"), "{text}");
    assert!(!text.contains('√'));
}

#[test]
fn an_alarm_names_its_block_and_its_clause() {
    for engine in ["model", "impl"] {
        let mut command = radcomp(&["run", "examples/first.nc", "-p", "seed-mill", "-r", "15", "--engine", engine]);
        let output = command.assert().code(1).get_output().clone();
        let (path, complaint) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
        assert!(path.contains("stopped at an alarm after 5 path elements"), "{path}");
        for part in ["radius-too-small at N60", "first.nc:6", "N60 G03 X85 Y35 I15 J0", "[TRC-ARC-05]"] {
            assert!(complaint.contains(part), "{part} is not in:\n{complaint}");
        }
    }
}

#[test]
fn advisories_stand_between_the_path_elements() {
    let text = printed(mill("run", &[], "G41 D1 G01 X10 F1\nX50\nX10 Y1\nY40\nG40 X0\n"));
    assert!(text.contains("warning far-intersection: ") && text.contains("[TRC-WEDGE-01]"), "{text}");
}

#[test]
fn blocks_with_a_slash_are_skipped_on_demand() {
    let program = "G01 X1 F1\n/ X2\nX3\n";
    assert!(printed(mill("run", &[], program)).contains("3 blocks"));
    assert!(printed(mill("run", &["--block-delete"], program)).contains("2 blocks"));
}

#[test]
fn the_radius_option_takes_the_place_of_tool_1() {
    let options = [&FIRST[..], &["--radius", "2"]].concat();
    assert!(printed(radcomp(&options)).contains("X     -2.000000   Y      0.000000"));
    for wrong in ["--1", "five", "1e3", "1.0000000001"] {
        let complaint = complaint(radcomp(&[&FIRST[..], &["--radius", wrong]].concat()), 2);
        assert!(complaint.contains("a radius is a decimal"), "{complaint}");
    }
}

#[test]
fn the_examples_of_the_help_run() {
    assert_eq!(example("first.nc").lines().count(), 12);
    let folder = tempfile::tempdir().unwrap();
    let examples = folder.path().join("examples");
    std::fs::create_dir(&examples).unwrap();
    for name in ["first.nc", "pocket.nc", "turning.nc", "tools.toml"] {
        std::fs::write(examples.join(name), example(name)).unwrap();
    }
    let mut count = 0;
    for subcommand in ["run", "explain", "plot", "profiles", "clause", "completions"] {
        let help = printed(radcomp(&[subcommand, "--help"]));
        assert!(help.contains("Examples:") && help.lines().all(|line| line.chars().count() <= 100), "{help}");
        let lines = help.lines().filter_map(|line| line.trim().strip_prefix("radcomp "));
        // Programs and profiles that the reader has, not the repository, and what only a shell can run.
        let runs = lines.filter(|line| !["part.nc", "my-lathe", " > "].iter().any(|part| line.contains(part)));
        for line in runs {
            printed({
                let mut command = radcomp(&line.split_whitespace().collect::<Vec<_>>());
                command.current_dir(folder.path());
                command
            });
            count += 1;
        }
    }
    assert!(count >= 10, "{count}");
}
