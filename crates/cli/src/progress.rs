//! What is being done: a spinner on a terminal, plain lines elsewhere.

use std::io::{IsTerminal, Write};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

/// How long plain lines say nothing new about repeated work.
const QUIET: Duration = Duration::from_secs(10);

/// Tells on stderr what is being done. A spinner leaves no trace when this is dropped.
pub struct Progress {
    spinner: Option<ProgressBar>,
    told: Instant,
}

impl Progress {
    /// By whether stderr is a terminal.
    pub fn new() -> Progress {
        let spinner = std::io::stderr().is_terminal().then(|| {
            let spinner = ProgressBar::new_spinner();
            if let Ok(style) = ProgressStyle::with_template("{spinner} {msg} ({elapsed})") {
                spinner.set_style(style);
            }
            spinner.enable_steady_tick(Duration::from_millis(100));
            spinner
        });
        Progress { spinner, told: Instant::now() }
    }
}

impl voxlume_measure::Progress for Progress {
    fn stage(&mut self, what: String) {
        self.told = Instant::now();
        match &self.spinner {
            Some(spinner) => spinner.set_message(what),
            // Work goes on where nobody reads.
            None => _ = writeln!(std::io::stderr(), "{what}"),
        }
    }

    /// Plain lines tell of it only now and then.
    fn repeated(&mut self, what: String) {
        if self.spinner.is_some() || self.told.elapsed() > QUIET {
            self.stage(what);
        }
    }

    fn share(&mut self, what: &str, done: f32) {
        const CELLS: usize = 20;
        let full = (done.clamp(0.0, 1.0) * CELLS as f32) as usize;
        self.repeated(format!(
            "{what} [{}{}] {:3.0} %",
            "#".repeat(full),
            " ".repeat(CELLS - full),
            done * 100.0
        ));
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(spinner) = &self.spinner {
            spinner.finish_and_clear();
        }
    }
}
