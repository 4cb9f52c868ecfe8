//! A device of the user's own, named by RADCOMP_DEVICE.

#![cfg_attr(fuzzing, no_main)]

radcomp_fuzz::target!(radcomp_fuzz::protocol::external);
