//! Memory on large pages, where the system has them.
#![cfg_attr(target_os = "linux", expect(unsafe_code, reason = "the system is told of memory by address"))]

/// An empty vector with room for some values, which the system is asked to keep on large pages.
///
/// A processor remembers where some thousand pages are. A ray that goes down a tree of many megabytes reads from another
/// page with nearly every step, and finds out where that is first. The values must be written after this: a page is as
/// large as it was when first written to.
pub(super) fn with_capacity<V>(count: usize) -> Vec<V> {
    let memory: Vec<V> = Vec::with_capacity(count);
    #[cfg(target_os = "linux")]
    ask(&memory);
    memory
}

/// Only advice: where it is not taken, pages are as small as ever.
#[cfg(target_os = "linux")]
fn ask<V>(memory: &Vec<V>) {
    use rustix::mm::{Advice, madvise};

    let page = rustix::param::page_size();
    let start = memory.as_ptr().addr().next_multiple_of(page);
    let end = memory.as_ptr().addr() + memory.capacity() * size_of::<V>();
    let length = end.saturating_sub(start) / page * page;
    if length >= WORTH_ASKING {
        let first = memory.as_ptr().cast::<u8>().wrapping_add(start - memory.as_ptr().addr());
        // SAFETY: the pages lie within memory of the vector's own, and this advice changes nothing that they hold.
        let advised = unsafe { madvise(first.cast_mut().cast(), length, Advice::LinuxHugepage) };
        advised.unwrap_or_default();
    }
}

/// Bytes: less has no large page in it.
#[cfg(target_os = "linux")]
const WORTH_ASKING: usize = 4 << 20;
