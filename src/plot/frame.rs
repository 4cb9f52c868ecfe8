//! From millimetres to the picture's units, and the samples that labels keep away from.

use radcomp_spec::block::Point;

use super::scene::Scene;

/// Width of the picture.
pub(super) const WIDTH: f64 = 1000.0;

/// The room of a picture and what is left free around its drawing.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sheet {
    /// Width of the whole.
    pub(super) width: f64,
    /// Above the drawing: the title.
    pub(super) top: f64,
    /// Beside the drawing: labels.
    pub(super) side: f64,
    /// Greatest and least height of the drawing.
    pub(super) height: (f64, f64),
    /// Below the drawing: labels and the scale.
    pub(super) below: f64,
}

/// A picture that stands alone.
const PICTURE: Sheet = Sheet { width: WIDTH, top: 64.0, side: 70.0, height: (640.0, 160.0), below: 96.0 };

/// The map from the plane to the picture: the first axis to the right, the second up.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    scale: f64,
    origin: Point<f64>,
    width: f64,
    /// Bottom of the drawing; the legend stands below it.
    pub(super) bottom: f64,
}

impl Frame {
    /// The frame that holds a scene on a picture that stands alone.
    pub(super) fn around(scene: &Scene) -> Self {
        Frame::on(PICTURE, scene, &[])
    }

    /// The frame that holds a scene and these lines on a sheet.
    pub(super) fn on(sheet: Sheet, scene: &Scene, lines: &[[Point<f64>; 2]]) -> Self {
        let (mut low, mut high) = ([f64::MAX; 2], [f64::MIN; 2]);
        let mut hold = |point: Point<f64>, radius: f64| {
            for axis in 0..2 {
                low[axis] = low[axis].min(point[axis] - radius);
                high[axis] = high[axis].max(point[axis] + radius);
            }
        };
        hold([0.0, 0.0], 0.0);
        for piece in scene.programmed.iter().chain(&scene.path) {
            piece.extremes().into_iter().for_each(|point| hold(point, 0.0));
        }
        scene.vectors.iter().for_each(|(point, radius)| hold(*point, *radius));
        lines.iter().flatten().for_each(|point| hold(*point, 0.0));
        let size = [0, 1].map(|axis: usize| (high[axis] - low[axis]).max(1e-6));
        let scale = ((sheet.width - 2.0 * sheet.side) / size[0]).min(sheet.height.0 / size[1]);
        let height = (size[1] * scale).max(sheet.height.1);
        let middle = [0, 1].map(|axis: usize| low[axis].midpoint(high[axis]));
        let origin = [sheet.width / 2.0 - middle[0] * scale, sheet.top + height / 2.0 + middle[1] * scale];
        Frame { scale, origin, width: sheet.width, bottom: sheet.top + height + sheet.below }
    }

    /// A point of the plane in the picture.
    pub(super) fn place(&self, point: Point<f64>) -> Point<f64> {
        [self.origin[0] + point[0] * self.scale, self.origin[1] - point[1] * self.scale]
    }

    /// A length of the plane in the picture.
    pub(super) fn length(&self, length: f64) -> f64 {
        length * self.scale
    }

    /// A round length, in millimetres, that takes about a seventh of the picture's width.
    pub(super) fn round_length(&self) -> f64 {
        let wanted = self.width / 7.0 / self.scale;
        let power = 10.0_f64.powf(wanted.log10().floor());
        let steps = [5.0, 2.0, 1.0].map(|step| step * power);
        steps.into_iter().find(|step| *step <= wanted).unwrap_or(power)
    }

    /// Points along all that is drawn, in the picture; of a large drawing not all.
    pub(super) fn samples(&self, scene: &Scene) -> Vec<Point<f64>> {
        const APART: f64 = 5.0;
        const MOST: usize = 20_000;
        let mut samples = Vec::new();
        for piece in scene.path.iter().chain(&scene.programmed) {
            let count = (self.length(piece.length()) / APART).ceil().clamp(1.0, 1000.0);
            for index in 0..=count as u32 {
                if samples.len() == MOST {
                    return samples;
                }
                samples.push(self.place(piece.at(f64::from(index) / count).0));
            }
        }
        samples
    }
}
