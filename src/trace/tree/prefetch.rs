//! Memory that is asked for before it is read.
#![cfg_attr(target_arch = "x86_64", expect(unsafe_code, reason = "the instruction takes a pointer"))]

/// Has a value brought to the processor, where there is an instruction for that.
#[inline(always)]
pub(super) fn prefetch<V>(value: &V) {
    #[cfg(target_arch = "x86_64")]
    {
        use core::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        let first: *const i8 = core::ptr::from_ref(value).cast();
        for line in (0..size_of::<V>()).step_by(64) {
            // SAFETY: nothing is read or written, whatever the address; it is within the value.
            unsafe { _mm_prefetch::<_MM_HINT_T0>(first.wrapping_add(line)) };
        }
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = value;
}
