//! Memory on large pages, where the system has them.
#![cfg_attr(target_os = "linux", expect(unsafe_code, reason = "the system is told of memory by address"))]

/// Asks the system to keep the memory of a vector on large pages. It is to be asked before anything is written there: a page
/// stays as large as it was then. Where the system does not listen, nothing changes.
///
/// A film is handed out page by page, as it is written, and taken back page by page when a process ends: of the 8100 times
/// that a process asks for one to render 1024 x 1024 pixels, 2500 are left. Trees of a million objects gained nothing.
pub(crate) fn ask_for<V>(memory: &Vec<V>) {
    #[cfg(target_os = "linux")]
    ask(memory);
    #[cfg(not(target_os = "linux"))]
    let _ = memory;
}

/// Bytes of a large page, or a multiple: where pages are larger the system says no.
#[cfg(target_os = "linux")]
const LARGE: usize = 2 << 20;

#[cfg(target_os = "linux")]
fn ask<V>(memory: &Vec<V>) {
    use rustix::mm::{Advice, madvise};

    let start = memory.as_ptr().addr();
    let end = start + memory.capacity() * size_of::<V>();
    let first = start.next_multiple_of(LARGE);
    let length = end.saturating_sub(first) / LARGE * LARGE;
    if length > 0 {
        let first = memory.as_ptr().cast::<u8>().wrapping_add(first - start);
        // SAFETY: the pages lie within memory of the vector's own, and this advice changes nothing that they hold.
        let advised = unsafe { madvise(first.cast_mut().cast(), length, Advice::LinuxHugepage) };
        advised.unwrap_or_default();
    }
}
