//! The engine: reads blocks, checks their numbers and arcs, and lets the look-ahead drive the geometry.

use nalgebra::Vector2;
use radcomp_spec::{Alarm, AlarmKind, Block, Centre, Movement, Parameters, Step};

use crate::arc_form::Arc;
use crate::geometry::{Event, Kind};
use crate::plane::Vector;
use crate::scene::{Scene, State};
use crate::window::Window;

/// Takes the path of the tool's centre, element by element.
pub trait Sink {
    /// Takes the next element. Coordinates are in millimetres, in the plane of [TRC-PLANE-01].
    fn step(&mut self, step: Step<f64>);
}

/// Tool-radius compensation of one program.
///
/// # Exactness
/// See the [crate].
#[derive(Clone, Debug)]
pub struct Engine {
    window: Window,
    state: State,
    /// The number of blocks read.
    blocks: usize,
    alarm: Option<Alarm>,
}

/// The greatest magnitude of a coordinate, vector component or radius, in millimetres. [TRC-MODE-07]
const MOST: f64 = 1e9;

impl Engine {
    /// An engine at the start of a program: the tool stands at (0, 0), in cancel mode, with radius 0.
    #[must_use]
    pub fn new(parameters: &Parameters) -> Self {
        Engine { window: Window::new(parameters), state: State::new(parameters), blocks: 0, alarm: None }
    }

    /// Reads the next block. Blocks are numbered from 0; lengths are in millimetres.
    ///
    /// # Errors
    /// The first alarm of the program in the order of blocks; its block may be an earlier one than this. After it
    /// every call returns the same alarm and emits nothing.
    #[inline]
    pub fn push(&mut self, block: &Block<f64>, sink: &mut impl Sink) -> Result<(), Alarm> {
        if let Some(alarm) = self.alarm {
            return Err(alarm);
        }
        let result = self.read(block, sink);
        if let Err(alarm) = result {
            self.alarm = Some(alarm);
        }
        result
    }

    /// Ends the program: what is pending is settled without a next block. [TRC-MODE-04]
    ///
    /// # Errors
    /// As [`Engine::push`].
    pub fn finish(&mut self, sink: &mut impl Sink) -> Result<(), Alarm> {
        if let Some(alarm) = self.alarm {
            return Err(alarm);
        }
        let end = self.state.position;
        let mut scene = Scene { state: &mut self.state, sink, end, block: self.blocks, rapid: false };
        let result = self.window.finish(&mut scene);
        self.alarm = result.err();
        result
    }

    #[inline(always)]
    fn read(&mut self, block: &Block<f64>, sink: &mut impl Sink) -> Result<(), Alarm> {
        let index = self.blocks;
        self.blocks = index.wrapping_add(1);
        let form = form(block, &mut self.state);
        let end = form.map_or(self.state.position, |form| form.end);
        let mut scene = Scene { state: &mut self.state, sink, end, block: index, rapid: block.rapid };
        let kind = match form {
            Ok(form) => form.kind,
            Err(fault) => return self.window.fault(index, fault, &mut scene),
        };
        let mut other_radius = false;
        if let Some(radius) = block.radius {
            other_radius = radius != scene.state.radius_in_force;
            // The sum makes one zero of the two.
            scene.state.radius_in_force = radius + 0.0;
        }
        if let Some(outer) = block.corner {
            scene.state.rules.outer = outer;
        }
        let event = Event { kind, code: block.compensation, other_radius, rapid: block.rapid };
        self.window.read(index, event, &mut scene)?;
        self.state.position = end;
        Ok(())
    }
}

/// A block whose numbers are within range and whose arc exists; its element, if it is one, is [`State::next`].
#[derive(Clone, Copy)]
struct Form {
    kind: Kind,
    end: Vector,
}

/// [TRC-MODE-07], then [TRC-ARC-06], [TRC-ARC-02] and [TRC-ARC-03].
#[inline(always)]
fn form(block: &Block<f64>, state: &mut State) -> Result<Form, AlarmKind> {
    let (start, tolerance) = (state.position, state.tolerance);
    if let Some(radius) = block.radius
        && !(0.0..=MOST).contains(&radius)
    {
        return Err(AlarmKind::OutOfRange);
    }
    let still = Form { kind: Kind::Still, end: start };
    match &block.movement {
        Movement::None => Ok(still),
        Movement::Line { end } => {
            let end = in_range(*end)?;
            // [TRC-LOOK-01]: a straight move of length zero does not move.
            if end == start {
                return Ok(still);
            }
            state.next().set_line(start, end);
            Ok(Form { kind: Kind::Line, end })
        }
        Movement::Dummy { vector } => {
            let vector = in_range(*vector)?;
            if vector == Vector::zeros() {
                return Ok(still);
            }
            state.next().set_dummy(start, vector);
            Ok(Form { kind: Kind::Dummy, end: start })
        }
        Movement::Arc { end, centre, direction } => {
            let end = in_range(*end)?;
            match *centre {
                Centre::FromStart(vector) => in_range(vector)?,
                Centre::Radius(radius) => in_range([radius, 0.0])?,
            };
            let arc = Arc::new(start, end, centre, *direction, tolerance)?;
            state.next().set_arc(start, end, arc);
            Ok(Form { kind: Kind::Arc, end })
        }
    }
}

#[inline(always)]
fn in_range([a, b]: [f64; 2]) -> Result<Vector, AlarmKind> {
    // A comparison with what is not a number is false.
    if a.abs() <= MOST && b.abs() <= MOST { Ok(Vector2::new(a, b)) } else { Err(AlarmKind::OutOfRange) }
}
