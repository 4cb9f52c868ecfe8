//! The radcomp toolkit: programs in, verdicts out.

pub mod book;
pub mod boundary;
pub mod canon;
pub mod certificate;
pub mod certify;
pub mod device;
pub mod edited;
pub mod evidence;
pub mod explain;
pub mod gcode;
pub mod generate;
pub mod judge;
pub mod metamorphic;
pub mod minimise;
pub mod plot;
pub mod report;
pub mod safety;
pub mod tip;
pub mod vectors;
pub mod verify;
pub mod workbench;
