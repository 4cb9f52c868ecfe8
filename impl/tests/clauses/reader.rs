//! Just enough G-code for the worked examples of the clauses: one block a line, no errors.

use radcomp_spec::parameters::*;
use radcomp_spec::profile::{Machine, Profile};
use radcomp_spec::{AlarmKind, Block, Centre, Compensation, Direction, Movement, OuterCorner, Parameters, Side};

/// A program reader; the fields are its modal state.
pub struct Reader {
    machine: Machine,
    activation: [Activation; 5],
    parameters: Parameters,
    /// Number and radius.
    tools: Vec<(u32, f64)>,
    plane: [char; 2],
    motion: u32,
    incremental: bool,
    position: [f64; 3],
    /// The code in force. [TRC-CANCEL-07]
    asked: Option<Side>,
    /// Offset number 0 is in force.
    offset_zero: bool,
}

const AXES: &str = "XYZ";
const CENTRES: &str = "IJK";

impl Reader {
    pub fn new(profile: &Profile, tools: Vec<(u32, f64)>) -> Self {
        Reader {
            machine: profile.machine,
            activation: profile.activation,
            parameters: profile.parameters,
            tools,
            plane: match profile.machine.plane {
                Plane::Xy => ['X', 'Y'],
                Plane::Zx => ['Z', 'X'],
                Plane::Yz => ['Y', 'Z'],
            },
            motion: 0,
            incremental: false,
            position: [0.0; 3],
            asked: None,
            offset_zero: false,
        }
    }

    pub fn block(&mut self, line: &str) -> Block<f64> {
        // Codes that are words. [TRC-START-12]
        let line = line.replace("NORM", "!0").replace("KONT", "!1");
        let words: Vec<(char, f64)> =
            line.split_whitespace().map(|word| (word.chars().next().unwrap(), word[1..].parse().unwrap())).collect();
        let word = |letter: char| words.iter().find(|word| word.0 == letter).map(|word| word.1);
        let mut block = Block::empty();
        let plane = self.plane;
        for (letter, value) in &words {
            match (letter, *value as u32) {
                ('G', motion @ 0..=3) => self.motion = motion,
                ('G', 17) => self.plane = ['X', 'Y'],
                ('G', 18) => self.plane = ['Z', 'X'],
                ('G', 19) => self.plane = ['Y', 'Z'],
                ('G', code @ 40..=44) => block.compensation = self.activated(code as usize - 40),
                ('G', 90) => self.incremental = false,
                ('G', 91) => self.incremental = true,
                ('G', 450) => block.corner = Some(OuterCorner::Arc),
                ('G', 451) => block.corner = Some(OuterCorner::LimitAngle),
                ('!', code) if self.machine.approach_codes == ApproachCodes::NormKont => {
                    block.approach = Some(if code == 0 { Approach::Norm } else { Approach::Kont });
                }
                ('D' | 'T', number) => self.select(number % 100, &mut block),
                ('M', 0 | 1) => {
                    block.stops_look_ahead = self.machine.read_ahead_stop == ReadAheadStop::BreaksLookAhead;
                }
                ('M', 96) if self.machine.corner_codes == CornerCodes::M96M97 => block.corner = Some(OuterCorner::Arc),
                ('M', 97) if self.machine.corner_codes == CornerCodes::M96M97 => {
                    block.corner = Some(OuterCorner::Intersection);
                }
                _ => {}
            }
        }
        self.note_side(&mut block);
        if self.asked.is_some() {
            block.not_in_mode = words.iter().find_map(|word| self.not_in_mode(*word, self.plane != plane));
        }
        block.rapid = self.motion == 0;
        // The words of a dwell are its time.
        if !words.contains(&('G', 4.0)) {
            let code = words.iter().find(|word| word.0 == 'G' && [38.0, 39.0].contains(&word.1));
            self.read_movement(&word, code.map(|code| code.1 as u32), &mut block);
        }
        block
    }

    /// The alarm of a code in mode. [TRC-MODE-08]
    fn not_in_mode(&self, (letter, value): (char, f64), other_plane: bool) -> Option<AlarmKind> {
        let machine = &self.machine;
        let (rule, kind) = match (letter, value as u32) {
            ('G', 17..=19) if other_plane => (machine.plane_change, AlarmKind::PlaneChangeInMode),
            ('G', 28..=30) => (machine.reference_return, AlarmKind::ReferenceReturnInMode),
            ('G', 53) => (machine.machine_coordinates, AlarmKind::MachineCoordinatesInMode),
            ('G', 92) => (machine.set_coordinates, AlarmKind::SetCoordinatesInMode),
            ('G', 81) => (machine.canned_cycle, AlarmKind::CannedCycleInMode),
            ('M', 6) if machine.tool_change == ToolChange::Alarm => (InMode::Alarm, AlarmKind::ToolChangeInMode),
            _ => return None,
        };
        (rule == InMode::Alarm).then_some(kind)
    }

    /// What a code means. [TRC-PLANE-05]
    fn activated(&self, code: usize) -> Option<Compensation> {
        match self.activation[code] {
            Activation::Cancel => Some(Compensation::Off),
            Activation::Left => Some(Compensation::On(Side::Left)),
            Activation::Right => Some(Compensation::On(Side::Right)),
            Activation::Undeclared | Activation::Absent => None,
        }
    }

    fn select(&mut self, number: u32, block: &mut Block<f64>) {
        let was_zero = self.offset_zero;
        self.offset_zero = number == 0;
        if number > 0 {
            block.radius = self.tools.iter().find(|tool| tool.0 == number).map(|tool| tool.1);
        }
        // [TRC-CANCEL-07]
        if let (Some(side), None) = (self.asked, block.compensation) {
            match (was_zero, self.offset_zero) {
                (false, true) => block.compensation = Some(Compensation::Off),
                (true, false) => block.compensation = Some(Compensation::On(side)),
                _ => {}
            }
        }
    }

    /// Keeps the code in force; codes of a side do nothing while offset number 0 is. [TRC-CANCEL-07]
    fn note_side(&mut self, block: &mut Block<f64>) {
        match block.compensation {
            Some(Compensation::On(side)) => {
                self.asked = Some(side);
                if self.offset_zero {
                    block.compensation = None;
                }
            }
            Some(Compensation::Off) if !self.offset_zero => self.asked = None,
            _ => {}
        }
    }

    /// Whether I, J, K beside a compensation code mean something. [TRC-START-10], [TRC-CANCEL-08]
    fn gives_vector(&self, code: Option<Compensation>) -> bool {
        match code {
            None => false,
            Some(Compensation::Off) => self.parameters.cancel_vector != CancelVector::Refused,
            Some(Compensation::On(_)) => self.parameters.side_code_vector != SideCodeVector::Refused,
        }
    }

    /// `vector_code` is 38 or 39. [TRC-VEC-01]
    fn read_movement(&mut self, word: &impl Fn(char) -> Option<f64>, vector_code: Option<u32>, block: &mut Block<f64>) {
        let before = self.position;
        let mut any_axis = false;
        for (axis, letter) in AXES.chars().enumerate() {
            if let Some(value) = word(letter) {
                any_axis = true;
                let value =
                    if letter == 'X' && self.machine.x_words == Measure::Diameter { value / 2.0 } else { value };
                self.position[axis] = if self.incremental { self.position[axis] + value } else { value };
            }
        }
        let moves = self.plane.iter().any(|letter| word(*letter).is_some());
        let end = self.plane.map(|letter| self.position[AXES.find(letter).unwrap()]);
        let has_centre = CENTRES.chars().any(|letter| word(letter).is_some());
        let arc = self.motion >= 2;
        let centre = self.plane.map(|letter| {
            let letter = CENTRES.chars().nth(AXES.find(letter).unwrap()).unwrap();
            word(letter).unwrap_or(0.0)
        });
        if vector_code == Some(39) {
            // The programmed point does not move.
            let from = self.plane.map(|letter| before[AXES.find(letter).unwrap()]);
            let vector = if has_centre { centre } else { [end[0] - from[0], end[1] - from[1]] };
            (self.position, block.movement) =
                (before, Movement::CornerArc { vector: (has_centre || any_axis).then_some(vector) });
            return;
        }
        let gives_vector = has_centre && !arc && self.gives_vector(block.compensation);
        block.vector = gives_vector.then_some(centre);
        block.movement = if vector_code.is_some() {
            if any_axis { Movement::HeldVector { end } } else { Movement::NewVector { vector: centre } }
        } else if arc && (moves || has_centre) {
            let direction = if self.motion == 2 { Direction::Clockwise } else { Direction::Counterclockwise };
            let centre = word('R').map_or(Centre::FromStart(centre), Centre::Radius);
            Movement::Arc { end, centre, direction }
        } else if !arc && has_centre && !any_axis && !gives_vector {
            let halved = self.machine.dummy_first_axis == Measure::Diameter;
            let halve = |at: usize| if halved && self.plane[at] == 'X' { centre[at] / 2.0 } else { centre[at] };
            Movement::Dummy { vector: [halve(0), halve(1)] }
        } else if moves {
            Movement::Line { end }
        } else {
            Movement::None
        };
    }
}
