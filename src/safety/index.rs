//! The spatial index: which boxes lie near a box.

use static_aabb2d_index::{Control, StaticAABB2DIndex, StaticAABB2DIndexBuilder};

/// Boxes by their place in a list.
pub(crate) struct Index(Option<StaticAABB2DIndex<f64>>);

impl Index {
    /// The index of some boxes, each given by its low and high corner.
    pub(crate) fn new(boxes: impl ExactSizeIterator<Item = [[f64; 2]; 2]>) -> Self {
        let mut builder = StaticAABB2DIndexBuilder::new(boxes.len());
        for [low, high] in boxes {
            builder.add(low[0], low[1], high[0], high[1]);
        }
        // Building fails only when fewer boxes were added than announced; without boxes there is nothing to find.
        Index(builder.build().ok())
    }

    /// The box nearest to a point, to within rounding.
    pub(crate) fn nearest(&self, [x, y]: [f64; 2]) -> Option<usize> {
        let mut found = None;
        let mut stop_at_first = |item: usize, _: f64| {
            found = Some(item);
            Control::Break(())
        };
        if let Some(index) = &self.0 {
            let _: Control<()> = index.visit_neighbors(x, y, &mut stop_at_first);
        }
        found
    }

    /// The boxes that come nearer to a box than a distance, perhaps some more.
    pub(crate) fn near(&self, [low, high]: [[f64; 2]; 2], distance: f64) -> Vec<usize> {
        let Some(index) = &self.0 else { return Vec::new() };
        let (low, high) = (low.map(|x| (x - distance).next_down()), high.map(|x| (x + distance).next_up()));
        index.query(low[0], low[1], high[0], high[1])
    }
}
