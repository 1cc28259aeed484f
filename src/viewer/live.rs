//! The live trace: a thread that traces the view asked for last, coarse at first, then finer and finer.
//!
//! Whatever is asked for replaces what was asked before: that is given up before its next row of pixels.

use std::io;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use crate::systems::{FrameError, Monitor, Workers};
use crate::trace::Counts;

use super::pace::Pace;
use super::traced_view::{Samples, TracedView};
use job::Job;

/// What is shown of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Shows {
    /// Itself.
    #[default]
    Picture,
    /// The error of each pixel in false colours, as it is estimated.
    Errors,
    /// The rays of each pixel in false colours.
    Rays,
}

/// A picture for the window.
#[derive(Clone, Debug)]
pub(crate) struct LiveRequest {
    /// What is seen.
    pub(crate) view: TracedView,
    /// Pixels along each side of the full picture.
    pub(crate) side: u32,
    /// The samples of each pixel when it is complete.
    pub(crate) samples: Samples,
    /// What is shown of it.
    pub(crate) shows: Shows,
}

/// A picture as far as it has come.
#[derive(Clone, Debug)]
pub(crate) struct Shown {
    /// Pixels along each side; fewer than asked for in the coarse picture that comes first.
    pub(crate) side: u32,
    /// Red, green, blue, top row first, in 8 bits as they are in a file.
    pub(crate) rgb8: Vec<u8>,
    /// What it shows.
    pub(crate) shows: Shows,
    /// Samples of each pixel so far; where that is decided pixel by pixel, the most that one may get.
    pub(crate) samples: u32,
    /// Whether nothing better follows.
    pub(crate) is_final: bool,
    /// What was counted in these samples.
    pub(crate) counts: Counts,
    /// Milliseconds that their tracing took.
    pub(crate) milliseconds: f64,
    /// Root mean squared error of the channels, 0 to 1, as the samples tell; nothing while they do not yet.
    pub(crate) error: Option<f64>,
    /// The largest number of a heat map's scale.
    pub(crate) most: f64,
}

/// The live trace. Dropping it gives up what it does, and waits for the thread to end.
pub(crate) struct Live {
    shared: Arc<Shared>,
    thread: Option<JoinHandle<()>>,
}

/// What the window and the thread have in common.
struct Shared {
    mailbox: Mutex<Mailbox>,
    changed: Condvar,
    wake: Box<dyn Fn() + Send + Sync>,
}

#[derive(Default)]
struct Mailbox {
    /// Counts requests and stops.
    generation: u64,
    request: Option<LiveRequest>,
    /// Gives up what belongs to this generation.
    cancel: Arc<AtomicBool>,
    is_working: bool,
    shown: Option<Result<Shown, FrameError>>,
    is_closed: bool,
}

impl Live {
    /// Starts the thread. Whenever there is something new to show it calls `wake`.
    pub(crate) fn new(workers: Workers, wake: impl Fn() + Send + Sync + 'static) -> io::Result<Self> {
        let (mailbox, changed, wake) = (Mutex::default(), Condvar::new(), Box::new(wake));
        let shared = Arc::new(Shared { mailbox, changed, wake });
        let served = shared.clone();
        let thread =
            thread::Builder::new().name("live trace".into()).spawn(move || serve(&served, &workers))?;
        Ok(Self { shared, thread: Some(thread) })
    }

    /// Asks for a picture.
    pub(crate) fn request(&self, what: LiveRequest) {
        self.shared.replace(Some(what));
    }

    /// Gives up whatever was asked for.
    pub(crate) fn stop(&self) {
        self.shared.replace(None);
    }

    /// The newest picture of the last request that has not been taken yet.
    pub(crate) fn latest(&self) -> Option<Result<Shown, FrameError>> {
        self.shared.lock().shown.take()
    }

    /// The same, after waiting for it a while if there is none yet; not if none will come.
    pub(crate) fn wait(&self, at_most: Duration) -> Option<Result<Shown, FrameError>> {
        let to_come = |mailbox: &mut Mailbox| {
            mailbox.shown.is_none() && (mailbox.is_working || mailbox.request.is_some())
        };
        let waited = self.shared.changed.wait_timeout_while(self.shared.lock(), at_most, to_come);
        waited.unwrap_or_else(PoisonError::into_inner).0.shown.take()
    }
}

impl Drop for Live {
    fn drop(&mut self) {
        self.shared.lock().is_closed = true;
        self.stop();
        if let Some(thread) = self.thread.take() {
            // It has nothing to tell, and a panic of it has been reported.
            let _ = thread.join();
        }
    }
}

impl Shared {
    fn lock(&self) -> MutexGuard<'_, Mailbox> {
        self.mailbox.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn replace(&self, request: Option<LiveRequest>) {
        let mut mailbox = self.lock();
        mailbox.cancel.store(true, Ordering::Relaxed);
        mailbox.cancel = Arc::default();
        mailbox.generation += 1;
        mailbox.request = request;
        mailbox.shown = None;
        self.changed.notify_all();
    }

    /// Waits for the next request. `None` once no further one will come.
    fn next<'a>(&'a self, workers: &'a Workers) -> Option<Job<'a>> {
        let idle = |mailbox: &mut Mailbox| mailbox.request.is_none() && !mailbox.is_closed;
        let mut mailbox = self.changed.wait_while(self.lock(), idle).unwrap_or_else(PoisonError::into_inner);
        let request = mailbox.request.take()?;
        mailbox.is_working = true;
        let monitor = Monitor::new(|_| (), mailbox.cancel.clone());
        Some(Job::new(self, workers, request, mailbox.generation, monitor))
    }

    fn finish(&self) {
        self.lock().is_working = false;
        self.changed.notify_all();
    }

    /// Waits so long, unless something else is asked for.
    fn pause(&self, generation: u64, time: Duration) {
        let is_same = |mailbox: &mut Mailbox| mailbox.generation == generation;
        drop(self.changed.wait_timeout_while(self.lock(), time, is_same));
    }

    /// Puts out a picture, unless something else has been asked for meanwhile.
    fn show(&self, generation: u64, shown: Result<Shown, FrameError>) {
        let mut mailbox = self.lock();
        if mailbox.generation == generation {
            mailbox.shown = Some(shown);
            self.changed.notify_all();
            drop(mailbox);
            (self.wake)();
        }
    }
}

/// The thread.
fn serve(shared: &Shared, workers: &Workers) {
    let mut pace = Pace::default();
    while let Some(job) = shared.next(workers) {
        if let Err(error) = job.run(&mut pace) {
            job.fail(error);
        }
        // Before the thread is said to be idle: until then nobody may count on the tables being free.
        drop(job);
        shared.finish();
    }
}

mod estimate;
mod job;

#[cfg(test)]
mod tests;
