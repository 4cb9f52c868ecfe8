//! Why programs are unsupported, by how many.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// The most reasons that are told apart.
pub const MOST_REASONS: usize = 64;
/// The most characters of a reason.
const MOST_CHARACTERS: usize = 200;

/// Reasons in a device's words, each with its programs. Of more than [`MOST_REASONS`] the first by alphabet are told and
/// the others are counted together, so that the parts of a campaign add up to the whole in any order.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Reasons {
    /// Programs by reason.
    pub told: BTreeMap<String, u64>,
    /// Programs with other reasons.
    pub others: u64,
}

impl Reasons {
    /// Counts a program.
    pub fn add(&mut self, reason: &str) {
        self.count(reason.chars().take(MOST_CHARACTERS).collect(), 1);
    }

    /// Adds the counts of another part.
    pub fn merge(&mut self, other: Reasons) {
        self.others += other.others;
        other.told.into_iter().for_each(|(reason, programs)| self.count(reason, programs));
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.told.is_empty() && self.others == 0
    }

    /// The reasons, most frequent first.
    pub fn by_frequency(&self) -> Vec<(&str, u64)> {
        let mut list: Vec<_> = self.told.iter().map(|(reason, programs)| (&reason[..], *programs)).collect();
        list.sort_by(|x, y| y.1.cmp(&x.1).then_with(|| x.0.cmp(y.0)));
        list
    }

    fn count(&mut self, reason: String, programs: u64) {
        *self.told.entry(reason).or_default() += programs;
        if self.told.len() > MOST_REASONS
            && let Some((_, last)) = self.told.pop_last()
        {
            self.others += last;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_add_up_in_any_order() {
        let of = |numbers: &mut dyn Iterator<Item = u64>| {
            let mut reasons = Reasons::default();
            numbers.for_each(|number| reasons.add(&format!("reason {}", number * 37 % 100)));
            reasons
        };
        let whole = of(&mut (0..1000));
        assert_eq!((whole.told.len(), whole.others), (MOST_REASONS, 360));
        let (even, odd) = (of(&mut (0..1000).step_by(2)), of(&mut (1..1000).step_by(2)));
        let sum = |mut first: Reasons, second: &Reasons| {
            first.merge(second.clone());
            first
        };
        assert_eq!(sum(even.clone(), &odd), whole);
        assert_eq!(sum(odd, &even), whole);
    }
}
