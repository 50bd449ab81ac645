//! The layout of structs in memory.

use naga::{Handle, Module, StructMember, Type, TypeInner};

use crate::check::Shader;
use crate::words;

/// Where the fields of a struct are.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct StructLayout {
    /// Bytes, rounded up to 16, as for a uniform.
    pub size: u64,
    /// The fields, in the order of the text.
    pub fields: Vec<Field>,
}

/// A field of a struct.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Field {
    /// Its name.
    pub name: String,
    /// Its type as WGSL writes it: `f32`, `vec3f`, `mat4x4f`, `array<vec4f, 6>`, a struct's name.
    pub ty: String,
    /// Bytes from the start of the struct.
    pub offset: u64,
    /// Bytes, what follows up to the next field excluded.
    pub size: u64,
    /// The `///` lines above it, joined by newlines.
    pub docs: String,
}

impl Shader {
    /// The layout of a struct; nothing if the shader declares none of that name.
    pub fn struct_layout(&self, name: &str) -> Option<StructLayout> {
        let named =
            |ty: &&Type| ty.name.as_deref() == Some(name) && matches!(ty.inner, TypeInner::Struct { .. });
        let (_, ty) = self.module.types.iter().find(|(_, ty)| named(ty))?;
        let TypeInner::Struct { members, span } = &ty.inner else { return None };
        let size = uniform_size(u64::from(*span));
        Some(StructLayout { size, fields: members.iter().map(|member| self.field(name, member)).collect() })
    }

    fn field(&self, of: &str, member: &StructMember) -> Field {
        let name = member.name.clone().unwrap_or_default();
        let declaration = self.modules.iter().find_map(|module| module.declaration(of));
        let docs =
            declaration.and_then(|declared| declared.members.iter().find(|(member, _)| *member == name));
        Field {
            ty: words::of_type(&self.module, member.ty),
            offset: u64::from(member.offset),
            size: size_of(&self.module, member.ty),
            docs: docs.map_or_else(String::new, |(_, docs)| docs.clone()),
            name,
        }
    }
}

/// Bytes of a type; of an array without a length, those of one element.
pub(crate) fn size_of(module: &Module, ty: Handle<Type>) -> u64 {
    module.types[ty].inner.try_size(module.to_ctx()).map_or(u64::from(u32::MAX), u64::from)
}

/// Bytes of a uniform buffer: a whole number of `vec4f`, which is what every backend takes.
pub(crate) fn uniform_size(size: u64) -> u64 {
    size.next_multiple_of(16)
}
