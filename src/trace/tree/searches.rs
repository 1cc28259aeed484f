//! What rays look for.

use crate::geometry::Real;
use crate::trace::closest::comes_first;
use crate::trace::{Kind, ObjectId, SceneTables};

use super::TreeSearch;

/// No row.
pub(in crate::trace) const NO_ROW: u32 = u32::MAX;

/// The nearest row so far.
#[derive(Clone, Copy)]
pub(in crate::trace) struct Nearest<'a, T: Real> {
    pub(in crate::trace) tables: &'a SceneTables<T>,
    /// The kind of the rows.
    pub(in crate::trace) kind: Kind,
    pub(in crate::trace) t: T,
    /// Packed name of the object at `t`, of whatever kind, or nobody's.
    pub(in crate::trace) name: u32,
    /// Which face of it, see [`FaceCode`](crate::trace::hit::FaceCode).
    pub(in crate::trace) face: u32,
}

impl<T: Real> TreeSearch<T> for Nearest<'_, T> {
    #[inline(always)]
    fn reach(&self) -> T {
        self.t
    }

    #[inline(always)]
    fn meet(&mut self, row: u32, t: T, face: u32) {
        let name = ObjectId::packed(self.kind, row);
        if t < self.t || (t == self.t && comes_first(self.tables, name, self.name)) {
            self.t = t;
            self.name = name;
            self.face = face;
        }
    }

    #[inline(always)]
    fn is_done(&self) -> bool {
        false
    }
}

/// Any row before `reach`.
#[derive(Clone, Copy)]
pub(in crate::trace) struct Any<T> {
    pub(in crate::trace) row: u32,
    pub(in crate::trace) reach: T,
}

impl<T: Real> TreeSearch<T> for Any<T> {
    #[inline(always)]
    fn reach(&self) -> T {
        self.reach
    }

    #[inline(always)]
    fn meet(&mut self, row: u32, t: T, _face: u32) {
        if t < self.reach {
            self.row = row;
        }
    }

    #[inline(always)]
    fn is_done(&self) -> bool {
        self.row != NO_ROW
    }
}
