//! A device and the errors that it reports.

use std::sync::atomic::{AtomicI64, Ordering};
use std::sync::{Arc, LazyLock, Mutex};

use crate::Error;

/// An open device. Clones are the same device.
#[derive(Clone, Debug)]
pub struct Gpu {
    /// The device.
    pub device: wgpu::Device,
    /// Its queue.
    pub queue: wgpu::Queue,
    /// What it is.
    pub info: wgpu::AdapterInfo,
    fault: Arc<Mutex<Option<String>>>,
}

fn instance() -> wgpu::Instance {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle_from_env();
    // Native drivers only; the software Vulkan driver counts as one.
    descriptor.backends = wgpu::Backends::PRIMARY;
    // Dispatch sizes in buffers are this crate's own and bounded where they are written.
    descriptor.flags.remove(wgpu::InstanceFlags::VALIDATION_INDIRECT_CALL);
    wgpu::Instance::new(descriptor)
}

impl Gpu {
    /// What adapters there are.
    pub fn list() -> Vec<wgpu::AdapterInfo> {
        let adapters = pollster::block_on(instance().enumerate_adapters(wgpu::Backends::PRIMARY));
        adapters.iter().map(wgpu::Adapter::get_info).collect()
    }

    /// Opens the adapter whose name contains `name`, case ignored, or else the most capable one. Without a name,
    /// `WGPU_ADAPTER_NAME` chooses.
    ///
    /// # Errors
    /// No such adapter, or it can't be opened with WebGPU's default limits.
    pub fn open(name: Option<&str>) -> Result<Gpu, Error> {
        let environment = std::env::var("WGPU_ADAPTER_NAME").ok();
        let name = name.or(environment.as_deref());
        let mut adapters = pollster::block_on(instance().enumerate_adapters(wgpu::Backends::PRIMARY));
        if adapters.is_empty() {
            return Err(Error::NoAdapter);
        }
        adapters.sort_by_key(|adapter| match adapter.get_info().device_type {
            wgpu::DeviceType::DiscreteGpu => 0,
            wgpu::DeviceType::IntegratedGpu => 1,
            wgpu::DeviceType::VirtualGpu | wgpu::DeviceType::Other => 2,
            wgpu::DeviceType::Cpu => 3,
        });
        let wanted = name.unwrap_or_default().to_lowercase();
        let matches = |adapter: &&wgpu::Adapter| adapter.get_info().name.to_lowercase().contains(&wanted);
        let Some(adapter) = adapters.iter().find(matches) else {
            let known = adapters.iter().map(|adapter| adapter.get_info().name).collect();
            return Err(Error::NoSuchAdapter { name: wanted, known });
        };
        let descriptor = wgpu::DeviceDescriptor {
            label: Some("voxlume"),
            // Each has a path without.
            required_features: adapter.features()
                & (wgpu::Features::TIMESTAMP_QUERY | wgpu::Features::FLOAT32_FILTERABLE),
            required_limits: wgpu::Limits::default(),
            ..Default::default()
        };
        let info = adapter.get_info();
        let open = pollster::block_on(adapter.request_device(&descriptor));
        let (device, queue) =
            open.map_err(|error| Error::Open { adapter: info.name.clone(), message: error.to_string() })?;
        tracing::info!(adapter = info.name, driver = info.driver_info, "device opened");
        Ok(Gpu::new(device, queue))
    }

    /// Wraps a device of the caller's. Its handlers of uncaptured errors and of loss are replaced.
    pub fn new(device: wgpu::Device, queue: wgpu::Queue) -> Gpu {
        let fault = Arc::new(Mutex::new(None));
        let keep = |fault: &Arc<Mutex<Option<String>>>, message: String| {
            let mut first = fault.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
            first.get_or_insert(message);
        };
        let uncaptured = Arc::clone(&fault);
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| keep(&uncaptured, error.to_string())));
        let lost = Arc::clone(&fault);
        device.set_device_lost_callback(move |reason, message| {
            keep(&lost, if message.is_empty() { format!("{reason:?}") } else { message });
        });
        let info = device.adapter_info();
        Gpu { device, queue, info, fault }
    }

    /// Whether passes can be timed on the device itself. Software devices have timestamps that are taken before
    /// the work is done (Mesa 22.3's llvmpipe reports 0.1 ms for a dispatch of 120 ms), so they don't count.
    pub fn has_reliable_timestamps(&self) -> bool {
        let software = self.info.device_type == wgpu::DeviceType::Cpu;
        !software && self.device.features().contains(wgpu::Features::TIMESTAMP_QUERY)
    }

    /// Whether the device filters textures of 32-bit floats.
    pub fn filters_float32(&self) -> bool {
        self.device.features().contains(wgpu::Features::FLOAT32_FILTERABLE)
    }

    /// Does something to the device and turns what it reports into an error. `what` completes "the device refuses …".
    ///
    /// # Errors
    /// What the device reports.
    pub fn guarded<T>(&self, what: &str, action: impl FnOnce() -> T) -> Result<T, Error> {
        let memory = self.device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
        let internal = self.device.push_error_scope(wgpu::ErrorFilter::Internal);
        let validation = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
        self.lose_if_asked();
        let value = action();
        let errors = [validation.pop(), internal.pop()].map(pollster::block_on);
        let memory = pollster::block_on(memory.pop());
        // A lost device refuses everything; why it is lost says more.
        self.check()?;
        if memory.is_some() {
            return Err(Error::OutOfMemory(what.to_owned()));
        }
        match errors.into_iter().flatten().next() {
            Some(error) => Err(Error::Refused { what: what.to_owned(), message: error.to_string() }),
            None => Ok(value),
        }
    }

    /// Loses the device, once, after as many guarded actions of the process as `VOXLUME_LOSE_DEVICE_AFTER` says: for
    /// tests of what becomes of the work then.
    fn lose_if_asked(&self) {
        static LEFT: LazyLock<AtomicI64> = LazyLock::new(|| {
            let asked = std::env::var("VOXLUME_LOSE_DEVICE_AFTER").ok().and_then(|text| text.parse().ok());
            AtomicI64::new(asked.unwrap_or(0))
        });
        if LEFT.load(Ordering::Relaxed) > 0 && LEFT.fetch_sub(1, Ordering::Relaxed) == 1 {
            self.device.destroy();
            // The callback comes with the next poll.
            let _ = self.device.poll(wgpu::PollType::Poll);
        }
    }

    /// Whether the device still works.
    ///
    /// # Errors
    /// What it reported outside of any call.
    pub fn check(&self) -> Result<(), Error> {
        let fault = self.fault.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        fault.as_ref().map_or(Ok(()), |message| Err(Error::Lost(message.clone())))
    }

    /// Waits until the device has done all that was submitted.
    ///
    /// # Errors
    /// The device is lost.
    pub fn wait(&self) -> Result<(), Error> {
        let waited = self.device.poll(wgpu::PollType::wait_indefinitely());
        waited.map_err(|error| Error::Lost(error.to_string()))?;
        self.check()
    }

    /// Reads a buffer that may be mapped.
    ///
    /// # Errors
    /// The device is lost.
    pub fn read(&self, buffer: &wgpu::Buffer) -> Result<Vec<u8>, Error> {
        let slice = buffer.slice(..);
        slice.map_async(wgpu::MapMode::Read, |_| {});
        self.wait()?;
        let bytes = slice.get_mapped_range().map_err(|error| Error::Lost(error.to_string()))?.to_vec();
        buffer.unmap();
        Ok(bytes)
    }
}
