//! Accessors: typed views of buffers, with sparse parts filled in.

use std::borrow::Cow;

use gltf::json::accessor::{Accessor, ComponentType, Type, sparse::Sparse};
use gltf::json::validation::Checked;
use gltf::json::{Index, Root};
use voxlume_fault::Fault;

use super::{at, source};

/// Reads accessors of one file.
#[derive(Clone, Copy)]
pub(super) struct Accessors<'a> {
    pub(super) root: &'a Root,
    pub(super) buffers: &'a [Cow<'a, [u8]>],
}

/// Items of an accessor, each of `size` bytes, `stride` apart.
struct Items<'a> {
    bytes: &'a [u8],
    stride: usize,
    size: usize,
}

impl<'a> Items<'a> {
    fn iter(&self) -> impl Iterator<Item = &'a [u8]> {
        let (bytes, size) = (self.bytes, self.size);
        (0..bytes.len()).step_by(self.stride).map_while(move |start| bytes.get(start..start + size))
    }
}

impl<'a> Accessors<'a> {
    /// How many items the accessor has.
    pub(super) fn count(&self, index: Index<Accessor>) -> u64 {
        self.root.accessors.get(index.value()).map_or(0, |accessor| accessor.count.0)
    }

    /// Vectors of `N` floats; integers are normalised if the accessor says so.
    pub(super) fn vectors<const N: usize>(&self, index: Index<Accessor>) -> Result<Vec<[f32; N]>, Fault> {
        let accessor = self.get(index)?;
        let (kind, component) = types(accessor, index)?;
        if kind.multiplicity() != N || !matches!(kind, Type::Vec2 | Type::Vec3 | Type::Vec4) {
            return Err(here(index, format!("VEC{N} is needed, it is {}", kind_name(kind))));
        }
        if component == ComponentType::U32 {
            return Err(here(index, "floats are needed, it has 32-bit integers"));
        }
        let size = component.size() * N;
        let decode = |item: &[u8]| {
            let mut parts = item.chunks_exact(component.size());
            std::array::from_fn(|_| {
                parts.next().map_or(0.0, |part| float(part, component, accessor.normalized))
            })
        };
        self.items(index, accessor, size, [0.0; N], decode)
    }

    /// Indices of vertices.
    pub(super) fn indices(&self, index: Index<Accessor>) -> Result<Vec<u32>, Fault> {
        let accessor = self.get(index)?;
        let (kind, component) = types(accessor, index)?;
        if kind != Type::Scalar
            || !matches!(component, ComponentType::U8 | ComponentType::U16 | ComponentType::U32)
        {
            return Err(here(index, "indices must be unsigned integers, SCALAR"));
        }
        self.items(index, accessor, component.size(), 0, unsigned)
    }

    fn get(&self, index: Index<Accessor>) -> Result<&'a Accessor, Fault> {
        self.root.accessors.get(index.value()).ok_or_else(|| here(index, "there is no such accessor"))
    }

    /// The caller has checked that `count` items fit in memory.
    fn items<T: Copy>(
        &self,
        index: Index<Accessor>,
        accessor: &Accessor,
        size: usize,
        zero: T,
        decode: impl Fn(&[u8]) -> T,
    ) -> Result<Vec<T>, Fault> {
        let count = accessor.count.0 as usize;
        let mut values = match accessor.buffer_view {
            None => vec![zero; count],
            Some(view) => {
                let offset = accessor.byte_offset.unwrap_or_default().0;
                self.slice(index, view, offset, count, size)?.iter().map(&decode).collect()
            }
        };
        if let Some(Sparse { count, indices, values: part, .. }) = &accessor.sparse {
            let count = count.0 as usize;
            let Checked::Valid(component) = &indices.component_type else {
                return Err(here(index, "its sparse indices have no valid type"));
            };
            let width = match component.0 {
                ComponentType::U8 => 1,
                ComponentType::U16 => 2,
                _ => 4,
            };
            let at = self.slice(index, indices.buffer_view, indices.byte_offset.0, count, width)?;
            let part = self.slice(index, part.buffer_view, part.byte_offset.0, count, size)?;
            for (at, item) in at.iter().zip(part.iter()) {
                let (at, len) = (unsigned(at), values.len());
                let value = values.get_mut(at as usize).ok_or_else(|| {
                    here(index, format!("sparse index {at} is out of range: there are {len} items"))
                })?;
                *value = decode(item);
            }
        }
        Ok(values)
    }

    fn slice(
        &self,
        index: Index<Accessor>,
        view: Index<gltf::json::buffer::View>,
        offset: u64,
        count: usize,
        size: usize,
    ) -> Result<Items<'a>, Fault> {
        let (json, bytes) = source::view(self.root, self.buffers, view)?;
        let stride = json.byte_stride.map_or(size, |stride| stride.0);
        if stride < size {
            return Err(here(index, format!("items of {size} bytes do not fit a stride of {stride}")));
        }
        let out = || here(index, format!("{count} items reach beyond bufferViews[{}]", view.value()));
        let length = match count {
            0 => 0,
            _ => (count - 1).checked_mul(stride).and_then(|n| n.checked_add(size)).ok_or_else(out)?,
        };
        let start = usize::try_from(offset).map_err(|_| out())?;
        let end = start.checked_add(length).ok_or_else(out)?;
        Ok(Items { bytes: bytes.get(start..end).ok_or_else(out)?, stride, size })
    }
}

fn types(accessor: &Accessor, index: Index<Accessor>) -> Result<(Type, ComponentType), Fault> {
    match (&accessor.type_, &accessor.component_type) {
        (Checked::Valid(kind), Checked::Valid(component)) => Ok((*kind, component.0)),
        _ => Err(here(index, "its type is not valid")),
    }
}

fn kind_name(kind: Type) -> &'static str {
    match kind {
        Type::Scalar => "SCALAR",
        Type::Vec2 => "VEC2",
        Type::Vec3 => "VEC3",
        Type::Vec4 => "VEC4",
        Type::Mat2 => "MAT2",
        Type::Mat3 => "MAT3",
        Type::Mat4 => "MAT4",
    }
}

/// glTF 2.0 §3.11: normalised signed integers clamp at −1.
fn float(bytes: &[u8], component: ComponentType, normalized: bool) -> f32 {
    let scale = |value: f32, max: f32| if normalized { (value / max).max(-1.0) } else { value };
    match (component, bytes) {
        (ComponentType::I8, &[a]) => scale(f32::from(a as i8), 127.0),
        (ComponentType::U8, &[a]) => scale(f32::from(a), 255.0),
        (ComponentType::I16, &[a, b]) => scale(f32::from(i16::from_le_bytes([a, b])), 32767.0),
        (ComponentType::U16, &[a, b]) => scale(f32::from(u16::from_le_bytes([a, b])), 65535.0),
        (ComponentType::F32, &[a, b, c, d]) => f32::from_le_bytes([a, b, c, d]),
        _ => 0.0,
    }
}

fn unsigned(bytes: &[u8]) -> u32 {
    bytes.iter().rev().fold(0, |value, &byte| (value << 8) | u32::from(byte))
}

fn here(index: Index<Accessor>, what: impl std::fmt::Display) -> Fault {
    at(format!("accessors[{}]", index.value()), what)
}
