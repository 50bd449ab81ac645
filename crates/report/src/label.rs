//! Places for labels beside marks.

/// Labels that overlap neither marks nor each other.
pub(crate) struct Labels {
    /// Left, top, right, bottom.
    inside: [f64; 4],
    taken: Vec<[f64; 4]>,
}

/// Half a mark's side, with some room.
const MARK: f64 = 6.0;
/// Of a letter in the plot's type, at most.
const LETTER: f64 = 6.8;
const HEIGHT: f64 = 12.0;

impl Labels {
    /// For marks around these places, of which labels keep clear.
    pub(crate) fn among(marks: &[(f64, f64)], inside: [f64; 4]) -> Labels {
        let mark = |(x, y): &(f64, f64)| [x - MARK, y - MARK, x + MARK, y + MARK];
        Labels { inside, taken: marks.iter().map(mark).collect() }
    }

    /// Where the text of a mark begins, on its base line; nothing where there is no room.
    pub(crate) fn place(&mut self, (x, y): (f64, f64), text: &str) -> Option<(f64, f64)> {
        let width = LETTER * text.chars().count() as f64;
        let (right, left) = (x + MARK + 2.0, x - MARK - 2.0 - width);
        let (above, level, below) = (y - MARK - 2.0, y + 4.0, y + MARK + HEIGHT);
        let middle = x - 0.5 * width;
        let tried = [
            (right, level),
            (right, above),
            (right, below),
            (left, level),
            (left, above),
            (left, below),
            (middle, above),
            (middle, below),
        ];
        let spot = |(x, y): (f64, f64)| [x, y - HEIGHT + 2.0, x + width, y + 2.0];
        let is_free = |place: &(f64, f64)| {
            let [l, t, r, b] = spot(*place);
            let [low, top, high, bottom] = self.inside;
            let overlaps = |other: &[f64; 4]| l < other[2] && r > other[0] && t < other[3] && b > other[1];
            l >= low && t >= top && r <= high && b <= bottom && !self.taken.iter().any(overlaps)
        };
        let place = tried.into_iter().find(is_free)?;
        self.taken.push(spot(place));
        Some(place)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_keep_clear_of_marks_and_of_each_other() {
        let marks: Vec<(f64, f64)> =
            (0..40).map(|i| (60.0 + f64::from(i * 37 % 400), 20.0 + f64::from(i * 61 % 280))).collect();
        let mut labels = Labels::among(&marks, [58.0, 14.0, 458.0, 294.0]);
        let placed = marks.iter().filter(|mark| labels.place(**mark, "128 1/2").is_some()).count();
        assert!(placed > 20, "{placed}");
        for (i, a) in labels.taken.iter().enumerate() {
            // Marks may overlap; a label overlaps nothing.
            for b in &labels.taken[..i.min(labels.taken.len())] {
                let both_marks = a[2] - a[0] == 2.0 * MARK && b[2] - b[0] == 2.0 * MARK;
                let apart = a[0] >= b[2] || a[2] <= b[0] || a[1] >= b[3] || a[3] <= b[1];
                assert!(both_marks || apart, "{a:?} {b:?}");
            }
        }
    }

    #[test]
    fn no_room_is_no_label() {
        assert_eq!(Labels::among(&[(5.0, 5.0)], [0.0, 0.0, 10.0, 10.0]).place((5.0, 5.0), "long"), None);
    }
}
