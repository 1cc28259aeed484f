//! How alike two pictures look.

use crate::film::Film;

/// Pixels along each side of the window that is moved over both pictures.
const WINDOW: usize = 11;
/// Standard deviation of the window's weights, in pixels.
const SIGMA: f64 = 1.5;

/// Mean structural similarity of two pictures, -1 to 1, and 1 for equal ones; `None` unless they are of the same size and
/// not empty.
///
/// Z. Wang, A. C. Bovik, H. R. Sheikh, E. P. Simoncelli: Image quality assessment, from error visibility to structural
/// similarity, 2004: of luma (0.299, 0.587, 0.114) in 8 bits, by windows of 11 by 11 pixels with Gaussian weights that lie
/// wholly inside. A smaller picture is one window.
pub fn mean_ssim(a: &Film, b: &Film) -> Option<f64> {
    if a.side() != b.side() || a.side() == 0 {
        return None;
    }
    let (side, weights) = (a.side() as usize, weights(a.side() as usize));
    let [a, b] = [a, b].map(luma);
    let mean = |of: &dyn Fn(f64, f64) -> f64| {
        let values: Vec<f64> = a.iter().zip(&b).map(|(&a, &b)| of(a, b)).collect();
        blurred(&values, side, &weights)
    };
    let (mean_a, mean_b) = (mean(&|a, _| a), mean(&|_, b| b));
    let (square_a, square_b, product) = (mean(&|a, _| a * a), mean(&|_, b| b * b), mean(&|a, b| a * b));
    let windows = mean_a.len();
    let sum: f64 = (0..windows)
        .map(|at| {
            let means = [mean_a[at], mean_b[at]];
            let variances = [square_a[at] - means[0] * means[0], square_b[at] - means[1] * means[1]];
            similarity(means, variances, product[at] - means[0] * means[1])
        })
        .sum();
    // At most 8192 x 8192.
    Some(sum / f64::from(u32::try_from(windows).ok()?))
}

fn similarity(means: [f64; 2], variances: [f64; 2], covariance: f64) -> f64 {
    // They keep the quotients calm where both pictures are dark, or flat.
    let (c1, c2) = (0.01_f64.powi(2), 0.03_f64.powi(2));
    let luminance = (2.0 * means[0] * means[1] + c1) / (means[0].powi(2) + means[1].powi(2) + c1);
    let structure = (2.0 * covariance + c2) / (variances[0] + variances[1] + c2);
    luminance * structure
}

fn luma(film: &Film) -> Vec<f64> {
    let levels = film.to_rgb8();
    let of = |rgb: &[u8]| 0.299 * f64::from(rgb[0]) + 0.587 * f64::from(rgb[1]) + 0.114 * f64::from(rgb[2]);
    levels.chunks_exact(3).map(|rgb| of(rgb) / 255.0).collect()
}

/// Gaussian weights of sum 1, as many as the window is wide.
fn weights(side: usize) -> Vec<f64> {
    let width = u32::try_from(WINDOW.min(side)).unwrap_or(u32::MAX);
    let center = f64::from(width - 1) / 2.0;
    let bell = |at: u32| (-(f64::from(at) - center).powi(2) / (2.0 * SIGMA * SIGMA)).exp();
    let sum: f64 = (0..width).map(bell).sum();
    (0..width).map(|at| bell(at) / sum).collect()
}

/// Weighted means of all windows, row after row: first along rows, then along columns.
fn blurred(values: &[f64], side: usize, weights: &[f64]) -> Vec<f64> {
    let places = side + 1 - weights.len();
    let weighted = |start: usize, step: usize, of: &[f64]| -> f64 {
        weights.iter().zip(of[start..].iter().step_by(step)).map(|(weight, value)| weight * value).sum()
    };
    let rows: Vec<f64> =
        (0..side * places).map(|at| weighted(at / places * side + at % places, 1, values)).collect();
    (0..places * places).map(|at| weighted(at, places, &rows)).collect()
}
