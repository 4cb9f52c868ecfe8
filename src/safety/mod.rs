//! draft
pub(crate) mod contour;
mod curve;
mod distance;
mod index;
mod interval;
mod leads;
mod path;
mod piece;
mod program;
mod search;
mod side;
mod uncut;
mod verdict;
pub use contour::Contour;
use path::{Move, beside};
use radcomp_spec::Step;
use search::{Search, Walls};
pub use verdict::{Finding, Gouge, SafetyVerdict, Uncut};

/// Largest magnitude of a coordinate that is looked at, in millimetres.
const LARGEST: f64 = 1e12;

/// Judges a path.
pub fn check(contour: &Contour, path: &[Step<f64>], budget: f64) -> SafetyVerdict {
    let all = match beside(&contour.stretches, path, budget) {
        Ok(all) => all,
        Err(block) => {
            let out = Finding::OutOfRange { block };
            return SafetyVerdict { path: out.clone(), start_up: out.clone(), cancel: out, uncut: None, crossings: 0 };
        }
    };
    let [mut offset, mut start_up, mut cancel] = [(); 3].map(|()| Search::new(budget));
    let mut crossings = 0;
    let mut uncut: Option<Uncut> = None;
    for (whole, beside) in contour.stretches.iter().zip(all) {
        let trimmed = leads::without_leads(whole, budget.max(1e-9));
        let stretch = trimmed.as_ref().unwrap_or(whole);
        let walls = Walls::new(stretch.walls());
        let look = |search: &mut Search, moves: &[Move]| {
            moves.iter().for_each(|each| search.look(each, &walls, stretch.radius));
        };
        look(&mut offset, &beside.offset);
        look(&mut start_up, &beside.start_up);
        look(&mut cancel, &beside.cancel);
        crossings += beside.crossings;
        let longest = uncut::longest(stretch, &beside.curves, budget);
        uncut = [uncut, longest].into_iter().flatten().max_by(|x, y| x.length.total_cmp(&y.length));
    }
    SafetyVerdict { path: offset.finding(), start_up: start_up.finding(), cancel: cancel.finding(), uncut, crossings }
}
