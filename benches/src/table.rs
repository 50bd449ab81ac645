//! Markdown tables on stdout, row by row as they are measured.

/// The head: columns of words, then columns of numbers, which are set flush right.
pub fn head(words: &[String], numbers: &[String]) {
    row(words.iter().chain(numbers));
    println!("|{}{}", "---|".repeat(words.len()), "--:|".repeat(numbers.len()));
}

/// One row.
pub fn row<'a>(cells: impl IntoIterator<Item = &'a String>) {
    let cells: Vec<&str> = cells.into_iter().map(String::as_str).collect();
    println!("| {} |", cells.join(" | "));
}

/// Milliseconds, or another positive number, with three digits.
pub fn digits(value: f64) -> String {
    let places = if value < 10.0 { 2 } else { usize::from(value < 100.0) };
    format!("{value:.places$}")
}
