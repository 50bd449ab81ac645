//! Aligned columns of plain text.

/// A line for each of the rows: its cells aligned, those from column `numbers` on flush right, then its note.
pub(crate) fn align(rows: &[(Vec<String>, String)], numbers: usize) -> String {
    let columns = rows.iter().map(|(cells, _)| cells.len()).max().unwrap_or(0);
    let width = |column: usize| {
        rows.iter()
            .filter_map(|(cells, _)| cells.get(column))
            .map(|cell| cell.chars().count())
            .max()
            .unwrap_or(0)
    };
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let line = |(cells, note): &(Vec<String>, String)| {
        let cells = cells.iter().zip(&widths).enumerate().map(|(column, (cell, &width))| {
            if column >= numbers { format!("{cell:>width$}") } else { format!("{cell:<width$}") }
        });
        let line = cells.collect::<Vec<_>>().join("  ") + "  " + note;
        line.trim_end().to_owned() + "\n"
    };
    rows.iter().map(line).collect()
}
