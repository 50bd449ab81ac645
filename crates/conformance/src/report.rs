//! What the suite found.

use std::fmt;

use voxlume::{Encoding, Miss, Property, StorageFormat};

/// One figure and what it may be at most.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// The property.
    pub property: Property,
    /// Where: a level, a content.
    pub at: String,
    /// The size of the miss; 0 is perfect.
    pub figure: f64,
    /// What rounding explains.
    pub bound: f64,
}

/// All figures of a format in an encoding.
#[derive(Clone, Debug)]
pub struct Report {
    /// Name of the format.
    pub format: String,
    /// The encoding.
    pub encoding: Encoding,
    /// Every figure.
    pub checks: Vec<Check>,
    misses: Vec<Miss>,
}

impl Report {
    pub(crate) fn new(format: &dyn StorageFormat, encoding: Encoding) -> Report {
        let misses = format.misses().to_vec();
        Report { format: format.name().to_owned(), encoding, checks: Vec::new(), misses }
    }

    pub(crate) fn extend(&mut self, checks: impl IntoIterator<Item = Check>) {
        self.checks.extend(checks);
    }

    /// The first that covers a check.
    fn declared(&self, check: &Check) -> Option<&Miss> {
        self.misses.iter().find(|miss| miss.property == check.property && check.at.starts_with(miss.at))
    }

    /// What a figure may be at most: what rounding explains, and what the format declares.
    pub fn limit(&self, check: &Check) -> f64 {
        check.bound + self.declared(check).map_or(0.0, |miss| miss.size)
    }

    /// The checks that fail. A figure that is no number does.
    pub fn failures(&self) -> impl Iterator<Item = &Check> {
        self.checks.iter().filter(|check| check.figure.is_nan() || check.figure > self.limit(check))
    }

    /// Declared misses that no figure comes within a tenth of, as far as rounding can tell.
    pub fn idle(&self) -> impl Iterator<Item = &Miss> {
        self.misses.iter().filter(|miss| {
            let of = self.checks.iter().filter(|check| self.declared(check) == Some(miss));
            of.map(|check| check.figure + check.bound)
                .reduce(f64::max)
                .is_some_and(|most| most < 0.9 * miss.size)
        })
    }

    /// Whether every figure is within its bound, and every declared miss is there.
    pub fn passes(&self) -> bool {
        self.failures().next().is_none() && self.idle().next().is_none()
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{} {}", self.format, self.encoding.name)?;
        for check in &self.checks {
            let limit = self.limit(check);
            let verdict = if check.figure <= limit { "" } else { "  FAILS" };
            let name = check.property.name();
            writeln!(f, "  {name:<11} {:<34} {:9.2e} of {limit:9.2e}{verdict}", check.at, check.figure)?;
        }
        for miss in &self.misses {
            writeln!(
                f,
                "  declared: {} misses by {} {}: {}",
                miss.property.name(),
                miss.size,
                miss.at,
                miss.why
            )?;
        }
        for miss in self.idle() {
            writeln!(
                f,
                "  {} is declared to miss by {} and doesn't  FAILS",
                miss.property.name(),
                miss.size
            )?;
        }
        Ok(())
    }
}
