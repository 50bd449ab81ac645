//! Aligned columns of plain text.

use std::fmt;

/// Rows under a head; every row has as many cells.
#[derive(Debug)]
pub struct Table<const N: usize> {
    rows: Vec<[String; N]>,
    numbers: usize,
}

impl<const N: usize> Table<N> {
    /// A table of words, with this head.
    pub fn new(head: [&str; N]) -> Table<N> {
        Table { rows: vec![head.map(str::to_owned)], numbers: N }
    }

    /// The columns from `first` on are set flush right.
    #[must_use]
    pub fn numbers_from(mut self, first: usize) -> Table<N> {
        self.numbers = first;
        self
    }

    /// Adds a row.
    pub fn row(&mut self, cells: [String; N]) {
        self.rows.push(cells);
    }
}

impl<const N: usize> fmt::Display for Table<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let width =
            |column: usize| self.rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
        let widths: [usize; N] = std::array::from_fn(width);
        for row in &self.rows {
            let cells = row.iter().zip(widths).enumerate().map(|(column, (cell, width))| {
                if column >= self.numbers { format!("{cell:>width$}") } else { format!("{cell:<width$}") }
            });
            writeln!(f, "{}", cells.collect::<Vec<_>>().join("  ").trim_end())?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_align() {
        let mut table = Table::new(["pass", "median"]).numbers_from(1);
        table.row(["voxelize".into(), "1.5 ms".into()]);
        table.row(["a".into(), "10.25 ms".into()]);
        assert_eq!(table.to_string(), "pass        median\nvoxelize    1.5 ms\na         10.25 ms\n");
    }
}
