//! Which vector instructions there are: the one place that chooses between copies of the same code.
#![cfg_attr(
    target_arch = "x86_64",
    expect(unsafe_code, reason = "calling code for instructions that were found to be there")
)]

use core::marker::PhantomData;

use crate::geometry::{ByPrecision, Real};

use super::packet::Scratch;
use super::pixels::PixelQueue;
use super::tile::PacketTask;
use super::{Counts, Kernel};

/// Whether this program has code for more than every processor of its kind has. Built with `ARCHETRACE_SIMD=baseline` it has
/// none, and is far slower: for measurements that a processor's age must not change.
const HAS_WIDER: bool = option_env!("ARCHETRACE_SIMD").is_none();

/// The vector instructions that pictures are traced with. No picture depends on them, only its time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Simd(Level);

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Level {
    /// What every processor of this kind has.
    Baseline,
    #[cfg(target_arch = "x86_64")]
    Avx2,
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

impl Simd {
    /// The widest that this processor has.
    pub fn detect() -> Self {
        Self::available().pop().unwrap_or(Self(Level::Baseline))
    }

    /// All that this processor has, the widest last.
    pub fn available() -> Vec<Self> {
        let levels = [
            Some(Level::Baseline),
            #[cfg(target_arch = "x86_64")]
            (HAS_WIDER && is_x86_feature_detected!("avx2")).then_some(Level::Avx2),
            #[cfg(target_arch = "x86_64")]
            (HAS_WIDER && has_avx512()).then_some(Level::Avx512),
        ];
        levels.into_iter().flatten().map(Self).collect()
    }

    /// `AVX-512`, `AVX2`, or `baseline` for what every processor of its kind has.
    pub fn name(self) -> &'static str {
        match self.0 {
            Level::Baseline => "baseline",
            #[cfg(target_arch = "x86_64")]
            Level::Avx2 => "AVX2",
            #[cfg(target_arch = "x86_64")]
            Level::Avx512 => "AVX-512",
        }
    }

    /// Traces pixels with a kernel.
    pub(super) fn trace<'a, T: Real>(
        self,
        kernel: Kernel,
        task: &'a PacketTask<'a, T>,
        queue: &'a mut dyn PixelQueue,
        scratch: &'a mut Scratch<T>,
    ) -> Counts {
        T::by_precision::<TracePixels<'a>>(Input { level: self.0, kernel, task, queue, scratch })
    }
}

/// Tracing pixels, compiled once for each precision, kernel and level.
struct TracePixels<'a>(PhantomData<&'a ()>);

struct Input<'a, T: Real> {
    level: Level,
    kernel: Kernel,
    task: &'a PacketTask<'a, T>,
    queue: &'a mut dyn PixelQueue,
    scratch: &'a mut Scratch<T>,
}

impl<'a> ByPrecision for TracePixels<'a> {
    type Input<T: Real> = Input<'a, T>;
    type Output = Counts;

    #[inline(never)]
    fn single(input: Input<'a, f32>) -> Counts {
        input.trace()
    }

    #[inline(never)]
    fn double(input: Input<'a, f64>) -> Counts {
        input.trace()
    }
}

impl<T: Real> Input<'_, T> {
    fn trace(self) -> Counts {
        match self.kernel {
            Kernel::Plain => self.trace_packets::<{ Kernel::Plain.effects().bits() }>(),
            Kernel::Assignment => self.trace_packets::<{ Kernel::Assignment.effects().bits() }>(),
            Kernel::Stages(_) => self.task.trace_by_stages(self.queue),
        }
    }

    fn trace_packets<const EFFECTS: u32>(self) -> Counts {
        match self.level {
            // SAFETY: the level is made by `available` alone, where the processor has these instructions.
            #[cfg(target_arch = "x86_64")]
            Level::Avx2 if HAS_WIDER => unsafe { trace_avx2::<T, EFFECTS>(self) },
            // SAFETY: as above.
            #[cfg(target_arch = "x86_64")]
            Level::Avx512 if HAS_WIDER => unsafe { trace_avx512::<T, EFFECTS>(self) },
            _ => trace_baseline::<T, EFFECTS>(self),
        }
    }
}

/// Work that may be done with any vector instructions.
pub(super) trait Vectorised {
    /// What it gives.
    type Output;

    /// Does it; to be inlined, so that it is compiled for the caller's instructions.
    fn run(self) -> Self::Output;
}

impl Simd {
    /// Does some work with these instructions, in code of its own: where kernels share work, none is larger for it.
    #[inline(always)]
    pub(super) fn run<W: Vectorised>(self, work: W) -> W::Output {
        match self.0 {
            // SAFETY: the level is made by `available` alone, where the processor has these instructions.
            #[cfg(target_arch = "x86_64")]
            Level::Avx2 if HAS_WIDER => unsafe { run_avx2(work) },
            // SAFETY: as above.
            #[cfg(target_arch = "x86_64")]
            Level::Avx512 if HAS_WIDER => unsafe { run_avx512(work) },
            _ => run_baseline(work),
        }
    }
}

#[inline(never)]
fn run_baseline<W: Vectorised>(work: W) -> W::Output {
    work.run()
}

#[cfg(target_arch = "x86_64")]
#[inline(never)]
#[target_feature(enable = "avx2")]
fn run_avx2<W: Vectorised>(work: W) -> W::Output {
    work.run()
}

#[cfg(target_arch = "x86_64")]
#[inline(never)]
#[target_feature(enable = "avx512f,avx512vl,avx512bw,avx512dq")]
fn run_avx512<W: Vectorised>(work: W) -> W::Output {
    work.run()
}

#[cfg(target_arch = "x86_64")]
fn has_avx512() -> bool {
    is_x86_feature_detected!("avx512f")
        && is_x86_feature_detected!("avx512vl")
        && is_x86_feature_detected!("avx512bw")
        && is_x86_feature_detected!("avx512dq")
}

#[inline(never)]
fn trace_baseline<T: Real, const EFFECTS: u32>(input: Input<'_, T>) -> Counts {
    input.task.trace_packets::<EFFECTS>(input.queue, input.scratch)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn trace_avx2<T: Real, const EFFECTS: u32>(input: Input<'_, T>) -> Counts {
    input.task.trace_packets::<EFFECTS>(input.queue, input.scratch)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512vl,avx512bw,avx512dq")]
fn trace_avx512<T: Real, const EFFECTS: u32>(input: Input<'_, T>) -> Counts {
    input.task.trace_packets::<EFFECTS>(input.queue, input.scratch)
}
