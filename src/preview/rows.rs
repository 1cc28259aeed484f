//! Numbers as GL takes them: rows of four floats, shared until they change.

use std::sync::Arc;

use glam::DVec3;

/// What one instance is drawn from: `N` times four floats.
pub(super) type Row<const N: usize> = [[f32; 4]; N];

/// Rows that are replaced as a whole. Two are the same where they share their memory, which tells without a look at
/// the numbers whether a buffer that was filled from one still holds the other.
#[derive(Clone, Debug)]
pub(super) struct Rows<const N: usize>(Arc<Vec<Row<N>>>);

impl<const N: usize> Default for Rows<N> {
    fn default() -> Self {
        Self::new(Vec::new())
    }
}

impl<const N: usize> Rows<N> {
    pub(super) fn new(rows: Vec<Row<N>>) -> Self {
        Self(Arc::new(rows))
    }

    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    pub(super) fn is(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }

    /// All numbers as bytes in this machine's order.
    pub(super) fn to_bytes(&self) -> Vec<u8> {
        self.0.as_flattened().as_flattened().iter().flat_map(|number| number.to_ne_bytes()).collect()
    }
}

/// A number as the sum of two floats: the nearest one, and the nearest one to the rest.
pub(super) fn pair(number: f64) -> [f32; 2] {
    let high = narrow(number);
    [high, narrow(number - f64::from(high))]
}

/// A point and a length as two rows of four floats, to be added.
pub(super) fn pairs(point: DVec3, length: f64) -> [[f32; 4]; 2] {
    let numbers = [point.x, point.y, point.z, length].map(pair);
    [numbers.map(|[high, _]| high), numbers.map(|[_, low]| low)]
}

/// A colour as 8 bits a channel show it: truncated, as in picture files.
pub(super) fn tint(color: DVec3) -> [f32; 4] {
    let level = |channel: f64| narrow((channel.clamp(0.0, 1.0) * 255.0).floor() / 255.0);
    [level(color.x), level(color.y), level(color.z), 1.0]
}

/// The nearest float.
#[expect(clippy::cast_possible_truncation, reason = "GL 3.3 computes in single precision")]
pub(super) fn narrow(number: f64) -> f32 {
    number as f32
}

/// Whether a coordinate can be drawn: its square, divided by that of another, stays within a float.
pub(super) fn is_drawable_point(point: DVec3) -> bool {
    point.to_array().iter().all(|along| along.abs() <= MOST)
}

/// Whether a length can be drawn.
pub(super) fn is_drawable_length(length: f64) -> bool {
    (1.0 / MOST..=MOST).contains(&length)
}

/// Magnitude of the largest coordinate and length; the smallest length is its inverse. A float holds both together
/// with the rest that [`pair`] leaves.
const MOST: f64 = 1e30;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pair_keeps_48_bits() {
        for number in [1.0e6 + 1.0 / 3.0, -std::f64::consts::PI, 1e-30 / 3.0, 1e30 / 7.0, 0.0] {
            let [high, low] = pair(number);
            let error = (f64::from(high) + f64::from(low) - number).abs();
            assert!(error <= number.abs() * 2.0_f64.powi(-48), "{number}: {error}");
        }
    }

    #[test]
    fn a_tint_is_the_level_that_a_picture_file_has() {
        let levels = tint(DVec3::new(0.5, 0.999, 2.0)).map(|channel| (channel * 255.0).round());
        assert_eq!(levels, [127.0, 254.0, 255.0, 255.0]);
    }

    #[test]
    fn rows_are_the_same_by_memory_alone() {
        let rows = Rows::new(vec![[[1.0; 4]; 2]]);
        assert!(rows.is(&rows.clone()));
        assert!(!rows.is(&Rows::new(vec![[[1.0; 4]; 2]])));
        assert_eq!(rows.to_bytes().len(), 32);
    }

    #[test]
    fn what_is_not_finite_is_not_drawable() {
        assert!(!is_drawable_point(DVec3::new(0.0, f64::NAN, 0.0)));
        assert!(!is_drawable_point(DVec3::new(0.0, f64::INFINITY, 0.0)));
        assert!(is_drawable_point(DVec3::new(0.0, -1e30, 0.0)));
        for length in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-31] {
            assert!(!is_drawable_length(length), "{length}");
        }
    }
}
