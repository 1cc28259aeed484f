//! What the panel shows of the session, and what it asks of it.

use std::time::Duration;

use crate::components::Precision;
use crate::geometry::Real;
use crate::preview::Layout;
use crate::systems::Tables;
use crate::trace::Counts;

use super::command::Command;
use super::commands::Then;
use super::keys::help;
use super::panel::{Request, Status};
use super::session::Session;

impl Session {
    /// What the panel shows, after a frame that took so long.
    pub(super) fn status(&self, frame: Duration) -> Status {
        let traced = self.refined.newest();
        let status = Status {
            scene: self.scene.path.clone(),
            name: self.scene.name.clone(),
            mode: self.switches.mode,
            shows: self.switches.shows,
            picture: traced.map(|picture| picture.shows),
            error: traced.and_then(|picture| picture.error),
            most: traced.map_or(0.0, |picture| picture.most),
            is_complete: traced.is_some_and(|picture| picture.is_final),
            front: self.fronts.front().clone(),
            strip: self.switches.strip && self.shown_mode() != Layout::Preview,
            texture: self.switches.texture,
            threads: self.workers.threads(),
            samples: traced.map_or(0, |picture| picture.samples),
            side: traced.map_or(self.side, |picture| picture.side),
            counts: traced.map_or_else(Counts::default, |picture| picture.counts),
            traced: traced.map_or(0.0, |picture| picture.milliseconds),
            frame: frame.as_secs_f64() * 1e3,
            progress: self.snapshots.progress(),
            written: self.written.clone(),
            problems: self.problems(),
            keys: help(),
            messages: self.messages.list().to_vec(),
            ..Status::default()
        };
        match self.precision() {
            Precision::F64 => with_tables(status, self.tables::<f64>()),
            Precision::F32 => with_tables(status, self.tables::<f32>()),
        }
    }

    /// Does what the panel asks for.
    pub(super) fn answer(&mut self, request: Request) -> Then {
        match request {
            Request::Save { path, overwrite } => self.save(&path, overwrite),
            Request::Reload => return self.command(Command::Reload),
            Request::Undo => return self.command(Command::Undo),
            Request::Redo => return self.command(Command::Redo),
            Request::Trace => return self.command(Command::Trace),
            Request::CancelTrace => self.snapshots.cancel(),
            Request::SetMode(mode) => self.set_mode(mode),
            Request::SetShows(shows) => self.set_shows(shows),
            Request::MeasureFront => self.fronts.forget(),
            Request::ToggleTexture => return self.command(Command::ToggleTexture),
            Request::Dismiss(place) => self.messages.dismiss(place),
        }
        Then::Stay
    }
}

fn with_tables<T: Real>(status: Status, tables: &Tables<T>) -> Status {
    let effects = tables.effect_counts();
    Status { effects, tables: tables.scene.table_counts().into_iter().collect(), ..status }
}
