//! The page "What a pass means".

use std::collections::BTreeMap;

use minijinja::context;
use radcomp_spec::DecisionKind;

use super::index::{Index, Kind};
use super::site::Site;
use crate::certificate::{BARE_ADMISSIBLE, Claim, LIMITS};
use crate::certify::{Level, MOVED_ONE_IN, ROUND};
use crate::report::GradeRecord;

/// What each verdict says, in the order of the design; Markdown.
const VERDICTS: [(&str, &str); 6] = [
    ("exact", "The answer is the exact outcome, to within δ at every end point and arc centre. Passes."),
    (
        "admissible",
        "It is, to within δ, the exact outcome of another program, each of whose numbers lies within β of the program's own. \
         The judge has that program in hand, the witness, and the report keeps it. Passes.",
    ),
    (
        "admissible-without-witness",
        "It is the outcome with some decisions taken the other way, each with its exact margin within the band, and no \
         single program that has it was constructed. Passes; counted apart.",
    ),
    (
        "inadmissible, fork-limit",
        "No outcome that the band allows, or none among those that were looked at before the bound. Red.",
    ),
    (
        "crash, timeout, no-answer, garbled",
        "The device gave no answer that can be read. Red, and no waiver covers it; it never ends the run.",
    ),
    (
        "unsupported",
        "The device says that it does not support something in the program: neither passed nor failed. A run with such \
         programs is INCOMPLETE unless `--allow-unsupported` is given.",
    ),
];

/// What is no fault, each with its clauses; Markdown.
const DIVERGENCES: [&str; 8] = [
    "The other branch of a decision whose exact margin lies within the band β: the table below. The boundary itself, at \
     margin zero, is decided by the clause, and the band is about it; so a device may round there to either side.",
    "Points within δ, and a unit in the last place, of where their branch puts them. An intersection far from its corner magnifies a difference of the \
     input ([TRC-WEDGE-01]): what passes there passes by its witness, not by a greater δ.",
    "A straight move in several pieces, or several straight moves on one line of one block in one piece ([TRC-CORNER-12] \
     says whose block a corner's moves are).",
    "A move of no length, written or left out ([TRC-LOOK-07] says what such a block does to the look-ahead).",
    "Advisories: a device need not warn ([TRC-WEDGE-01], [TRC-LOOK-06], [TRC-DUMMY-03]). Alarms must agree in kind and \
     block.",
    "The path of the imaginary tip ([TRC-TIP-01], [TRC-TIP-03]): devices are compared by the centre of the tool or nose.",
    "What the profile chooses. A control that does otherwise than a profile says may be right by its own manual: the \
     choice, for instance whose block a corner is or what an alarm leaves of the block before ([TRC-MODE-10]), is made in \
     a profile of its own, not waived.",
    "What a waiver names, by clause and with its reason: it is counted as an expected failure, stays in the report, and is \
     printed on the certificate.",
];

/// Adds the page.
pub(super) fn page(site: &mut Site<'_>, index: &mut Index) -> Result<(), String> {
    let claim = Claim { programs: "N", pass: "N", delta: "δ", profile: "named in the report", band: "the grade" };
    let levels: Vec<_> = [(1, Level::One), (2, Level::Two)]
        .map(|(number, level)| {
            let triples = level.programs() / ROUND;
            BTreeMap::from([
                ("number", number),
                ("generated", level.programs()),
                ("triples", triples),
                ("moved", MOVED_ONE_IN),
            ])
        })
        .into();
    let grades = [
        ("binary64", GradeRecord::Binary64.band(), "What arithmetic in double precision may lose; the default."),
        (
            "resolution",
            GradeRecord::Resolution.band(),
            "For a control that computes in its own increments. A green run of this grade says less than one of binary64.",
        ),
    ];
    let prose = site.documents();
    let verdicts = VERDICTS.map(|(name, words)| (name, prose.inline(words)));
    let divergences = DIVERGENCES.map(|words| prose.inline(words));
    let decisions: Vec<_> = DecisionKind::ALL
        .iter()
        .map(|kind| {
            let target = site.links().clause(kind.clause().id()).unwrap_or_default();
            let (id, clause) = (kind.id(), kind.clause().id());
            BTreeMap::from([("id", id), ("clause", clause), ("target", target), ("margin", kind.margin())])
        })
        .collect();
    let limits: Vec<_> = LIMITS.iter().chain([&BARE_ADMISSIBLE]).collect();
    let text = format!("{claim} {}", LIMITS.join(" "));
    index.add(Kind::Guide, "What a pass means", "pass.html", &text);
    index.add(
        Kind::Guide,
        "What a pass means: divergences that are not faults",
        "pass.html#divergences",
        &DIVERGENCES.join(" "),
    );
    let theorem = claim.to_string();
    let values = context! { theorem, levels, grades, verdicts, divergences, limits, decisions };
    site.page("pass.html", "What a pass means", "pass.html", values)
}
