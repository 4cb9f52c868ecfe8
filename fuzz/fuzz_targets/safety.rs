//! The safety verdict against the judge.

#![cfg_attr(fuzzing, no_main)]

radcomp_fuzz::target!(radcomp_fuzz::programs::safety, heap: own);
