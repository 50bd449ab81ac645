//! What a name of the graph stands for in shaders.

use crate::plan::Target;

/// What a name of the graph stands for: shader variables with their resources, constants, words and modules. A pass that
/// reads the name has all of them.
#[derive(Clone, Debug, Default)]
pub struct Bundle {
    parts: Vec<(String, Target)>,
    constants: Vec<(&'static str, f64)>,
    words: Vec<(String, &'static str)>,
    mounts: Vec<(&'static str, String)>,
    grid: Option<usize>,
}

impl Bundle {
    /// A single variable.
    pub fn of(variable: &str, target: Target) -> Bundle {
        let mut bundle = Bundle::default();
        bundle.add(variable, target);
        bundle
    }

    /// Adds a variable by its name in WGSL.
    pub fn add(&mut self, variable: &str, target: Target) {
        self.parts.push((variable.to_owned(), target));
    }

    /// Gives an `override` a value in every shader that reads this.
    pub fn with(&mut self, constant: &'static str, value: f64) {
        self.constants.push((constant, value));
    }

    /// Gives an `override` the value of the shader's constant `<NAME>_<WORD>`.
    pub fn with_word(&mut self, name: &str, word: &'static str) {
        self.words.push((name.to_owned(), word));
    }

    /// Has imports below `package::<name>` mean the modules of a folder.
    pub fn mount(&mut self, name: &'static str, folder: &str) {
        self.mounts.push((name, folder.to_owned()));
    }

    /// Adds all variables of another.
    pub fn join(&mut self, other: &Bundle) {
        self.parts.extend(other.parts.iter().cloned());
    }

    /// What a variable stands for.
    pub fn part(&self, variable: &str) -> Option<&Target> {
        self.parts.iter().find(|(name, _)| name == variable).map(|(_, target)| target)
    }

    pub(crate) fn parts(&self) -> &[(String, Target)] {
        &self.parts
    }

    pub(crate) fn constant(&self, name: &str) -> Option<f64> {
        self.constants.iter().find(|(known, _)| *known == name).map(|(_, value)| *value)
    }

    pub(crate) fn word(&self, name: &str) -> Option<&'static str> {
        self.words.iter().find(|(known, _)| known == name).map(|(_, word)| *word)
    }

    pub(crate) fn mounts(&self) -> &[(&'static str, String)] {
        &self.mounts
    }

    pub(crate) fn set_grid(&mut self, grid: usize) {
        self.grid = Some(grid);
    }

    /// The grid that it is of, in the context's list.
    pub(crate) fn grid(&self) -> Option<usize> {
        self.grid
    }
}
