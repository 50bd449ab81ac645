//! The WGSL does what the twin does, with each word of each format's options.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use voxlume::{Choices, Encoding, Formats, Gpu, Library};
use voxlume_conformance::{Bench, Content, SIDE, against_twin};

#[test]
fn every_option_has_a_twin() {
    let (gpu, library) = (Gpu::open(None).unwrap(), Library::builtin());
    for format in Formats::builtin().iter() {
        for (number, option) in format.options().iter().enumerate() {
            for word in option.words {
                let mut choices = Choices::default();
                if number > 0 && option.name == "empty" {
                    // Only a directional level 0 has empty faces.
                    choices.choose(&format.options()[0], "weighted");
                }
                let without = format.twin(&choices).unwrap();
                choices.choose(option, word);
                let twin = format.twin(&choices).unwrap();
                let mut bench =
                    Bench::new(&gpu, format, &choices, &library, Encoding::RGBA16FLOAT, SIDE).unwrap();
                // Another choice's twin is told apart, where it has the same volumes.
                if number > 0 && word != &option.words[0] {
                    let content = Content::random(SIDE, 5, 1.0);
                    let checks = against_twin(&mut bench, without.as_ref(), "random", &content).unwrap();
                    assert!(
                        checks.iter().any(|check| check.figure > check.bound),
                        "{choices} changes nothing"
                    );
                }
                for (name, content) in Content::adversarial(SIDE) {
                    for check in against_twin(&mut bench, twin.as_ref(), name, &content).unwrap() {
                        assert!(check.figure <= check.bound, "{}{choices}: {check:?}", format.name());
                    }
                }
            }
        }
    }
}
