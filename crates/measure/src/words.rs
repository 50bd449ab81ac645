//! Lists of words on the command line.

use voxlume::{Fault, Faults};
use voxlume_fault::suggest;

/// The words, each once, or all that there are.
pub fn words(what: &str, given: &[String], known: &[&str], faults: &mut Faults) -> Vec<String> {
    if given == ["all"] {
        return known.iter().map(|word| (*word).to_owned()).collect();
    }
    let mut words: Vec<String> = Vec::new();
    for word in given {
        // Options follow the name.
        let name = word.split(':').next().unwrap_or_default();
        if !known.contains(&name) {
            let label = suggest(name, known.iter().copied());
            faults.push(Fault::new(format!("unknown {what} `{word}`")).note(format!("{label}, or all")));
        } else if !words.contains(word) {
            words.push(word.clone());
        }
    }
    words
}
