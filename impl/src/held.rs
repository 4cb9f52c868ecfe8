//! The blocks without movement behind the pending element: how many they are, and which of them are rapid.
//!
//! A profile may allow any number of them ([TRC-LOOK-08]), so that only the places are kept at which the rate changes
//! from one to the next.

use radcomp_spec::parameters::MOST_NON_MOVING;

/// Blocks without movement that wait for a junction.
#[derive(Clone, Debug)]
pub(crate) struct Held {
    count: usize,
    /// The first of them is rapid.
    rapid: bool,
    /// How many of `changes` count.
    changed: u8,
    /// The places of the blocks whose rate is not that of the block before. Past the last place the rate that has been
    /// reached stays: blocks without movement have no rate of their own but the modal one, which does not change more
    /// often in a run of them, nor behind so many of them that a place has no number here.
    changes: [u16; MOST_CHANGES],
}

/// The most changes of rate that are kept; a run of bounded length has fewer.
const MOST_CHANGES: usize = 16;
const _: () = assert!((MOST_NON_MOVING as usize) <= MOST_CHANGES);

impl Held {
    /// No blocks.
    pub fn none() -> Held {
        Held { count: 0, rapid: false, changed: 0, changes: [0; MOST_CHANGES] }
    }

    /// How many there are.
    #[inline(always)]
    pub fn count(&self) -> usize {
        self.count
    }

    /// Adds a block.
    pub fn push(&mut self, rapid: bool) {
        if self.count == 0 {
            self.rapid = rapid;
        } else if rapid != self.last()
            && let Some(place) = self.changes.get_mut(usize::from(self.changed))
            && let Ok(count) = u16::try_from(self.count)
        {
            *place = count;
            self.changed += 1;
        }
        self.count = self.count.saturating_add(1);
    }

    /// The last block is rapid.
    fn last(&self) -> bool {
        self.rapid ^ (self.changed & 1 == 1)
    }

    /// Whether each of them is rapid, in order.
    pub fn rapid(&self) -> impl Iterator<Item = bool> {
        let (mut rapid, mut changes) = (self.rapid, self.changes.iter().take(usize::from(self.changed)).peekable());
        (0..self.count).map(move |place| {
            if changes.next_if(|change| usize::from(**change) == place).is_some() {
                rapid = !rapid;
            }
            rapid
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rates_come_back_in_order() {
        for pattern in 0..1_u32 << 12 {
            let rates: Vec<bool> = (0..12).map(|place| pattern >> place & 1 == 1).collect();
            let mut held = Held::none();
            rates.iter().for_each(|rapid| held.push(*rapid));
            assert_eq!((held.count(), held.rapid().collect::<Vec<_>>()), (12, rates));
        }
    }

    #[test]
    fn a_rate_that_changes_too_often_stays() {
        let mut held = Held::none();
        (0..30).for_each(|place| held.push(place % 2 == 1));
        assert_eq!(held.rapid().take(17).collect::<Vec<_>>(), (0..17).map(|place| place % 2 == 1).collect::<Vec<_>>());
        assert!(held.rapid().skip(17).all(|rapid| !rapid) && held.count() == 30);
    }
}
