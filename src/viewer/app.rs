//! The event loop: what the window system says, to commands and frames.

use std::time::{Duration, Instant};

use winit::application::ApplicationHandler;
use winit::dpi::PhysicalSize;
use winit::event::{ElementState, KeyEvent, MouseButton, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop, EventLoopProxy};
use winit::window::{Window, WindowAttributes, WindowId};

use crate::components::Snapshot;

use super::command::Command;
use super::commands::Then;
use super::context::ContextError;
use super::files::Occasion;
use super::held::drag;
use super::keys::{self, Modifiers};
use super::panel::{PanelState, Request, Status, show, show_overlay, show_strip};
use super::pointer::Pointer;
use super::report::Happened;
use super::screen::Screen;
use super::session::Session;
use super::watch::Watch;
use super::{Viewer, ViewerError};

/// How long a file must be quiet before it is read: editors write in several steps.
const SETTLED: Duration = Duration::from_millis(80);
/// Pixels along each side of a window for a picture that is too large for a screen.
const LARGEST: u32 = 1024;

/// What other threads tell the event loop.
#[derive(Clone, Copy, Debug)]
enum Told {
    /// There is a new picture, or news of one.
    Traced,
    /// The scene file may have changed.
    FileChanged,
}

/// Opens the window of a viewer and stays until it is closed.
pub(super) fn run(viewer: Viewer) -> Result<(), ViewerError> {
    let no_display = |error: winit::error::EventLoopError| ViewerError::NoDisplay(error.to_string());
    let event_loop = EventLoop::<Told>::with_user_event().build().map_err(no_display)?;
    let mut app = App::new(viewer, &event_loop.create_proxy())?;
    event_loop.run_app(&mut app).map_err(no_display)?;
    app.error.map_or(Ok(()), Err)
}

struct App {
    // GL goes first, while its window still stands.
    screen: Option<Screen>,
    _watch: Option<Watch>,
    session: Session,
    panel: PanelState,
    pointer: Pointer,
    modifiers: Modifiers,
    started: Instant,
    /// When the scene file is to be read again.
    reload_at: Option<Duration>,
    /// When the panel wants another frame.
    panel_at: Option<Duration>,
    /// How long the last frame took.
    frame: Duration,
    is_ready: bool,
    error: Option<ViewerError>,
}

impl App {
    fn new(viewer: Viewer, proxy: &EventLoopProxy<Told>) -> Result<Self, ViewerError> {
        // A loop that has ended hears nothing more, and need not.
        let tell = |told: Told| {
            let proxy = proxy.clone();
            move || {
                let _ = proxy.send_event(told);
            }
        };
        let file = viewer.file.clone();
        let mut session = Session::new(viewer, tell(Told::Traced))?;
        let watch = file.and_then(|file| match Watch::new(&file, tell(Told::FileChanged)) {
            Ok(watch) => Some(watch),
            Err(error) => {
                session.refuse("watch", &format!("changes of the scene file will not be seen: {error}"));
                None
            }
        });
        Ok(Self {
            screen: None,
            _watch: watch,
            session,
            panel: PanelState::default(),
            pointer: Pointer::default(),
            modifiers: Modifiers::default(),
            started: Instant::now(),
            reload_at: None,
            panel_at: None,
            frame: Duration::ZERO,
            is_ready: false,
            error: None,
        })
    }

    fn now(&self) -> Duration {
        self.started.elapsed()
    }

    fn attributes(&self) -> WindowAttributes {
        let Snapshot { pixels, .. } = *self.session.world.resource();
        let side = pixels.clamp(1, LARGEST);
        Window::default_attributes()
            .with_title(format!("{} - archetrace", self.session.scene.name))
            .with_inner_size(PhysicalSize::new(side, side))
    }

    /// Ends the loop with an error.
    fn fail(&mut self, event_loop: &ActiveEventLoop, error: impl Into<ViewerError>) {
        self.error = Some(error.into());
        event_loop.exit();
    }

    fn redraw(&self) {
        if let Some(screen) = &self.screen {
            screen.window().request_redraw();
        }
    }

    fn resized(&mut self) {
        let Some(screen) = &self.screen else { return };
        screen.resize();
        self.session.side = screen.side();
        let [width, height] = screen.size();
        if self.is_ready {
            let side = screen.side();
            self.session.report.event(&Happened::Resized { width, height, side });
        }
        self.redraw();
    }

    fn frame(&mut self, event_loop: &ActiveEventLoop) {
        let now = self.now();
        let Some(screen) = &mut self.screen else { return };
        let (session, panel) = (&mut self.session, &mut self.panel);
        let status = session.status(self.frame);
        let mut requests = Vec::new();
        let calm = screen.run_panel(|ui| requests.extend(show_panel(ui, session, &status, panel)));
        let is_asked = !requests.is_empty();
        let closes = requests.into_iter().any(|request| session.answer(request) == Then::Close);
        if closes {
            event_loop.exit();
        }
        session.side = screen.side();
        session.update(now);
        let drawn = screen.draw(session);
        let until = session.messages.expire(now);
        self.panel_at = [now.checked_add(calm), until].into_iter().flatten().min();
        self.frame = self.now() - now;
        match drawn {
            Ok(()) => self.tell_ready(),
            Err(ContextError::Lost) => self.recover(event_loop),
            Err(error) => self.fail(event_loop, error),
        }
        if is_asked {
            self.redraw();
        }
    }

    fn tell_ready(&mut self) {
        if let Some(screen) = self.screen.as_ref().filter(|_| !self.is_ready) {
            let [width, height] = screen.size();
            let side = screen.side();
            self.is_ready = true;
            self.session.report.event(&Happened::Ready { width, height, side });
        }
    }

    /// Goes on in a new GL context: everything that is drawn can be drawn again from the World.
    fn recover(&mut self, event_loop: &ActiveEventLoop) {
        match self.screen.take().map(Screen::reopen) {
            Some(Ok(screen)) => {
                self.screen = Some(screen);
                self.session.refined.draw_again();
                self.redraw();
            }
            Some(Err(error)) => self.fail(event_loop, error),
            None => {}
        }
    }

    fn key(&mut self, event_loop: &ActiveEventLoop, event: &KeyEvent) {
        let now = self.now();
        let stroke = keys::read(event, self.modifiers);
        if !stroke.down {
            let rest = self.session.held.release(stroke.key, now);
            self.session.ask(rest);
            return self.redraw();
        }
        match stroke.command {
            None => {}
            Some(Command::Camera(step)) => {
                let first = self.session.held.press(stroke.key, step, now);
                self.session.ask(first);
            }
            Some(_) if stroke.again => {}
            Some(command) => self.command(event_loop, command),
        }
        self.redraw();
    }

    fn command(&mut self, event_loop: &ActiveEventLoop, command: Command) {
        if self.session.command(command) == Then::Close {
            event_loop.exit();
        }
    }

    fn button(&mut self, state: ElementState) {
        match state {
            ElementState::Pressed if self.is_over_scene() => self.pointer.pressed(),
            ElementState::Pressed => {}
            ElementState::Released => {
                let clicked = self.pointer.released().zip(self.screen.as_ref());
                if let Some(pixel) = clicked.and_then(|(at, screen)| screen.pixel_at(at)) {
                    self.session.select_at(pixel);
                    self.redraw();
                }
            }
        }
    }

    fn moved(&mut self, to: (f64, f64)) {
        if let Some((right, down)) = self.pointer.moved(to)
            && let Some((_, lens)) = self.session.camera()
        {
            let side = f64::from(self.session.side.max(1));
            self.session.ask(drag(right, down, &lens, side));
            self.redraw();
        }
    }

    fn wheel(&mut self, lines: f64) {
        if self.is_over_scene() {
            let step = self.session.held.wheel(lines);
            self.session.ask([step]);
            self.redraw();
        }
    }

    fn modifiers_changed(&mut self, modifiers: Modifiers) {
        self.modifiers = modifiers;
        let now = self.now();
        let moves = self.session.held.set_speed(modifiers.speed(), now);
        self.session.ask(moves);
    }

    fn is_over_scene(&self) -> bool {
        self.screen.as_ref().is_some_and(|screen| !screen.is_panel_at(self.pointer.at()))
    }
}

impl ApplicationHandler<Told> for App {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.screen.is_some() {
            return;
        }
        match Screen::open(event_loop, self.attributes()) {
            Ok(screen) => {
                self.screen = Some(screen);
                self.resized();
            }
            Err(error) => self.fail(event_loop, error),
        }
    }

    fn user_event(&mut self, _: &ActiveEventLoop, told: Told) {
        match told {
            Told::Traced => self.redraw(),
            Told::FileChanged => self.reload_at = Some(self.now() + SETTLED),
        }
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        let Some(screen) = &mut self.screen else { return };
        let is_kept = screen.offer(&event);
        match event {
            WindowEvent::CloseRequested => event_loop.exit(),
            WindowEvent::RedrawRequested => self.frame(event_loop),
            WindowEvent::Resized(_) | WindowEvent::ScaleFactorChanged { .. } => self.resized(),
            WindowEvent::Occluded(false) => self.redraw(),
            WindowEvent::ModifiersChanged(modifiers) => self.modifiers_changed(modifiers.state().into()),
            WindowEvent::CursorMoved { position, .. } => self.moved((position.x, position.y)),
            WindowEvent::Focused(false) => {
                self.session.held.clear();
                self.pointer.cancel();
            }
            WindowEvent::KeyboardInput { event, is_synthetic, .. } => {
                // What is let go ends its motion, whoever has the focus by then. What was pressed in another window is
                // made up for this one when it gets the focus, and means nothing here.
                let is_release = event.state == ElementState::Released;
                if is_release || !(is_kept || is_synthetic) {
                    self.key(event_loop, &event);
                }
            }
            WindowEvent::MouseInput { state, button: MouseButton::Left, .. } => self.button(state),
            WindowEvent::MouseWheel { delta, .. } => self.wheel(keys::wheel_lines(delta)),
            _ => {}
        }
    }

    fn about_to_wait(&mut self, event_loop: &ActiveEventLoop) {
        let now = self.now();
        if self.reload_at.is_some_and(|at| at <= now) {
            self.reload_at = None;
            self.session.reload(Occasion::Changed);
            self.redraw();
        }
        if self.session.is_moving(now) || self.panel_at.is_some_and(|at| at <= now) {
            self.panel_at = None;
            self.redraw();
        }
        let moves_from = self.session.held.moves_from();
        let next = [self.reload_at, self.panel_at, moves_from].into_iter().flatten().min();
        event_loop.set_control_flow(match next.and_then(|at| self.started.checked_add(at)) {
            Some(at) => ControlFlow::WaitUntil(at),
            None => ControlFlow::Wait,
        });
    }
}

/// The panel if it is open, and what is shown over the scene in any case.
fn show_panel(
    ui: &mut egui::Ui,
    session: &mut Session,
    status: &Status,
    state: &mut PanelState,
) -> Vec<Request> {
    let mut requests = show_overlay(ui.ctx(), status);
    if session.switches.panel {
        requests.extend(show(ui, &mut session.world, &mut session.editor, status, state));
    }
    requests.extend(show_strip(ui, &mut session.world, &mut session.editor, status));
    requests
}
