//! What a shader asks of the program that runs it.

use naga::ShaderStage;
use naga::valid::GlobalUse;

use crate::binding::{Binding, binding};
use crate::check::Shader;
use crate::words;

/// A function that a pipeline can start with.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct EntryPoint {
    /// Its name.
    pub name: String,
    /// The stage that it is for.
    pub stage: Stage,
    /// Invocations along x, y and z; 0 unless it is a compute shader.
    pub workgroup_size: [u32; 3],
}

/// A pipeline stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Stage {
    /// `@vertex`
    Vertex,
    /// `@fragment`
    Fragment,
    /// `@compute`
    Compute,
}

/// A constant that is given when the pipeline is made.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Override {
    /// Its name.
    pub name: String,
    /// Its type: `bool`, `i32`, `u32` or `f32`.
    pub ty: String,
    /// Whether the shader gives a value itself.
    pub has_default: bool,
}

/// A function's types, as WGSL words such as `vec3f` or `Surface`; aliases are resolved.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Signature {
    /// Name and type of each argument.
    pub arguments: Vec<(String, String)>,
    /// The type returned.
    pub result: Option<String>,
}

impl Shader {
    /// The entry points, in the order of the text.
    pub fn entry_points(&self) -> Vec<EntryPoint> {
        let entry = |entry: &naga::EntryPoint| {
            let stage = match entry.stage {
                ShaderStage::Vertex => Stage::Vertex,
                ShaderStage::Fragment => Stage::Fragment,
                ShaderStage::Compute => Stage::Compute,
                // The others need an optional feature, so that checking refuses them.
                _ => return None,
            };
            Some(EntryPoint { name: entry.name.clone(), stage, workgroup_size: entry.workgroup_size })
        };
        self.module.entry_points.iter().filter_map(entry).collect()
    }

    /// The resources that an entry point statically uses, by group and binding. Empty if there is no such
    /// entry point.
    pub fn bindings(&self, entry: &str) -> Vec<Binding> {
        let Some(index) = self.module.entry_points.iter().position(|point| point.name == entry) else {
            return Vec::new();
        };
        let info = self.info.get_entry_point(index);
        let used = self.module.global_variables.iter().filter(|(handle, _)| !info[*handle].is_empty());
        let mut bindings: Vec<_> = used.filter_map(|(handle, _)| binding(self, info, handle)).collect();
        bindings.sort_by_key(|binding| (binding.group, binding.binding));
        bindings
    }

    /// Whether an entry point may read a variable, its atomics included, and not just write to it.
    pub fn reads(&self, entry: &str, variable: &str) -> bool {
        let index = self.module.entry_points.iter().position(|point| point.name == entry);
        let mut named = self.module.global_variables.iter();
        let named = named.find(|(_, global)| global.name.as_deref() == Some(variable));
        let using = index.zip(named).map(|(index, (handle, _))| self.info.get_entry_point(index)[handle]);
        using.is_some_and(|using| using.intersects(GlobalUse::READ | GlobalUse::ATOMIC))
    }

    /// The overrides, in the order of the text.
    pub fn overrides(&self) -> Vec<Override> {
        let overrides = self.module.overrides.iter();
        let plain = |value: &naga::Override| {
            Some(Override {
                name: value.name.clone()?,
                ty: words::of_type(&self.module, value.ty),
                has_default: value.init.is_some(),
            })
        };
        overrides.filter_map(|(_, value)| plain(value)).collect()
    }

    /// The types of a function; entry points are none of these.
    pub fn function(&self, name: &str) -> Option<Signature> {
        let mut functions = self.module.functions.iter().map(|(_, function)| function);
        let function = functions.find(|function| function.name.as_deref() == Some(name))?;
        let argument = |argument: &naga::FunctionArgument| {
            (argument.name.clone().unwrap_or_default(), words::of_type(&self.module, argument.ty))
        };
        Some(Signature {
            arguments: function.arguments.iter().map(argument).collect(),
            result: function.result.as_ref().map(|result| words::of_type(&self.module, result.ty)),
        })
    }
}
