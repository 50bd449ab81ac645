//! Seeded damage to files.

use crate::Random;

/// What breaks readers: numbers at and past the ends of their ranges, brackets, words of the formats.
const TOKENS: [&str; 36] = [
    "0",
    "-1",
    "1e999",
    "-1e-999",
    "1e38",
    "340282350000000000000000000000000000000",
    "NaN",
    "inf",
    "-inf",
    "4294967295",
    "4294967296",
    "18446744073709551616",
    "2147483648",
    "0.0",
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ",",
    ":",
    "\"",
    "'",
    "\\",
    "/*",
    "*/",
    "//",
    "r#\"",
    "Some(",
    "None",
    "true",
    "\u{0}",
    "é",
    "\u{feff}",
    "#![enable(implicit_some)]",
];

/// A text damaged in one to four places.
pub fn mutated_text(text: &str, random: &mut Random) -> String {
    let mut text = text.to_owned();
    for _ in 0..1 + random.below(4) {
        let (from, to) = range(&text, random);
        match random.below(6) {
            0 => text.replace_range(from..to, ""),
            1 => {
                let part = text[from..to].to_owned();
                text.insert_str(to, &part);
            }
            2 => text.truncate(from),
            3 => text.insert_str(from, TOKENS[random.below(TOKENS.len())]),
            4 => {
                let part = text[from..to].to_owned();
                text.replace_range(from..to, "");
                let at = boundary(&text, random.below(text.len() + 1));
                text.insert_str(at, &part);
            }
            _ => replace_number(&mut text, from, random),
        }
    }
    text
}

/// The first number after `from`, if there is one, becomes another token.
fn replace_number(text: &mut String, from: usize, random: &mut Random) {
    let Some(start) = text[from..].find(|c: char| c.is_ascii_digit()).map(|at| from + at) else { return };
    let length =
        text[start..].find(|c: char| !(c.is_ascii_digit() || c == '.')).unwrap_or(text.len() - start);
    text.replace_range(start..start + length, TOKENS[random.below(TOKENS.len())]);
}

fn range(text: &str, random: &mut Random) -> (usize, usize) {
    let from = boundary(text, random.below(text.len() + 1));
    let to = boundary(text, (from + random.below(40)).min(text.len()));
    (from, to)
}

fn boundary(text: &str, mut at: usize) -> usize {
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// Bytes damaged in one to four places: bits flipped, words of 32 bits at the ends of their range, cut short.
pub fn mutated_bytes(bytes: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    for _ in 0..1 + random.below(4) {
        let at = random.below(bytes.len().max(1));
        match random.below(8) {
            0 => bytes.truncate(at),
            1..4 => {
                let word =
                    [0u32, 1, 0x7fff_ffff, 0x8000_0000, u32::MAX, 0x7fc0_0000, 0x7f80_0000][random.below(7)];
                let at = at & !3;
                if let Some(place) = bytes.get_mut(at..at + 4) {
                    place.copy_from_slice(&word.to_le_bytes());
                }
            }
            _ => {
                if let Some(byte) = bytes.get_mut(at) {
                    *byte ^= 1 << random.below(8);
                }
            }
        }
    }
    bytes
}
