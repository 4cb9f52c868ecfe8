//! A worked example or a vector, executed by the exact model and drawn.

use radcomp_model::{Engine, Run, run};
use radcomp_spec::profile::Profile;
use radcomp_spec::{Direction, Segment};
use serde::Serialize;

use super::formula::math;
use super::prose::{Prose, escaped};
use super::variation::{Variation, variations};
use crate::explain::{Axes, Choice, Coordinate, Source, Teller};
use crate::gcode::Program;
use crate::plot::{Scene, figure};
use crate::vectors::{Vector, mismatch};

/// An example as its page shows it.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Exhibit {
    /// Its anchor.
    pub(super) id: String,
    /// What it shows, as HTML.
    pub(super) caption: String,
    /// The profile that it runs under.
    profile: String,
    /// Tool and changed parameters, in words.
    setting: Vec<String>,
    /// The lines of the program.
    program: Vec<String>,
    /// The figure; empty if the program is refused.
    figure: String,
    /// The path.
    rows: Vec<Row>,
    /// The alarm that ends it: line and id.
    alarm: Option<[String; 2]>,
    /// Advisories: line, id, amount.
    advisories: Vec<[String; 3]>,
    /// What the program reader says, if it refuses the program.
    refusal: Option<String>,
    /// Decisions, margins and clauses, block by block, as `radcomp explain` tells them.
    told: String,
    /// The same program under the choices of other controls.
    pub(super) variations: Vec<Variation>,
    /// Controls whose choice differs, with the same path.
    same: Vec<String>,
    /// The example as its file has it.
    source: String,
}

/// One step of the path.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Row {
    line: u32,
    /// The move in words, as HTML: decimals.
    words: String,
    /// Closed forms that the decimals do not tell, as MathML.
    closed: String,
    clause: &'static str,
    /// The step is a corner's, not the block's own.
    corner: bool,
}

/// Where an example stands, for messages and anchors.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place<'a> {
    /// Its file, from the root of the repository.
    pub(super) file: &'a str,
    /// The line where it starts, from 1; none if it is not known.
    pub(super) line: Option<u32>,
    /// Its anchor.
    pub(super) id: &'a str,
}

/// Digits after the decimal point.
const DIGITS: usize = 4;

/// Runs and draws an example. `parameters` are the names of those that its clause speaks of.
///
/// # Errors
///
/// If the model does not give what the example says, or it cannot be read: the place and what differs.
pub(super) fn exhibit(
    vector: &Vector,
    caption: &str,
    source: &str,
    place: Place<'_>,
    parameters: &[&str],
    prose: Prose<'_>,
) -> Result<Exhibit, String> {
    let wrong = |reason: String| match place.line {
        Some(line) => format!("{}:{line}: the worked example of {} does not hold: {reason}", place.file, place.id),
        None => format!("{}: the vector {} does not hold: {reason}", place.file, place.id),
    };
    if let Some(reason) = mismatch(vector) {
        return Err(wrong(reason));
    }
    let profile = vector.profile().map_err(wrong)?;
    let mut exhibit = Exhibit {
        id: place.id.to_owned(),
        caption: prose.inline(caption),
        profile: vector.profile.clone(),
        setting: setting(vector),
        program: vector.program.lines().map(str::to_owned).collect(),
        figure: String::new(),
        rows: Vec::new(),
        alarm: None,
        advisories: Vec::new(),
        refusal: None,
        told: String::new(),
        variations: Vec::new(),
        same: Vec::new(),
        source: source.to_owned(),
    };
    let program = match vector.read(&profile).map_err(wrong)? {
        Ok(program) => program,
        Err(diagnostic) => {
            exhibit.refusal = Some(diagnostic.to_string());
            return Ok(exhibit);
        }
    };
    let axes = Axes { plane: program.plane, x_words: program.x_words };
    let outcome = outcome(&program, &profile);
    exhibit.figure = drawn(&program, &profile, vector, &without_marks(caption));
    exhibit.rows = rows(&program, &outcome, axes);
    let line = |block: usize| program.blocks.get(block).map_or(0, |read| read.line).to_string();
    exhibit.alarm = outcome.alarm.map(|alarm| [line(alarm.block), alarm.kind.id().to_owned()]);
    for advisory in &outcome.advisories {
        exhibit.advisories.push([line(advisory.block), advisory.kind.id().to_owned(), advisory.amount.short(DIGITS)]);
    }
    exhibit.told = told(&program, &profile, vector).map_err(wrong)?;
    (exhibit.variations, exhibit.same) = variations(vector, &profile, &program, &outcome, parameters);
    Ok(exhibit)
}

/// The outcome of a program under a profile.
pub(super) fn outcome(program: &Program, profile: &Profile) -> Run {
    run(&profile.parameters, program.blocks.iter().map(|read| &read.block))
}

/// The figure of a program under a profile.
pub(super) fn drawn(program: &Program, profile: &Profile, vector: &Vector, label: &str) -> String {
    let axes = Axes { plane: program.plane, x_words: program.x_words };
    let mut scene = Scene::new(axes);
    let mut engine = Engine::new(&profile.parameters);
    let mut stopped = Ok(());
    for read in &program.blocks {
        scene.read(&read.block, &source_of(read.line, read.sequence.clone(), vector), axes);
        if stopped.is_ok() {
            stopped = engine.push(&read.block, &mut scene);
        }
    }
    if stopped.is_ok() {
        stopped = engine.finish(&mut scene);
    }
    if let Some(alarm) = stopped.err().and_then(|stop| stop.alarm()) {
        scene.alarm(alarm);
    }
    figure(&scene, label)
}

fn source_of(line: u32, sequence: Option<String>, vector: &Vector) -> Source {
    let text = vector.program.lines().nth(line.saturating_sub(1) as usize).unwrap_or_default().to_owned();
    Source { line, sequence, text }
}

/// What `radcomp explain` says of the program.
fn told(program: &Program, profile: &Profile, vector: &Vector) -> Result<String, String> {
    let axes = Axes { plane: program.plane, x_words: program.x_words };
    let mut text = Vec::new();
    let mut teller = Teller::new(&mut text, Choice::All, DIGITS, false);
    let mut engine = Engine::new(&profile.parameters);
    let mut stopped = Ok(());
    for read in &program.blocks {
        teller.read(&read.block, source_of(read.line, read.sequence.clone(), vector), axes);
        stopped = engine.push(&read.block, &mut teller);
        if stopped.is_err() {
            break;
        }
    }
    if stopped.is_ok() {
        stopped = engine.finish(&mut teller);
    }
    teller.finish(stopped.err().and_then(|stop| stop.alarm())).map_err(|error| error.to_string())?;
    drop(teller);
    String::from_utf8(text).map_err(|error| error.to_string())
}

fn setting(vector: &Vector) -> Vec<String> {
    let mut setting = Vec::new();
    if let Some(radius) = &vector.radius {
        setting.push(format!("{} {radius} mm", math("r =")));
    }
    if let Some(wear) = &vector.wear {
        setting.push(format!("wear {wear} mm"));
    }
    if let Some(tip) = vector.tip {
        setting.push(format!("orientation T{tip}"));
    }
    setting.extend(vector.tools.iter().map(|(number, radius)| format!("tool {number}: {radius} mm")));
    for (name, value) in &vector.set {
        let value = escaped(value.to_string().trim_matches('"'));
        setting.push(format!("<a href=\"parameters.html#{name}\"><code>{name}</code></a> = <code>{value}</code>"));
    }
    setting
}

fn rows(program: &Program, outcome: &Run, axes: Axes) -> Vec<Row> {
    let row = |step: &radcomp_spec::Step<_>| {
        let (words, closed) = match &step.segment {
            Segment::Hold => ("no movement in the plane".to_owned(), None),
            Segment::Line { end } => (format!("line to {}", axes.words(end, DIGITS)), axes.closed_forms(end, DIGITS)),
            Segment::Arc { end, centre, direction, full } => {
                let sense = if *direction == Direction::Clockwise { "clockwise" } else { "counter-clockwise" };
                let whole = if *full { "full circle" } else { "arc" };
                let (end_words, centre) = (axes.words(end, DIGITS), axes.words(centre, DIGITS));
                let words = format!("{sense} {whole} to {end_words} about {centre}");
                (words, axes.closed_forms(end, DIGITS))
            }
        };
        Row {
            line: program.blocks.get(step.block).map_or(0, |read| read.line),
            words,
            closed: closed.map_or(String::new(), |forms| forms.split(", ").map(math).collect::<Vec<_>>().join(", ")),
            clause: step.clause.id(),
            corner: !step.main && step.segment != Segment::Hold,
        }
    };
    outcome.steps.iter().map(row).collect()
}

/// Markdown without its marks, for those who hear it.
fn without_marks(text: &str) -> String {
    text.replace(['`', '[', ']', '*'], "").split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::super::links::Links;
    use super::*;

    fn of(path: &str) -> Result<Exhibit, String> {
        let text = format!(
            "profile = \"seed-mill\"\nradius = \"1\"\npath = [{path}]\nprogram = \"\"\"\nG41 D1 G01 X10 F100\nY10\nG40 X0\n\"\"\"\n"
        );
        let links = Links::new([]);
        let place = Place { file: "spec/clauses/01-plane.md", line: Some(12), id: "TRC-PLANE-02-1" };
        let prose = Prose { links: &links, formulas: true, bare: false };
        exhibit(&toml::from_str(&text).unwrap(), "On [TRC-PLANE-02].", &text, place, &["start-up"], prose)
    }

    const RIGHT: &str = r#""1 line 9 0 TRC-START-02", "2 line 9 10 TRC-CANCEL-01", "3 line 0 10 TRC-CANCEL-02""#;

    #[test]
    fn a_wrong_example_is_refused_with_its_file_and_line() {
        assert!(of(RIGHT).is_ok());
        let wrong = of(&RIGHT.replace("9 10", "9 11")).unwrap_err();
        assert!(
            wrong.starts_with("spec/clauses/01-plane.md:12: the worked example of TRC-PLANE-02-1 does not hold"),
            "{wrong}"
        );
        assert!(wrong.contains("step 2: expected"), "{wrong}");
    }

    #[test]
    fn controls_that_choose_otherwise_are_drawn_beside_it() {
        let exhibit = of(RIGHT).unwrap();
        let others: Vec<_> = exhibit.variations.iter().flat_map(|variation| &variation.profiles).collect();
        assert!(others.iter().any(|name| *name == "linuxcnc"), "{others:?}");
        assert!(exhibit.variations.iter().all(|variation| variation.values.iter().all(|[name, _]| name == "start-up")));
        let told = others.len() + exhibit.same.len();
        assert!(told >= 4, "{told}");
    }
}
