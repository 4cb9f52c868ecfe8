//! What a generated program shows. Half of the programs show a single feature with little around it, so that a failure
//! tells what it is about; the others have everything at once.

/// What a program shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Shape {
    /// One corner between two moves.
    SingleCorner,
    /// Corners of lines, one after the other.
    CornerChain,
    /// Arcs, one after the other.
    ArcChain,
    /// Into a slot and out of it, about as wide as the tool; or over a step or a notch that is narrower.
    Slot,
    /// A start-up and the first move behind it.
    StartUp,
    /// The last move before a cancel, and at times a new start.
    Cancel,
    /// A change of the side between moves.
    SideChange,
    /// Blocks without movement, and dummy blocks, between moves.
    WithoutMovement,
    /// A contour as lathes turn it: cylinders, faces, chamfers, tapers, fillets and grooves.
    Lathe,
    /// A contour of any moves with everything that the profile has words for.
    WholeProgram,
}

impl Shape {
    /// Those with a single feature.
    pub const SINGLE: [Shape; 9] = [
        Shape::SingleCorner,
        Shape::CornerChain,
        Shape::ArcChain,
        Shape::Slot,
        Shape::StartUp,
        Shape::Cancel,
        Shape::SideChange,
        Shape::WithoutMovement,
        Shape::Lathe,
    ];

    /// The shape of the program with this number: every second three have a single feature, each in its turn.
    #[must_use]
    pub fn of(number: u64) -> Shape {
        let three = number / 3;
        if three % 2 == 1 {
            Shape::WholeProgram
        } else {
            Shape::SINGLE[(three / 2 % Shape::SINGLE.len() as u64) as usize]
        }
    }

    /// Its name, for messages.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Shape::SingleCorner => "single corner",
            Shape::CornerChain => "corner chain",
            Shape::ArcChain => "arc chain",
            Shape::Slot => "slot",
            Shape::StartUp => "start-up",
            Shape::Cancel => "cancel",
            Shape::SideChange => "side change",
            Shape::WithoutMovement => "blocks without movement",
            Shape::Lathe => "lathe",
            Shape::WholeProgram => "whole program",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_of_the_programs_show_a_single_feature_each_as_often_as_the_others() {
        let count = |shape| (0..540).filter(|number| Shape::of(*number) == shape).count();
        assert_eq!(count(Shape::WholeProgram), 270);
        for shape in Shape::SINGLE {
            assert_eq!(count(shape), 30, "{}", shape.name());
        }
    }
}
