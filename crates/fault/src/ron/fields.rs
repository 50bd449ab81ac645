//! A struct's fields, each asked for by name, the rest reported.

use super::node::{Field, Node};
use super::read::FromRon;
use crate::{Fault, Faults, suggest};

/// Reads the fields of one struct. What was never asked for is unknown, which [`Fields::finish`] reports.
#[derive(Debug)]
pub struct Fields<'a> {
    node: Node<'a>,
    fields: Vec<Field<'a>>,
    asked: Vec<String>,
}

impl<'a> Fields<'a> {
    /// The fields of `node`.
    ///
    /// # Errors
    /// It is no struct.
    pub fn of(node: Node<'a>) -> Result<Fields<'a>, Fault> {
        Ok(Fields { node, fields: node.fields()?, asked: Vec::new() })
    }

    /// The struct itself.
    pub fn whole(&self) -> Node<'a> {
        self.node
    }

    /// The value of the field `name`, if it is given.
    pub fn node(&mut self, name: &str) -> Option<Node<'a>> {
        if !self.asked.iter().any(|asked| asked == name) {
            self.asked.push(name.to_owned());
        }
        self.fields.iter().find(|field| field.name == name).map(|field| field.value)
    }

    /// The value of the field `name`; a fault if it is not given.
    pub fn required_node(&mut self, name: &str, faults: &mut Faults) -> Option<Node<'a>> {
        let node = self.node(name);
        if node.is_none() {
            let of = self.node.name().map(|of| format!(" of `{of}`")).unwrap_or_default();
            faults.push(self.node.fault(format!("missing field `{name}`{of}"), "needed here"));
        }
        node
    }

    /// Reads the field `name`; a fault, and `None`, if it is not given or not a `T`.
    pub fn required<T: FromRon>(&mut self, name: &str, faults: &mut Faults) -> Option<T> {
        let node = self.required_node(name, faults)?;
        faults.gather(node.get())
    }

    /// Reads the field `name`; `None` if it is not given, and with a fault if it is not a `T`.
    pub fn optional<T: FromRon>(&mut self, name: &str, faults: &mut Faults) -> Option<T> {
        let node = self.node(name)?;
        faults.gather(node.get())
    }

    /// Reads the field `name`, `default` if it is not given; also, with a fault, if it is not a `T`.
    pub fn or<T: FromRon>(&mut self, name: &str, default: T, faults: &mut Faults) -> T {
        self.optional(name, faults).unwrap_or(default)
    }

    /// Reports the fields that nobody asked for and those given twice.
    pub fn finish(self, faults: &mut Faults) {
        for (i, Field { name, span, .. }) in self.fields.iter().enumerate() {
            let place = |message: String, label: String| {
                Fault::new(message).at(self.node.source(), span.clone(), label)
            };
            if !self.asked.iter().any(|asked| asked == name) {
                let label = suggest(name, self.asked.iter().map(String::as_str));
                faults.push(place(format!("unknown field `{name}`"), label));
            } else if self.fields[..i].iter().any(|earlier| earlier.name == *name) {
                faults.push(place(format!("field `{name}` given twice"), "the second".into()));
            }
        }
    }
}
