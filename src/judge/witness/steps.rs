//! The numbers of a program as levers on a point, and the smallest steps of them that bring it somewhere.

use super::input::Place;

/// How often the numbers that have reached the edge of the band are set aside in one step.
const MOST_PASSES: usize = 4;

/// A number, how far it stands from the program's, and how the point follows it, per millimetre.
pub(super) struct Lever {
    pub(super) place: Place,
    pub(super) at: f64,
    pub(super) pull: [f64; 2],
}

/// Whether all the numbers together can close half of the gap, as far as the point follows them evenly.
pub(super) fn can_close(levers: &[Lever], gap: [f64; 2], beta: f64) -> bool {
    let length = gap[0].hypot(gap[1]);
    let pulls = levers.iter().map(|lever| (lever.pull[0] * gap[0] + lever.pull[1] * gap[1]).abs() * beta);
    2.0 * pulls.sum::<f64>() >= length / 2.0 * length
}

/// The numbers that are moved together: all of them; then fewer, since a number may also belong to another junction that
/// stands on a decision and must stay.
pub(super) fn groups(levers: &[Lever], block: usize) -> Vec<Vec<&Lever>> {
    let mut indices: Vec<usize> = levers.iter().map(|lever| lever.place.0).collect();
    indices.dedup();
    let only = |keep: &dyn Fn(&Lever) -> bool| levers.iter().filter(|lever| keep(lever)).collect::<Vec<_>>();
    let mut groups = vec![only(&|_| true), only(&|lever| lever.place.0 <= block)];
    groups.extend(indices.iter().map(|index| only(&|lever| lever.place.0 == *index)));
    groups.extend(levers.iter().map(|lever| vec![lever]));
    groups.retain(|group| !group.is_empty());
    groups
}

/// The smallest steps of the levers that close the gap: numbers at the edge of the band are held there, and the others
/// take over what they cannot do.
pub(super) fn steps(levers: &[&Lever], gap: [f64; 2], beta: f64) -> Vec<f64> {
    let mut steps = vec![0.0; levers.len()];
    let mut free = vec![true; levers.len()];
    for _ in 0..MOST_PASSES {
        let mut left = gap;
        let (mut aa, mut ab, mut bb) = (0.0, 0.0, 0.0);
        for ((lever, step), free) in levers.iter().zip(&steps).zip(&free) {
            let [a, b] = lever.pull;
            if *free {
                (aa, ab, bb) = (aa + a * a, ab + a * b, bb + b * b);
            } else {
                left = [left[0] - a * step, left[1] - b * step];
            }
        }
        // Points that can move along one line only leave the matrix singular: a share of its trace keeps it solvable.
        let lift = (aa + bb) * 1e-12;
        let (aa, bb) = (aa + lift, bb + lift);
        let determinant = aa * bb - ab * ab;
        if determinant <= 0.0 {
            break;
        }
        let dual = [(bb * left[0] - ab * left[1]) / determinant, (aa * left[1] - ab * left[0]) / determinant];
        let mut held = false;
        for ((lever, step), free) in levers.iter().zip(&mut steps).zip(&mut free) {
            if !*free {
                continue;
            }
            let wanted = lever.pull[0] * dual[0] + lever.pull[1] * dual[1];
            *step = wanted.clamp(-beta - lever.at, beta - lever.at);
            if *step != wanted {
                *free = false;
                held = true;
            }
        }
        if !held {
            break;
        }
    }
    steps
}
