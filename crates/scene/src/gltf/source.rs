//! Bytes that a glTF file refers to: buffers, and files beside it, confined to its folder.

use std::borrow::Cow;
use std::path::{Component, Path, PathBuf};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use gltf::json::{Index, Root, buffer::View};
use percent_encoding::percent_decode_str;
use voxlume_fault::{Fault, Faults};

use super::at;
use crate::limit::read_file;

/// What bytes are that should be glTF or an image, as far as their first ones say it.
pub(super) fn kind(bytes: &[u8]) -> Option<&'static str> {
    const KINDS: [(&[u8], &str); 3] = [
        (b"version https://git-lfs", "a pointer of Git LFS; `git lfs pull` gets the file itself"),
        (b"<", "HTML or XML"),
        (b"\xabKTX ", "a KTX texture"),
    ];
    let text = bytes.trim_ascii_start();
    KINDS.iter().find(|(first, _)| text.starts_with(first)).map(|(_, kind)| *kind)
}

/// Every buffer's bytes, each at least as long as the file says.
pub(super) fn buffers<'a>(
    root: &Root,
    bin: Option<&'a [u8]>,
    folder: &Path,
) -> Result<Vec<Cow<'a, [u8]>>, Faults> {
    let mut faults = Faults::default();
    let mut buffers = Vec::new();
    for (i, buffer) in root.buffers.iter().enumerate() {
        let place = format!("buffers[{i}]");
        let bytes = match (&buffer.uri, bin) {
            (Some(uri), _) => resolve(uri, folder).map(Cow::Owned).map_err(|e| at(format!("{place}.uri"), e)),
            (None, Some(bin)) if i == 0 => Ok(Cow::Borrowed(bin)),
            (None, _) => Err(at(&place, "neither a uri nor a binary chunk")),
        };
        let bytes = bytes.and_then(|bytes| {
            let (needed, found) = (buffer.byte_length.0, bytes.len());
            let short = || at(&place, format!("truncated: {needed} bytes are announced, {found} are there"));
            if (found as u64) < needed { Err(short()) } else { Ok(bytes) }
        });
        buffers.extend(faults.gather(bytes));
    }
    faults.into_result(buffers)
}

/// The bytes of a buffer view.
pub(super) fn view<'a>(
    root: &'a Root,
    buffers: &'a [Cow<'_, [u8]>],
    index: Index<View>,
) -> Result<(&'a View, &'a [u8]), Fault> {
    let out = || at(format!("bufferViews[{}]", index.value()), "reaches beyond its buffer");
    let view = root.buffer_views.get(index.value()).ok_or_else(out)?;
    let buffer = buffers.get(view.buffer.value()).ok_or_else(out)?;
    let start = view.byte_offset.unwrap_or_default().0;
    let end = start.checked_add(view.byte_length.0).ok_or_else(out)?;
    let bytes = usize::try_from(start).ok().zip(usize::try_from(end).ok());
    Ok((view, bytes.and_then(|(start, end)| buffer.get(start..end)).ok_or_else(out)?))
}

/// The bytes behind a URI: `data:` with base64, or a file in `folder` or below it.
pub(super) fn resolve(uri: &str, folder: &Path) -> Result<Vec<u8>, String> {
    if let Some(data) = uri.strip_prefix("data:") {
        let (_, text) = data.split_once(";base64,").ok_or("a `data:` URI without base64")?;
        return STANDARD.decode(text).map_err(|e| format!("a `data:` URI with bad base64: {e}"));
    }
    let file = folder.join(relative(uri)?);
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    // A link may lead out where the path does not. What is not there is for the reader to report.
    let outside_by_link = match (file.canonicalize(), folder.canonicalize()) {
        (Ok(file), Ok(folder)) => !file.starts_with(folder),
        _ => false,
    };
    if outside_by_link { Err(outside(uri)) } else { read_file(&file) }
}

/// The path of a URI that stays within its folder.
fn relative(uri: &str) -> Result<PathBuf, String> {
    let scheme = |name: &str| {
        name.starts_with(|c: char| c.is_ascii_alphabetic())
            && name.chars().all(|c| c.is_ascii_alphanumeric() || "+-.".contains(c))
    };
    if let Some((name, _)) = uri.split_once(':').filter(|(name, _)| scheme(name)) {
        return Err(format!("the scheme of `{uri}` is `{name}:`; only files and `data:` are read"));
    }
    let decoded = percent_decode_str(uri).decode_utf8().map_err(|_| format!("`{uri}` is not UTF-8"))?;
    let path = Path::new(decoded.as_ref());
    let inside = path.components().all(|c| matches!(c, Component::Normal(_) | Component::CurDir));
    // What is a separator or a drive on one system must not depend on which it is.
    let portable = !decoded.contains(['\\', '\0']) && decoded.as_bytes().get(1) != Some(&b':');
    if inside && portable { Ok(path.to_owned()) } else { Err(outside(uri)) }
}

fn outside(uri: &str) -> String {
    format!("`{uri}` leads outside the scene's folder")
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn uris_stay_inside() {
        assert_eq!(relative("a/b%20c.png").unwrap(), Path::new("a/b c.png"));
        assert_eq!(relative("./a..b/..c").unwrap(), Path::new("./a..b/..c"));
        for uri in ["../a", "a/../../b", "a/..", "%2e%2e/a", "%2E%2e%2fa", "/etc/passwd", "%2Fetc", "..\\a"] {
            assert_eq!(relative(uri), Err(format!("`{uri}` leads outside the scene's folder")), "{uri}");
        }
        for uri in ["\\\\host\\a", "a%00b", "C%3A/a"] {
            assert!(relative(uri).unwrap_err().ends_with("outside the scene's folder"), "{uri}");
        }
        for uri in ["http://a/b", "file:///etc/passwd", "C:/a", "c:a"] {
            assert!(relative(uri).unwrap_err().starts_with("the scheme of"), "{uri}");
        }
        assert_eq!(relative("%ff"), Err("`%ff` is not UTF-8".into()));
    }

    #[test]
    fn links_that_lead_out_are_refused() {
        let folder = tempfile::tempdir().unwrap();
        let inner = folder.path().join("scene");
        std::fs::create_dir(&inner).unwrap();
        std::fs::write(folder.path().join("secret.bin"), "x").unwrap();
        std::fs::write(inner.join("own.bin"), "y").unwrap();
        assert_eq!(resolve("own.bin", &inner).unwrap(), b"y");
        #[cfg(unix)]
        {
            std::os::unix::fs::symlink(folder.path().join("secret.bin"), inner.join("link.bin")).unwrap();
            let refused = Err("`link.bin` leads outside the scene's folder".into());
            assert_eq!(resolve("link.bin", &inner), refused);
        }
    }

    #[test]
    fn data_uris() {
        let none = Path::new("");
        assert_eq!(resolve("data:application/octet-stream;base64,AQID", none).unwrap(), [1, 2, 3]);
        assert_eq!(resolve("data:text/plain,a", none), Err("a `data:` URI without base64".into()));
        assert!(resolve("data:;base64,?", none).unwrap_err().starts_with("a `data:` URI with bad base64: "));
    }
}
