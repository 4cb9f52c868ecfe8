//! Fuzz targets over the toolkit's generators and judge. A target is a function of bytes that panics when it finds a
//! fault. Under `cargo fuzz` libFuzzer calls it; otherwise the same file is an ordinary program that runs it over files
//! and over seeded inputs ([`ordinary`]), and stable builds it.

pub mod kernels;
pub mod ledger;
pub mod ordinary;
pub mod programs;
pub mod protocol;
pub mod text;

/// Makes a target of a function of bytes.
#[macro_export]
macro_rules! target {
    ($target:path) => {
        #[cfg(fuzzing)]
        libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
            $crate::ledger::ran();
            $target(bytes);
        });

        #[cfg(not(fuzzing))]
        fn main() -> std::process::ExitCode {
            $crate::ordinary::main($target)
        }
    };
}
