//! The search for the worst gouge: branch and bound over pieces of the path, each bound proved.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::contour::Wall;
use super::distance::{farthest, gap, nearest_on, point_to_piece};
use super::index::Index;
use super::interval::{Interval, Spot, middle, spot};
use super::path::Move;
use super::piece::{Hull, Piece};
use super::side::{Standing, standing};
use super::verdict::{Finding, Gouge};

/// Pieces that the search cuts in halves at most, all in all; what is left then is answered by its bounds.
const MOST_CUTS: usize = 1_000_000;

/// The same for one move.
const CUTS_OF_A_MOVE: usize = 1_000;

/// The same in a row where the bounds have a closed form and hardly get better.
const VAIN_CUTS: u8 = 4;

/// More walls than this near to a long piece of path make it worth cutting before they are looked at.
const MANY: usize = 64;

/// How often it is cut for that reason.
const FIRST_CUTS: u8 = 24;

/// How well the greatest depth is found, as a part of it, where it has no closed form: behind the contour.
const PRECISION: f64 = 1e-7;

/// The walls of a stretch, findable.
pub(crate) struct Walls {
    walls: Vec<Wall>,
    /// A disc around each wall.
    discs: Vec<([f64; 2], f64)>,
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
    cuts_left: usize,
}

/// A piece of path with bounds of the greatest depth on it, and the walls that matter there.
struct Bounded {
    piece: Piece,
    near: Vec<usize>,
    gouge: Gouge,
    /// All of it is on the tool's side: the bounds have a closed form.
    free: bool,
    /// How often it has been cut all the same.
    vain: u8,
}

impl Walls {
    pub(crate) fn new(walls: Vec<Wall>) -> Self {
        let extents: Vec<_> = walls.iter().map(|wall| wall.piece.extent()).collect();
        let index = Index::new(extents.iter().copied());
        Walls { walls, discs: extents.iter().map(disc).collect(), index }
    }

    /// A lower bound of the distance of a wall from a disc.
    fn apart(&self, wall: usize, (centre, radius): &([f64; 2], f64)) -> f64 {
        let (other, reach) = &self.discs[wall];
        let apart = (other[0] - centre[0]).hypot(other[1] - centre[1]);
        // All of these numbers round by less than this.
        let scale = apart + radius + reach + centre.iter().chain(other).map(|x| x.abs()).sum::<f64>();
        apart - radius - reach - 16.0 * f64::EPSILON * scale
    }

    /// Parts of a piece, each with the walls that may be nearest to some point of it, and not many of them if possible.
    fn candidates(&self, piece: Piece, block: usize, cuts: u8, found: &mut Vec<(Piece, Vec<usize>)>) {
        // The walls of the same block and those around it, and one near the middle, give an upper bound of the distance.
        let place = self.walls.partition_point(|wall| wall.block < block);
        let around = place.saturating_sub(2)..(place + 3).min(self.walls.len());
        let hull = piece.hull();
        let bound = around.chain(self.index.nearest(piece.centre_point()));
        let bound = bound.map(|wall| farthest(&piece, &hull, &self.walls[wall].piece)).fold(f64::INFINITY, f64::min);
        let near = self.index.near(piece.extent(), bound);
        if near.len() > MANY && cuts > 0 && piece.chord() > bound / 8.0 {
            for half in piece.halves() {
                self.candidates(half, block, cuts - 1, found);
            }
        } else {
            found.push((piece, near));
        }
    }
}

impl Search {
    pub(crate) fn new(budget: f64) -> Self {
        Search { budget, deepest: None, doubtful: None, at_most: f64::NEG_INFINITY, cuts_left: MOST_CUTS }
    }

    /// Looks at one move.
    pub(crate) fn look(&mut self, step: &Move, walls: &Walls, radius: Interval) {
        let mut parts = Vec::new();
        walls.candidates(step.piece, step.block, FIRST_CUTS, &mut parts);
        let first = parts.iter().map(|(piece, near)| self.bounded(*piece, step.block, near, walls, radius));
        let mut open = first.collect::<BinaryHeap<_>>();
        let tiny = 1e-12 * (radius.high + self.budget);
        let mut cuts = CUTS_OF_A_MOVE.min(self.cuts_left);
        // The piece that may hold the greatest depth comes first.
        while let Some(Bounded { piece, near, gouge, free, vain }) = open.pop() {
            let settled = gouge.depth.1 <= self.settled();
            if settled || cuts == 0 || vain == VAIN_CUTS || piece.chord() < tiny {
                self.at_most = self.at_most.max(gouge.depth.1);
                if self.doubtful.is_none_or(|doubtful| doubtful.depth.1 < gouge.depth.1) {
                    self.doubtful = Some(gouge);
                }
                if settled {
                    // No piece left is deeper.
                    return;
                }
                continue;
            }
            cuts -= 1;
            self.cuts_left -= 1;
            for half in piece.halves() {
                let half = self.bounded(half, step.block, &near, walls, radius);
                open.push(Bounded { vain: if free { vain + 1 } else { 0 }, ..half });
            }
        }
    }

    /// A depth that need not be looked into: within the budget, or hardly more than what is proved.
    fn settled(&self) -> f64 {
        self.deepest.map_or(self.budget, |gouge| gouge.depth.0 * (1.0 + PRECISION) + 1e-12)
    }

    /// The bounds of the depth on a piece; a proved gouge is noted.
    fn bounded(&mut self, piece: Piece, block: usize, near: &[usize], walls: &Walls, radius: Interval) -> Bounded {
        let bounded = bounded(piece, block, near, walls, radius);
        if bounded.gouge.depth.0 > self.deepest.map_or(self.budget, |gouge| gouge.depth.0) {
            self.deepest = Some(bounded.gouge);
        }
        bounded
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

impl Ord for Bounded {
    fn cmp(&self, other: &Self) -> Ordering {
        self.gouge.depth.1.total_cmp(&other.gouge.depth.1)
    }
}

impl PartialOrd for Bounded {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Bounded {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Bounded {}

/// Bounds of the greatest depth on a piece of path.
fn bounded(piece: Piece, block: usize, near: &[usize], walls: &Walls, radius: Interval) -> Bounded {
    let hull = piece.hull();
    let disc = disc(&piece.extent());
    // Walls whose discs are near give an upper bound of the distance; those beyond it do not matter.
    let mut reach = f64::INFINITY;
    let mut order: Vec<(f64, usize)> = near.iter().map(|wall| (walls.apart(*wall, &disc), *wall)).collect();
    order.sort_unstable_by(|x, y| x.0.total_cmp(&y.0));
    let mut nearest = f64::INFINITY;
    let mut at = middle(&piece.a);
    let mut gaps = Vec::new();
    for (apart, wall) in order {
        if apart > reach {
            break;
        }
        reach = reach.min(farthest(&piece, &hull, &walls.walls[wall].piece));
        let gap = gap(&piece, &walls.walls[wall].piece);
        if gap.low < nearest {
            (nearest, at) = (gap.low, gap.at);
        }
        gaps.push((gap.low, wall));
    }
    let near: Vec<usize> = gaps.into_iter().filter(|(gap, _)| *gap <= reach).map(|(_, wall)| wall).collect();
    let stands = near.iter().fold(Standing::Elsewhere, |stands, wall| {
        if stands == Standing::Mixed { stands } else { stands.and(standing(&piece, &hull, &walls.walls[*wall], reach)) }
    });
    let free = matches!(stands, Standing::Free | Standing::Elsewhere);
    let high = if free { radius - Interval::of(nearest) } else { radius + Interval::of(reach) }.high;
    let places = if free { vec![at] } else { vec![piece.centre_point(), middle(&piece.a), middle(&piece.b)] };
    let gouges = places.into_iter().map(|at| depth_at(at, &piece, &near, walls, radius));
    let Some(gouge) = gouges.max_by(|x, y| x.depth.0.total_cmp(&y.depth.0)) else { unreachable!() };
    let gouge = Gouge { depth: (gouge.depth.0, high.max(gouge.depth.0)), path_block: block, ..gouge };
    Bounded { piece, near, gouge, free, vain: 0 }
}

/// The disc around a box: centre and radius.
fn disc([low, high]: &[[f64; 2]; 2]) -> ([f64; 2], f64) {
    let half = [0, 1].map(|axis| 0.5 * (high[axis] - low[axis]));
    ([low[0] + half[0], low[1] + half[1]], half[0].hypot(half[1]))
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
        stands.and(standing(&point, &Hull::point(q), &walls.walls[*wall], distance.high + 2.0 * off))
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
