//! The peer: cavalier_contours offsets the same closed contour to the same side, as a polyline of lines and arcs.

use cavalier_contours::polyline::{PlineSource, Polyline};

/// The number of vertices of the offset.
pub fn run(polyline: &Polyline<f64>, radius: f64) -> usize {
    polyline.parallel_offset(radius).iter().map(PlineSource::vertex_count).sum()
}
