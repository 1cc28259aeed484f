//! The window's picture: preview, traced picture, and the panel over them.

use std::sync::Arc;

use egui::{ClippedPrimitive, TexturesDelta, ViewportId};
use egui_glow::Painter;
use winit::event::WindowEvent;
use winit::event_loop::ActiveEventLoop;
use winit::window::{Window, WindowAttributes};

use crate::preview::gl::Renderer;
use crate::preview::{Layout, PreviewStyle};
use crate::systems::Drawn;

use super::context::{ContextError, WindowContext};
use super::panel::apply_theme;
use super::session::Session;

/// A window that frames are drawn into.
pub(super) struct Screen {
    renderer: Renderer,
    panel: PanelPainter,
    context: WindowContext,
}

/// The panel's input from the window, and its way onto it.
struct PanelPainter {
    context: egui::Context,
    input: egui_winit::State,
    painter: Painter,
    primitives: Vec<ClippedPrimitive>,
    textures: TexturesDelta,
    pixels_per_point: f32,
    /// Pixels from the right that the panel takes.
    width: u32,
}

impl Screen {
    /// Opens a window.
    pub(super) fn open(
        event_loop: &ActiveEventLoop,
        attributes: WindowAttributes,
    ) -> Result<Self, ContextError> {
        Self::on(WindowContext::open(event_loop, attributes)?)
    }

    /// Starts again in the same window, after its GL context was lost.
    pub(super) fn reopen(self) -> Result<Self, ContextError> {
        let Self { renderer, panel, context } = self;
        drop(renderer);
        drop(panel);
        Self::on(context.reopen()?)
    }

    fn on(context: WindowContext) -> Result<Self, ContextError> {
        let renderer = Renderer::new(context.gl().clone())?;
        let panel = PanelPainter::new(&context)?;
        Ok(Self { renderer, panel, context })
    }

    /// The window.
    pub(super) fn window(&self) -> &Arc<Window> {
        self.context.window()
    }

    /// Width and height in pixels.
    pub(super) fn size(&self) -> [u32; 2] {
        self.window().inner_size().into()
    }

    /// Width and height in pixels of what the panel leaves free, at the left.
    fn free(&self) -> [u32; 2] {
        let [width, height] = self.size();
        [width.saturating_sub(self.panel.width), height]
    }

    /// Pixels along each side of the picture, which lies in the middle of what is free.
    pub(super) fn side(&self) -> u32 {
        let [width, height] = self.free();
        width.min(height)
    }

    /// The pixel of the picture that a position in the window shows.
    pub(super) fn pixel_at(&self, (x, y): (f64, f64)) -> Option<(u32, u32)> {
        let [width, height] = self.free();
        let side = width.min(height);
        Some((index(x, (width - side) / 2, side)?, index(y, (height - side) / 2, side)?))
    }

    /// Fits what is drawn to the window.
    pub(super) fn resize(&self) {
        self.context.resize();
    }

    /// Lets the panel see an event. Returns whether it keeps the event to itself, as what is typed into a field.
    pub(super) fn offer(&mut self, event: &WindowEvent) -> bool {
        let response = self.panel.input.on_window_event(self.context.window(), event);
        if response.repaint {
            self.window().request_redraw();
        }
        response.consumed
    }

    /// Whether the panel, or something else over the scene, lies at a position in the window.
    pub(super) fn is_panel_at(&self, (x, y): (f64, f64)) -> bool {
        let [free, _] = self.free();
        x >= f64::from(free) || self.panel.is_something_at(x, y)
    }

    /// Runs the panel. Returns how long it can stay as it is.
    pub(super) fn run_panel(&mut self, show: impl FnMut(&mut egui::Ui)) -> std::time::Duration {
        self.panel.run(self.context.window(), show)
    }

    /// Draws a frame and shows it. A window without any area shows nothing.
    pub(super) fn draw(&mut self, session: &mut Session) -> Result<(), ContextError> {
        let size = self.size();
        if self.side() == 0 {
            return Ok(());
        }
        let mode = session.shown_mode();
        if mode != Layout::Traced {
            self.draw_preview(session)?;
        }
        if let Some(traced) = session.refined.take_undrawn() {
            self.renderer.show_picture(traced.side, &traced.rgb8);
        }
        self.renderer.present(self.free(), mode);
        self.panel.paint(size);
        self.context.swap()
    }

    fn draw_preview(&mut self, session: &mut Session) -> Result<(), ContextError> {
        let Some((pose, lens)) = session.camera() else { return Ok(()) };
        let style = PreviewStyle {
            lights: session.switches.lights,
            axes: session.switches.axes,
            ..PreviewStyle::default()
        };
        let outline = session.outline();
        let list = &mut session.world.resource_mut::<Drawn>().into_inner().0;
        list.set_outline(outline);
        Ok(self.renderer.draw(list, &pose, &lens, &style, self.side())?)
    }
}

/// The pixel at a distance from the window's edge, if it lies in the picture.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "truncation tells the pixel, and the number lies within the picture"
)]
fn index(at: f64, start: u32, side: u32) -> Option<u32> {
    let within = at - f64::from(start);
    (0.0..f64::from(side)).contains(&within).then_some(within as u32)
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a width of some pixels, at least 0"
)]
fn pixels(width: f32) -> u32 {
    width.max(0.0).round() as u32
}

impl PanelPainter {
    fn new(context: &WindowContext) -> Result<Self, ContextError> {
        let window = context.window();
        let painter = Painter::new(context.gl().clone(), "", None, false)
            .map_err(|error| ContextError::Open(error.to_string()))?;
        let panel = egui::Context::default();
        apply_theme(&panel);
        let input = egui_winit::State::new(
            panel.clone(),
            ViewportId::ROOT,
            window,
            None,
            window.theme(),
            Some(painter.max_texture_side()),
        );
        Ok(Self {
            context: panel,
            input,
            painter,
            primitives: Vec::new(),
            textures: TexturesDelta::default(),
            pixels_per_point: 1.0,
            width: 0,
        })
    }

    fn run(&mut self, window: &Window, mut show: impl FnMut(&mut egui::Ui)) -> std::time::Duration {
        let input = self.input.take_egui_input(window);
        let mut free = 0.0;
        let output = self.context.run_ui(input, |ui| {
            let whole = ui.available_width();
            show(ui);
            free = whole - ui.available_width();
        });
        self.width = pixels(free * output.pixels_per_point);
        self.input.handle_platform_output(window, output.platform_output);
        self.pixels_per_point = output.pixels_per_point;
        self.primitives = self.context.tessellate(output.shapes, output.pixels_per_point);
        self.textures.append(output.textures_delta);
        let viewport = output.viewport_output.get(&ViewportId::ROOT);
        viewport.map_or(std::time::Duration::MAX, |viewport| viewport.repaint_delay)
    }

    /// Whether a window of the panel's crate, such as a message, lies at a position. The panel itself is none.
    #[expect(clippy::cast_possible_truncation, reason = "positions on a screen fit")]
    fn is_something_at(&self, x: f64, y: f64) -> bool {
        let at = egui::pos2(x as f32, y as f32) / self.pixels_per_point;
        let layer = self.context.layer_id_at(at);
        layer.is_some_and(|layer| layer.order != egui::Order::Background)
    }

    fn paint(&mut self, size: [u32; 2]) {
        let mut textures = std::mem::take(&mut self.textures);
        self.painter.paint_and_update_textures(size, self.pixels_per_point, &self.primitives, &mut textures);
    }
}

impl Drop for PanelPainter {
    fn drop(&mut self) {
        self.painter.destroy();
    }
}
