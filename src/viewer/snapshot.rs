//! Key 0: a view is traced on a thread of its own and written to a file of its own.

use std::ffi::{OsStr, OsString};
use std::io;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{self, Receiver, TryRecvError};
use std::thread::{self, JoinHandle};

use thiserror::Error;

use crate::film::Film;
use crate::image_file::{ImageFileError, encode};
use crate::systems::{FrameError, Monitor, Workers, WorkersError};
use crate::whole_file::{WriteError, check_folder, write_new};

use super::traced_view::{Samples, TracedView};

/// A picture to be traced and written as `<stem>-001.bmp`, or under the next number that is free.
#[derive(Clone, Debug)]
pub(crate) struct SnapshotRequest {
    /// What is seen.
    pub(crate) view: TracedView,
    /// Pixels along each side.
    pub(crate) pixels: u32,
    /// The samples of each pixel.
    pub(crate) samples: Samples,
    /// Folder of the file; empty for the current one.
    pub(crate) folder: PathBuf,
    /// What its name begins with.
    pub(crate) stem: OsString,
}

/// How the tracing of a snapshot ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// The picture is in this file.
    Written(PathBuf),
    /// It was given up; there is no file.
    Cancelled,
    /// There is no file, for this reason.
    Failed(String),
}

/// Why no tracing begins.
#[derive(Debug, Error)]
pub(crate) enum Refusal {
    /// One at a time.
    #[error("a picture is being traced already")]
    Busy,
    /// The file could not be written.
    #[error(transparent)]
    Folder(#[from] WriteError),
    /// There are no threads for it.
    #[error(transparent)]
    Workers(#[from] WorkersError),
    /// There is no thread for it.
    #[error("cannot start a thread: {0}")]
    Thread(#[from] io::Error),
}

/// Traces snapshots, one at a time. Dropping it gives up what it does: no part of a file stays.
///
/// Each is traced on threads made for it. In a pool shared with the live trace a pass would wait until the one before
/// it has left the queue, which can take minutes; with their own, the operating system shares the processors out, and
/// the live trace learns that it has become slower.
pub(crate) struct Snapshots {
    threads: usize,
    wake: Arc<dyn Fn() + Send + Sync>,
    running: Option<Running>,
}

struct Running {
    cancel: Arc<AtomicBool>,
    progress: Arc<Progress>,
    outcome: Receiver<Outcome>,
    thread: Option<JoinHandle<()>>,
}

/// Samples of pixels traced.
struct Progress {
    done: AtomicU64,
    total: u64,
}

impl Snapshots {
    /// For as many threads as these. `wake` is called when the progress has grown by a hundredth, and at the end.
    pub(crate) fn new(workers: &Workers, wake: impl Fn() + Send + Sync + 'static) -> Self {
        Self { threads: workers.threads(), wake: Arc::new(wake), running: None }
    }

    /// Begins to trace.
    pub(crate) fn start(&mut self, request: SnapshotRequest) -> Result<(), Refusal> {
        if self.running.is_some() {
            return Err(Refusal::Busy);
        }
        check_folder(&request.folder)?;
        let workers = Workers::new(NonZeroUsize::new(self.threads))?;
        self.running = Some(Running::start(request, workers, self.wake.clone())?);
        Ok(())
    }

    /// How much is traced, 0 to 1; `None` if nothing is being traced.
    pub(crate) fn progress(&self) -> Option<f32> {
        self.running.as_ref().map(|running| running.progress.share())
    }

    /// Gives up. The outcome follows soon.
    pub(crate) fn cancel(&self) {
        if let Some(running) = &self.running {
            running.cancel.store(true, Ordering::Relaxed);
        }
    }

    /// The outcome, once, after the end.
    pub(crate) fn finished(&mut self) -> Option<Outcome> {
        let outcome = match self.running.as_ref()?.outcome.try_recv() {
            Ok(outcome) => outcome,
            Err(TryRecvError::Empty) => return None,
            Err(TryRecvError::Disconnected) => Outcome::Failed("the tracing broke off".into()),
        };
        self.running = None;
        Some(outcome)
    }
}

impl Running {
    fn start(
        request: SnapshotRequest,
        workers: Workers,
        wake: Arc<dyn Fn() + Send + Sync>,
    ) -> io::Result<Self> {
        let cancel = Arc::new(AtomicBool::new(false));
        let progress = Arc::new(Progress::of(&request));
        let (sender, outcome) = mpsc::channel();
        let monitor = monitor(progress.clone(), cancel.clone(), wake.clone());
        let work = move || {
            // If nobody waits for it any more, the outcome is of no interest.
            let _ = sender.send(trace_to_file(&request, &workers, &monitor));
            wake();
        };
        let thread = thread::Builder::new().name("snapshot".into()).spawn(work)?;
        Ok(Self { cancel, progress, outcome, thread: Some(thread) })
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        self.cancel.store(true, Ordering::Relaxed);
        if let Some(thread) = self.thread.take() {
            // It has nothing to tell, and a panic of it has been reported.
            let _ = thread.join();
        }
    }
}

impl Progress {
    fn of(request: &SnapshotRequest) -> Self {
        let total = u64::from(request.pixels).pow(2) * u64::from(request.samples.grid.count());
        Self { done: AtomicU64::new(0), total: total.max(1) }
    }

    /// Whether this many more make another hundredth complete.
    fn add(&self, samples: u64) -> bool {
        let before = self.done.fetch_add(samples, Ordering::Relaxed);
        let hundredths = |done: u64| done * 100 / self.total;
        hundredths(before + samples) > hundredths(before)
    }

    fn share(&self) -> f32 {
        let thousandths = self.done.load(Ordering::Relaxed) * 1000 / self.total;
        u16::try_from(thousandths).map_or(1.0, |thousandths| f32::from(thousandths) / 1000.0)
    }
}

fn monitor(progress: Arc<Progress>, cancel: Arc<AtomicBool>, wake: Arc<dyn Fn() + Send + Sync>) -> Monitor {
    let on_tile = move |pixels| {
        if progress.add(pixels) {
            wake();
        }
    };
    Monitor::new(on_tile, cancel)
}

/// Why there is no file.
#[derive(Debug, Error)]
enum NoFile {
    #[error(transparent)]
    Frame(#[from] FrameError),
    #[error(transparent)]
    Image(#[from] ImageFileError),
    #[error(transparent)]
    Write(#[from] WriteError),
}

fn trace_to_file(request: &SnapshotRequest, workers: &Workers, monitor: &Monitor) -> Outcome {
    match try_trace_to_file(request, workers, monitor) {
        Ok(path) => Outcome::Written(path),
        Err(NoFile::Frame(FrameError::Cancelled)) => Outcome::Cancelled,
        Err(error) => Outcome::Failed(error.to_string()),
    }
}

fn try_trace_to_file(
    request: &SnapshotRequest,
    workers: &Workers,
    monitor: &Monitor,
) -> Result<PathBuf, NoFile> {
    let SnapshotRequest { view, pixels, samples, folder, stem } = request;
    let mut film = Film::new(*pixels).ok_or(FrameError::Memory(*pixels))?;
    view.trace_picture(*samples, &mut film, workers, monitor);
    go_on(monitor)?;
    let picture = encode(&film, Path::new("picture.bmp"))?;
    go_on(monitor)?;
    Ok(write_new(folder, names(stem), &picture)?)
}

fn go_on(monitor: &Monitor) -> Result<(), FrameError> {
    if monitor.is_cancelled() { Err(FrameError::Cancelled) } else { Ok(()) }
}

/// The names of a scene's pictures: `<stem>-001.bmp`, `<stem>-002.bmp`, ...
fn names(stem: &OsStr) -> impl Iterator<Item = OsString> {
    (1_u32..).map(move |number| {
        let mut name = stem.to_owned();
        name.push(format!("-{number:03}.bmp"));
        name
    })
}

#[cfg(test)]
mod tests;
