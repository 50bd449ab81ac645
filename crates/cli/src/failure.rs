//! Why the program ends otherwise than well.

use std::fmt;
use std::process::ExitCode;

use voxlume::{Fault, Faults};
use voxlume_measure::Error;

/// What is printed, and with which exit code the program ends.
#[derive(Debug)]
pub enum Failure {
    /// Something is wrong with what the user gave: exit code 2.
    Input(Faults),
    /// As `Input`, and how many faults in what, told last.
    Checked(Faults, String),
    /// The device or the system failed: exit code 1.
    Work(Fault),
}

impl Failure {
    /// A failure of the work.
    pub fn work(message: impl Into<String>) -> Failure {
        Failure::Work(Fault::new(message))
    }

    /// 1 or 2.
    pub fn exit_code(&self) -> ExitCode {
        match self {
            Failure::Work(_) => ExitCode::from(1),
            Failure::Input(_) | Failure::Checked(..) => ExitCode::from(2),
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Failure::Input(faults) => faults.fmt(f),
            Failure::Checked(faults, count) => write!(f, "{faults}\n\n{count}"),
            Failure::Work(fault) => fault.fmt(f),
        }
    }
}

impl From<Faults> for Failure {
    fn from(faults: Faults) -> Failure {
        Failure::Input(faults)
    }
}

impl From<Fault> for Failure {
    fn from(fault: Fault) -> Failure {
        Failure::Input(fault.into())
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Failure {
        match error {
            Error::Input(faults) => Failure::Input(faults),
            Error::Work(fault) => Failure::Work(fault),
            Error::Interrupted { .. } => Failure::work(error.to_string()),
        }
    }
}

impl From<voxlume::Error> for Failure {
    fn from(error: voxlume::Error) -> Failure {
        Error::from(error).into()
    }
}
