//! What the window shows, without a window: the World, the switches, and the pictures traced from it.

use std::path::PathBuf;
use std::time::Duration;

use bevy_ecs::prelude::*;

use crate::components::{CameraInput, CameraMove, CameraPose, FrameTime, Home, Lens, Precision, Textured};
use crate::geometry::Real;
use crate::preview::Layout;
use crate::systems::{Tables, Workers, control_schedule, extract_schedule, list_schedule, prepare};
use crate::trace::CameraEffects;

use super::editor::{Editor, Traced};
use super::fronts::Fronts;
use super::held::Held;
use super::live::Shows;
use super::panel::Messages;
use super::refine::Refined;
use super::report::Report;
use super::scene_file::SceneFile;
use super::selection::{bounds, entity_at};
use super::snapshot::Snapshots;
use super::traced_view::{SharedTables, TracedView};
use super::{Viewer, ViewerError};

/// Everything behind the window.
pub(super) struct Session {
    pub(super) world: World,
    pub(super) editor: Editor,
    pub(super) held: Held,
    pub(super) report: Report,
    pub(super) switches: Switches,
    pub(super) scene: SceneFile,
    pub(super) snapshots: Snapshots,
    /// The command that repeats the picture that is being traced for a file.
    pub(super) recipe: Option<super::files::Recipe>,
    pub(super) messages: Messages,
    /// The picture that was written last.
    pub(super) written: Option<PathBuf>,
    pub(super) workers: Workers,
    /// Images for the texture switch.
    pub(super) textured: Option<Textured>,
    /// Pixels along each side of the square picture in the window.
    pub(super) side: u32,
    pub(super) refined: Refined,
    pub(super) fronts: Fronts,
    /// The number of the last edit that was told of.
    pub(super) told_edit: u64,
    /// The editor's number of arrivals when images were laid on boards last.
    pub(super) arrivals: u64,
    /// When the last frame was, since the window was opened.
    pub(super) now: Duration,
    systems: Option<Schedule>,
    schedules: Schedules,
}

/// What can be switched.
#[derive(Clone, Copy, Debug)]
pub(super) struct Switches {
    pub(super) mode: Layout,
    pub(super) shows: Shows,
    pub(super) texture: bool,
    pub(super) lights: bool,
    pub(super) axes: bool,
    pub(super) panel: bool,
    pub(super) strip: bool,
}

/// The schedules of a frame.
struct Schedules {
    control: Schedule,
    double: Schedule,
    single: Schedule,
    list: Schedule,
}

impl Session {
    /// A session on the World of a viewer. `wake` is called, from any thread, when there is something new to show.
    pub(super) fn new(
        viewer: Viewer,
        wake: impl Fn() + Clone + Send + Sync + 'static,
    ) -> Result<Self, ViewerError> {
        let Viewer { mut world, name, file, systems, has_systems, options } = viewer;
        let workers = Workers::new(options.threads)?;
        prepare::<f64>(&mut world, workers.clone());
        prepare::<f32>(&mut world, workers.clone());
        world.init_resource::<FrameTime>();
        world.insert_resource(Traced { precision: options.precision, own_level: None });
        if file.is_none() {
            remember_home(&mut world);
        }
        let switches = Switches {
            mode: Layout::Preview,
            shows: Shows::Picture,
            texture: false,
            lights: true,
            axes: true,
            panel: false,
            strip: true,
        };
        let mut session = Self {
            editor: Editor::default(),
            held: Held::default(),
            report: Report::new(options.print_camera, options.print_events),
            switches,
            scene: SceneFile::new(name, file, &options),
            snapshots: Snapshots::new(&workers, wake.clone()),
            recipe: None,
            messages: Messages::default(),
            written: None,
            fronts: Fronts::new(wake.clone()),
            refined: Refined::new(workers.clone(), wake)?,
            workers,
            textured: options.textured,
            side: 0,
            systems: has_systems.then_some(systems),
            schedules: Schedules::new(),
            told_edit: 0,
            arrivals: 0,
            now: Duration::ZERO,
            world,
        };
        session.take_over_texture(options.shows_texture);
        Ok(session)
    }

    /// Whether frames must follow each other although nobody touches anything.
    pub(super) fn is_moving(&self, now: Duration) -> bool {
        self.systems.is_some() || self.held.moves_from().is_some_and(|from| from <= now)
    }

    /// Brings the World, and everything drawn from it, up to a moment.
    pub(super) fn update(&mut self, now: Duration) {
        let step = now.saturating_sub(std::mem::replace(&mut self.now, now));
        self.world.insert_resource(FrameTime { seconds: now.as_secs_f64(), step: step.as_secs_f64() });
        if let Some(systems) = &mut self.systems {
            systems.run(&mut self.world);
        }
        let moves = self.held.advance(now);
        self.ask(moves);
        self.dress_arrivals();
        self.settle();
        if let Some((pose, _)) = self.camera() {
            self.report.camera(&pose);
        }
        self.tell_edits();
        self.refine();
        self.measure_front();
        self.collect_snapshot();
    }

    /// Makes the moves that were asked for and brings the tables up to the World as it is now. What comes between two
    /// frames needs that before it looks.
    pub(super) fn settle(&mut self) {
        let precision = self.precision();
        self.schedules.run(&mut self.world, precision);
    }

    /// Of tables and kernels.
    pub(super) fn precision(&self) -> Precision {
        self.world.resource::<Traced>().precision
    }

    /// Asks the camera for moves, made in the next update.
    pub(super) fn ask(&mut self, moves: impl IntoIterator<Item = CameraMove>) {
        self.world.resource_mut::<CameraInput>().0.extend(moves);
    }

    /// The one camera, if there is exactly one.
    pub(super) fn camera(&mut self) -> Option<(CameraPose, Lens)> {
        let mut cameras = self.world.query::<(&CameraPose, &Lens)>();
        cameras.single(&self.world).ok().map(|(pose, lens)| (*pose, *lens))
    }

    /// The box around what is selected.
    pub(super) fn outline(&self) -> Option<[glam::DVec3; 2]> {
        bounds(&self.world, self.editor.selected()?)
    }

    /// Everything that keeps the World from being traced.
    pub(super) fn problems(&self) -> Vec<String> {
        let problems = match self.precision() {
            Precision::F64 => self.tables::<f64>().problems(),
            Precision::F32 => self.tables::<f32>().problems(),
        };
        problems.iter().map(ToString::to_string).collect()
    }

    /// A number that grows when the tables of the present precision change.
    pub(super) fn revision(&self) -> u64 {
        match self.precision() {
            Precision::F64 => self.tables::<f64>().revision(),
            Precision::F32 => self.tables::<f32>().revision(),
        }
    }

    /// The view as it stands, to be traced beside the World; `None` if the World cannot be traced.
    pub(super) fn view(&mut self) -> Option<TracedView> {
        let (pose, lens) = self.camera().filter(|_| self.problems().is_empty())?;
        let tables = match self.precision() {
            Precision::F64 => SharedTables::F64(self.tables::<f64>().scene.clone()),
            Precision::F32 => SharedTables::F32(self.tables::<f32>().scene.clone()),
        };
        Some(TracedView {
            tables,
            pose,
            lens,
            effects: self.camera_effects(),
            level: self.level(),
            cutoff: self.cutoff(),
        })
    }

    /// What the camera does beyond that of a pinhole.
    pub(super) fn camera_effects(&self) -> CameraEffects {
        match self.precision() {
            Precision::F64 => self.tables::<f64>().camera_effects(),
            Precision::F32 => self.tables::<f32>().camera_effects(),
        }
    }

    /// The object that shows at a pixel of the picture.
    pub(super) fn entity_at(&mut self, pixel: (u32, u32)) -> Option<Entity> {
        self.settle();
        let (pose, lens) = self.camera().filter(|_| self.problems().is_empty())?;
        match self.precision() {
            Precision::F64 => entity_at(self.tables::<f64>(), &pose, &lens, self.side, pixel),
            Precision::F32 => entity_at(self.tables::<f32>(), &pose, &lens, self.side, pixel),
        }
    }

    pub(super) fn tables<T: Real>(&self) -> &Tables<T> {
        self.world.resource()
    }
}

impl Schedules {
    fn new() -> Self {
        Self {
            control: control_schedule(),
            double: extract_schedule::<f64>(),
            single: extract_schedule::<f32>(),
            list: list_schedule(),
        }
    }

    fn run(&mut self, world: &mut World, precision: Precision) {
        self.control.run(world);
        match precision {
            Precision::F64 => self.double.run(world),
            Precision::F32 => self.single.run(world),
        }
        self.list.run(world);
    }
}

/// A World that a program has built keeps its own start: that is where its camera goes home to.
fn remember_home(world: &mut World) {
    let mut cameras = world.query_filtered::<(Entity, &CameraPose), Without<Home>>();
    if let Ok((camera, pose)) = cameras.single(world) {
        let home = Home(*pose);
        world.entity_mut(camera).insert(home);
    }
}
