//! Values read from nodes.

use serde::de::DeserializeOwned;

use super::Node;
use crate::{Fault, Faults};

/// A type that is read from RON.
pub trait FromRon: Sized {
    /// Reads the value.
    ///
    /// # Errors
    /// Every fault in it, placed.
    fn from_ron(node: Node<'_>) -> Result<Self, Faults>;
}

fn leaf<T: DeserializeOwned>(node: Node<'_>, expected: &str) -> Result<T, Fault> {
    node.deserialize().map_err(|_| node.expected(expected))
}

/// Numbers are finite: RON's `NaN` and `inf` are faults, and so is what overflows.
impl FromRon for f64 {
    fn from_ron(node: Node<'_>) -> Result<Self, Faults> {
        let number: f64 = leaf(node, "a number")?;
        if number.is_finite() { Ok(number) } else { Err(node.expected("a finite number").into()) }
    }
}

/// As `f64`, and within the range of `f32`.
impl FromRon for f32 {
    fn from_ron(node: Node<'_>) -> Result<Self, Faults> {
        let number = f64::from_ron(node)? as f32;
        if number.is_finite() { Ok(number) } else { Err(node.expected("a number within ±3.4e38").into()) }
    }
}

macro_rules! integers {
    ($($type:ty)*) => { $(
        impl FromRon for $type {
            fn from_ron(node: Node<'_>) -> Result<Self, Faults> {
                let expected = format!("a whole number from {} to {}", <$type>::MIN, <$type>::MAX);
                Ok(leaf(node, &expected)?)
            }
        }
    )* };
}
integers!(u8 u32 i32 u64 i64 usize);

impl FromRon for bool {
    fn from_ron(node: Node<'_>) -> Result<Self, Faults> {
        Ok(leaf(node, "`true` or `false`")?)
    }
}

impl FromRon for String {
    fn from_ron(node: Node<'_>) -> Result<Self, Faults> {
        Ok(leaf(node, "a string")?)
    }
}

impl<T: FromRon> FromRon for Vec<T> {
    fn from_ron(node: Node<'_>) -> Result<Self, Faults> {
        let mut faults = Faults::default();
        let items = node.items()?;
        let values = items.iter().filter_map(|item| faults.gather(item.get())).collect();
        faults.into_result(values)
    }
}

/// `N` items, as a tuple `(1, 2, 3)` or a list.
impl<T: FromRon, const N: usize> FromRon for [T; N] {
    fn from_ron(node: Node<'_>) -> Result<Self, Faults> {
        let wrong = |found: String| node.fault(format!("expected {N} values, found {found}"), "");
        let items = node.items().map_err(|_| node.expected(&format!("{N} values `(...)`")))?;
        if items.len() != N {
            return Err(wrong(items.len().to_string()).into());
        }
        let values = Vec::<T>::from_ron(node)?;
        values.try_into().map_err(|values: Vec<T>| wrong(values.len().to_string()).into())
    }
}
