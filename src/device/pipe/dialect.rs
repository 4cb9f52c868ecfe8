//! What a device is asked in, and what it answers in.

use radcomp_spec::profile::Profile;
use radcomp_spec::{Block, Parameters};
use rug::Rational;

use crate::device::DeviceFault;
use crate::device::wire::{ProfileRecord, Reply, ReplyError, request};

/// A language of lines.
pub(crate) trait Dialect {
    /// The parameters of the questions that follow. Those before are forgotten.
    fn begin(&mut self, parameters: &Parameters);

    /// The lines that ask for a program's path.
    ///
    /// # Errors
    ///
    /// [`DeviceFault::Unsupported`] for a program that cannot be asked.
    fn question(&mut self, id: &str, blocks: &[Block<Rational>]) -> Result<String, DeviceFault>;

    /// Takes a line of the device's; the answer that it completes, if it does.
    ///
    /// # Errors
    ///
    /// A line that cannot be part of an answer.
    fn read(&mut self, line: &[u8]) -> Result<Option<Reply>, ReplyError>;

    /// The process is a new one: an answer that was begun will not be completed.
    fn restart(&mut self);
}

/// The pipe protocol.
pub(super) struct JsonLines {
    control: Profile,
    record: ProfileRecord,
}

impl JsonLines {
    pub(super) fn new(control: &Profile) -> Self {
        JsonLines { control: control.clone(), record: ProfileRecord::new(control, &control.parameters) }
    }
}

impl Dialect for JsonLines {
    fn begin(&mut self, parameters: &Parameters) {
        self.record = ProfileRecord::new(&self.control, parameters);
    }

    fn question(&mut self, id: &str, blocks: &[Block<Rational>]) -> Result<String, DeviceFault> {
        request(id, &self.control, &self.record, blocks)
    }

    fn read(&mut self, line: &[u8]) -> Result<Option<Reply>, ReplyError> {
        Reply::read(line).map(Some)
    }

    fn restart(&mut self) {}
}
