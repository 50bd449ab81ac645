//! A graphics device for every machine, if need be a software one.

use std::process::{Command, Stdio};

use crate::{cargo, run};

const ADVICE: &str = "no graphics device: install a Vulkan driver, such as `mesa-vulkan-drivers` of Debian, Ubuntu and \
                      Fedora or `vulkan-swrast` of Arch";

/// Builds the program, asks it for devices, and installs Debian's software Vulkan driver if there is none.
pub fn ensure(profile: &[&str]) -> Result<(), String> {
    run(cargo().args(["build", "--package", "voxlume-cli"]).args(profile))?;
    if has_device(profile) {
        return Ok(());
    }
    let Some(privilege) = privilege() else { return Err(ADVICE.into()) };
    eprintln!("no graphics device: installing mesa-vulkan-drivers");
    let apt = |arguments: &[&str]| {
        let mut words = privilege.iter().copied().chain(["env", "DEBIAN_FRONTEND=noninteractive", "apt-get"]);
        let mut command = Command::new(words.next().unwrap_or("env"));
        // The lock may be held by the machine's own updates.
        command
            .args(words)
            .args(["-q", "-o", "DPkg::Lock::Timeout=120"])
            .args(arguments)
            .stdin(Stdio::null());
        run(&mut command)
    };
    apt(&["update"])
        .and_then(|()| apt(&["install", "--yes", "--no-install-recommends", "mesa-vulkan-drivers"]))
        .map_err(|error| format!("{error}; {ADVICE}"))?;
    if has_device(profile) { Ok(()) } else { Err(ADVICE.into()) }
}

fn has_device(profile: &[&str]) -> bool {
    let mut devices = cargo();
    devices.args(["run", "--quiet", "--package", "voxlume-cli"]).args(profile).args(["--", "devices"]);
    succeeds(&mut devices)
}

/// The words that come before a command that must run as root; `None` where apt-get can't.
fn privilege() -> Option<&'static [&'static str]> {
    if !succeeds(Command::new("apt-get").arg("--version")) {
        return None;
    }
    let id = Command::new("id").arg("-u").output().ok()?;
    if id.stdout.trim_ascii() == b"0" {
        return Some(&[]);
    }
    succeeds(Command::new("sudo").args(["-n", "true"])).then_some(&["sudo", "-n"])
}

fn succeeds(command: &mut Command) -> bool {
    let status = command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).status();
    status.is_ok_and(|status| status.success())
}
