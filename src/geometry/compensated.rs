//! Error-free transformations: a rounded result and, exactly, what rounding took away.
//!
//! Knuth's two-sum and Dekker's product (T. J. Dekker, "A floating-point technique for extending the available
//! precision", Numerische Mathematik 18, 1971). No fused multiply-add, see [`Real`].

use super::{Real, Vector};

/// `a + b` as rounded sum and exact error.
#[inline(always)]
pub fn two_sum<T: Real>(a: T, b: T) -> (T, T) {
    let sum = a + b;
    let b_part = sum - a;
    (sum, (a - (sum - b_part)) + (b - b_part))
}

/// `a - b` as rounded difference and exact error.
#[inline(always)]
pub fn two_diff<T: Real>(a: T, b: T) -> (T, T) {
    two_sum(a, -b)
}

/// `a * b` as rounded product and exact error, where neither overflows nor underflows.
#[inline(always)]
pub fn two_prod<T: Real>(a: T, b: T) -> (T, T) {
    let product = a * b;
    let (a_high, a_low) = split(a);
    let (b_high, b_low) = split(b);
    let error = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
    (product, error)
}

/// A number as the sum of two of half its significand.
#[inline(always)]
fn split<T: Real>(a: T) -> (T, T) {
    let scaled = T::SPLITTER * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

/// Componentwise `a - b` as rounded difference and exact error.
#[inline(always)]
pub(super) fn two_diff_vector<T: Real>(a: Vector<T>, b: Vector<T>) -> (Vector<T>, Vector<T>) {
    let (x, ex) = two_diff(a.x, b.x);
    let (y, ey) = two_diff(a.y, b.y);
    let (z, ez) = two_diff(a.z, b.z);
    (Vector::new(x, y, z), Vector::new(ex, ey, ez))
}

/// `|v + e|^2 - r^2` for a small `e`, to about the relative accuracy of one rounding even where the two squares
/// cancel almost wholly.
#[inline(always)]
pub(super) fn square_excess<T: Real>(v: Vector<T>, e: Vector<T>, r: T) -> T {
    // Largest cancellation first: each square is split into product and error, each sum into sum and error.
    // The x and y squares are added to each other first, which keeps the result the same when they swap.
    let (x2, x_err) = two_prod(v.x, v.x);
    let (y2, y_err) = two_prod(v.y, v.y);
    let (z2, z_err) = two_prod(v.z, v.z);
    let (r2, r_err) = two_prod(r, r);
    let (xy, xy_err) = two_sum(x2, y2);
    let (xyz, xyz_err) = two_sum(xy, z2);
    let (excess, excess_err) = two_diff(xyz, r2);
    let products = (x_err + y_err) + z_err - r_err;
    let sums = (xy_err + xyz_err) + excess_err;
    excess + ((products + sums) + T::TWO * v.dot(e))
}
