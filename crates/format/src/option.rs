//! Options of a format, and what is chosen of them.

/// A choice that a format leaves open.
///
/// WGSL declares it as `override <NAME>: u32` with a constant `<NAME>_<WORD>` for each word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FormatOption {
    /// Its name in RON and on the command line.
    pub name: &'static str,
    /// What it decides, and what the words mean.
    pub summary: &'static str,
    /// Its words; the first is the default.
    pub words: &'static [&'static str],
}

/// Words chosen for a format's options; for the others their defaults.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Choices(Vec<(&'static str, &'static str)>);

impl Choices {
    /// Chooses a word. Neither an option's default nor a word that it doesn't have changes anything.
    pub fn choose(&mut self, option: &FormatOption, word: &str) {
        self.0.retain(|(name, _)| *name != option.name);
        let known = option.words.iter().skip(1).find(|known| **known == word);
        self.0.extend(known.map(|known| (option.name, *known)));
    }

    /// The word chosen for an option.
    pub fn word(&self, option: &FormatOption) -> &'static str {
        let chosen = self.0.iter().find(|(name, _)| *name == option.name).map(|(_, word)| *word);
        chosen.or(option.words.first().copied()).unwrap_or_default()
    }
}

/// What differs from the defaults, as it follows a format's name: `:mip=projected:negatives=window`.
impl std::fmt::Display for Choices {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.0.iter().try_for_each(|(name, word)| write!(f, ":{name}={word}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MIP: FormatOption = FormatOption { name: "mip", summary: "", words: &["linear", "projected"] };
    const BASE: FormatOption = FormatOption { name: "base", summary: "", words: &["isotropic", "lobe"] };

    #[test]
    fn what_is_not_chosen_is_the_default() {
        let mut choices = Choices::default();
        choices.choose(&MIP, "projected");
        assert_eq!((choices.word(&MIP), choices.word(&BASE)), ("projected", "isotropic"));
        assert_eq!(choices.to_string(), ":mip=projected");
        choices.choose(&BASE, "lobe");
        choices.choose(&MIP, "linear");
        assert_eq!((choices.word(&MIP), choices.word(&BASE)), ("linear", "lobe"));
        assert_eq!(choices.to_string(), ":base=lobe");
    }
}
