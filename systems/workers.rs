//! The threads that trace, and what they report while they do.

use std::num::NonZeroUsize;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use bevy_ecs::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use thiserror::Error;

use crate::effects::EffectSet;
use crate::trace::{Kernel, Simd};

/// The threads of the heavy systems; a clone shares them. No picture depends on their number or on the tile size.
#[derive(Resource, Clone, Debug)]
pub struct Workers {
    pub(super) pool: Arc<ThreadPool>,
    pub(super) tile_size: u32,
    pub(super) simd: Simd,
    /// Every kernel that is used has what this one has.
    least: Kernel,
}

impl Workers {
    /// This many threads, or one per processor.
    pub fn new(threads: Option<NonZeroUsize>) -> Result<Self, WorkersError> {
        // For rayon, 0 stands for one per processor.
        let builder = ThreadPoolBuilder::new().num_threads(threads.map_or(0, NonZeroUsize::get));
        let pool = builder.build().map_err(|error| WorkersError(error.to_string()))?;
        // 16 rows: enough bands to keep all threads busy to the end, few enough not to matter themselves.
        Ok(Self { pool: Arc::new(pool), tile_size: 16, simd: Simd::detect(), least: Kernel::Plain })
    }

    /// The same threads with tiles of another size, in pixels along each side; a row of tiles is traced by one thread.
    #[must_use]
    pub fn with_tile_size(self, tile_size: u32) -> Self {
        Self { tile_size, ..self }
    }

    /// The same threads with other vector instructions.
    #[must_use]
    pub fn with_simd(self, simd: Simd) -> Self {
        Self { simd, ..self }
    }

    /// The same threads with kernels that have what this one has, whatever a scene asks for.
    #[must_use]
    pub fn with_least_kernel(self, least: Kernel) -> Self {
        Self { least, ..self }
    }

    /// The kernel for these effects.
    pub fn kernel_for(&self, effects: EffectSet) -> Kernel {
        Kernel::smallest_for(effects.union(self.least.effects()))
    }

    /// Does work whose parts rayon is to give to these threads.
    pub fn run<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        self.pool.install(work)
    }

    /// Number of threads.
    pub fn threads(&self) -> usize {
        self.pool.current_num_threads()
    }
}

/// The operating system has no more threads to give.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("cannot start the threads that trace: {0}")]
pub struct WorkersError(String);

/// Watches a frame from outside: told of each finished tile, asked whether to go on.
#[derive(Resource, Clone)]
pub struct Monitor {
    on_tile: Arc<dyn Fn(u64) + Send + Sync>,
    cancel: Arc<AtomicBool>,
}

impl Monitor {
    /// Calls `on_tile` with the number of pixels of each finished tile, once for each of their samples, from any
    /// thread; no further row of pixels is started once `cancel` is set.
    pub fn new(on_tile: impl Fn(u64) + Send + Sync + 'static, cancel: Arc<AtomicBool>) -> Self {
        Self { on_tile: Arc::new(on_tile), cancel }
    }

    pub(super) fn tile_done(&self, pixels: u64) {
        (self.on_tile)(pixels);
    }

    /// Whether the frame is to be given up.
    pub fn is_cancelled(&self) -> bool {
        self.cancel.load(Ordering::Relaxed)
    }
}

impl Default for Monitor {
    /// Nobody watches.
    fn default() -> Self {
        Self::new(|_| (), Arc::default())
    }
}
