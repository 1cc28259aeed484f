//! The recursion.

use crate::effects::{Rgb, reflect};
use crate::geometry::{Convex, Ray, Real, SurfacePoint};

use super::shade::{Lighting, Look, Shaded, own_color};
use super::{CameraRay, Counts, Departure, Hit, Kind, SampleId, SceneTables, ShapeColumns, closest_hit};

/// The radiance that arrives along a ray of the camera from surfaces within its reach, followed through mirrors for at
/// most `level` rays in all (T. Whitted, "An Improved Illumination Model for Shaded Display", CACM 23(6), 1980).
/// Not clamped. The caller counts the ray itself.
///
/// Every surface sends on at most one ray, so the recursion `local + r * (local + r * ...)` is a loop that carries
/// the product of the reflectances: no level overflows a stack.
#[inline(never)]
pub fn radiance<T: Real>(
    tables: &SceneTables<T>,
    start: CameraRay<T>,
    level: u32,
    sample: SampleId,
    counts: &mut Counts,
) -> Rgb<T> {
    let mut sum = Rgb::BLACK;
    let mut weight = T::ONE;
    let CameraRay { mut ray, mut reach } = start;
    let mut departure = Departure::Free;
    for remaining in (0..level).rev() {
        let Some(hit) = closest_hit(tables, &ray, &departure, reach) else {
            break;
        };
        let at = locate(tables, &hit, &ray);
        let shaded = Shaded::new(&hit, at);
        let (surfaces, row) = tables.surface(hit.object);
        let surface = surfaces.row(row);
        let reflectance = surface.mirror.filter(|_| remaining > 0);
        // One reflected direction serves gloss and mirror; a surface with neither never computes it.
        let needs_mirrored = surface.gloss.is_some() || reflectance.is_some();
        let mirrored = if needs_mirrored { reflect(ray.direction, shaded.normal) } else { ray.direction };
        let own = own_color(tables, hit.object, surface.color, shaded.point);
        let look = Look { sample, ray: level - remaining };
        let lighting = Lighting { tables, shaded: &shaded, surface: &surface, mirrored, look };
        sum += lighting.shade(own, counts) * weight;

        let Some(reflectance) = reflectance else { break };
        weight *= reflectance;
        if weight == T::ZERO {
            break;
        }
        counts.rays.mirror += 1;
        ray = Ray { origin: shaded.point, direction: mirrored };
        reach = T::INFINITY;
        departure = shaded.departure;
    }
    sum
}

/// The surface point of a hit.
#[inline(always)]
fn locate<T: Real>(tables: &SceneTables<T>, hit: &Hit<T>, ray: &Ray<T>) -> SurfacePoint<T> {
    let row = hit.object.row as usize;
    match hit.object.kind {
        Kind::Sphere => tables.spheres.shapes.shape(row).locate(ray, &hit.crossing),
        Kind::Cube => tables.cubes.shapes.shape(row).locate(ray, &hit.crossing),
        Kind::Pyramid => tables.pyramids.shapes.shape(row).locate(ray, &hit.crossing),
        Kind::Board => tables.boards.shapes.shape(row).locate(ray, &hit.crossing),
    }
}
