//! Answers that were written down: `radcomp gen`, an adapter, `radcomp check`.

use std::io::Write;
use std::process::{Command, Stdio};

use super::RADCOMP;

const ARGUMENTS: [&str; 4] = ["--profile", "yasnac-lx", "--programs", "300"];

/// What a command prints, what it complains of, and its exit status.
fn run(arguments: &[&str], input: &str) -> (String, String, Option<i32>) {
    let mut child = Command::new(RADCOMP)
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let (mut stdin, text) = (child.stdin.take().unwrap(), input.to_owned());
    // A command may end before it has read its input.
    let writer = std::thread::spawn(move || drop(stdin.write_all(text.as_bytes())));
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (text(output.stdout), text(output.stderr), output.status.code())
}

fn command(name: &str, input: &str) -> (String, String, Option<i32>) {
    run(&[&[name], &ARGUMENTS[..]].concat(), input)
}

#[test]
fn answers_of_the_implementation_pass_and_spoilt_ones_fail() {
    let (requests, _, _) = command("gen", "");
    let (answers, _, _) = run(&["answer"], &requests);
    let (verdict, _, status) = command("check", &answers);
    assert!(verdict.ends_with("PASS\n") && status == Some(0), "{verdict}");

    let one_missing: String = answers.lines().skip(1).map(|line| format!("{line}\n")).collect();
    let (verdict, _, status) = command("check", &one_missing);
    assert!(verdict.contains("no-answer: 1\n") && status == Some(1), "{verdict}");

    let first = answers.lines().next().unwrap();
    let (verdict, _, status) = command("check", &format!("{answers}{first}\n"));
    assert!(verdict.contains("garbled: 1\n") && status == Some(1), "{verdict}");

    let (_, complaint, status) = command("check", &format!("{answers}starting up\n"));
    assert!(complaint.contains("not an answer") && status == Some(2), "{complaint}");

    let of_another_seed = answers.replace("\"#7\"", "\"#700\"");
    let (_, complaint, status) = command("check", &of_another_seed);
    assert!(complaint.contains("answers are for programs that were not asked") && status == Some(2), "{complaint}");
}

#[test]
fn nothing_answered_is_never_green() {
    let (verdict, _, status) = command("check", "");
    assert!(verdict.ends_with("RED\n") && status == Some(1), "{verdict}");

    let (requests, _, _) = command("gen", "");
    let refuse = |line: &str| {
        let request: serde_json::Value = serde_json::from_str(line).unwrap();
        format!("{}\n", serde_json::json!({ "id": request["id"], "unsupported": "no" }))
    };
    let answers: String = requests.lines().map(refuse).collect();
    let (verdict, _, status) = command("check", &answers);
    assert!(verdict.contains("INCOMPLETE") && status == Some(1), "{verdict}");
    let (verdict, _, status) = run(&[&["check", "--allow-unsupported"], &ARGUMENTS[..]].concat(), &answers);
    assert!(verdict.contains("INCOMPLETE") && status == Some(1), "{verdict}");
}

/// What `certify` writes of a campaign `check` writes of answers.
#[test]
fn a_report_and_its_pages_are_written_of_recorded_answers() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).display().to_string();
    let (requests, _, _) = command("gen", "");
    let (answers, _, _) = run(&["answer"], &requests);
    // A centre path that is a tenth of a millimetre off wherever a corner was formed.
    let spoil = |line: &str| {
        let mut answer: serde_json::Value = serde_json::from_str(line).unwrap();
        for step in answer["steps"].as_array_mut().into_iter().flatten() {
            if step["clause"] == "TRC-CORNER-03"
                && let Some(end) = step.get_mut("end")
            {
                end[0] = (end[0].as_f64().unwrap() + 0.1).into();
            }
        }
        format!("{answer}\n")
    };
    let spoilt: String = answers.lines().map(spoil).collect();
    std::fs::write(path("answers.jsonl"), &spoilt).unwrap();
    let (answers, report, junit, html) = (path("answers.jsonl"), path("r.json"), path("r.xml"), path("r.html"));
    let check = [&["check", &answers][..], &ARGUMENTS, &["--report", &report, "--junit", &junit, "--html", &html]];
    let (told, _, status) = run(&check.concat(), "");
    assert!(told.ends_with("RED\n") && status == Some(1), "{told}");
    let replay = format!("replay: radcomp replay {report} --case ");
    assert!(told.contains("safety: ") && told.contains("nearest decision: ") && told.contains(&replay), "{told}");
    let [xml, page] = [&junit, &html].map(|file| std::fs::read_to_string(file).unwrap());
    assert!(xml.contains("safety: ") && xml.contains("nearest decision: ") && xml.contains("radcomp replay"), "{xml}");
    assert!(
        page.contains("<dt>Safety</dt>")
            && page.contains("<dt>Nearest decision</dt>")
            && page.contains("radcomp replay")
    );
    let (_, complaint, status) = run(&["verify-witness", &report], "");
    assert_eq!(status, Some(0), "{complaint}");
    let read = radcomp::report::Report::open(report.as_ref()).unwrap();
    assert_eq!((read.device.as_str(), read.level, read.device_files.len()), ("recorded", None, 1));

    // Waivers for every cause make it green.
    let waiver = |cause: &radcomp::report::Cause| {
        format!("[[waiver]]\nclause = \"{}\"\nreason = \"spoilt\"\n", cause.clause.unwrap().0)
    };
    let mut waivers: Vec<_> = read.causes.iter().map(waiver).collect();
    waivers.sort();
    waivers.dedup();
    std::fs::write(path("waivers.toml"), waivers.concat()).unwrap();
    let waivers = path("waivers.toml");
    let waived = [&["check", &answers][..], &ARGUMENTS, &["--waivers", &waivers]].concat();
    let (told, complaint, status) = run(&waived, "");
    assert!(told.contains("expected failures: ") && status == Some(0), "{told}{complaint}");
}
