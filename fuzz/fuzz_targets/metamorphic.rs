//! Relations between moved programs.

#![cfg_attr(fuzzing, no_main)]

radcomp_fuzz::target!(radcomp_fuzz::programs::metamorphic, heap: own);
