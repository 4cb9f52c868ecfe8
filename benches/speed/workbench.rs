//! What the workbench takes for a program: reading, the exact model, the safety verdict, and the answer as JSON.

use std::time::Duration;

use radcomp::workbench::{Asked, Patience, run};

use crate::contour::{Contour, TOOL_RADIUS};

/// The request for a program of so many blocks round a contour, start-up and cancel among them.
pub fn request(contour: &Contour, blocks: usize) -> Asked {
    // The interpreter's words for a tool of a given diameter are those of offset 1 here.
    let program = contour.g_code(blocks - 4).replace(&format!("g41.1 d{}", 2.0 * TOOL_RADIUS), "g41 d1");
    Asked {
        program,
        profile: "seed-mill".to_owned(),
        offset: 1,
        radius: TOOL_RADIUS.to_string(),
        safety: true,
        ..Asked::default()
    }
}

/// The answer.
pub fn answer(request: &Asked) -> String {
    let patience = Patience::new(Duration::from_secs(3600), Default::default());
    run(request, &patience).expect("a program that is answered")
}
