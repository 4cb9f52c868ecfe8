//! How small the programs are that a report tells causes by: of ten, nine have at most six blocks and two decimals.

use radcomp::certify::Outcome;
use radcomp::report::BlockRecord;

/// The most blocks of a program that one would have written by hand.
const MOST_BLOCKS: usize = 6;
/// The most decimals of its numbers.
const MOST_DECIMALS: usize = 2;

/// The causes that were told, and those among them whose program is larger.
#[derive(Default)]
pub struct Sizes {
    causes: usize,
    larger: Vec<String>,
}

impl Sizes {
    /// Adds the causes of a campaign; `device` says of which.
    pub fn add(&mut self, device: &str, outcome: &Outcome) {
        for (cause, _, smallest) in &outcome.groups {
            self.causes += 1;
            let decimals = smallest.blocks.iter().map(|block| decimals(&BlockRecord::from(block))).max().unwrap_or(0);
            let blocks = smallest.blocks.len();
            if blocks > MOST_BLOCKS || decimals > MOST_DECIMALS {
                self.larger.push(format!("{device}, {cause}: {blocks} blocks, {decimals} decimals"));
            }
        }
    }

    /// Nine in ten are as small as that.
    #[track_caller]
    pub fn are_small(&self) {
        let told = format!("{} of {} are larger\n{}", self.larger.len(), self.causes, self.larger.join("\n"));
        println!("{told}");
        assert!(self.causes > 0 && 10 * self.larger.len() <= self.causes, "{told}");
    }
}

/// The most decimals of a block's numbers, as a report writes them.
fn decimals(block: &BlockRecord) -> usize {
    let text = serde_json::to_string(block).expect("a block is JSON");
    let numbers = text.split('"').filter(|word| word.starts_with(|c: char| c == '-' || c.is_ascii_digit()));
    numbers.map(|word| word.split_once('.').map_or(0, |(_, digits)| digits.len())).max().unwrap_or(0)
}
