//! Why there are no figures.

use voxlume::{Fault, Faults};

/// Why there are no figures.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// Something is wrong with what was given: a scene, a pipeline, a shader, a word.
    #[error("{0}")]
    Input(Faults),
    /// The device, the reference or the file system failed.
    #[error("{0}")]
    Work(Fault),
    /// The flag to stop was raised.
    #[error("interrupted: {finished} of {all} cells are finished")]
    Interrupted {
        /// Cells that are finished.
        finished: usize,
        /// Cells in all.
        all: usize,
    },
}

impl Error {
    /// A failure of the work.
    pub(crate) fn work(message: impl Into<String>) -> Error {
        Error::Work(Fault::new(message))
    }
}

impl From<Faults> for Error {
    fn from(faults: Faults) -> Error {
        Error::Input(faults)
    }
}

impl From<Fault> for Error {
    fn from(fault: Fault) -> Error {
        Error::Input(fault.into())
    }
}

impl From<voxlume::Error> for Error {
    fn from(error: voxlume::Error) -> Error {
        use voxlume::Error::{NoSuchAdapter, NoSuchImage, OverBudget, Scene, TooLarge};
        let fault = Fault::new(error.to_string());
        match error {
            Scene(faults) => Error::Input(faults),
            NoSuchAdapter { .. } | NoSuchImage { .. } | TooLarge { .. } | OverBudget { .. } => {
                Error::Input(fault.into())
            }
            _ => Error::Work(fault),
        }
    }
}
