//! Rows of compensated blocks, whose vectors are compared over several blocks before the tool moves on: the second stage
//! behind the settled junctions ([TRC-INT-01], [TRC-INT-04], [TRC-INT-05]). Where nothing is compared, every step passes
//! straight through.

use std::collections::VecDeque;

use radcomp_spec::parameters::{Interference, InterferenceBlocks, InterferenceBoundary, Parameters};
use radcomp_spec::{Alarm, AlarmKind, Segment, Side, Step, clause};

use super::own_move::own_move;
use crate::decision::{Judgement, Stop};
use crate::element::{Element, Shape};
use crate::geometry::Vector;
use crate::number::Real;
use crate::rules::arc::Fit;
use crate::rules::interference::{avoidance, interfere};
use crate::rules::junction::Refused;

/// The row being read, as far as it is not released.
#[derive(Clone, Debug)]
pub(super) struct Rows {
    /// How many blocks are known before the first of them is begun, N - 2; none where nothing is compared.
    ahead: Option<usize>,
    avoids: bool,
    boundary: InterferenceBoundary,
    /// Bk: made, but for where it ends. None at P0, and where blocks have been left out.
    before: Option<RowBlock>,
    /// Pk and the vectors there.
    from: Corner,
    /// The only vector at Pk is a point to which blocks that were left out have led.
    avoided: bool,
    /// Bk+1 and those behind it whose vectors are known.
    blocks: VecDeque<RowBlock>,
    /// The block that the last of them is joined to, which is read and not yet ended.
    next: Option<Next>,
    open: bool,
}

/// A programmed point, and the vectors of its corner.
#[derive(Clone, Debug)]
struct Corner {
    point: Vector,
    vectors: Vec<Vector>,
}

/// A block of a row whose junctions are settled.
#[derive(Clone, Debug)]
pub(super) struct RowBlock {
    pub(super) element: Element,
    pub(super) side: Side,
    pub(super) radius: Real,
    pub(super) fit: Fit,
    /// It is run as a full circle.
    pub(super) whole_circle: bool,
    /// Where its own move starts.
    pub(super) start: Vector,
    /// The vectors at its end.
    pub(super) vectors: Vec<Vector>,
    /// The corner moves before its own move.
    pub(super) lead_in: Vec<Step<Real>>,
    pub(super) own: Step<Real>,
    /// The corner moves behind its own move, and the blocks without movement that are executed there.
    pub(super) behind: Vec<Step<Real>>,
}

/// What a row knows of a block before its end is settled.
#[derive(Clone, Debug)]
pub(super) struct Next {
    pub(super) element: Element,
    pub(super) fit: Fit,
}

impl RowBlock {
    fn has_curve(&self) -> bool {
        has_curve(&self.element, self.fit)
    }

    /// [TRC-INT-01] whether the block is not looked at by itself.
    fn is_exempt(&self) -> bool {
        self.whole_circle || self.fit == Fit::Point
    }

    fn release(self, judgement: &mut Judgement<'_>) {
        for step in self.lead_in.into_iter().chain([self.own]).chain(self.behind) {
            judgement.sink.step(step);
        }
    }

    /// [TRC-INT-05] the block is left out: executed where the tool stands.
    fn release_as_hold(self, judgement: &mut Judgement<'_>) {
        let Step { block, rapid, .. } = self.own;
        judgement.sink.step(Step { block, clause: clause::TRC_INT_05, rapid, main: false, segment: Segment::Hold });
        self.release_holds_behind(judgement);
    }

    fn release_holds_behind(self, judgement: &mut Judgement<'_>) {
        for step in self.behind.into_iter().filter(|step| step.segment == Segment::Hold) {
            judgement.sink.step(step);
        }
    }
}

/// Neither a full circle nor an arc whose offset curve is a point.
fn has_curve(element: &Element, fit: Fit) -> bool {
    fit == Fit::Ordinary && !matches!(element.shape, Shape::Arc { full: true, .. })
}

impl Rows {
    pub(super) fn new(parameters: &Parameters) -> Self {
        let blocks = match parameters.interference_blocks {
            InterferenceBlocks::Three => 3,
            InterferenceBlocks::Four => 4,
            InterferenceBlocks::Five => 5,
            InterferenceBlocks::Six => 6,
            InterferenceBlocks::Seven => 7,
            InterferenceBlocks::Eight => 8,
        };
        let compares = matches!(parameters.interference, Interference::Alarm | Interference::Avoid);
        Rows {
            ahead: compares.then_some(blocks - 2),
            avoids: parameters.interference == Interference::Avoid,
            boundary: parameters.interference_boundary,
            before: None,
            from: Corner { point: Vector::zero(), vectors: Vec::new() },
            avoided: false,
            blocks: VecDeque::new(),
            next: None,
            open: false,
        }
    }

    /// Whether blocks wait here for those behind them.
    pub(super) fn compares(&self) -> bool {
        self.ahead.is_some()
    }

    /// A step that is settled: it stands behind the row's last block, or passes.
    pub(super) fn step(&mut self, step: Step<Real>, judgement: &mut Judgement<'_>) {
        match self.blocks.back_mut().or(self.before.as_mut()) {
            Some(last) => last.behind.push(step),
            None => judgement.sink.step(step),
        }
    }

    /// The next block of the row, or the first one of another row.
    pub(super) fn push(&mut self, mut block: RowBlock) {
        if !self.open {
            self.open = true;
            self.avoided = false;
            self.from = Corner { point: block.element.start.clone(), vectors: vec![block.start.clone()] };
        }
        if self.blocks.is_empty() && self.avoided {
            self.starts_where_others_are_left_out(&mut block);
        }
        self.next = None;
        self.blocks.push_back(block);
    }

    /// [TRC-INT-05] there are no corner moves there.
    fn starts_where_others_are_left_out(&self, block: &mut RowBlock) {
        block.lead_in.clear();
        if let [only] = self.from.vectors.as_slice() {
            block.start = only.clone();
        }
    }

    /// The last block is joined to a next one: what needs no more blocks is released.
    pub(super) fn joined(&mut self, next: Next, judgement: &mut Judgement<'_>) -> Result<(), Stop> {
        self.next = Some(next);
        while self.ahead.is_some_and(|ahead| self.blocks.len() >= ahead) {
            self.look(judgement)?;
        }
        Ok(())
    }

    /// The row ends behind the blocks that it has: all of them are released. Answers whether the corner moves there are
    /// not made, because the block behind them starts where others have been left out.
    pub(super) fn end(&mut self, judgement: &mut Judgement<'_>) -> Result<bool, Stop> {
        while !self.blocks.is_empty() {
            self.look(judgement)?;
        }
        if let Some(last) = self.before.take() {
            last.release(judgement);
        }
        self.next = None;
        self.open = false;
        Ok(self.avoided)
    }

    /// [TRC-INT-04] looks at Pk, and releases Bk.
    fn look(&mut self, judgement: &mut Judgement<'_>) -> Result<(), Stop> {
        let Some(block) = self.blocks.front().map(|first| first.own.block) else { return Ok(()) };
        let reading = core::mem::replace(&mut judgement.block, block);
        let found = self.farthest_interference(judgement);
        let around = match found {
            Some(place) if self.avoids => self.around(place, judgement),
            _ => Ok(None),
        };
        judgement.block = reading;
        match (found, around?) {
            (None, _) => {
                if let Some(last) = self.before.take() {
                    last.release(judgement);
                }
                self.avoided = false;
                self.before = self.blocks.pop_front();
                if let Some(first) = &self.before {
                    self.from = Corner { point: first.element.end.clone(), vectors: first.vectors.clone() };
                }
                Ok(())
            }
            (Some(place), Some(point)) => {
                self.leave_out(place, point, judgement);
                Ok(())
            }
            (Some(_), None) => {
                if let Some(last) = self.before.take() {
                    last.release(judgement);
                }
                Err(Stop::Alarm(Alarm { block, kind: AlarmKind::Interference }))
            }
        }
    }

    /// The place of the block, counted from Bk+1, at whose end a vector interferes with one at Pk; the farthest one.
    fn farthest_interference(&self, judgement: &mut Judgement<'_>) -> Option<usize> {
        let known = self.ahead.unwrap_or(0).min(self.blocks.len());
        (0..known).rev().find(|place| {
            let Some(block) = self.blocks.get(*place) else { return false };
            let only = (*place == 0).then_some(&block.element);
            if only.is_some() && block.is_exempt() {
                return false;
            }
            self.from.vectors.iter().any(|vector| {
                block.vectors.iter().any(|later| {
                    let (from, to) = ((&self.from.point, vector), (&block.element.end, later));
                    interfere(from, to, only, self.boundary, judgement)
                })
            })
        })
    }

    /// [TRC-INT-05] the point at which Bk ends and Bj+1 starts; none where the alarm is raised instead.
    fn around(&self, place: usize, judgement: &mut Judgement<'_>) -> Result<Option<Vector>, Stop> {
        let after = match self.blocks.get(place + 1) {
            Some(block) => Some((&block.element, block.fit)),
            None => self.next.as_ref().map(|next| (&next.element, next.fit)),
        };
        let (Some(before), Some((after, fit))) = (&self.before, after) else { return Ok(None) };
        if !before.has_curve() || !has_curve(after, fit) {
            return Ok(None);
        }
        let point = match avoidance(&before.element, after, before.side, &before.radius, judgement) {
            Ok(Some(point)) => point,
            Ok(None) | Err(Refused::Alarm(_)) => return Ok(None),
            Err(Refused::Contradiction) => return Err(Stop::Contradiction),
        };
        let (from, to) = ((&before.element.start, &before.start), (&before.element.end, &point));
        let led_back = interfere(from, to, Some(&before.element), self.boundary, judgement);
        Ok((!led_back).then_some(point))
    }

    /// [TRC-INT-05] Bk ends at the point, and the blocks up to this place are executed there.
    fn leave_out(&mut self, place: usize, point: Vector, judgement: &mut Judgement<'_>) {
        if let Some(mut last) = self.before.take() {
            for step in core::mem::take(&mut last.lead_in) {
                judgement.sink.step(step);
            }
            let own = Step {
                segment: own_move(&last.element, &point, false),
                clause: clause::TRC_INT_05,
                ..last.own.clone()
            };
            judgement.sink.step(own);
            last.release_holds_behind(judgement);
        }
        for block in self.blocks.drain(..=place) {
            self.from.point = block.element.end.clone();
            block.release_as_hold(judgement);
        }
        self.from.vectors = vec![point];
        self.avoided = true;
        if let Some(mut first) = self.blocks.pop_front() {
            self.starts_where_others_are_left_out(&mut first);
            self.blocks.push_front(first);
        }
    }
}
