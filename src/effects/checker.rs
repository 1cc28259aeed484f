//! The checker pattern.

use crate::geometry::{Real, two_prod};

/// Where a point of the plane lies in the checker pattern.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellPoint<T> {
    /// Whether the cell is white: the cell from 0 to its width on both axes is, and every other one from there.
    pub white: bool,
    /// Position within the cell along x, 0 to 1.
    pub along_x: T,
    /// Position within the cell along y, 0 to 1.
    pub along_y: T,
}

/// The cell of a point `(x, y)` relative to the pattern's origin, for square cells of width `cell` > 0.
#[inline(always)]
pub fn cell_point<T: Real>(x: T, y: T, cell: T) -> CellPoint<T> {
    let (column, along_x) = divide_floor(x, cell);
    let (row, along_y) = divide_floor(y, cell);
    CellPoint { white: is_odd(column) == is_odd(row), along_x, along_y }
}

/// `floor(x / cell)`, exactly, and the rest as a share of the cell.
#[inline(always)]
fn divide_floor<T: Real>(x: T, cell: T) -> (T, T) {
    let quotient = (x / cell).floor();
    let (product, error) = two_prod(quotient, cell);
    let rest = (x - product) - error;
    // The division may round up to a whole number that x does not reach; the exact rest tells.
    if rest < T::ZERO { (quotient - T::ONE, (rest + cell) / cell) } else { (quotient, rest / cell) }
}

/// Parity of a whole number of any size; an integer type would saturate beyond its range.
#[inline(always)]
fn is_odd<T: Real>(whole: T) -> bool {
    let half = whole / T::TWO;
    half != half.floor()
}
