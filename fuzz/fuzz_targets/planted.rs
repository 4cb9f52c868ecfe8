//! A planted fault, which must be found.

#![cfg_attr(fuzzing, no_main)]

radcomp_fuzz::target!(radcomp_fuzz::programs::planted, heap: own);
