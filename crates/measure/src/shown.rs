//! How images are shown.

use voxlume::{Pipeline, Shows, Value};

/// Images that no effect makes, and channels of voxels.
const KNOWN: [(&str, Shows); 9] = [
    ("albedo", Shows::Albedo),
    ("normal", Shows::Normal),
    ("geometry", Shows::Normal),
    ("depth", Shows::Share),
    ("emission", Shows::Light),
    ("occupancy", Shows::Share),
    ("opacity", Shows::Share),
    ("radiance", Shows::Light),
    ("lit", Shows::Light),
];

/// What an image of a pipeline shows: what its entry says, or what images of the camera and channels of voxels are. `set`
/// replaces parameters of the file.
pub fn shows(pipeline: &Pipeline, set: &[(String, String, Value)], image: &str) -> Shows {
    let maker = pipeline.passes.iter().find(|pass| pass.writes.iter().any(|name| name.value == image));
    let Some(maker) = maker else { return channel_shows(image) };
    let given = maker.params.iter().map(|param| (&param.name, &param.value));
    let set = set.iter().filter(|(pass, ..)| *pass == maker.name).map(|(_, name, value)| (name, value));
    let channel = given.chain(set).rfind(|(name, _)| *name == "channel");
    match (&maker.shows, channel) {
        (Some(shows), _) => shows.value,
        (None, Some((_, Value::Word(channel)))) if maker.run.value == "voxel_view" => channel_shows(channel),
        _ => Shows::default(),
    }
}

/// What an image of the camera or a channel of voxels shows.
pub fn channel_shows(name: &str) -> Shows {
    KNOWN.iter().find(|(known, _)| *known == name).map_or(Shows::default(), |(_, shows)| *shows)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn an_entry_a_table_or_a_channel_says_it() {
        let pipeline = Pipeline::builtin("gi").unwrap();
        let of = |image| shows(&pipeline, &[], image);
        assert_eq!([of("shadow"), of("ao")], [Shows::Share; 2]);
        assert_eq!([of("diffuse"), of("specular"), of("final")], [Shows::Light; 3]);
        assert_eq!(
            [of("albedo"), of("normal"), of("geometry")],
            [Shows::Albedo, Shows::Normal, Shows::Normal]
        );
        assert_eq!([of("depth"), of("emission")], [Shows::Share, Shows::Light]);
        assert_eq!(of("voxel_view"), Shows::Light);
        let set = ("voxel_view".to_owned(), "channel".to_owned(), Value::Word("normal".into()));
        assert_eq!(shows(&pipeline, &[set], "voxel_view"), Shows::Normal);
    }
}
