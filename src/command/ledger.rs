//! The places of the blocks that are not settled yet.

use std::collections::VecDeque;

use super::program::Placed;

/// Blocks by their index, in the memory of those that the engine holds.
#[derive(Debug, Default)]
pub struct Ledger {
    first: usize,
    blocks: VecDeque<Placed>,
}

impl Ledger {
    /// The next block.
    pub fn add(&mut self, block: Placed) {
        self.blocks.push_back(block);
    }

    /// How many blocks have been added.
    pub fn count(&self) -> usize {
        self.first + self.blocks.len()
    }

    /// A block that has not been forgotten.
    pub fn block(&self, index: usize) -> Option<&Placed> {
        self.blocks.get(index.checked_sub(self.first)?)
    }

    /// Forgets the blocks before this one: path elements come in the order of blocks.
    pub fn forget_before(&mut self, index: usize) {
        while self.first < index && self.blocks.pop_front().is_some() {
            self.first += 1;
        }
    }
}
