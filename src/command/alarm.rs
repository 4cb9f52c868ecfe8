//! Alarms, told on the standard error output.

use annotate_snippets::{AnnotationKind, Level, Snippet};
use radcomp::explain::{Source, first_sentence};
use radcomp_model::Stop;
use radcomp_spec::{Alarm, clause};

use super::failure::Failure;
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

/// Tells an alarm with its block, its clause and that clause's first sentence.
pub fn report(file: &str, alarm: Alarm, source: &Source) {
    let (kind, clause) = (alarm.kind, alarm.kind.clause());
    let name = source.sequence.as_ref().map_or(String::new(), |sequence| format!(" at N{sequence}"));
    let title = format!("{}{name}: {}", kind.id(), kind.text());
    let text = source.text.trim_end();
    let start = text.len() - text.trim_start().len();
    let mark = AnnotationKind::Primary.span(start..text.len()).label("the tool stops before this block");
    let snippet = Snippet::source(text).path(file).line_start(source.line as usize).annotation(mark);
    let heading = clause::ALL.iter().find(|(known, _)| *known == clause).map_or("", |(_, title)| title);
    let group = Level::ERROR
        .with_name("alarm")
        .primary_title(title)
        .element(snippet)
        .element(Level::NOTE.message(format!("[{clause}] {heading}: {}", first_sentence(clause))))
        .element(Level::HELP.message(format!("`radcomp clause {clause}` shows the whole clause and its examples")));
    terminal::complain(&terminal::renderer().render(&[group]));
}
