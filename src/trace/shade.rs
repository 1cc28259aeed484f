//! The light that a surface point sends back by itself.

use crate::components::Texture;
use crate::effects::{Rgb, attenuation, cell_point, lambert, phong, texel_index};
use crate::geometry::{Ray, Real, Side, SurfacePoint, Vector};

use super::{Counts, Departure, GlossRow, Hit, Kind, ObjectId, SceneTables, SurfaceRow, is_occluded};

/// A surface point as the shading sees it.
pub(super) struct Shaded<T> {
    /// On the surface.
    pub(super) point: Vector<T>,
    /// Unit normal, on the side that the ray came from.
    pub(super) normal: Vector<T>,
    /// How rays leave it on that side.
    pub(super) departure: Departure,
}

impl<T: Real> Shaded<T> {
    /// The point of a hit, with its normal turned to the side of the ray.
    #[inline(always)]
    pub(super) fn new(hit: &Hit<T>, at: SurfacePoint<T>) -> Self {
        let normal = match hit.crossing.side {
            Side::Outside => at.normal,
            Side::Inside => -at.normal,
        };
        Self { point: at.point, normal, departure: hit.departure() }
    }
}

/// Sums over all lights that reach a point; not capped.
#[derive(Clone, Copy)]
struct LightSums<T> {
    lambert: T,
    phong: T,
}

/// Ambient, diffuse and specular radiance of a surface point: `own * (a + d * lambert + s * phong)`. `mirrored` is
/// the unit direction of the viewing ray after reflection; it is asked for only where the surface has gloss.
#[inline(always)]
pub(super) fn shade_local<T: Real>(
    tables: &SceneTables<T>,
    shaded: &Shaded<T>,
    surface: &SurfaceRow<T>,
    own: Rgb<T>,
    mirrored: Vector<T>,
    counts: &mut Counts,
) -> Rgb<T> {
    let gloss = surface.gloss;
    let sums = gather_lights(tables, shaded, gloss, mirrored, counts);
    let specular = gloss.map_or(T::ZERO, |gloss| gloss.specular * sums.phong);
    own * ((surface.ambient + surface.diffuse * sums.lambert) + specular)
}

#[inline(always)]
fn gather_lights<T: Real>(
    tables: &SceneTables<T>,
    shaded: &Shaded<T>,
    gloss: Option<GlossRow<T>>,
    mirrored: Vector<T>,
    counts: &mut Counts,
) -> LightSums<T> {
    let mut sums = LightSums { lambert: T::ZERO, phong: T::ZERO };
    for row in 0..tables.lights.len() {
        let light = tables.lights.row(row);
        let segment = light.position - shaded.point;
        // 1. Lights behind the surface, or in it (and a light at the very point, which has no direction).
        if segment.dot(shaded.normal) <= T::ZERO {
            continue;
        }
        // 2. Lights whose cone does not contain the point.
        if light.cone.is_some_and(|cone| !cone.contains(-segment)) {
            continue;
        }
        // 3. Lights of which nothing arrives from so far.
        let distance_squared = segment.dot(segment);
        let scale = light.falloff.map_or(T::ONE, |falloff| attenuation(distance_squared, falloff));
        if scale == T::ZERO {
            continue;
        }
        // 4. Lights that something hides.
        counts.rays.shadow += 1;
        if is_occluded(tables, &Ray { origin: shaded.point, direction: segment }, &shaded.departure) {
            continue;
        }
        let to_light = segment.unit();
        sums.lambert += lambert(to_light, shaded.normal) * scale;
        if let Some(gloss) = gloss {
            sums.phong += phong(mirrored, to_light, gloss.shininess) * scale;
        }
    }
    sums
}

/// The own colour of an object at a point: plain, or the pattern or image of a checkerboard.
#[inline(always)]
pub(super) fn own_color<T: Real>(
    tables: &SceneTables<T>,
    object: ObjectId,
    plain: Rgb<T>,
    point: Vector<T>,
) -> Rgb<T> {
    if object.kind != Kind::Board {
        return plain;
    }
    let boards = &tables.boards.shapes;
    let row = object.row as usize;
    let (origin, width) = boards.pattern(row);
    let cell = cell_point(point.x - origin.x, point.y - origin.y, width);
    match boards.textures.get(row) {
        Some(texture) => {
            let image = if cell.white { &texture.white } else { &texture.black };
            texel_color(image, cell.along_x, T::ONE - cell.along_y)
        }
        None if cell.white => plain,
        None => Rgb::BLACK,
    }
}

/// The texel at a position from the left and from the top, each 0 to 1.
fn texel_color<T: Real>(image: &Texture, from_left: T, from_top: T) -> Rgb<T> {
    let column = texel_index(from_left, image.width());
    let row = texel_index(from_top, image.height());
    Rgb::from_bytes(image.texel(column, row))
}
