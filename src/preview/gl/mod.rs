//! Draws a [`DrawList`] with OpenGL 3.3. The only place that names glow.
//!
//! Nothing here knows a window: [`load_context`] takes the functions of a context that somebody else made current, and
//! that somebody keeps it current on this thread for as long as anything made from it is alive.
#![expect(unsafe_code, reason = "every function of GL is foreign")]

mod boards;
mod error;
mod instances;
mod program;
mod screen;
mod sources;
mod state;
mod target;
mod texture;

use core::ffi::{CStr, c_void};
use core::marker::PhantomData;
use std::sync::Arc;

use glow::HasContext;

use crate::components::{CameraPose, Lens};

use super::view::View;
use super::{DrawList, Layout, PreviewStyle};
use boards::Boards;
use error::{check, forget};
use instances::Instances;
use program::{Program, Value, ViewBlock};
use screen::Screen;
use target::Target;
use texture::Texture;

pub use error::GlError;

/// The functions of a GL context.
pub type Context = glow::Context;

/// The oldest version that will do.
const OLDEST: (u32, u32) = (3, 3);

/// Corners of the strips that hide a sphere or marker, a line, and a cube or pyramid.
const SQUARE: i32 = 4;
const BOX: i32 = 14;

/// Widths in pixels.
const LINE_WIDTH: f32 = 1.6;
const MARKER_RADIUS: f32 = 5.0;

/// Loads the functions of the current context by name, and refuses a context below OpenGL 3.3.
///
/// # Safety
///
/// `loader` must give the functions of the context that is current on this thread, and that context must stay current
/// here as long as the result or a [`Renderer`] made from it is used or dropped.
pub unsafe fn load_context(loader: impl FnMut(&CStr) -> *const c_void) -> Result<Arc<Context>, GlError> {
    // SAFETY: promised by the caller.
    let gl = unsafe { Context::from_loader_function_cstr(loader) };
    let version = gl.version();
    if version.is_embedded || (version.major, version.minor) < OLDEST {
        // SAFETY: promised by the caller.
        let found = unsafe { gl.get_parameter_string(glow::VERSION) };
        return Err(GlError::Version(found));
    }
    Ok(Arc::new(gl))
}

/// Draws lists into a picture of its own, and pictures into a window.
pub struct Renderer {
    spheres: Drawer<3>,
    solids: Drawer<5>,
    markers: Drawer<3>,
    line: Program,
    cones: Instances<5>,
    axes: Instances<5>,
    outline: Instances<5>,
    boards: Boards,
    screen: Screen,
    view: ViewBlock,
    target: Option<Target>,
    traced: Option<Texture>,
    fills: u64,
    gl: Arc<Context>,
    /// A context is current on one thread.
    _here: PhantomData<*const ()>,
}

/// A program and the instances that it draws.
struct Drawer<const N: usize> {
    program: Program,
    instances: Instances<N>,
}

impl<const N: usize> Drawer<N> {
    fn new(gl: &Arc<Context>, what: &'static str, [vertex, fragment]: [String; 2]) -> Result<Self, GlError> {
        Ok(Self { program: Program::new(gl, what, &vertex, &fragment)?, instances: Instances::new(gl)? })
    }
}

impl Renderer {
    /// Compiles the shaders.
    pub fn new(gl: Arc<Context>) -> Result<Self, GlError> {
        forget(&gl);
        let [line_vertex, line_fragment] = sources::line();
        Ok(Self {
            spheres: Drawer::new(&gl, "the spheres' program", sources::sphere())?,
            solids: Drawer::new(&gl, "the program of cubes and pyramids", sources::solid())?,
            markers: Drawer::new(&gl, "the lights' program", sources::marker())?,
            line: Program::new(&gl, "the lines' program", &line_vertex, &line_fragment)?,
            cones: Instances::new(&gl)?,
            axes: Instances::new(&gl)?,
            outline: Instances::new(&gl)?,
            boards: Boards::new(&gl)?,
            screen: Screen::new(&gl)?,
            view: ViewBlock::new(&gl)?,
            target: None,
            traced: None,
            fills: 0,
            gl,
            _here: PhantomData,
        })
    }

    /// Draws the list as the camera sees it, into a picture of `side` by `side` pixels that stays in GL. Buffers are
    /// filled from those parts of the list alone that are not the ones of the picture before.
    pub fn draw(
        &mut self,
        list: &DrawList,
        pose: &CameraPose,
        lens: &Lens,
        style: &PreviewStyle,
        side: u32,
    ) -> Result<(), GlError> {
        forget(&self.gl);
        self.fill(list)?;
        let target = match self.target.take() {
            Some(target) if target.suits(side, style.samples) => target,
            _ => Target::new(&self.gl, side, style.samples)?,
        };
        let view = View::new(pose, lens, side);
        self.view.fill(&view.to_bytes());
        target.bind();
        state::begin(&self.gl, target.side(), style.background);
        self.draw_objects(list, &view, target.samples());
        self.draw_signs(style);
        state::end(&self.gl);
        target.finish();
        state::leave(&self.gl);
        self.target = Some(target);
        check(&self.gl)
    }

    /// How many buffers and textures have been filled so far: none by a picture of an unchanged list.
    pub fn fills(&self) -> u64 {
        self.fills
    }

    /// The picture drawn last: red, green, blue, 8 bits each, top row first. Empty before there is one.
    pub fn read(&self) -> Vec<u8> {
        self.target.as_ref().map(Target::read).unwrap_or_default()
    }

    /// Takes a traced picture to be shown: `side` by `side` pixels of red, green, blue, top row first. Bytes that do
    /// not fit the side, or a side that GL cannot hold, take away the picture there was.
    pub fn show_picture(&mut self, side: u32, rgb: &[u8]) {
        forget(&self.gl);
        let area = u64::from(side) * u64::from(side) * 3;
        let pixels = i32::try_from(side).ok().filter(|_| side > 0 && u64::try_from(rgb.len()) == Ok(area));
        self.traced = pixels.and_then(|side| self.uploaded(side, rgb));
        state::leave(&self.gl);
    }

    fn uploaded(&mut self, side: i32, rgb: &[u8]) -> Option<Texture> {
        let texture = self.traced.take().or_else(|| Texture::empty(&self.gl, 1).ok())?;
        texture.bind(0);
        texture.upload(side, side, Some(rgb));
        check(&self.gl).is_ok().then_some(texture)
    }

    /// Shows the pictures in the middle of a window of this size in pixels, and clears the rest. GL is left as anybody
    /// would find it who draws on top.
    pub fn present(&self, window: [u32; 2], layout: Layout) {
        let size = window.map(|pixels| i32::try_from(pixels).unwrap_or(i32::MAX));
        if size.contains(&0) {
            return;
        }
        state::flat(&self.gl);
        let preview = self.target.as_ref().map(|target| &target.picture);
        self.screen.show(size, layout, preview, self.traced.as_ref());
        state::leave(&self.gl);
    }

    fn fill(&mut self, list: &DrawList) -> Result<(), GlError> {
        let filled = [
            self.spheres.instances.fill(&list.spheres)?,
            self.solids.instances.fill(&list.solids.rows)?,
            self.markers.instances.fill(&list.markers)?,
            self.cones.fill(&list.cones)?,
            self.axes.fill(&list.axes)?,
            self.outline.fill(&list.outline)?,
        ];
        self.fills += filled.into_iter().map(u64::from).sum::<u64>() + self.boards.load(&list.boards)?;
        Ok(())
    }

    /// Bodies and boards. What is drawn first keeps its pixel against what comes at the same depth, so solids and boards
    /// take turns in their common order, and at the same order a board comes last.
    fn draw_objects(&self, list: &DrawList, view: &View, samples: i32) {
        self.spheres.program.bind();
        self.spheres.instances.draw(SQUARE, self.spheres.instances.all());
        let mut drawn = 0;
        for board in &list.boards {
            let until = list.solids.order.partition_point(|&order| order <= board.order);
            self.draw_solids(drawn..until);
            drawn = until;
            self.boards.draw(board, view, samples, &self.screen);
        }
        self.draw_solids(drawn..list.solids.order.len());
    }

    fn draw_solids(&self, rows: core::ops::Range<usize>) {
        self.solids.program.bind();
        state::cull_fronts(&self.gl, true);
        self.solids.instances.draw(BOX, rows);
        state::cull_fronts(&self.gl, false);
    }

    /// What is no object: lights, axes, the box around what is selected.
    fn draw_signs(&self, style: &PreviewStyle) {
        if style.lights {
            self.markers.program.bind();
            self.markers.program.set("radius", Value::Float(MARKER_RADIUS));
            self.markers.instances.draw(SQUARE, self.markers.instances.all());
        }
        self.line.bind();
        self.line.set("width", Value::Float(LINE_WIDTH));
        let switched = [(style.lights, &self.cones), (style.axes, &self.axes), (true, &self.outline)];
        for (_, lines) in switched.iter().filter(|(shown, _)| *shown) {
            lines.draw(SQUARE, lines.all());
        }
    }
}
