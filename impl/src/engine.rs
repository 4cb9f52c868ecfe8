//! The engine: reads blocks, checks their numbers and arcs, and lets the look-ahead drive the geometry.

use nalgebra::Vector2;
use radcomp_spec::parameters::{Approach, StartUp};
use radcomp_spec::{Alarm, AlarmKind, Block, Centre, Direction, Movement, Parameters, Step};

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
pub(crate) const MOST: f64 = 1e9;

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
        let given = Vector::zeros();
        let mut scene =
            Scene { state: &mut self.state, sink, end, block: self.blocks, rapid: false, runs: false, given };
        let result = self.window.finish(&mut scene);
        self.alarm = result.err();
        result
    }

    /// What follows a block's form is compiled once for lines, once for arcs and once for all else: most blocks are
    /// lines or arcs, and what is known of their kind is then not asked again.
    #[inline(always)]
    fn read<S: Sink>(&mut self, block: &Block<f64>, sink: &mut S) -> Result<(), Alarm> {
        let start = self.state.position;
        if block.not_in_mode.is_some() {
            // The movement words are not looked at. [TRC-MODE-08]
            return self.stay(block, Kind::Still, radius_in_range(block, &self.state), sink);
        }
        if let Some(vector) = block.vector {
            return self.read_beside(block, vector, sink);
        }
        match &block.movement {
            Movement::Line { end } if *end != <[f64; 2]>::from(start) => {
                let form = form_line(block, *end, &mut self.state);
                self.take(block, Kind::Line, form, Vector::zeros(), sink)
            }
            Movement::Arc { end, centre, direction } => {
                let form = form_arc(block, *end, centre, *direction, &mut self.state);
                self.take(block, Kind::Arc, form, Vector::zeros(), sink)
            }
            // [TRC-LOOK-01]: a straight move of length zero does not move.
            Movement::Line { .. } | Movement::None => {
                self.stay(block, Kind::Still, radius_in_range(block, &self.state), sink)
            }
            Movement::Dummy { vector } => {
                let kind = if *vector == [0.0, 0.0] { Kind::Still } else { Kind::Dummy };
                let form = form_dummy(block, *vector, &mut self.state);
                self.stay(block, kind, form, sink)
            }
            Movement::HeldVector { end } if *end != <[f64; 2]>::from(start) => {
                let form = form_line(block, *end, &mut self.state);
                self.take_rare(block, Kind::HeldVector, form, Vector::zeros(), sink)
            }
            // [TRC-VEC-04]: of length zero it is a straight move of length zero.
            Movement::HeldVector { .. } => self.stay(block, Kind::Still, radius_in_range(block, &self.state), sink),
            Movement::NewVector { vector } => self.read_vector(block, Kind::NewVector, *vector, sink),
            Movement::CornerArc { vector: Some(vector) } => self.read_vector(block, Kind::CornerArc, *vector, sink),
            Movement::CornerArc { vector: None } => {
                self.stay(block, Kind::CornerToNext, radius_in_range(block, &self.state), sink)
            }
        }
    }

    /// Reads a block with a vector beside its compensation code: a straight move, or no movement. The words of an arc are
    /// its centre's.
    #[cold]
    fn read_beside<S: Sink>(&mut self, block: &Block<f64>, vector: [f64; 2], sink: &mut S) -> Result<(), Alarm> {
        let start = self.state.position;
        let given = in_range(vector).and_then(|vector| radius_in_range(block, &self.state).map(|()| vector));
        match &block.movement {
            Movement::Line { end } if *end != <[f64; 2]>::from(start) => {
                let form = given.and_then(|_| form_line(block, *end, &mut self.state));
                self.take_rare(block, Kind::Line, form, given.unwrap_or(Vector::zeros()), sink)
            }
            Movement::Line { .. } | Movement::None => self.read_vector(block, Kind::Still, vector, sink),
            _ => self.read(&Block { vector: None, ..block.clone() }, sink),
        }
    }

    /// Reads a block that gives a vector and does not move by its program; without a length it gives none.
    #[cold]
    fn read_vector<S: Sink>(
        &mut self,
        block: &Block<f64>,
        kind: Kind,
        vector: [f64; 2],
        sink: &mut S,
    ) -> Result<(), Alarm> {
        let position = self.state.position;
        let given = radius_in_range(block, &self.state).and_then(|()| in_range(vector));
        let kind = if vector == [0.0, 0.0] { Kind::Still } else { kind };
        self.take_rare(block, kind, given.map(|_| position), given.unwrap_or(Vector::zeros()), sink)
    }

    /// Takes a block that does not move. Such blocks are rare, and their code stands apart.
    #[inline(never)]
    fn stay<S: Sink>(
        &mut self,
        block: &Block<f64>,
        kind: Kind,
        form: Result<(), AlarmKind>,
        sink: &mut S,
    ) -> Result<(), Alarm> {
        let position = self.state.position;
        self.take(block, kind, form.map(|()| position), Vector::zeros(), sink)
    }

    /// Takes a block whose code is rare too.
    #[inline(never)]
    fn take_rare<S: Sink>(
        &mut self,
        block: &Block<f64>,
        kind: Kind,
        form: Result<Vector, AlarmKind>,
        given: Vector,
        sink: &mut S,
    ) -> Result<(), Alarm> {
        self.take(block, kind, form, given, sink)
    }

    /// Takes a block of which the form, with its end, has been looked at; `given` is the vector that it gives, or zero.
    #[inline(always)]
    fn take<S: Sink>(
        &mut self,
        block: &Block<f64>,
        kind: Kind,
        form: Result<Vector, AlarmKind>,
        given: Vector,
        sink: &mut S,
    ) -> Result<(), Alarm> {
        let index = self.blocks;
        self.blocks = index.wrapping_add(1);
        let end = match form {
            Ok(end) => end,
            Err(kind) => return self.refuse(block, index, kind, sink),
        };
        let runs = matches!(kind, Kind::Line | Kind::Arc);
        let mut scene = Scene { state: &mut self.state, sink, end, block: index, rapid: block.rapid, runs, given };
        let mut other_radius = false;
        if let Some(radius) = block.radius {
            other_radius = radius.abs() != scene.state.radius_in_force;
            (scene.state.radius_in_force, scene.state.swapped) = (radius.abs(), radius < 0.0);
        }
        if let Some(approach) = block.approach {
            self.window.approach(approach);
            scene.state.rules.start_up = match approach {
                Approach::Norm => StartUp::TypeA,
                Approach::Kont => StartUp::TypeB,
            };
        }
        if let Some(outer) = block.corner {
            scene.state.rules.outer = outer;
        }
        let event = Event {
            kind,
            code: block.compensation,
            other_radius,
            rapid: block.rapid,
            swapped: scene.state.swapped,
            zero_length: kind == Kind::Still
                && matches!(block.movement, Movement::Line { .. } | Movement::HeldVector { .. }),
            stops: block.stops_look_ahead,
            not_in_mode: block.not_in_mode,
            vector: given != Vector::zeros() && block.vector.is_some(),
            vector_code: kind != Kind::Line
                && kind != Kind::Arc
                && matches!(
                    block.movement,
                    Movement::HeldVector { .. } | Movement::NewVector { .. } | Movement::CornerArc { .. }
                ),
        };
        self.window.read(index, event, &mut scene)?;
        self.state.position = end;
        Ok(())
    }

    /// Raises the alarm of a block whose numbers are out of range, or of an arc that does not exist. [TRC-MODE-06]
    #[cold]
    fn refuse<S: Sink>(
        &mut self,
        block: &Block<f64>,
        index: usize,
        kind: AlarmKind,
        sink: &mut S,
    ) -> Result<(), Alarm> {
        let (end, given) = (self.state.position, Vector::zeros());
        let other_radius = block.radius.is_some_and(|radius| radius.abs() != self.state.radius_in_force);
        let event = Event { code: block.compensation, other_radius, ..Event::of(Kind::Arc) };
        let (rapid, runs) = (block.rapid, false);
        let mut scene = Scene { state: &mut self.state, sink, end, block: index, rapid, runs, given };
        self.window.refuse(index, event, kind, &mut scene)
    }
}

/// Makes the line that the block moves on the element read. [TRC-MODE-07]
#[inline(always)]
fn form_line(block: &Block<f64>, end: [f64; 2], state: &mut State) -> Result<Vector, AlarmKind> {
    radius_in_range(block, state)?;
    let (start, end) = (state.position, in_range(end)?);
    state.next().set_line(start, end);
    Ok(end)
}

/// Makes the arc that the block moves on the element read. [TRC-MODE-07], then [TRC-ARC-06], [TRC-ARC-02] and
/// [TRC-ARC-03].
#[inline(always)]
fn form_arc(
    block: &Block<f64>,
    end: [f64; 2],
    centre: &Centre<f64>,
    direction: Direction,
    state: &mut State,
) -> Result<Vector, AlarmKind> {
    radius_in_range(block, state)?;
    let (start, end, tolerances) = (state.position, in_range(end)?, state.tolerances);
    match *centre {
        Centre::FromStart(vector) => in_range(vector)?,
        Centre::Radius(radius) => in_range([radius, 0.0])?,
    };
    state.next().set_arc(start, end, centre, direction, tolerances)?;
    Ok(end)
}

/// Makes the straight move that the block stands for, if it does, the element read. [TRC-MODE-07], [TRC-DUMMY-02]
fn form_dummy(block: &Block<f64>, vector: [f64; 2], state: &mut State) -> Result<(), AlarmKind> {
    radius_in_range(block, state)?;
    let (start, vector) = (state.position, in_range(vector)?);
    if vector != Vector::zeros() {
        state.next().set_dummy(start, vector);
    }
    Ok(())
}

#[inline(always)]
fn radius_in_range(block: &Block<f64>, state: &State) -> Result<(), AlarmKind> {
    match block.radius {
        Some(radius) if !(state.least_radius..=MOST).contains(&radius) => Err(AlarmKind::OutOfRange),
        _ => Ok(()),
    }
}

#[inline(always)]
fn in_range([a, b]: [f64; 2]) -> Result<Vector, AlarmKind> {
    // A comparison with what is not a number is false.
    if a.abs() <= MOST && b.abs() <= MOST { Ok(Vector2::new(a, b)) } else { Err(AlarmKind::OutOfRange) }
}
