//! Ctrl-C as a wish that long work looks at.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::failure::Failure;

static WISH: AtomicBool = AtomicBool::new(false);
static HANDLER: OnceLock<()> = OnceLock::new();

/// From now on Ctrl-C raises this flag; a second one ends the program at once.
pub fn wish() -> &'static AtomicBool {
    HANDLER.get_or_init(|| {
        // Where no handler can be set, Ctrl-C ends the program as ever.
        let _ = ctrlc::set_handler(|| {
            if WISH.swap(true, Ordering::Relaxed) {
                std::process::exit(1);
            }
        });
    });
    &WISH
}

/// Whether the work should end.
pub fn wished() -> bool {
    WISH.load(Ordering::Relaxed)
}

/// Ends work of which nothing is kept, if it should end.
pub fn heed() -> Result<(), Failure> {
    if wished() { Err(Failure::work("interrupted; nothing was written")) } else { Ok(()) }
}
