//! `cargo bench` prints one table: each goal of speed and size, what was measured, and the reference beside it.
//!
//! Everything runs on one core in one process. Contestants take turns, and the medians of their turns are compared, so
//! that a busy machine slows all of them alike; the ratios say more than the times.

mod contour;
mod implementation;
mod interpreter;
mod judged;
mod measure;
mod mitre;
mod model;
mod peer;
mod table;

use radcomp_spec::Parameters;
use radcomp_spec::parameters::{
    ArcExtension, ArcOnRapid, Cancel, CancelVector, CancelWithoutMovement, CornerOwner, EqualRadius, NegativeRadius,
    OffsetChange, OuterCorner, PendingAtAlarm, Ratio, Reversal, ReversedPath, SameCode, SideChange,
    SideChangeAfterStartUp, SideCodeVector, StartUp, StartUpArc, StartUpB, StartUpLost, StartUpWithoutMovement,
    ZeroLengthMove,
};

use contour::Contour;
use measure::{Contestant, race};
use table::{Row, nanoseconds, per_second, times};

/// The choices of a usual mill; no branch of theirs is dearer than another.
const PARAMETERS: Parameters = Parameters {
    start_up: StartUp::TypeA,
    start_up_lost: StartUpLost::Normal,
    cancel: Cancel::TypeA,
    outer_corner: OuterCorner::Intersection,
    reversal: Reversal::Outer,
    side_change: SideChange::IntersectionWithin,
    side_change_after_start_up: SideChangeAfterStartUp::Alarm,
    non_moving_allowed: Some(2),
    corner_owner: CornerOwner::Next,
    reversed_path: ReversedPath::Advisory,
    arc_end_tolerance: Ratio { numerator: 1, denominator: 100 },
    far_intersection: Ratio { numerator: 5, denominator: 1 },
    start_up_b: StartUpB::ViaNormal,
    start_up_without_movement: StartUpWithoutMovement::None,
    start_up_arc: StartUpArc::Alarm,
    cancel_without_movement: CancelWithoutMovement::None,
    corner_limit_cosine: NONE,
    arc_extension: ArcExtension::Tangent,
    smallest_corner_cosine: NONE,
    straight_band_cosine: NONE,
    arc_on_rapid: ArcOnRapid::Arc,
    small_vector_limit: NONE,
    same_code: SameCode::Ordinary,
    negative_radius: NegativeRadius::Alarm,
    equal_radius: EqualRadius::Alarm,
    zero_length_move: ZeroLengthMove::NoMovement,
    pending_at_alarm: PendingAtAlarm::Ended,
    side_code_vector: SideCodeVector::Refused,
    cancel_vector: CancelVector::Refused,
    offset_change: OffsetChange::Alarm,
};

/// A limit that there is not.
const NONE: Ratio = Ratio { numerator: 0, denominator: 1 };

/// Vertices of the closed contours.
const VERTICES: usize = 1000;

fn main() {
    // `cargo bench` says --bench; any other caller only wants to see that this runs.
    let rounds = if std::env::args().any(|argument| argument == "--bench") { 31 } else { 1 };
    let star = Contour::star(VERTICES);
    let scallops = Contour::scallops(VERTICES);

    let mut rows = Vec::new();
    let implementation = compare_implementation(&star, &scallops, rounds, &mut rows);
    compare_interpreter(&star, implementation, rounds, &mut rows);
    rows.push(Row {
        what: "impl, memory of one engine",
        goal: "≤ 4096 bytes".into(),
        measured: format!("{} bytes", implementation::size()),
        met: Some(implementation::size() <= 4096),
        beside: "rs274 16 MB".into(),
        ratio: String::new(),
    });
    measure_model(&star, &scallops, rounds, &mut rows);
    measure_judged(rounds, &mut rows);
    measure_growth(&star, rounds, &mut rows);
    table::print(&rows);
}

/// The implementation beside the bare formula and beside an offset library, all on the same contours. Answers the
/// implementation's nanoseconds per line.
fn compare_implementation(star: &Contour, scallops: &Contour, rounds: usize, rows: &mut Vec<Row>) -> f64 {
    let star_blocks = star.program_f64();
    let scallop_blocks = scallops.program_f64();
    let (star_points, star_polyline, scallop_polyline) = (star.points(), star.polyline(), scallops.polyline());
    let [lines, arcs, formula, peer_lines, peer_arcs] = race(
        [
            Contestant::new(star_blocks.len(), || implementation::run(&PARAMETERS, &star_blocks)),
            Contestant::new(scallop_blocks.len(), || implementation::run(&PARAMETERS, &scallop_blocks)),
            Contestant::new(VERTICES, || mitre::run(&star_points, contour::TOOL_RADIUS)),
            Contestant::new(VERTICES, || peer::run(&star_polyline, contour::TOOL_RADIUS)),
            Contestant::new(VERTICES, || peer::run(&scallop_polyline, contour::TOOL_RADIUS)),
        ],
        rounds,
    );
    rows.push(Row {
        what: "impl, a block, lines",
        goal: "≤ 40 ns".into(),
        measured: nanoseconds(lines),
        met: Some(lines <= 40.0),
        beside: format!("the bare mitre formula (the limit) {}", nanoseconds(formula)),
        ratio: format!("{} its time", times(lines / formula)),
    });
    rows.push(Row {
        what: "impl, a block, arcs",
        goal: "≤ 120 ns".into(),
        measured: nanoseconds(arcs),
        met: Some(arcs <= 120.0),
        beside: format!("impl on lines {}", nanoseconds(lines)),
        ratio: format!("{} its time", times(arcs / lines)),
    });
    for (what, own, peer) in
        [("impl, a vertex, contour of lines", lines, peer_lines), ("impl, a vertex, contour of arcs", arcs, peer_arcs)]
    {
        rows.push(Row {
            what,
            goal: "≥ 10× faster".into(),
            measured: nanoseconds(own),
            met: Some(peer / own >= 10.0),
            beside: format!("cavalier_contours {}", nanoseconds(peer)),
            ratio: format!("{} faster", times(peer / own)),
        });
    }
    lines
}

fn compare_interpreter(star: &Contour, implementation: f64, rounds: usize, rows: &mut Vec<Row>) {
    let interpreter = interpreter::nanoseconds_per_block(star, rounds.min(7));
    rows.push(Row {
        what: "impl, a block, beside a control",
        goal: "≥ 50× faster".into(),
        measured: nanoseconds(implementation),
        met: interpreter.map(|interpreter| interpreter / implementation >= 50.0),
        beside: match interpreter {
            Some(interpreter) => format!("rs274 with reading and printing {}", nanoseconds(interpreter)),
            None => "not measured: no rs274".into(),
        },
        ratio: interpreter.map_or_else(String::new, |it| format!("{} faster", times(it / implementation))),
    });
}

fn measure_model(star: &Contour, scallops: &Contour, rounds: usize, rows: &mut Vec<Row>) {
    let (star_blocks, scallop_blocks) = (star.program_exact(), scallops.program_exact());
    let [lines, arcs] = race(
        [
            Contestant::new(star_blocks.len(), || model::run(&PARAMETERS, &star_blocks)),
            Contestant::new(scallop_blocks.len(), || model::run(&PARAMETERS, &scallop_blocks)),
        ],
        rounds.min(11),
    );
    rows.push(Row {
        what: "model, blocks, lines, 100-bit enclosures",
        goal: "≥ 30,000 a second".into(),
        measured: per_second(lines),
        met: Some(1e9 / lines >= 30_000.0),
        beside: "CGAL exact kernel, measured elsewhere: 343 µs".into(),
        ratio: format!("{} faster", times(343_000.0 / lines)),
    });
    rows.push(Row {
        what: "model, blocks, arcs, 100-bit enclosures",
        goal: String::new(),
        measured: per_second(arcs),
        met: None,
        beside: format!("model on lines {}", per_second(lines)),
        ratio: format!("{} its time", times(arcs / lines)),
    });
}

fn measure_judged(rounds: usize, rows: &mut Vec<Row>) {
    for (what, goal, measured) in [
        ("judged ten-block programs, builtin device", 2_000.0, judged::builtin(rounds.min(7))),
        ("judged ten-block programs, LinuxCNC", 1_000.0, judged::linuxcnc()),
    ] {
        rows.push(Row {
            what,
            goal: format!("≥ {} a second", table::grouped(goal)),
            measured: measured.map_or_else(|reason| format!("not measured: {reason}"), per_second),
            met: measured.ok().map(|nanoseconds| 1e9 / nanoseconds >= goal),
            beside: String::new(),
            ratio: String::new(),
        });
    }
}

/// The cost of a block as the program grows: the contour is run round and round.
fn measure_growth(star: &Contour, rounds: usize, rows: &mut Vec<Row>) {
    let (program, exact) = (&star.program_f64(), &star.program_exact());
    let lengths = [1_000, 10_000, 100_000, 1_000_000];
    let lap = |blocks| Contestant::new(blocks, move || implementation::run_laps(&PARAMETERS, program, blocks));
    let costs = race(lengths.map(lap), rounds.min(7));
    rows.extend(
        lengths
            .into_iter()
            .zip(costs)
            .map(|(length, cost)| growth("impl, a block, as the program grows", length, cost, cost / costs[0])),
    );

    let lengths = [1_000, 10_000, 100_000];
    let lap = |blocks| Contestant::new(blocks, move || model::run_laps(&PARAMETERS, exact, blocks));
    let before = measure::peak_bytes();
    let costs = race(lengths.map(lap), rounds.min(3));
    let after = measure::peak_bytes();
    rows.extend(
        lengths
            .into_iter()
            .zip(costs)
            .map(|(length, cost)| growth("model, a block, as the program grows", length, cost, cost / costs[0])),
    );
    if let (Some(before), Some(after)) = (before, after) {
        let growth = after.saturating_sub(before);
        rows.push(Row {
            what: "model, peak memory that the longest program adds",
            goal: "bounded".into(),
            measured: format!("{} KiB", growth / 1024),
            met: Some(growth < 4 << 20),
            beside: format!("{} blocks", table::grouped(lengths[2] as f64)),
            ratio: String::new(),
        });
    }
}

fn growth(what: &'static str, length: usize, cost: f64, ratio: f64) -> Row {
    // A cache or an interrupt may add this much; anything that is not linear adds more.
    const STEADY: f64 = 1.5;

    Row {
        what,
        goal: "linear".into(),
        measured: nanoseconds(cost),
        met: Some(ratio <= STEADY),
        beside: format!("{} blocks", table::grouped(length as f64)),
        ratio: format!("{} the first", times(ratio)),
    }
}
