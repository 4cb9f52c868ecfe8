//! Fuzz targets over the toolkit's generators and judge. A target is a function of bytes that panics when it finds a
//! fault. Under `cargo fuzz` libFuzzer calls it; otherwise the same file is an ordinary program that runs it over files
//! and over seeded inputs ([`ordinary`]), and stable builds it.

#[cfg(fuzzing)]
pub mod heap;
pub mod kernels;
pub mod ledger;
pub mod ordinary;
pub mod programs;
pub mod protocol;
pub mod text;

/// Makes a target of a function of bytes. With `heap: own` the fuzzer's sanitizer does not watch its heap ([`heap`]).
#[macro_export]
macro_rules! target {
    ($target:path, heap: own) => {
        #[cfg(fuzzing)]
        #[global_allocator]
        static HEAP: mimalloc::MiMalloc = mimalloc::MiMalloc;

        #[cfg(fuzzing)]
        libfuzzer_sys::fuzz_target!(
            // SAFETY: the fuzzer calls this before anything else.
            init: unsafe { $crate::heap::give_to_gmp() },
            |bytes: &[u8]| {
                $crate::ledger::ran();
                $target(bytes);
            }
        );

        #[cfg(not(fuzzing))]
        fn main() -> std::process::ExitCode {
            $crate::ordinary::main($target)
        }
    };
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
