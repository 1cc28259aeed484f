//! The preview without a window or display server: a GL context on an EGL device.
#![expect(unsafe_code, reason = "GL contexts are made from raw handles, and functions loaded by name")]

use glutin::api::egl::context::PossiblyCurrentContext;
use glutin::api::egl::device::Device;
use glutin::api::egl::display::Display;
use glutin::config::{Api, ConfigSurfaceTypes, ConfigTemplateBuilder};
use glutin::context::{ContextApi, ContextAttributesBuilder, GlProfile, Version};
use glutin::display::GlDisplay;
use thiserror::Error;

use crate::preview::gl::{GlError, Renderer, load_context};

/// Why nothing can be drawn off screen.
#[derive(Debug, Error)]
pub enum HeadlessError {
    /// There is no EGL, or it can list no devices.
    #[error("cannot draw off screen: no EGL ({0}); {ADVICE}")]
    Library(String),
    /// No device has a context to offer; why the last one did not.
    #[error("cannot draw off screen: no EGL device with OpenGL 3.3 ({0}); {ADVICE}")]
    Device(String),
    /// The context cannot be used.
    #[error(transparent)]
    Gl(#[from] GlError),
}

/// What to do about it.
const ADVICE: &str =
    "install a driver for OpenGL with EGL, such as Mesa's, or use `archetrace render`, which needs neither";

/// A renderer with a context of its own, which belongs to the thread that made it.
pub struct Headless {
    renderer: Renderer,
    context: PossiblyCurrentContext,
}

impl Headless {
    /// Takes the first EGL device with OpenGL 3.3; those that compute in software come last.
    pub fn new() -> Result<Self, HeadlessError> {
        let library = |error: glutin::error::Error| HeadlessError::Library(error.to_string());
        let mut devices: Vec<Device> = Device::query_devices().map_err(library)?.collect();
        devices.sort_by_key(|device| device.extensions().contains("EGL_MESA_device_software"));
        let mut failure = HeadlessError::Device("there is no device".into());
        for device in &devices {
            match Self::on(device) {
                Ok(headless) => return Ok(headless),
                Err(error) => failure = error,
            }
        }
        Err(failure)
    }

    /// The renderer; its context is made current.
    pub fn renderer(&mut self) -> Result<&mut Renderer, HeadlessError> {
        self.context.make_current_surfaceless().map_err(refused)?;
        Ok(&mut self.renderer)
    }

    fn on(device: &Device) -> Result<Self, HeadlessError> {
        let template = ConfigTemplateBuilder::new()
            .with_api(Api::OPENGL)
            .with_surface_type(ConfigSurfaceTypes::empty())
            .build();
        let attributes = ContextAttributesBuilder::new()
            .with_context_api(ContextApi::OpenGl(Some(Version::new(3, 3))))
            .with_profile(GlProfile::Core)
            .build(None);
        // SAFETY: the device comes from EGL itself, and no display server's handle is involved.
        let display = unsafe { Display::with_device(device, None) }.map_err(refused)?;
        // SAFETY: the template names no window.
        let mut configs = unsafe { display.find_configs(template) }.map_err(refused)?;
        let config = configs.next().ok_or_else(|| HeadlessError::Device("no configuration".into()))?;
        // SAFETY: the attributes name no window.
        let context = unsafe { display.create_context(&config, &attributes) }.map_err(refused)?;
        let context = context.make_current_surfaceless().map_err(refused)?;
        // SAFETY: the context is current, and `Self` makes it so again whenever the renderer is used or dropped.
        let gl = unsafe { load_context(|name| display.get_proc_address(name).cast()) }?;
        Ok(Self { renderer: Renderer::new(gl)?, context })
    }
}

impl Drop for Headless {
    fn drop(&mut self) {
        // Before the renderer frees what it has there. A context that is lost has nothing left to be freed.
        let _ = self.context.make_current_surfaceless();
    }
}

fn refused(error: glutin::error::Error) -> HeadlessError {
    HeadlessError::Device(error.to_string())
}
