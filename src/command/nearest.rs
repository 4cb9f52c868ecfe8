//! Names near to one that does not exist.

/// The names at most this many edits away are offered.
const MOST_EDITS: usize = 3;

/// The names that are likely to be meant, the likeliest first, at most three.
pub fn nearest<'n>(wanted: &str, names: impl IntoIterator<Item = &'n str>) -> Vec<&'n str> {
    let wanted = wanted.to_lowercase();
    let mut near: Vec<(usize, &str)> = names
        .into_iter()
        .filter_map(|name| {
            let lower = name.to_lowercase();
            let part = wanted.len() >= 3 && lower.contains(&wanted);
            let edits = if part { 0 } else { edits(&wanted, &lower) };
            // A name of three letters is not near to every other one.
            (edits <= MOST_EDITS.min(wanted.chars().count() / 2)).then_some((edits, name))
        })
        .collect();
    near.sort();
    near.into_iter().map(|(_, name)| name).take(3).collect()
}

/// `did you mean a, b?`, or nothing.
pub fn suggestion<'n>(wanted: &str, names: impl IntoIterator<Item = &'n str>) -> String {
    let near = nearest(wanted, names);
    if near.is_empty() { String::new() } else { format!("; did you mean {}?", near.join(", ")) }
}

/// Insertions, deletions and replacements of characters from one word to the other.
fn edits(from: &str, to: &str) -> usize {
    let to: Vec<char> = to.chars().collect();
    let mut row: Vec<usize> = (0..=to.len()).collect();
    for (i, a) in from.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, b) in to.iter().enumerate() {
            let replaced = diagonal + usize::from(a != *b);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[to.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_names_come_in_order_of_their_distance() {
        let names = ["mori-lathe", "seed-mill", "yasnac-lx"];
        assert_eq!(nearest("sed-mil", names), ["seed-mill"]);
        assert_eq!(nearest("lathe", names), ["mori-lathe"]);
        assert_eq!(nearest("fanuc", names), [""; 0]);
        assert_eq!(edits("kitten", "sitting"), 3);
    }
}
