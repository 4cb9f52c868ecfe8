//! A small reader of programs: what the examples' words mean, block by block.

use radcomp_model::number::parse_decimal;
use radcomp_spec::parameters::{
    Activation, Approach, ApproachCodes, CancelVector, CornerCodes, Dummy, InMode, Measure, OffsetZero, Plane,
    ReadAheadStop, SideCodeVector, ToolChange, VectorCodes,
};
use radcomp_spec::profile::Profile;
use radcomp_spec::{AlarmKind, Block, Centre, Compensation, Direction, Movement, OuterCorner, Side};
use rug::Rational;

use crate::example::Example;

/// The blocks of a program, and the line of each, from 1.
pub struct Program {
    pub blocks: Vec<Block<Rational>>,
    pub lines: Vec<usize>,
}

pub fn read(example: &Example, profile: &Profile) -> Program {
    let mut reader = Reader {
        example,
        profile,
        plane: profile.machine.plane,
        motion: 1,
        incremental: false,
        position: [Rational::new(), Rational::new(), Rational::new()],
        code: None,
        offset: None,
    };
    let mut program = Program { blocks: Vec::new(), lines: Vec::new() };
    for (line, text) in (1..).zip(example.program.lines()) {
        let words = words(text);
        if words.is_empty() {
            continue;
        }
        let ends = words.iter().any(|word| word.is('M', &[2, 30]));
        program.blocks.push(reader.block(&words));
        program.lines.push(line);
        if ends {
            break;
        }
    }
    program
}

struct Word {
    letter: char,
    value: Rational,
}

impl Word {
    fn is(&self, letter: char, values: &[u32]) -> bool {
        self.letter == letter && values.iter().any(|value| self.value == *value)
    }
}

/// The words of a line, without comments and block numbers.
fn words(line: &str) -> Vec<Word> {
    let mut text = line.split(';').next().unwrap_or("").trim().to_owned();
    while let (Some(open), Some(close)) = (text.find('('), text.find(')')) {
        text.replace_range(open..=close, " ");
    }
    // Codes that are words ([TRC-START-12]).
    let text = text.replace("NORM", "!0").replace("KONT", "!1");
    let mut words = Vec::new();
    let mut rest = text.trim_start();
    while let Some(letter) = rest.chars().next() {
        let number = &rest[letter.len_utf8()..];
        let end = number.find(|c: char| !(c.is_ascii_digit() || "+-.".contains(c))).unwrap_or(number.len());
        let value = parse_decimal(&number[..end]).unwrap_or_else(|| panic!("{line:?}: {letter}{}", &number[..end]));
        words.push(Word { letter, value });
        rest = number[end..].trim_start();
    }
    words.retain(|word| word.letter != 'N');
    words
}

struct Reader<'a> {
    example: &'a Example,
    profile: &'a Profile,
    plane: Plane,
    motion: u32,
    incremental: bool,
    position: [Rational; 3],
    /// The compensation code in force; offset number 0 leaves it so ([TRC-CANCEL-07]).
    code: Option<Side>,
    /// The offset number in force.
    offset: Option<u32>,
}

/// The axes of a plane, in its order ([TRC-PLANE-01]).
fn axes(plane: Plane) -> [usize; 2] {
    match plane {
        Plane::Xy => [0, 1],
        Plane::Zx => [2, 0],
        Plane::Yz => [1, 2],
    }
}

impl Reader<'_> {
    fn block(&mut self, words: &[Word]) -> Block<Rational> {
        let mut block = Block::empty();
        let before = (self.code, self.offset);
        let mut own_code = None;
        let mut not_in_mode = None;
        let mut moves = true;
        let mut vector_code = None;
        for word in words {
            if word.is('G', &[0, 1, 2, 3]) {
                self.motion = word.value.numer().to_u32().expect("0 to 3");
            } else if word.is('G', &[17, 18, 19]) {
                let plane = match word.value.numer().to_u32() {
                    Some(17) => Plane::Xy,
                    Some(18) => Plane::Zx,
                    _ => Plane::Yz,
                };
                if plane != self.plane {
                    not_in_mode = alarm(self.profile.machine.plane_change, AlarmKind::PlaneChangeInMode);
                }
                self.plane = plane;
            } else if word.is('G', &[40, 41, 42, 43, 44]) {
                let place = word.value.numer().to_usize().expect("40 to 44") - 40;
                own_code = Some(match self.profile.activation[place] {
                    Activation::Cancel => Compensation::Off,
                    Activation::Left => Compensation::On(Side::Left),
                    Activation::Right => Compensation::On(Side::Right),
                    Activation::Undeclared | Activation::Absent => panic!("G{} of an example", place + 40),
                });
            } else if word.is('G', &[38, 39]) {
                assert_eq!(self.profile.machine.vector_codes, VectorCodes::G38G39, "G38 or G39 of an example");
                vector_code = word.value.numer().to_u32();
            } else if word.is('G', &[90, 91]) {
                self.incremental = word.value == 91;
            } else if word.letter == 'D' || (word.letter == 'T' && word.value >= 100) {
                self.offset = word.value.numer().to_u32().map(|number| number % 100);
            } else {
                self.code_of_no_movement(word, &mut block, &mut not_in_mode, &mut moves);
            }
        }
        block.compensation = self.compensation(own_code, before);
        if self.offset != before.1 || words.iter().any(|word| "DT".contains(word.letter)) {
            block.radius = self.offset.and_then(|number| self.example.offset(number));
        }
        block.rapid = self.motion == 0;
        // [TRC-MODE-08] from the block with G41 or G42 on, and up to the block with G40.
        let in_mode = block.compensation != Some(Compensation::Off)
            && (before.0.is_some() || matches!(block.compensation, Some(Compensation::On(_))));
        if in_mode && not_in_mode.is_some() {
            block.not_in_mode = not_in_mode;
        } else if let Some(code) = vector_code {
            block.movement = self.vector_block(code, words);
        } else if moves {
            let parameters = &self.profile.parameters;
            let has_meaning = match own_code {
                None => false,
                Some(Compensation::Off) => parameters.cancel_vector != CancelVector::Refused,
                Some(Compensation::On(_)) => parameters.side_code_vector != SideCodeVector::Refused,
            };
            if has_meaning && self.motion < 2 {
                block.vector = self.in_plane(words, ['I', 'J', 'K']);
            }
            block.movement = self.movement(words, block.vector.is_some());
        }
        block
    }

    /// [TRC-VEC-01]
    fn vector_block(&mut self, code: u32, words: &[Word]) -> Movement<Rational> {
        let vector = self.in_plane(words, ['I', 'J', 'K']);
        let start = axes(self.plane).map(|axis| self.position[axis].clone());
        let to_point = self.in_plane(words, ['X', 'Y', 'Z']).is_some();
        if code == 38 {
            return match vector {
                Some(vector) => Movement::NewVector { vector },
                None => match self.movement(words, false) {
                    Movement::Line { end } => Movement::HeldVector { end },
                    other => panic!("G38 of an example with {other:?}"),
                },
            };
        }
        if !to_point {
            return Movement::CornerArc { vector };
        }
        let kept = self.position.clone();
        let end = axes(self.plane);
        self.motion = self.motion.min(1);
        let _ = self.movement(words, false);
        let end = end.map(|axis| self.position[axis].clone());
        self.position = kept;
        Movement::CornerArc { vector: Some([0, 1].map(|axis| Rational::from(&end[axis] - &start[axis]))) }
    }

    /// The words of the plane among three letters, if one of them is there; one that is not is 0.
    fn in_plane(&self, words: &[Word], letters: [char; 3]) -> Option<[Rational; 2]> {
        let find = |letter: char| words.iter().find(|word| word.letter == letter).map(|word| word.value.clone());
        let given = axes(self.plane).map(|axis| find(letters[axis]));
        given.iter().any(Option::is_some).then(|| given.map(Option::unwrap_or_default))
    }

    /// The other codes of an example.
    fn code_of_no_movement(
        &self,
        word: &Word,
        block: &mut Block<Rational>,
        not_in_mode: &mut Option<AlarmKind>,
        moves: &mut bool,
    ) {
        let machine = &self.profile.machine;
        if word.is('G', &[4]) {
            *moves = false;
        } else if word.is('G', &[28, 29, 30]) {
            *not_in_mode = alarm(machine.reference_return, AlarmKind::ReferenceReturnInMode);
        } else if word.is('G', &[53]) {
            *not_in_mode = alarm(machine.machine_coordinates, AlarmKind::MachineCoordinatesInMode);
        } else if word.is('G', &[50, 92]) {
            *not_in_mode = alarm(machine.set_coordinates, AlarmKind::SetCoordinatesInMode);
        } else if word.is('G', &[81, 82, 83, 84, 85, 86, 87, 88, 89]) {
            *not_in_mode = alarm(machine.canned_cycle, AlarmKind::CannedCycleInMode);
        } else if word.is('M', &[6]) {
            *not_in_mode = match machine.tool_change {
                ToolChange::NoMovement => None,
                ToolChange::Alarm => Some(AlarmKind::ToolChangeInMode),
                ToolChange::Unsupported => panic!("M06 of an example"),
            };
        } else if word.is('M', &[0, 1]) {
            block.stops_look_ahead = machine.read_ahead_stop == ReadAheadStop::BreaksLookAhead;
        } else if word.is('!', &[0, 1]) && machine.approach_codes == ApproachCodes::NormKont {
            block.approach = Some(if word.value == 0 { Approach::Norm } else { Approach::Kont });
        } else if word.is('M', &[96, 97]) && machine.corner_codes == CornerCodes::M96M97 {
            block.corner = Some(if word.value == 96 { OuterCorner::Arc } else { OuterCorner::Intersection });
        } else if word.is('G', &[450, 451]) && machine.corner_codes == CornerCodes::G450G451 {
            block.corner = Some(if word.value == 450 { OuterCorner::Arc } else { OuterCorner::LimitAngle });
        } else {
            assert!("FSMPTXYZIJKR".contains(word.letter), "{}{} of an example", word.letter, word.value);
        }
    }

    /// What the codes and the offset number of a block ask for ([TRC-CANCEL-07]).
    fn compensation(
        &mut self,
        own: Option<Compensation>,
        (code_before, offset_before): (Option<Side>, Option<u32>),
    ) -> Option<Compensation> {
        match own {
            Some(Compensation::Off) => self.code = None,
            Some(Compensation::On(side)) => self.code = Some(side),
            None => {}
        }
        let zero_cancels = self.profile.machine.offset_zero == OffsetZero::Cancel;
        let (was_off, is_off) = (offset_before == Some(0), self.offset == Some(0));
        if own == Some(Compensation::Off) || !zero_cancels || was_off == is_off && !is_off {
            return own;
        }
        match (was_off, is_off) {
            (false, true) => code_before.map(|_| Compensation::Off),
            (true, false) => self.code.map(Compensation::On),
            _ => None,
        }
    }

    /// The movement of a block; its centre words may be those beside a code.
    fn movement(&mut self, words: &[Word], beside_code: bool) -> Movement<Rational> {
        let find = |letter: char| words.iter().find(|word| word.letter == letter).map(|word| word.value.clone());
        let start = self.position.clone();
        for (axis, letter) in ['X', 'Y', 'Z'].into_iter().enumerate() {
            if let Some(mut value) = find(letter) {
                if axis == 0 && self.profile.machine.x_words == Measure::Diameter {
                    value /= 2;
                }
                self.position[axis] = if self.incremental { value + &start[axis] } else { value };
            }
        }
        let plane = axes(self.plane);
        let given = |letters: [char; 3]| plane.map(|axis| find(letters[axis]));
        let in_plane = given(['X', 'Y', 'Z']).iter().any(Option::is_some);
        let centre = given(['I', 'J', 'K']);
        let has_centre = centre.iter().any(Option::is_some);
        let centre = centre.map(Option::unwrap_or_default);
        let end = plane.map(|axis| self.position[axis].clone());
        let no_axis_words = ['X', 'Y', 'Z'].into_iter().all(|letter| find(letter).is_none());
        match self.motion {
            2 | 3 if has_centre || in_plane => {
                let centre = match find('R') {
                    Some(radius) => Centre::Radius(radius),
                    None => Centre::FromStart(centre),
                };
                let direction = if self.motion == 2 { Direction::Clockwise } else { Direction::Counterclockwise };
                Movement::Arc { end, centre, direction }
            }
            0 | 1 if in_plane => Movement::Line { end },
            0 | 1 if has_centre && no_axis_words && !beside_code => self.dummy(plane, centre),
            _ => Movement::None,
        }
    }

    /// [TRC-DUMMY-01], [TRC-DUMMY-05]
    fn dummy(&self, plane: [usize; 2], mut vector: [Rational; 2]) -> Movement<Rational> {
        assert_eq!(self.profile.machine.dummy, Dummy::Ijk, "a dummy block of an example");
        if self.profile.machine.dummy_first_axis == Measure::Diameter {
            for (axis, component) in plane.into_iter().zip(&mut vector) {
                if axis == 0 {
                    *component /= 2;
                }
            }
        }
        Movement::Dummy { vector }
    }
}

/// The alarm of a code in mode.
fn alarm(rule: InMode, kind: AlarmKind) -> Option<AlarmKind> {
    // What is `unsupported` is refused by name in an example that shows it.
    (rule == InMode::Alarm).then_some(kind)
}
