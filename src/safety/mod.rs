//! The safety verdict: does the tool enter the part, and does it leave material that it could have cut?
//!
//! It knows no rules and no profile. From the programmed contour, its sides, the tool radius and the device's path it
//! proves that the tool's disc never enters the part by more than a budget along the whole path, or names the worst
//! place. Nothing is sampled.
//!
//! # Contour
//!
//! The *elements* are the programmed lines and arcs of the blocks that move after a start-up block (the first block that
//! moves with G41 or G42 in force) and before the cancel block (the first block that moves from the one with G40 on). A
//! *stretch* is a longest sequence of consecutive elements of one offset mode and one side; the radius is the one in
//! force in the start-up block. A stretch is *closed* when its last point is its first one.
//!
//! *Leads* are cut off. If a stretch is not closed, and one of its last three elements meets one of its first three
//! (to within the budget, and at least 10⁻⁹ mm), the stretch is closed at the meeting point, as few elements as possible
//! being cut away, and what comes before and after that point is no contour: programs run on past the point where they
//! began, or come and leave on arcs, and there is no part behind such elements.
//!
//! # Depth
//!
//! Let q be a position of the tool's centre, d its distance from the nearest contour point c of its stretch, all
//! elements being looked at and not only the adjacent ones. q is *in the material* when it lies on the side of c that
//! is not the tool's: behind the element if c is inside an element; and if c is a corner, when the path turns toward the
//! tool there (an inner corner), but not at an outer corner, a reversal, or an open end of the stretch. The *depth* at q
//! is r - d, or r + d if q is in the material. The tool *gouges* where the depth is greater than the budget: its open
//! disc then holds contour points more than the budget inside, or its centre is on the wrong side.
//!
//! # Which path against which contour
//!
//! A path element belongs to the stretch of its block, which is believed; blocks between two stretches of one mode belong
//! to the earlier one. It is judged against all of that stretch and against no other.
//!
//! * In offset mode the elements decide the verdict, [`SafetyVerdict::path`].
//! * The elements of the start-up block come from anywhere, even through the part, because the program says so; so
//!   do those of the blocks from G40 to the cancel block. They are judged against the first and the last stretch of their
//!   mode, and reported apart. A wrong vector at the end of start-up does not escape: the next element begins there.
//! * *Crossings* are counted and not judged. Where the side changes at a point P, a path element of the block before,
//!   of the block after or of one between them is a crossing if all of it lies within r + budget of P. The offset of an
//!   element touches that disc in one point only, so no element that follows the contour is a crossing.
//!
//! # Uncut material
//!
//! A contour point is *reached* if some path element of its stretch in offset mode comes within r + budget of it. It is
//! *open to the tool* if the disc of radius r that touches it on the tool's side comes nowhere nearer than r - budget to
//! another element of the stretch. [`Uncut`] is the longest interval of one element that is open and not reached,
//! if it is longer than the budget and 10⁻⁶ mm.
//!
//! # What is proved
//!
//! Numbers of the program enter as intervals that hold them, numbers of the path as the doubles they are. Distances of
//! lines and arcs are found in closed form with every operation rounded outward; a bound of the whole path is the
//! greatest of the bounds of its pieces, which are cut in halves only where the side or the nearest element changes.
//! [`Finding::Safe`] and the two bounds of [`Gouge::depth`] are therefore proved (given IEEE arithmetic, and an index that
//! finds what overlaps), and where rounding or the number of cuts does not let them be, the answer is
//! [`Finding::Undecided`] with the bounds that are. An arc whose two radii differ is any curve between them, so the
//! difference is added to the bounds, and where the part is thinner than it, either side of the part may be the nearer
//! one: the upper bound is then that of a tool in the material. An arc is the one that its doubles name: an end that lies
//! a rounding behind its start makes a whole turn. Lead-offs are cut at points found in f64, to 16 units in the last
//! place, and proofs are about the contour so cut.
//!
//! Ends of [`Uncut`] are roots in f64, good to about the square root of the precision where curves touch; that no longer
//! interval exists is exact reasoning, but not proved against rounding. That the tool *fits* at a point does not say that
//! it could have got there.
//!
//! # What is not claimed
//!
//! * Nothing of moves in cancel mode, of material beyond open ends, and of one stretch's path against another's contour.
//! * Elements at rapid traverse count as contour. Depths along the normal axis are not known.
//! * A profile may make the block after a lost start-up another start-up ([TRC-START-04] `no-vector`); here it is
//!   an element, and the tool is found to gouge it.
//! * A contour that crosses itself other than by its leads contradicts itself, and every path along it gouges.

mod contour;
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

use radcomp_spec::Step;

pub use contour::Contour;
pub use verdict::{Finding, Gouge, SafetyVerdict, Uncut};

use path::{Move, beside};
use search::{Search, Walls};

/// Largest magnitude of a coordinate of a path that is looked at, in millimetres.
const LARGEST: f64 = 1e12;

/// Elements meet that come this near to each other, in millimetres, or as near as the budget.
const MEETING: f64 = 1e-9;

/// Judges a path that begins at (0, 0) against a contour, whose stretches know their radii; the budget is in millimetres.
///
/// A path that ends in an alarm is judged against [`Contour::before`] the alarm's block.
///
/// # Exactness
///
/// See the [module](self): the bounds of findings are proved.
///
/// ```
/// use radcomp::gcode::{Tools, read};
/// use radcomp::safety::{Contour, check};
/// use radcomp_spec::profile::Profile;
/// use radcomp_spec::{Segment, Step, clause};
/// let mill = Profile::builtin("seed-mill").unwrap();
/// let tools = Tools::parse("[[tool]]\nnumber = 1\nradius = \"5\"", "tools.toml")?;
/// let program = read("part.nc", b"G41 D1 G01 X10 Y0 F100\nX50\nG40 Y30\n", &mill, &tools)?;
/// let blocks: Vec<_> = program.blocks.into_iter().map(|read| read.block).collect();
/// let to = |block, end| Step {
///     block, clause: clause::TRC_MODE_01, rapid: false, main: true, segment: Segment::Line { end },
/// };
/// let path = [to(0, [10.0, 5.0]), to(1, [50.0, 4.7]), to(2, [50.0, 30.0])];
/// let gouge = *check(&Contour::of(&blocks), &path, 0.001).gouge().unwrap();
/// assert!(gouge.depth.0 > 0.299_999 && gouge.depth.1 < 0.300_001);
/// assert_eq!(gouge.path_block, 1);
/// # Ok::<(), radcomp::gcode::Diagnostic>(())
/// ```
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
        let trimmed = leads::without_leads(whole, budget.max(MEETING));
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
