//! The table that is printed.

/// One line of the table.
pub struct Row {
    /// What is measured.
    pub what: &'static str,
    /// What the design asks for; empty where it asks for nothing.
    pub goal: String,
    /// What was measured.
    pub measured: String,
    /// Whether the goal is met; `None` where that was not measured.
    pub met: Option<bool>,
    /// The reference of the same run.
    pub beside: String,
    /// The two compared.
    pub ratio: String,
}

/// Prints the rows as a table in Markdown.
pub fn print(rows: &[Row]) {
    let head = ["what", "goal", "measured", "met", "beside it", "ratio"].map(String::from);
    let body = rows.iter().map(|row| {
        let met = row.met.map_or("", |met| if met { "yes" } else { "no" });
        [row.what, &row.goal, &row.measured, met, &row.beside, &row.ratio].map(String::from)
    });
    let mut lines = vec![head];
    lines.extend(body);
    let widths: [usize; 6] =
        std::array::from_fn(|column| lines.iter().map(|line| line[column].chars().count()).max().unwrap_or(0));
    lines.insert(1, widths.map(|width| "-".repeat(width)));
    println!();
    for line in lines {
        let cells: Vec<String> = line.iter().zip(widths).map(|(cell, width)| format!("{cell:width$}")).collect();
        println!("| {} |", cells.join(" | "));
    }
}

/// Nanoseconds, in the unit a person would choose.
pub fn nanoseconds(value: f64) -> String {
    match value {
        value if value < 1e3 => format!("{value:.1} ns"),
        value if value < 1e6 => format!("{:.2} µs", value / 1e3),
        value => format!("{:.2} ms", value / 1e6),
    }
}

/// How many fit in a second, of something that takes `nanoseconds`.
pub fn per_second(nanoseconds: f64) -> String {
    format!("{} a second", grouped((1e9 / nanoseconds).round()))
}

/// A ratio.
pub fn times(ratio: f64) -> String {
    if ratio < 10.0 { format!("{ratio:.2}×") } else { format!("{ratio:.0}×") }
}

/// A whole number with its thousands apart.
pub fn grouped(value: f64) -> String {
    let digits = format!("{value:.0}");
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i) % 3 == 0 {
            text.push(',');
        }
        text.push(digit);
    }
    text
}
