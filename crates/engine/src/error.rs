//! What can go wrong on a device.

/// An error of the device or of what was asked of it.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// No adapter at all.
    #[error(
        "no graphics device found: install a Vulkan driver (on Debian: apt-get install mesa-vulkan-drivers for a software one)"
    )]
    NoAdapter,
    /// No adapter whose name has this part.
    #[error("no graphics device is called `{name}`; there is: {}", known.join(", "))]
    NoSuchAdapter {
        /// The part asked for.
        name: String,
        /// Names of what there is.
        known: Vec<String>,
    },
    /// The device can't be opened.
    #[error("{adapter}: can't open the device: {message}")]
    Open {
        /// Name of the adapter.
        adapter: String,
        /// What the driver says.
        message: String,
    },
    /// The device has no memory left.
    #[error("out of device memory while {0}")]
    OutOfMemory(String),
    /// A buffer would exceed what one binding holds.
    #[error(
        "`{name}` needs {bytes} bytes for {voxels} occupied voxels; one buffer holds at most {limit}: choose a lower resolution"
    )]
    TooLarge {
        /// The resource.
        name: String,
        /// What it needs.
        bytes: u64,
        /// Occupied voxels.
        voxels: u64,
        /// Largest binding.
        limit: u64,
    },
    /// The plan would exceed its own budget.
    #[error(
        "the plan needs {bytes} bytes on the device with {voxels} occupied voxels, over the budget of {budget}: choose a lower resolution"
    )]
    OverBudget {
        /// What it needs, without the scene.
        bytes: u64,
        /// Occupied voxels.
        voxels: u64,
        /// What it may take.
        budget: u64,
    },
    /// The device refuses something.
    #[error("the device refuses {what}: {message}")]
    Refused {
        /// What was being done.
        what: String,
        /// What it says.
        message: String,
    },
    /// The device is gone.
    #[error("the device was lost: {0}")]
    Lost(String),
    /// The scene is not what it has to be.
    #[error(transparent)]
    Scene(#[from] voxlume_fault::Faults),
    /// A scene is given that differs from the one on the device in more than may change between frames.
    #[error("this is another scene than the one that was planned for: {0}")]
    OtherScene(String),
    /// A parameter, a camera or a time is not what it has to be.
    #[error(transparent)]
    Fault(#[from] voxlume_fault::Fault),
    /// No screen has this size.
    #[error("an image of {width} × {height} pixels: each side must be from 1 to {limit}")]
    Screen {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
        /// The device's largest side.
        limit: u32,
    },
    /// A pass that the plan doesn't have.
    #[error("no pass is called `{name}`; there is: {}", known.join(", "))]
    NoSuchPass {
        /// What was asked for.
        name: String,
        /// What there is.
        known: Vec<String>,
    },
    /// A buffer that the plan doesn't have.
    #[error("no buffer is called `{0}`")]
    NoSuchBuffer(String),
    /// An image or a volume that the plan doesn't have.
    #[error("no image is called `{name}`; there is: {}", known.join(", "))]
    NoSuchImage {
        /// What was asked for.
        name: String,
        /// What there is.
        known: Vec<String>,
    },
}
