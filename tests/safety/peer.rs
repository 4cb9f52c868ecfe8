//! The peer: cavalier_contours trims its offsets where the tool would gouge, so a path without gouges is all of one.

use cavalier_contours::polyline::{PlineSource, PlineSourceMut, Polyline};
use radcomp::safety::{Contour, Finding, check};
use radcomp_model::run;
use radcomp_spec::{Direction, OuterCorner, Segment, Step};

use super::shapes::{Dice, Shape, star};
use super::{blocks, mill, model_path};

/// Length of the path in offset mode.
fn length(path: &[Step<f64>], from: usize, to: usize) -> f64 {
    let mut at = [0.0_f64; 2];
    let mut sum = 0.0;
    for step in path {
        let (end, length) = match step.segment {
            Segment::Hold => continue,
            Segment::Line { end } => (end, (end[0] - at[0]).hypot(end[1] - at[1])),
            Segment::Arc { end, centre, direction, full } => {
                let angle = |p: [f64; 2]| (p[1] - centre[1]).atan2(p[0] - centre[0]);
                let turn = angle(end) - angle(at);
                let turn = if direction == Direction::Clockwise { -turn } else { turn };
                let turn = if full { std::f64::consts::TAU } else { turn.rem_euclid(std::f64::consts::TAU) };
                (end, turn * (end[0] - centre[0]).hypot(end[1] - centre[1]))
            }
        };
        if step.block > from && step.block < to {
            sum += length;
        }
        at = end;
    }
    sum
}

pub fn polyline(shape: &Shape) -> Polyline<f64> {
    let mut polyline = Polyline::new_closed();
    for [x, y, bulge] in shape.bulges() {
        polyline.add(x, y, bulge);
    }
    polyline
}

#[derive(Debug, Default)]
struct Tally {
    safe: usize,
    gouging: usize,
    alarms: usize,
    crossing: usize,
    different: Vec<String>,
}

/// Compares the verdict on the model's path with the peer's offset, until so many contours have been compared.
fn compare(seed: u64, count: usize) -> Tally {
    let mut parameters = mill().parameters;
    parameters.outer_corner = OuterCorner::Arc;
    let mut tally = Tally::default();
    let mut number = seed;
    while tally.safe + tally.gouging + tally.different.len() < count {
        number += 1;
        let mut dice = Dice::new(number);
        let shape = star(&mut dice, dice_has_arcs(number));
        let (code, sign) = if number % 4 < 2 { ("G41", 1.0) } else { ("G42", -1.0) };
        let radius = dice.between(1500, 24_000) as u32;
        let contour = polyline(&shape);
        if contour.scan_for_self_intersect() {
            tally.crossing += 1;
            continue;
        }
        let blocks = blocks(&shape.program(code), radius);
        if run(&parameters, &blocks).alarm.is_some() {
            tally.alarms += 1;
            continue;
        }
        let path = model_path(&parameters, &blocks);
        let verdict = check(&Contour::of(&blocks), &path, 1e-6);
        let offsets = contour.parallel_offset(sign * f64::from(radius) / 1e3);
        let whole = length(&path, 0, blocks.len() - 1);
        let peer_safe = offsets.len() == 1 && (offsets[0].path_length() - whole).abs() < 1e-5;
        match (&verdict.path, peer_safe) {
            (Finding::Safe { .. }, true) => tally.safe += 1,
            (Finding::Gouges(_), false) => tally.gouging += 1,
            (finding, _) => {
                let lengths: Vec<f64> = offsets.iter().map(PlineSource::path_length).collect();
                tally.different.push(format!("{number}: {finding:?}, model {whole}, peer {lengths:?}"));
            }
        }
    }
    tally
}

fn dice_has_arcs(number: u64) -> bool {
    !number.is_multiple_of(3)
}

#[test]
fn agrees_with_the_peer_on_who_gouges() {
    let tally = compare(0, 2000);
    assert!(tally.different.is_empty(), "{tally:#?}");
    assert!(tally.safe > 300 && tally.gouging > 300, "{tally:?}");
}

#[test]
#[ignore = "long: `cargo test --release --test safety -- --ignored`"]
fn agrees_with_the_peer_on_ten_thousand_contours() {
    let tally = compare(1_000_000, 10_000);
    println!("safe {}, gouging {}, {:#?}", tally.safe, tally.gouging, tally.different);
    println!("left out: {} alarms, {} contours that cross themselves", tally.alarms, tally.crossing);
    assert!(tally.different.is_empty());
}

/// The peer's own offsets are safe; offsets that lie 1 µm nearer gouge by 1 µm.
#[test]
fn the_peers_offsets_are_safe() {
    for number in 0..300 {
        let mut dice = Dice::new(number);
        let shape = star(&mut dice, true);
        let radius = dice.between(500, 9000) as u32;
        let contour = polyline(&shape);
        if contour.scan_for_self_intersect() {
            continue;
        }
        let ours = Contour::of(&blocks(&shape.program("G41"), radius));
        for (nearer, deep) in [(0.0, 0.0), (0.001, 0.001)] {
            for offset in contour.parallel_offset(f64::from(radius) / 1e3 - nearer) {
                let verdict = check(&ours, &steps(&offset), 1e-4);
                match verdict.path {
                    Finding::Safe { at_most } => assert!(deep == 0.0 && at_most < 1e-4, "{number} {verdict:?}"),
                    Finding::Gouges(gouge) => assert!((gouge.depth.0 - deep).abs() < 1e-5, "{number} {verdict:?}"),
                    _ => panic!("{number} {verdict:?}"),
                }
            }
        }
    }
}

/// A closed polyline as a path of block 1, reached in block 0.
fn steps(offset: &Polyline<f64>) -> Vec<Step<f64>> {
    let count = offset.vertex_count();
    let vertex = |index: usize| offset.at(index % count);
    let mut steps = super::lines(&[(0, [vertex(0).x, vertex(0).y])]);
    for index in 0..count {
        let (from, to) = (vertex(index), vertex(index + 1));
        let end = [to.x, to.y];
        let mut step = super::lines(&[(1, end)]).remove(0);
        if from.bulge != 0.0 {
            // The centre lies (1 - b²) / 4b chords to the left of the chord's middle.
            let height = (1.0 - from.bulge * from.bulge) / (4.0 * from.bulge);
            let chord = [to.x - from.x, to.y - from.y];
            let middle = [(to.x + from.x) / 2.0, (to.y + from.y) / 2.0];
            let centre = [middle[0] - height * chord[1], middle[1] + height * chord[0]];
            let direction = if from.bulge > 0.0 { Direction::Counterclockwise } else { Direction::Clockwise };
            step.segment = Segment::Arc { end, centre, direction, full: false };
        }
        steps.push(step);
    }
    steps
}
