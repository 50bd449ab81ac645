//! The valid choices, for labels.

/// `one of: a, b, c`.
pub fn one_of<'a>(choices: impl IntoIterator<Item = &'a str>) -> String {
    let choices: Vec<&str> = choices.into_iter().collect();
    if choices.is_empty() {
        "there is none to choose".into()
    } else {
        format!("one of: {}", choices.join(", "))
    }
}

/// The choice that `word` is probably a misspelling of: at most a third of its letters edited
/// (insert, delete, replace, swap neighbours), case ignored. The first of equals.
pub fn nearest<'a>(word: &str, choices: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let word = word.to_lowercase();
    let limit = (word.chars().count() / 3).max(1);
    choices
        .into_iter()
        .map(|choice| (strsim::damerau_levenshtein(&word, &choice.to_lowercase()), choice))
        // An edit of every letter is another word, not a misspelling.
        .filter(|(distance, choice)| *distance <= limit && *distance < choice.chars().count())
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, choice)| choice)
}

/// ``did you mean `b`? one of: a, b, c``, or only the choices when none is near.
pub fn suggest<'a>(word: &str, choices: impl IntoIterator<Item = &'a str> + Clone) -> String {
    match nearest(word, choices.clone()) {
        Some(near) => format!("did you mean `{near}`? {}", one_of(choices)),
        None => one_of(choices),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FORMATS: [&str; 3] = ["isotropic", "six_face", "sh2"];

    #[test]
    fn nearest_finds_misspellings_only() {
        assert_eq!(nearest("sixface", FORMATS), Some("six_face"));
        assert_eq!(nearest("Isotropci", FORMATS), Some("isotropic"));
        assert_eq!(nearest("sh3", FORMATS), Some("sh2"));
        assert_eq!(nearest("cube", FORMATS), None);
        assert_eq!(nearest("x", ["a"]), None);
        assert_eq!(nearest("", FORMATS), None);
    }

    #[test]
    fn suggestions_list_every_choice() {
        assert_eq!(suggest("sixface", FORMATS), "did you mean `six_face`? one of: isotropic, six_face, sh2");
        assert_eq!(suggest("cube", FORMATS), "one of: isotropic, six_face, sh2");
        assert_eq!(suggest("cube", []), "there is none to choose");
    }
}
