//! The panel on a session, as the window has it.

use std::fs;
use std::path::PathBuf;
use std::time::Duration;

use bevy_ecs::prelude::*;
use egui::{Context, Event, RawInput, Rect, pos2, vec2};

use super::super::{PanelState, Request, apply_theme, show};
use super::{Folder, folder};
use crate::components::{Checkerboard, Sphere, Texture, Textured};
use crate::preview::Layout;
use crate::scene::{parse, spawn};
use crate::viewer::command::Command;
use crate::viewer::editor::New;
use crate::viewer::live::Shows;
use crate::viewer::session::Session;
use crate::viewer::{Viewer, ViewerOptions};

/// A session on a copy of the official scene, its panel, and a screen for it.
struct Desk {
    session: Session,
    panel: PanelState,
    ctx: Context,
    time: f64,
    folder: Folder,
}

impl Desk {
    fn new() -> Self {
        let folder = folder();
        let file = folder.path().join("room.txt");
        let official = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/official.txt");
        fs::copy(official, &file).unwrap();
        let mut world = World::new();
        spawn(&mut world, &parse(&fs::read_to_string(&file).unwrap()).unwrap().0);
        let image = std::sync::Arc::new(Texture::new(1, 1, vec![[1, 2, 3]]).unwrap());
        let options = ViewerOptions {
            out: folder.path().to_owned(),
            textured: Some(Textured { white: image.clone(), black: image }),
            ..ViewerOptions::default()
        };
        let viewer = Viewer::of_file(&file, world).with_options(options);
        let ctx = Context::default();
        apply_theme(&ctx);
        let session = Session::new(viewer, || ()).unwrap();
        let mut desk = Self { session, panel: PanelState::default(), ctx, time: 0.0, folder };
        desk.frame();
        desk
    }

    fn file(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn frame(&mut self) {
        self.frame_with(Vec::new());
    }

    fn frame_with(&mut self, events: Vec<Event>) {
        self.time += 0.1;
        let screen_rect = Some(Rect::from_min_size(pos2(0.0, 0.0), vec2(1000.0, 800.0)));
        let input = RawInput { screen_rect, events, time: Some(self.time), ..RawInput::default() };
        let status = self.session.status(Duration::ZERO);
        let session = &mut self.session;
        let mut requests = Vec::new();
        let output = self.ctx.run_ui(input, |ui| {
            requests = show(ui, &mut session.world, &mut session.editor, &status, &mut self.panel);
        });
        output.drop_without_applying_deltas();
        assert_eq!(requests, []);
        self.session.update(Duration::from_secs_f64(self.time));
    }

    fn ask(&mut self, request: Request) {
        self.session.answer(request);
        self.frame();
    }
}

#[test]
fn requests_are_performed() {
    let mut desk = Desk::new();
    desk.ask(Request::SetMode(Layout::Split));
    desk.ask(Request::SetShows(Shows::Rays));
    desk.ask(Request::ToggleTexture);
    let switches = desk.session.switches;
    assert_eq!((switches.mode, switches.shows, switches.texture), (Layout::Split, Shows::Rays, true));
    desk.session.editor.add(&mut desk.session.world, New::Sphere);
    let spheres = |desk: &mut Desk| desk.session.world.query::<&Sphere>().iter(&desk.session.world).count();
    assert_eq!(spheres(&mut desk), 3);
    desk.ask(Request::Undo);
    assert_eq!(spheres(&mut desk), 2);
    desk.ask(Request::Redo);
    assert_eq!(spheres(&mut desk), 3);
    desk.ask(Request::Reload);
    assert_eq!(spheres(&mut desk), 2, "the file again");
    assert!(!desk.session.editor.is_modified());
}

#[test]
fn a_scene_is_saved_under_the_name_that_is_offered_and_replaced_only_if_said_so() {
    let mut desk = Desk::new();
    let offered = desk.session.scene.edited_name();
    assert_eq!(offered, desk.file("room-edited.txt"));
    let save = |overwrite| Request::Save { path: offered.clone(), overwrite };
    desk.session.editor.add(&mut desk.session.world, New::Cube);
    desk.ask(save(false));
    assert!(!desk.session.editor.is_modified());
    let first = fs::read_to_string(&offered).unwrap();
    assert_eq!(desk.session.scene.edited_name(), desk.file("room-edited-2.txt"));
    desk.session.editor.add(&mut desk.session.world, New::Cube);
    desk.ask(save(false));
    assert_eq!(fs::read_to_string(&offered).unwrap(), first);
    assert!(desk.session.editor.is_modified());
    desk.ask(save(true));
    assert_ne!(fs::read_to_string(&offered).unwrap(), first);
    assert!(!desk.session.editor.is_modified());
}

#[test]
fn boards_that_come_back_show_images_as_the_switch_says() {
    let mut desk = Desk::new();
    desk.ask(Request::ToggleTexture);
    let textured = |desk: &mut Desk| {
        desk.session.world.query::<(&Checkerboard, &Textured)>().iter(&desk.session.world).count()
    };
    assert_eq!(textured(&mut desk), 1);
    desk.session.command(Command::Reload);
    desk.session.editor.add(&mut desk.session.world, New::Sphere);
    desk.session.command(Command::Reload);
    assert_eq!(textured(&mut desk), 1);
    desk.ask(Request::ToggleTexture);
    desk.ask(Request::Undo);
    assert_eq!(textured(&mut desk), 0);
}

#[test]
fn the_pointer_is_the_scenes_where_there_is_no_panel() {
    let mut desk = Desk::new();
    for (x, is_panels) in [(900.0, true), (300.0, false)] {
        desk.frame_with(vec![Event::PointerMoved(pos2(x, 300.0))]);
        desk.frame();
        assert_eq!(desk.ctx.egui_wants_pointer_input(), is_panels, "at {x}");
    }
}
