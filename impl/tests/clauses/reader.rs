//! Just enough G-code for the worked examples of the clauses: one block a line, no errors.

use radcomp_spec::{Block, Centre, Compensation, Direction, Movement, OuterCorner, Side};

/// A program reader; the fields are its modal state.
pub struct Reader {
    /// X words are diameters, and M96 and M97 count: a lathe.
    lathe: bool,
    /// The I word of a dummy block is a diameter.
    pub dummy_diameter: bool,
    tool: f64,
    /// Tools with a radius of their own: number and radius.
    pub tools: Vec<(f64, f64)>,
    plane: [char; 2],
    motion: u32,
    incremental: bool,
    position: [f64; 3],
}

const AXES: &str = "XYZ";
const CENTRES: &str = "IJK";

impl Reader {
    pub fn new(profile: &str, tool: f64) -> Self {
        let plane = if profile == "seed-mill" { ['X', 'Y'] } else { ['Z', 'X'] };
        let lathe = profile != "seed-mill";
        Reader {
            lathe,
            dummy_diameter: false,
            tool,
            tools: Vec::new(),
            plane,
            motion: 0,
            incremental: false,
            position: [0.0; 3],
        }
    }

    pub fn block(&mut self, line: &str) -> Block<f64> {
        let words: Vec<(char, f64)> =
            line.split_whitespace().map(|word| (word.chars().next().unwrap(), word[1..].parse().unwrap())).collect();
        let word = |letter: char| words.iter().find(|word| word.0 == letter).map(|word| word.1);
        let mut block = Block::empty();
        for (letter, value) in &words {
            match (letter, *value as u32) {
                ('G', motion @ 0..=3) => self.motion = motion,
                ('G', 17) => self.plane = ['X', 'Y'],
                ('G', 18) => self.plane = ['Z', 'X'],
                ('G', 19) => self.plane = ['Y', 'Z'],
                ('G', 40) => block.compensation = Some(Compensation::Off),
                ('G', 41) => block.compensation = Some(Compensation::On(Side::Left)),
                ('G', 42) => block.compensation = Some(Compensation::On(Side::Right)),
                ('G', 90) => self.incremental = false,
                ('G', 91) => self.incremental = true,
                ('D' | 'T', _) => {
                    let own = self.tools.iter().find(|tool| tool.0 == *value);
                    block.radius = Some(own.map_or(self.tool, |tool| tool.1));
                }
                ('M', 96) if self.lathe => block.corner = Some(OuterCorner::Arc),
                ('M', 97) if self.lathe => block.corner = Some(OuterCorner::Intersection),
                _ => {}
            }
        }
        block.rapid = self.motion == 0;
        let mut any_axis = false;
        for (axis, letter) in AXES.chars().enumerate() {
            if let Some(value) = word(letter) {
                any_axis = true;
                let value = if letter == 'X' && self.lathe { value / 2.0 } else { value };
                self.position[axis] = if self.incremental { self.position[axis] + value } else { value };
            }
        }
        let moves = self.plane.iter().any(|letter| word(*letter).is_some());
        let end = self.plane.map(|letter| self.position[AXES.find(letter).unwrap()]);
        let has_centre = CENTRES.chars().any(|letter| word(letter).is_some());
        let arc = self.motion >= 2 && words.iter().all(|word| *word != ('G', 4.0));
        let centre = self.plane.map(|letter| {
            let letter = CENTRES.chars().nth(AXES.find(letter).unwrap()).unwrap();
            let halved = self.dummy_diameter && !arc && letter == 'I';
            word(letter).unwrap_or(0.0) / if halved { 2.0 } else { 1.0 }
        });
        block.movement = if arc && (moves || has_centre) {
            let direction = if self.motion == 2 { Direction::Clockwise } else { Direction::Counterclockwise };
            let centre = word('R').map_or(Centre::FromStart(centre), Centre::Radius);
            Movement::Arc { end, centre, direction }
        } else if !arc && has_centre && !any_axis {
            Movement::Dummy { vector: centre }
        } else if moves {
            Movement::Line { end }
        } else {
            Movement::None
        };
        block
    }
}
