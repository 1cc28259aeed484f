//! A window with a GL context of its own. What is platform-specific about that is glutin's; nobody else names it.
#![expect(unsafe_code, reason = "GL contexts are made from raw window handles, and functions loaded by name")]

use std::num::NonZeroU32;
use std::sync::Arc;

use glutin::config::{Config, ConfigTemplateBuilder};
use glutin::context::{
    ContextApi, ContextAttributesBuilder, GlProfile, NotCurrentGlContext, PossiblyCurrentContext, Version,
};
use glutin::display::{GetGlDisplay, GlDisplay};
use glutin::error::ErrorKind;
use glutin::surface::{GlSurface, Surface, SwapInterval, WindowSurface};
use glutin_winit::{DisplayBuilder, GlWindow};
use raw_window_handle::HasWindowHandle;
use thiserror::Error;
use winit::event_loop::ActiveEventLoop;
use winit::window::{Window, WindowAttributes};

use crate::preview::gl::{Context, GlError, load_context};

/// What to do where there is no window to be had.
const ADVICE: &str = "`archetrace render` traces without a display, `archetrace preview` draws without one";

/// Why there is no window, or none any more.
#[derive(Debug, Error)]
pub(super) enum ContextError {
    /// No window, no matching configuration, or no context.
    #[error("cannot open a window with OpenGL 3.3: {0} ({ADVICE})")]
    Open(String),
    /// The context is too old or lacks something.
    #[error(transparent)]
    Gl(#[from] GlError),
    /// The driver took the context away.
    #[error("the OpenGL context was lost")]
    Lost,
    /// A finished frame could not be shown.
    #[error("cannot show a frame: {0}")]
    Swap(String),
}

/// A context that draws into a window. The fields are dropped in this order: GL objects first, the window last.
pub(super) struct WindowContext {
    gl: Arc<Context>,
    surface: Surface<WindowSurface>,
    context: PossiblyCurrentContext,
    config: Config,
    window: Arc<Window>,
}

impl WindowContext {
    /// Opens a window with an OpenGL context of version 3.3 or later.
    pub(super) fn open(
        event_loop: &ActiveEventLoop,
        attributes: WindowAttributes,
    ) -> Result<Self, ContextError> {
        let open = |reason: &dyn std::fmt::Display| ContextError::Open(reason.to_string());
        let (window, config) = DisplayBuilder::new()
            .with_window_attributes(Some(attributes))
            .build(event_loop, ConfigTemplateBuilder::new(), pick)
            .map_err(|error| open(&error))?;
        let window = Arc::new(window.ok_or_else(|| open(&"no window was made"))?);
        Self::on(window, config)
    }

    /// A new context for the same window, after the old one was lost.
    pub(super) fn reopen(self) -> Result<Self, ContextError> {
        let (window, config) = (self.window.clone(), self.config.clone());
        drop(self);
        Self::on(window, config)
    }

    fn on(window: Arc<Window>, config: Config) -> Result<Self, ContextError> {
        let open = |error: glutin::error::Error| ContextError::Open(error.to_string());
        let unusable = |error: raw_window_handle::HandleError| ContextError::Open(error.to_string());
        let handle = window.window_handle().map_err(unusable)?.as_raw();
        let attributes = ContextAttributesBuilder::new()
            .with_context_api(ContextApi::OpenGl(Some(Version::new(3, 3))))
            .with_profile(GlProfile::Core)
            .build(Some(handle));
        let display = config.display();
        // SAFETY: the handle is that of a window that outlives the context: `Self` drops it last.
        let context = unsafe { display.create_context(&config, &attributes) }.map_err(open)?;
        let attributes = window.build_surface_attributes(<_>::default()).map_err(unusable)?;
        // SAFETY: as above, and the window has a size: winit makes none without.
        let surface = unsafe { display.create_window_surface(&config, &attributes) }.map_err(open)?;
        let context = context.make_current(&surface).map_err(open)?;
        // Frames at the rate of the display, where the platform can do that; it only saves work.
        let _ = surface.set_swap_interval(&context, SwapInterval::Wait(NonZeroU32::MIN));
        // SAFETY: the context is current on this thread, and stays so until `Self` is dropped, of which `gl` goes first.
        let gl = unsafe { load_context(|name| display.get_proc_address(name).cast()) }?;
        Ok(Self { gl, surface, context, config, window })
    }

    /// The loaded GL functions.
    pub(super) fn gl(&self) -> &Arc<Context> {
        &self.gl
    }

    /// The window.
    pub(super) fn window(&self) -> &Arc<Window> {
        &self.window
    }

    /// Fits the surface to the window. A window without any area keeps its last surface.
    pub(super) fn resize(&self) {
        self.window.resize_surface(&self.surface, &self.context);
    }

    /// Shows what was drawn.
    pub(super) fn swap(&self) -> Result<(), ContextError> {
        self.surface.swap_buffers(&self.context).map_err(|error| match error.error_kind() {
            ErrorKind::ContextLost => ContextError::Lost,
            _ => ContextError::Swap(error.to_string()),
        })
    }
}

/// The configuration with the fewest samples: smoothing is done in a buffer of the preview's own.
#[expect(
    clippy::expect_used,
    reason = "the picker cannot say that there is none, and a display that shows windows has one"
)]
fn pick(configs: Box<dyn Iterator<Item = Config> + '_>) -> Config {
    use glutin::config::GlConfig;
    configs.min_by_key(GlConfig::num_samples).expect("glutin offers at least one configuration")
}
