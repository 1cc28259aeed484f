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

#[cfg(test)]
mod tests {
    use glutin::prelude::NotCurrentGlContext;
    use glutin::surface::{PbufferSurface, SurfaceAttributesBuilder};

    use super::*;
    use crate::components::{CameraPose, Lens};
    use crate::preview::{DrawList, Layout, PreviewStyle};

    const BACKGROUND: [u8; 3] = [51, 102, 153];
    const WINDOW: [u32; 2] = [60, 40];

    /// A renderer whose context has a window that nobody sees, and what must outlive it.
    fn with_window() -> (Renderer, impl Drop) {
        let device = Device::query_devices().unwrap().last().unwrap();
        // SAFETY: as in `Headless::on`.
        let display = unsafe { Display::with_device(&device, None) }.unwrap();
        let template = ConfigTemplateBuilder::new().with_surface_type(ConfigSurfaceTypes::PBUFFER).build();
        // SAFETY: as in `Headless::on`.
        let config = unsafe { display.find_configs(template) }.unwrap().next().unwrap();
        let attributes = ContextAttributesBuilder::new()
            .with_context_api(ContextApi::OpenGl(Some(Version::new(3, 3))))
            .with_profile(GlProfile::Core)
            .build(None);
        let [width, height] = WINDOW.map(|pixels| pixels.try_into().unwrap());
        let surface = SurfaceAttributesBuilder::<PbufferSurface>::new().build(width, height);
        // SAFETY: the attributes name no window.
        let surface = unsafe { display.create_pbuffer_surface(&config, &surface) }.unwrap();
        // SAFETY: the attributes name no window.
        let context = unsafe { display.create_context(&config, &attributes) }.unwrap();
        let context = context.make_current(&surface).unwrap();
        // SAFETY: the context is current, and the test lets go of it last.
        let gl = unsafe { load_context(|name| display.get_proc_address(name).cast()) }.unwrap();
        (Renderer::new(gl).unwrap(), Kept(Box::new((context, surface))))
    }

    /// Held until the end of a test.
    struct Kept(#[expect(dead_code, reason = "it is only dropped")] Box<dyn core::any::Any>);

    impl Drop for Kept {
        fn drop(&mut self) {}
    }

    fn draw_nothing(renderer: &mut Renderer, side: u32) {
        let lens = Lens { near: 1.0, far: 10.0, fovy: 60.0, aspect: 1.0 };
        let style = PreviewStyle { background: [0.2, 0.4, 0.6], ..PreviewStyle::default() };
        renderer.draw(&DrawList::default(), &CameraPose::default(), &lens, &style, side).unwrap();
    }

    /// A traced picture of four coloured quarters: upper left, upper right, lower left, lower right.
    const QUARTERS: [[u8; 3]; 4] = [[255, 0, 0], [0, 255, 0], [0, 0, 255], [255, 255, 255]];

    fn row_of(window: &[u8], row: usize) -> Vec<[u8; 3]> {
        window.as_chunks::<3>().0.chunks(60).nth(row).unwrap().to_vec()
    }

    #[test]
    fn pictures_lie_upright_in_the_middle_of_the_window_whatever_others_have_set() {
        let (mut renderer, _kept) = with_window();
        renderer.spoil();
        draw_nothing(&mut renderer, 40);
        renderer.show_picture(2, QUARTERS.as_flattened());
        for layout in [Layout::Preview, Layout::Traced, Layout::Split] {
            renderer.spoil();
            renderer.present(WINDOW, layout);
            let window = renderer.read_window(WINDOW);
            for row in 0..40 {
                let row_of = row_of(&window, row);
                let [left, right] = if row < 20 { [0, 1] } else { [2, 3] }.map(|at| QUARTERS[at]);
                let expected = match layout {
                    Layout::Preview => [BACKGROUND, BACKGROUND],
                    Layout::Traced => [left, right],
                    Layout::Split => [BACKGROUND, right],
                };
                let around = row_of[0];
                assert!(around.iter().all(|&level| level < 30), "{around:?}");
                assert_eq!(row_of[..10], [around; 10]);
                assert_eq!(row_of[50..], [around; 10]);
                assert_eq!(row_of[10..30], [expected[0]; 20], "{layout:?}, row {row}");
                assert_eq!(row_of[31..50], [expected[1]; 19], "{layout:?}, row {row}");
                let divided = row_of[30] != expected[1];
                assert_eq!(divided, layout == Layout::Split, "{layout:?}, row {row}");
            }
        }
    }

    #[test]
    fn a_picture_that_is_not_there_is_replaced_by_the_other() {
        let (mut renderer, _kept) = with_window();
        let middle = |renderer: &Renderer, layout| {
            renderer.present(WINDOW, layout);
            row_of(&renderer.read_window(WINDOW), 5)[45]
        };
        assert!(middle(&renderer, Layout::Split).iter().all(|&level| level < 30));
        draw_nothing(&mut renderer, 16);
        for layout in [Layout::Preview, Layout::Traced, Layout::Split] {
            assert_eq!(middle(&renderer, layout), BACKGROUND, "{layout:?}");
        }
        renderer.show_picture(2, QUARTERS.as_flattened());
        assert_eq!(middle(&renderer, Layout::Traced), QUARTERS[1]);
        // Bytes that make no picture of that side.
        renderer.show_picture(3, QUARTERS.as_flattened());
        assert_eq!(middle(&renderer, Layout::Traced), BACKGROUND);
    }

    #[test]
    fn a_window_without_area_and_a_picture_without_pixels_are_survived() {
        let (mut renderer, _kept) = with_window();
        renderer.present([0, 40], Layout::Split);
        renderer.show_picture(0, &[]);
        let lens = Lens { near: 1.0, far: 10.0, fovy: 60.0, aspect: 1.0 };
        for side in [0, 1 << 20] {
            let style = PreviewStyle::default();
            let drawn = renderer.draw(&DrawList::default(), &CameraPose::default(), &lens, &style, side);
            assert!(matches!(drawn, Err(GlError::Size { .. })), "{drawn:?}");
        }
        draw_nothing(&mut renderer, 8);
        assert_eq!(renderer.read(), BACKGROUND.repeat(64));
    }
}
