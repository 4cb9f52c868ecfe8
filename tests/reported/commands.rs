//! `radcomp replay`, `compare`, `certificate` and `certify --waivers`, end to end.

use std::fs::{self, File};
use std::path::Path;

use assert_cmd::Command;
use radcomp::report::Report;

use crate::campaigns::{faulty, sound};

/// Exit status and output.
fn radcomp(folder: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let output = Command::cargo_bin("radcomp").unwrap().current_dir(folder).args(arguments).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code(), text(output.stdout) + &text(output.stderr))
}

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, report: &Report| report.write(File::create(folder.path().join(name)).unwrap()).unwrap();
    // `replay` opens the device by its name.
    write("red.json", &Report { device: "builtin".to_owned(), ..faulty().clone() });
    write("green.json", sound());
    folder
}

#[test]
fn a_failure_is_asked_again() {
    let folder = folder();
    let causes = faulty().causes.len();
    // The device of the report had faults that builtin has not.
    let (status, out) = radcomp(folder.path(), &["replay", "red.json"]);
    assert_eq!((status, out.matches("changed ").count()), (Some(0), causes), "{out}");
    assert!(out.contains("exact, was inadmissible"), "{out}");
    let cause = &faulty().causes[0].cause;
    let (status, out) = radcomp(folder.path(), &["replay", "red.json", "--case", cause]);
    assert_eq!((status, out.lines().count()), (Some(0), 2), "{out}");
    // A device that fails in the same way every time.
    let mut same = faulty().clone();
    same.device = "pipe:false".to_owned();
    same.causes.truncate(1);
    let case = same.causes[0].case.as_mut().unwrap();
    (case.verdict, case.divergence, case.answer) = ("crash".to_owned(), None, None);
    case.fault = Some("the device ended with exit status 1".to_owned());
    same.write(File::create(folder.path().join("same.json")).unwrap()).unwrap();
    let (status, out) = radcomp(folder.path(), &["replay", "same.json"]);
    assert!(status == Some(1) && out.starts_with("same "), "{out}");
    let (status, _) = radcomp(folder.path(), &["replay", "red.json", "--case", "no such"]);
    assert_eq!(status, Some(2));
}

#[test]
fn reports_are_compared() {
    let folder = folder();
    let (status, out) = radcomp(folder.path(), &["compare", "red.json", "green.json"]);
    assert!(status == Some(0) && out.contains("BETTER failed programs") && out.contains(" 0 worse"), "{out}");
    let (status, out) = radcomp(folder.path(), &["compare", "green.json", "red.json"]);
    assert!(status == Some(1) && out.contains("WORSE cause TRC-CORNER-08"), "{out}");
    let (status, out) = radcomp(folder.path(), &["compare", "red.json", "red.json"]);
    assert!(status == Some(0) && out == "0 better, 0 worse\n", "{out}");
}

#[test]
fn no_certificate_of_a_red_or_partial_report() {
    let folder = folder();
    for report in ["red.json", "green.json"] {
        let (status, out) =
            radcomp(folder.path(), &["certificate", report, "--make-key", "key.pem", "--output", "certificate.json"]);
        assert!(status == Some(1) && out.ends_with("NO CERTIFICATE\n"), "{out}");
    }
    assert!(!folder.path().join("certificate.json").exists() && !folder.path().join("key.pem").exists());
}

/// From a certification to its certificate.
#[test]
fn a_level_is_certified_signed_and_verified() {
    let folder = folder();
    let certify = ["certify", "builtin", "--profile", "seed-mill", "--report", "r.json", "--html", "r.html"];
    let (status, out) = radcomp(folder.path(), &[&certify[..], &["--junit", "r.xml"]].concat());
    assert_eq!(status, Some(0), "{out}");
    for file in ["r.html", "r.xml"] {
        assert!(fs::metadata(folder.path().join(file)).unwrap().len() > 1000);
    }
    let sign = ["certificate", "r.json", "--make-key", "key.pem", "--output", "c.json", "--html", "c.html"];
    let (status, out) = radcomp(folder.path(), &sign);
    assert_eq!(status, Some(0), "{out}");
    let (status, out) = radcomp(folder.path(), &["verify-certificate", "c.json", "--report", "r.json"]);
    assert!(status == Some(0) && out.ends_with("VERIFIED\n"), "{out}");
    let other = ["verify-certificate", "c.json", "--report", "r.json", "--quick", "--public-key", "00"];
    let (status, out) = radcomp(folder.path(), &other);
    assert!(status == Some(1) && out.contains("another key"), "{out}");
    let text = fs::read_to_string(folder.path().join("r.json")).unwrap();
    fs::write(folder.path().join("r.json"), text.replacen("\"level\": 1", "\"level\": 2", 1)).unwrap();
    let (status, out) = radcomp(folder.path(), &["verify-certificate", "c.json", "--report", "r.json", "--quick"]);
    assert!(status == Some(1) && out.contains("NOT VERIFIED"), "{out}");
}

#[test]
fn an_unused_waiver_is_an_error() {
    let folder = folder();
    let waivers = "[[waiver]]\nclause = \"TRC-CORNER-08\"\nreason = \"none needed\"\n";
    fs::write(folder.path().join("waivers.toml"), waivers).unwrap();
    let certify = ["certify", "builtin", "--profile", "seed-mill", "--waivers", "waivers.toml"];
    let (status, out) = radcomp(folder.path(), &certify);
    assert!(status == Some(2) && out.contains("waivers that cover no failure\nTRC-CORNER-08: none needed"), "{out}");
}
