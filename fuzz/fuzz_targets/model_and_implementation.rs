//! The model against the implementation.

#![cfg_attr(fuzzing, no_main)]

radcomp_fuzz::target!(radcomp_fuzz::programs::model_and_implementation, heap: own);
