//! The picture of a failure.

use std::fs;

use radcomp::explain::Axes;
use radcomp::plot::comparison;
use radcomp_spec::Parameters;
use radcomp_spec::parameters::{Measure, Plane};

use crate::campaigns::faulty;

#[test]
fn each_cause_has_a_picture() {
    let report = faulty();
    let axes = Axes { plane: Plane::Zx, x_words: Measure::Diameter };
    let folder = std::env::var_os("RADCOMP_PICTURES");
    let mut drawn = 0;
    for (index, cause) in report.causes.iter().enumerate() {
        let case = cause.case.as_ref().expect("the case");
        let picture = comparison(case, &Parameters::from(&report.parameters), axes, "c", &cause.cause);
        if let Some(folder) = &folder {
            fs::write(std::path::Path::new(folder).join(format!("{index}.svg")), &picture).unwrap();
        }
        assert!(picture.starts_with("<svg ") && !picture.contains("NaN") && !picture.contains("inf\""), "{picture}");
        let divergence = case.divergence.as_ref();
        if divergence.is_some_and(|divergence| divergence.expected_end.is_some()) {
            // The band under the first element that differs, in the whole and magnified, and its legend.
            assert!(picture.matches("stroke:#ffd43b").count() >= 3, "{}: {picture}", cause.cause);
            drawn += 1;
        }
    }
    assert!(drawn >= 1, "{:?}", report.causes.iter().map(|cause| &cause.cause).collect::<Vec<_>>());
}
