//! The kernels of this build, on this machine, against arithmetic of twice the digits.
//!
//! Rays are random, seeded, and aimed where tracers go wrong: at edges, corners and rims, at pebbles on the horizon and
//! planets underfoot, from surface points into and out of bodies. Cubes and pyramids are to be hit and missed as the truth
//! says, spheres may differ from it where a float cannot tell; ray parameters have bounds. The truth comes from other
//! formulas ([`Double`]): it shares no step with the kernels but the error-free sums and products.

mod ball;
mod double;
mod edges;
mod leaving;
mod pictures;
mod random;
mod solid;
mod tally;

use crate::geometry::{Convex, Real};

pub use ball::{Aim, check_spheres};
pub use double::Double;
pub use edges::{check_cubes, check_planes, check_pyramids};
pub use leaving::check_leaving;
pub use pictures::check_pictures;
pub use random::Random;
pub use tally::Tally;

/// Seed of the first ray of the first group, unless another is given.
pub const SEED: u64 = 0x5E1F_C8EC;

/// Rays of a pass of each group, for each picture that is traced.
const RAYS_A_SCENE: u64 = 10_000;

/// Checks every group in both precisions, with so many rays in each, and hands over each tally when it is done. Whether
/// all are good.
///
/// # Errors
///
/// What `tell` says ends the check.
pub fn check_all<E>(rays: u64, seed: u64, mut tell: impl FnMut(&Tally) -> Result<(), E>) -> Result<bool, E> {
    let double = check_precision::<f64, E>(rays, seed, &mut tell)?;
    let single = check_precision::<f32, E>(rays, seed, &mut tell)?;
    Ok(double && single)
}

fn check_precision<T: Real, E>(
    rays: u64,
    seed: u64,
    tell: &mut impl FnMut(&Tally) -> Result<(), E>,
) -> Result<bool, E> {
    let mut is_good = true;
    let mut take = |tally: &Tally| {
        is_good &= tally.is_good();
        tell(tally)
    };
    for aim in Aim::ALL {
        take(&check_spheres::<T>(aim, rays, seed, |sphere, ray| sphere.intersect(ray)))?;
    }
    take(&check_cubes::<T>(rays, seed))?;
    take(&check_pyramids::<T>(rays, seed))?;
    take(&check_planes::<T>(rays, seed))?;
    take(&check_leaving::<T>(rays, seed))?;
    take(&check_pictures::<T>(rays.div_ceil(RAYS_A_SCENE), seed))?;
    Ok(is_good)
}
