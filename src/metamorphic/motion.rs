//! Similarities of the plane, applied to programs and to paths.

use radcomp_spec::{Block, Centre, Compensation, Direction, Movement, Parameters, Segment};
use rug::Rational;

/// `p ↦ matrix·p + shift`: a rotation or a mirroring, with a whole scale, and a translation; exact.
#[derive(Clone, Debug)]
pub struct Motion {
    /// What it is called in reports.
    pub name: &'static str,
    /// The linear part; its columns are at right angles and as long as `scale`.
    pub matrix: [[Rational; 2]; 2],
    /// The translation, in millimetres.
    pub shift: [Rational; 2],
    /// How much lengths grow.
    pub scale: u32,
    /// The sense of turns is reversed, and the sides swap.
    pub mirrors: bool,
}

fn rational(numerator: i64, denominator: i64) -> Rational {
    Rational::from((numerator, denominator))
}

impl Motion {
    /// A translation by so many thousandths of a millimetre.
    pub fn translation(a: i64, b: i64) -> Self {
        Motion {
            name: "translation",
            matrix: [[rational(1, 1), rational(0, 1)], [rational(0, 1), rational(1, 1)]],
            shift: [rational(a, 1000), rational(b, 1000)],
            scale: 1,
            mirrors: false,
        }
    }

    /// Mirroring in the second axis.
    pub fn mirroring() -> Self {
        let matrix = [[rational(-1, 1), rational(0, 1)], [rational(0, 1), rational(1, 1)]];
        Motion { name: "mirroring", matrix, mirrors: true, ..Motion::translation(0, 0) }
    }

    /// Scaling by ten.
    pub fn scaling() -> Self {
        let matrix = [[rational(10, 1), rational(0, 1)], [rational(0, 1), rational(10, 1)]];
        Motion { name: "scaling by ten", matrix, scale: 10, ..Motion::translation(0, 0) }
    }

    /// A rotation whose cosine is `a / c` and whose sine is `b / c`, with a² + b² = c².
    pub fn rotation(a: i64, b: i64, c: i64) -> Self {
        let matrix = [[rational(a, c), rational(-b, c)], [rational(b, c), rational(a, c)]];
        Motion { name: "rotation", matrix, ..Motion::translation(0, 0) }
    }

    /// A vector's image.
    pub fn vector(&self, [a, b]: &[Rational; 2]) -> [Rational; 2] {
        self.matrix.each_ref().map(|row| Rational::from(&row[0] * a) + Rational::from(&row[1] * b))
    }

    /// A point's image.
    pub fn point(&self, point: &[Rational; 2]) -> [Rational; 2] {
        let [a, b] = self.vector(point);
        [a + &self.shift[0], b + &self.shift[1]]
    }

    /// A direction of turning's image.
    pub fn direction(&self, direction: Direction) -> Direction {
        if self.mirrors { direction.reversed() } else { direction }
    }

    /// A block's image: sides swap with a mirroring, lengths grow with the scale.
    pub fn block(&self, block: &Block<Rational>) -> Block<Rational> {
        let movement = match &block.movement {
            Movement::None => Movement::None,
            Movement::Line { end } => Movement::Line { end: self.point(end) },
            Movement::Dummy { vector } => Movement::Dummy { vector: self.vector(vector) },
            Movement::HeldVector { end } => Movement::HeldVector { end: self.point(end) },
            Movement::NewVector { vector } => Movement::NewVector { vector: self.vector(vector) },
            Movement::CornerArc { vector } => {
                Movement::CornerArc { vector: vector.as_ref().map(|vector| self.vector(vector)) }
            }
            Movement::Arc { end, centre, direction } => Movement::Arc {
                end: self.point(end),
                centre: match centre {
                    Centre::FromStart(vector) => Centre::FromStart(self.vector(vector)),
                    Centre::Radius(radius) => Centre::Radius(Rational::from(radius * self.scale)),
                },
                direction: self.direction(*direction),
            },
        };
        let compensation = block.compensation.map(|code| match code {
            Compensation::On(side) if self.mirrors => Compensation::On(side.other()),
            code => code,
        });
        let radius = block.radius.as_ref().map(|radius| Rational::from(radius * self.scale));
        let vector = block.vector.as_ref().map(|vector| self.vector(vector));
        Block { movement, compensation, vector, radius, ..block.clone() }
    }

    /// The parameters with their lengths grown by the scale; none if a rule of theirs looks at the coordinates themselves
    /// and the motion does not map axes to axes ([TRC-CORNER-18]).
    pub fn parameters(&self, parameters: &Parameters) -> Option<Parameters> {
        let along_axes = self.matrix.iter().flatten().any(Rational::is_zero);
        if parameters.small_vector_limit.numerator > 0 && !along_axes {
            return None;
        }
        let mut scaled = *parameters;
        scaled.arc_end_tolerance.numerator *= self.scale;
        scaled.small_vector_limit.numerator *= self.scale;
        scaled.chord_tolerance.numerator *= self.scale;
        scaled.centre_tolerance.numerator *= self.scale;
        Some(scaled)
    }

    /// A path element's image, with the arithmetic of the number type handed in: `image` maps a point.
    pub fn segment<N: Clone>(&self, segment: &Segment<N>, image: impl Fn(&[N; 2]) -> [N; 2]) -> Segment<N> {
        match segment {
            Segment::Hold => Segment::Hold,
            Segment::Line { end } => Segment::Line { end: image(end) },
            Segment::Arc { end, centre, direction, full } => Segment::Arc {
                end: image(end),
                centre: image(centre),
                direction: self.direction(*direction),
                full: *full,
            },
        }
    }

    /// A point's image in f64.
    ///
    /// # Exactness
    ///
    /// Within a few units in the last place of the largest coordinate.
    pub fn rounded(&self, [a, b]: &[f64; 2]) -> [f64; 2] {
        let of =
            |row: usize| self.matrix[row][0].to_f64() * a + self.matrix[row][1].to_f64() * b + self.shift[row].to_f64();
        [of(0), of(1)]
    }
}
