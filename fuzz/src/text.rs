//! Targets over text: the G-code reader, and profile files.

use radcomp::gcode::{Tools, print, read};
use radcomp_spec::profile::{BUILTIN, Profile};

/// The tools that programs of the target may call.
const TOOLS: &str = "[[tool]]\nnumber = 1\nradius = \"5\"\n\n[[tool]]\nnumber = 2\nradius = \"0.8\"\n";

/// The reader takes any bytes: it answers a program or a fault with its place, and never panics. What it reads, the
/// printer writes so that it is read again. The first byte names the profile.
pub fn reader(bytes: &[u8]) {
    let Some((&first, text)) = bytes.split_first() else { return };
    let (name, _) = BUILTIN[usize::from(first) % BUILTIN.len()];
    let profile = Profile::builtin(name).expect("built in");
    let tools = Tools::parse(TOOLS, "tools.toml").expect("sound");
    match read("fuzz.nc", text, &profile, &tools) {
        // Its message is written too: it points into the bytes.
        Err(fault) => assert!(!format!("{fault}").is_empty()),
        Ok(program) => {
            if let Ok(listing) = print(&program, &profile) {
                let again = read("fuzz.nc", listing.program.as_bytes(), &profile, &listing.tools);
                let again = again.unwrap_or_else(|fault| panic!("{fault}\n{}", listing.program));
                assert_eq!(again.blocks.len(), program.blocks.len(), "{}", listing.program);
            }
        }
    }
}

/// A profile file of any bytes is read or refused with a message, and what is read can be run.
pub fn profile_file(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    match Profile::parse(text, "fuzz.toml") {
        Err(error) => assert!(!format!("{error}").is_empty()),
        Ok(profile) => {
            for number in 0..3 {
                let blocks = radcomp::generate::program(1, number, radcomp::generate::Reach::of(&profile));
                let _ = radcomp_model::run(&profile.parameters, &blocks);
            }
        }
    }
}
