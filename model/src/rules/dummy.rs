//! Dummy blocks: `spec/clauses/08-dummy.md`.

use crate::element::Element;
use crate::geometry::Vector;

/// The element that a dummy block stands for: a straight move from the programmed point along its vector
/// ([TRC-DUMMY-02]); none if the vector is zero ([TRC-DUMMY-01]).
pub(crate) fn element(point: &Vector, vector: &Vector) -> Option<Element> {
    if vector.is_zero() {
        return None;
    }
    Some(Element::line(point.clone(), point.plus(vector)))
}
