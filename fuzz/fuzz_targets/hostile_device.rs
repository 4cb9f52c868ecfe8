//! Lines that a hostile device writes.

#![cfg_attr(fuzzing, no_main)]

radcomp_fuzz::target!(radcomp_fuzz::protocol::hostile_device);
