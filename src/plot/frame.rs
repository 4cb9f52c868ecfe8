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

/// How many times as large as what follows the way from the start may be, to be in the picture.
const MOST_AROUND: f64 = 100.0;
/// Nothing is drawn larger than this makes it, in millimetres.
const LEAST_SIZE: f64 = 1e-6;

/// The rectangle around what is drawn.
struct Hull {
    low: Point<f64>,
    high: Point<f64>,
}

impl Hull {
    /// Around these lines and a scene, of whose moves the first so many are left out.
    fn of(scene: &Scene, lines: &[[Point<f64>; 2]], left_out: usize) -> Self {
        let mut hull = Hull { low: [f64::MAX; 2], high: [f64::MIN; 2] };
        for piece in scene.programmed.iter().skip(left_out).chain(scene.path.iter().skip(left_out)) {
            piece.extremes().into_iter().for_each(|point| hull.hold(point, 0.0));
        }
        scene.vectors.iter().for_each(|(point, radius)| hull.hold(*point, *radius));
        lines.iter().flatten().for_each(|point| hull.hold(*point, 0.0));
        hull
    }

    fn hold(&mut self, point: Point<f64>, radius: f64) {
        self.low = [0, 1].map(|axis| self.low[axis].min(point[axis] - radius));
        self.high = [0, 1].map(|axis| self.high[axis].max(point[axis] + radius));
    }

    /// Negative around nothing.
    fn longer_side(&self) -> f64 {
        (self.high[0] - self.low[0]).max(self.high[1] - self.low[1])
    }
}

/// A length in the unit that makes a short number of it.
fn told(millimetres: f64) -> String {
    // From which length on, in millimetres, and what one of them is.
    const UNITS: [(f64, f64, &str); 4] = [(1e6, 1e6, "km"), (1e4, 1e3, "m"), (1e-3, 1.0, "mm"), (1e-6, 1e-3, "µm")];
    let fits = |(from, _, _): &(f64, f64, &str)| millimetres > 0.999 * from;
    let (_, one, unit) = UNITS.into_iter().find(fits).unwrap_or((0.0, 1e-6, "nm"));
    let digits = format!("{:.4}", millimetres / one);
    format!("{} {unit}", digits.trim_end_matches('0').trim_end_matches('.'))
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
        let mut whole = Hull::of(scene, lines, 0);
        whole.hold([0.0, 0.0], 0.0);
        // Of a small contour far from where the program starts nothing could be seen.
        let behind = Hull::of(scene, lines, 1);
        let far = behind.longer_side() > 0.0 && whole.longer_side() > MOST_AROUND * behind.longer_side();
        let Hull { low, high } = if far { behind } else { whole };
        let size = [0, 1].map(|axis: usize| (high[axis] - low[axis]).max(LEAST_SIZE));
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

    /// A round length, in millimetres, that takes about a seventh of the picture's width; and as text.
    pub(super) fn round_length(&self) -> (f64, String) {
        let length = self.about_a_seventh();
        (length, told(length))
    }

    fn about_a_seventh(&self) -> f64 {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_told_in_a_fitting_unit() {
        let lengths = [2e8, 1e6, 5e5, 1e4, 5000.0, 1.0, 0.2, 0.001, 0.000_5, 2e-6, 1e-7];
        let texts = [
            "200 km",
            "1 km",
            "500 m",
            "10 m",
            "5000 mm",
            "1 mm",
            "0.2 mm",
            "0.001 mm",
            "0.5 µm",
            "0.002 µm",
            "0.1 nm",
        ];
        assert_eq!(lengths.map(told), texts);
    }
}
