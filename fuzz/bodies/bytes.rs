//! Bytes as a stream of choices and numbers.

use archetrace::components::range::Range;
use glam::DVec3;

/// Numbers at which something may change.
const NUMBERS: [f64; 24] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    2.0,
    3.0,
    10.0,
    90.0,
    179.999_999,
    180.0,
    1e-9,
    1e9,
    1e-20,
    1e20,
    1e-70,
    1e70,
    1e35,
    1e-35,
    5e-324,
    f64::MIN_POSITIVE,
    f64::MAX,
    -1e9,
    0.1,
];

/// What is left of the bytes; an empty rest is all zeros.
pub(super) struct Bytes<'a> {
    rest: &'a [u8],
    /// The last number that was read.
    last: f64,
}

impl<'a> Bytes<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { rest: bytes, last: 1.0 }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.rest.is_empty()
    }

    pub(super) fn byte(&mut self) -> u8 {
        let Some((&first, rest)) = self.rest.split_first() else { return 0 };
        self.rest = rest;
        first
    }

    /// One choice of some.
    pub(super) fn below(&mut self, count: u8) -> u8 {
        self.byte() % count
    }

    /// Any number that is finite: of the list, whole, the last one or next to it, or of eight bytes.
    pub(super) fn number(&mut self) -> f64 {
        let number = match self.below(8) {
            0 | 1 => NUMBERS[usize::from(self.byte()) % NUMBERS.len()],
            2 | 3 => f64::from(self.byte().cast_signed()),
            4 => self.last,
            5 => self.last.next_up(),
            6 => f64::from(self.byte()) / 256.0 * self.last,
            _ => f64::from_bits(u64::from_le_bytes(core::array::from_fn(|_| self.byte()))),
        };
        self.last = if number.is_finite() { number } else { 1.0 };
        self.last
    }

    /// A number that is allowed, or one time in thirty-two any.
    pub(super) fn within(&mut self, range: &Range) -> f64 {
        let number = self.number();
        if self.below(32) == 31 { number } else { range.nearest(number).unwrap_or(number) }
    }

    /// Three of them.
    pub(super) fn vector(&mut self, range: &Range) -> DVec3 {
        DVec3::new(self.within(range), self.within(range), self.within(range))
    }
}
