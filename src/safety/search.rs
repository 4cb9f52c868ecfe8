//! The search for the worst gouge: branch and bound over pieces of the path, each bound proved.

use super::contour::Wall;
use super::distance::{box_gap, farthest, gap, nearest_on, point_to_piece};
use super::index::Index;
use super::interval::{Interval, Spot, spot};
use super::path::Move;
use super::piece::{Hull, Piece};
use super::side::{Standing, standing};
use super::verdict::{Finding, Gouge};

/// Pieces that the search cuts in halves at most, all in all; what is left then is answered by its bounds.
const MOST_CUTS: usize = 200_000;

/// The walls of a stretch, findable.
pub(crate) struct Walls {
    walls: Vec<Wall>,
    extents: Vec<[[f64; 2]; 2]>,
    index: Index,
}

/// The worst gouge so far of some moves.
pub(crate) struct Search {
    budget: f64,
    /// The gouge of the greatest proved depth.
    deepest: Option<Gouge>,
    /// The place of the greatest depth that is not excluded, beyond the proved ones.
    doubtful: Option<Gouge>,
    /// Nothing is deeper.
    at_most: f64,
    cuts: usize,
}

/// The depth on a piece of path: bounds, and the places that they come from.
struct Depth {
    low: f64,
    high: f64,
    gouge: Gouge,
}

impl Walls {
    pub(crate) fn new(walls: Vec<Wall>) -> Self {
        let extents: Vec<_> = walls.iter().map(|wall| wall.piece.extent()).collect();
        let index = Index::new(extents.iter().copied());
        Walls { walls, extents, index }
    }

    /// The walls that may be nearest to some point of a piece.
    fn candidates(&self, step: &Move) -> Vec<usize> {
        // The walls of the same block and those around it give a first upper bound of the distance.
        let place = self.walls.partition_point(|wall| wall.block < step.block);
        let around = place.saturating_sub(2)..(place + 6).min(self.walls.len());
        let hull = step.piece.hull();
        let bound = self.walls[around].iter().map(|wall| farthest(&step.piece, &hull, &wall.piece));
        let bound = bound.fold(f64::INFINITY, f64::min);
        self.index.near(step.piece.extent(), bound)
    }
}

impl Search {
    pub(crate) fn new(budget: f64) -> Self {
        Search { budget, deepest: None, doubtful: None, at_most: f64::NEG_INFINITY, cuts: 0 }
    }

    /// Looks at one move.
    pub(crate) fn look(&mut self, step: &Move, walls: &Walls, radius: Interval) {
        let mut open = vec![(step.piece, walls.candidates(step))];
        while let Some((piece, candidates)) = open.pop() {
            let (depth, candidates) = depth(&piece, step.block, candidates, walls, radius);
            if depth.low > self.deepest.map_or(self.budget, |gouge| gouge.depth.0) {
                self.deepest = Some(depth.gouge);
            }
            let settled = match &self.deepest {
                Some(gouge) => gouge.depth.0 + 1e-7 * radius.high + 1e-12 * piece.extent()[1][0].abs(),
                None => self.budget,
            };
            let exhausted = self.cuts >= MOST_CUTS || piece.chord() < 1e-9 * (radius.high + self.budget);
            if depth.high <= settled || exhausted {
                self.at_most = self.at_most.max(depth.high);
                if self.doubtful.is_none_or(|gouge| gouge.depth.1 < depth.high) {
                    self.doubtful = Some(depth.gouge);
                }
                continue;
            }
            self.cuts += 1;
            open.extend(piece.halves().map(|half| (half, candidates.clone())));
        }
    }

    /// What has been proved.
    pub(crate) fn finding(self) -> Finding {
        match (self.deepest, self.doubtful) {
            (Some(gouge), _) => {
                Finding::Gouges(Gouge { depth: (gouge.depth.0, self.at_most.max(gouge.depth.0)), ..gouge })
            }
            (None, Some(gouge)) if self.at_most > self.budget => Finding::Undecided(gouge),
            _ => Finding::Safe { at_most: self.at_most },
        }
    }
}

/// Bounds of the greatest depth on a piece of path, and the walls that matter there.
fn depth(piece: &Piece, block: usize, mut near: Vec<usize>, walls: &Walls, radius: Interval) -> (Depth, Vec<usize>) {
    let hull = piece.hull();
    let extent = piece.extent();
    // No point is farther from the contour than this.
    let reach = near.iter().map(|wall| farthest(piece, &hull, &walls.walls[*wall].piece)).fold(f64::INFINITY, f64::min);
    let mut nearest = f64::INFINITY;
    let mut at = super::interval::middle(&piece.a);
    near.retain(|wall| {
        if box_gap(&extent, &walls.extents[*wall]) > reach {
            return false;
        }
        let gap = gap(piece, &walls.walls[*wall].piece);
        if gap.low < nearest {
            (nearest, at) = (gap.low, gap.at);
        }
        gap.low <= reach
    });
    let stands = near.iter().fold(Standing::Elsewhere, |stands, wall| {
        if stands == Standing::Mixed { stands } else { stands.and(standing(piece, &hull, &walls.walls[*wall])) }
    });
    let free = matches!(stands, Standing::Free | Standing::Elsewhere);
    let high = if free { radius - Interval::of(nearest) } else { radius + Interval::of(reach) }.high;
    if !free {
        at = piece.centre_point();
    }
    let gouge = depth_at(at, piece, &near, walls, radius);
    let gouge = Gouge { depth: (gouge.depth.0, high.max(gouge.depth.0)), path_block: block, ..gouge };
    (Depth { low: gouge.depth.0, high: gouge.depth.1, gouge }, near)
}

/// A proved lower bound of the depth where the tool's centre stands at a point of a piece, or as near as rounding lets.
fn depth_at(at: [f64; 2], piece: &Piece, near: &[usize], walls: &Walls, radius: Interval) -> Gouge {
    let q: Spot = spot(at);
    let point = Piece::line(q, q);
    let off = point_to_piece(&q, piece).high;
    let distances: Vec<_> = near.iter().map(|wall| point_to_piece(&q, &walls.walls[*wall].piece)).collect();
    let mut distance = Interval::of(f64::MAX);
    let mut nearest = None;
    for (wall, to_wall) in near.iter().zip(&distances) {
        if nearest.is_none() || to_wall.middle() < distance.middle() {
            nearest = Some(*wall);
        }
        distance = distance.min(*to_wall);
    }
    let around = near.iter().zip(&distances).filter(|(_, to_wall)| to_wall.low <= distance.high + 2.0 * off);
    let stands = around.fold(Standing::Elsewhere, |stands, (wall, _)| {
        stands.and(standing(&point, &Hull::point(q), &walls.walls[*wall]))
    });
    let depth = if stands == Standing::Material {
        radius + Interval::of(distance.low) - Interval::of(2.0 * off)
    } else {
        radius - Interval::of(distance.high) - Interval::of(2.0 * off)
    };
    let (contour, contour_block) = nearest.map_or((at, 0), |wall| {
        let wall = &walls.walls[wall];
        (nearest_on(&wall.piece, at), wall.block)
    });
    Gouge { depth: (depth.low, depth.high), centre: at, contour, path_block: 0, contour_block }
}
