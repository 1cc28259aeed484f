//! What a ray met, and how the next one leaves it.

use crate::geometry::{Crossing, Meeting, Real, Side};

/// The kind of an object; each has a table of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// A row of the sphere table.
    Sphere,
    /// A row of the cube table.
    Cube,
    /// A row of the pyramid table.
    Pyramid,
    /// A row of the checkerboard table. Last, so that at equal order a finite object shows in front of a board.
    Board,
}

/// The name of an object within one frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ObjectId {
    /// Which table.
    pub kind: Kind,
    /// Which row of it.
    pub row: u32,
}

impl ObjectId {
    /// No object's [`packed`](Self::packed) name.
    pub(super) const NOBODY: u32 = u32::MAX;
    const ROW_BITS: u32 = 30;

    /// Kind and row in one number that sorts by kind, then row. There are far fewer than 2^30 rows.
    #[inline(always)]
    pub(super) fn packed(kind: Kind, row: u32) -> u32 {
        ((kind as u32) << Self::ROW_BITS) | row
    }

    /// The object of a packed name.
    #[inline(always)]
    pub(super) fn unpacked(name: u32) -> Self {
        let kind = match name >> Self::ROW_BITS {
            0 => Kind::Sphere,
            1 => Kind::Cube,
            2 => Kind::Pyramid,
            _ => Kind::Board,
        };
        Self { kind, row: name & ((1 << Self::ROW_BITS) - 1) }
    }
}

/// The nearest crossing of a ray with the scene.
#[derive(Clone, Copy, Debug)]
pub struct Hit<T> {
    /// The object met.
    pub object: ObjectId,
    /// Where on its boundary.
    pub crossing: Crossing<T>,
}

/// How a ray starts: every shape is convex, so what a ray leaves needs no offset and no tolerance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Departure {
    /// In open space.
    Free,
    /// On this object, outwards: it is out of the question.
    Outward(ObjectId),
    /// On this face of this object, into it: it is left on another face.
    Inward(ObjectId, u8),
}

impl<T> Hit<T> {
    /// How a ray leaves that goes on from this hit on the side it came from.
    #[inline(always)]
    pub fn departure(&self) -> Departure {
        match self.crossing.side {
            Side::Outside => Departure::Outward(self.object),
            Side::Inside => Departure::Inward(self.object, self.crossing.face),
        }
    }

    /// How a ray leaves that goes on through the surface.
    #[inline(always)]
    pub(super) fn passage(&self) -> Departure {
        match (self.object.kind, self.crossing.side) {
            // A board has no inside.
            (Kind::Board, _) | (_, Side::Inside) => Departure::Outward(self.object),
            (_, Side::Outside) => Departure::Inward(self.object, self.crossing.face),
        }
    }
}

impl Departure {
    /// What this departure means to one kind of object.
    #[inline(always)]
    pub(super) fn rows(&self, kind: Kind) -> DepartedRow {
        match *self {
            Self::Outward(object) if object.kind == kind => {
                DepartedRow { skipped: object.row, ..DepartedRow::NONE }
            }
            Self::Inward(object, face) if object.kind == kind => {
                DepartedRow { within: object.row, face, ..DepartedRow::NONE }
            }
            _ => DepartedRow::NONE,
        }
    }
}

/// The one row of a table that a ray starts on, if any.
#[derive(Clone, Copy)]
pub(super) struct DepartedRow {
    /// Not to be tested.
    pub(super) skipped: u32,
    /// To be tested by its exit only,
    pub(super) within: u32,
    /// other than by this face.
    pub(super) face: u8,
}

impl DepartedRow {
    /// No table has a row of this number.
    const NONE: Self = Self { skipped: u32::MAX, within: u32::MAX, face: 0 };

    /// The row, whichever way it was left; a number that no table has if there is none.
    #[inline(always)]
    pub(super) fn row(self) -> u32 {
        self.skipped.min(self.within)
    }
}

/// A face and the side that a ray comes from, in one number.
pub(super) struct FaceCode;

impl FaceCode {
    /// Above every face.
    const INSIDE: u32 = 8;

    #[inline(always)]
    pub(super) fn of<T: Real>(meeting: &Meeting<T>) -> u32 {
        meeting.face | if meeting.inside { Self::INSIDE } else { 0 }
    }

    #[inline(always)]
    pub(super) fn meeting<T: Real>(code: u32, t: T) -> Meeting<T> {
        Meeting { t, face: code & (Self::INSIDE - 1), inside: code & Self::INSIDE != 0, unsure: false }
    }
}
