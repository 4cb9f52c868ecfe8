//! Alarms, told on the standard error output.

use annotate_snippets::{AnnotationKind, Level, Snippet};
use radcomp::explain::{Source, first_sentence};
use radcomp_model::Stop;
use radcomp_spec::{Alarm, AlarmKind, clause};

use super::failure::Failure;
use super::program::Control;
use super::terminal;

/// The alarm that the model stopped at, if it did.
pub fn of(stopped: Result<(), Stop>) -> Result<Option<Alarm>, Failure> {
    match stopped {
        Ok(()) => Ok(None),
        Err(Stop::Alarm(alarm)) => Ok(Some(alarm)),
        Err(Stop::Contradiction) => {
            Err(Failure::Input("radcomp itself is at fault: its exact answers contradict each other".to_owned()))
        }
    }
}

/// What the control calls an alarm, with the source of that.
fn number(control: &Control, kind: AlarmKind) -> Option<String> {
    let entry = control.profile.alarms.iter().find(|entry| entry.kind == kind)?;
    let (number, name) = (entry.number.as_ref()?, &control.profile.name);
    Some(format!("profile {name} gives this alarm as: {number} ({})", entry.source))
}

/// Tells an alarm with its block, its clause and that clause's first sentence; the control's own number or text of it
/// too, where the profile's sources give one.
pub fn report(control: &Control, alarm: Alarm, source: &Source) {
    let (kind, clause) = (alarm.kind, alarm.kind.clause());
    let name = source.sequence.as_ref().map_or(String::new(), |sequence| format!(" at N{sequence}"));
    let title = format!("{}{name}: {}", kind.id(), kind.text());
    let text = source.text.trim_end();
    let start = text.len() - text.trim_start().len();
    let mark = AnnotationKind::Primary.span(start..text.len()).label("the tool stops before this block");
    let snippet = Snippet::source(text).path(&*control.name).line_start(source.line as usize).annotation(mark);
    let heading = clause::ALL.iter().find(|(known, _)| *known == clause).map_or("", |(_, title)| title);
    let mut group = Level::ERROR
        .with_name("alarm")
        .primary_title(title)
        .element(snippet)
        .element(Level::NOTE.message(format!("[{clause}] {heading}: {}", first_sentence(clause))))
        .element(Level::HELP.message(format!("`radcomp clause {clause}` shows the whole clause and its examples")));
    if let Some(number) = number(control, kind) {
        group = group.element(Level::NOTE.message(number));
    }
    terminal::complain(&terminal::renderer().render(&[group]));
}
