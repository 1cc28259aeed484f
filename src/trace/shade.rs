//! The light that a surface point sends back by itself.

use crate::components::Texture;
use crate::effects::{Ball, Effect, Rgb, attenuation, cell_point, disk_point, lambert, phong, texel_index};
use crate::geometry::{Ray, Real, Side, SurfacePoint, Vector};

use super::kernel::known;
use super::{
    Counts, Departure, Hit, Kind, LightRow, ObjectId, Purpose, SampleId, SceneTables, SurfaceRow, Trail,
    is_occluded,
};

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

/// What a surface point is looked at for: samples of lights are drawn for it.
#[derive(Clone, Copy)]
pub(super) struct Look {
    /// The pixel's sample.
    pub(super) sample: SampleId,
    /// Number of the ray that met the point, within the sample.
    pub(super) ray: u32,
}

/// The light that reaches a surface point.
pub(super) struct Lighting<'a, T: Real> {
    pub(super) tables: &'a SceneTables<T>,
    pub(super) shaded: &'a Shaded<T>,
    pub(super) surface: &'a SurfaceRow<T>,
    /// Unit direction of the viewing ray after reflection; asked for only where the surface has gloss.
    pub(super) mirrored: Vector<T>,
    pub(super) look: Look,
}

/// Sums over all lights that reach a point; not capped.
#[derive(Clone, Copy)]
struct LightSums<T> {
    lambert: Rgb<T>,
    phong: Rgb<T>,
    trail: Trail,
}

impl<T: Real> Lighting<'_, T> {
    /// Ambient, diffuse and specular radiance of the point: `own * (a + d * lambert + s * phong)`. The lights that reach it
    /// are noted in the trail.
    #[inline(always)]
    pub(super) fn shade<const EFFECTS: u32>(
        &self,
        own: Rgb<T>,
        trail: &mut Trail,
        counts: &mut Counts,
    ) -> Rgb<T> {
        let surface = self.surface;
        let sums = self.gather::<EFFECTS>(*trail, counts);
        *trail = sums.trail;
        let specular = surface.gloss.map_or(Rgb::BLACK, |gloss| sums.phong * gloss.specular);
        own * ((Rgb::gray(surface.ambient) + sums.lambert * surface.diffuse) + specular)
    }

    #[inline(always)]
    fn gather<const EFFECTS: u32>(&self, trail: Trail, counts: &mut Counts) -> LightSums<T> {
        let mut sums = LightSums { lambert: Rgb::BLACK, phong: Rgb::BLACK, trail };
        for row in 0..self.tables.lights.len() {
            let light = self.tables.lights.row(row).of_kernel::<EFFECTS>();
            let color = light.color.unwrap_or(Rgb::WHITE);
            if color == Rgb::BLACK {
                continue;
            }
            if let Some(toward) = light.toward {
                self.add_parallel(row, toward, color, &mut sums, counts);
            } else if let Some(ball) = light.ball {
                self.add_ball(row, &light, ball, color, &mut sums, counts);
            } else {
                let segment = light.position - self.shaded.point;
                self.add_point(row, &light, segment, color, &mut sums, counts);
            }
        }
        sums
    }

    /// Light from `segment` away.
    #[inline(always)]
    fn add_point(
        &self,
        row: usize,
        light: &LightRow<T>,
        segment: Vector<T>,
        color: Rgb<T>,
        sums: &mut LightSums<T>,
        counts: &mut Counts,
    ) {
        // 1. Lights behind the surface, or in it (and a light at the very point, which has no direction).
        if segment.dot(self.shaded.normal) <= T::ZERO {
            return;
        }
        // 2. Lights whose cone does not contain the point.
        if light.cone.is_some_and(|cone| !cone.contains(-segment)) {
            return;
        }
        // 3. Lights of which nothing arrives from so far.
        let distance_squared = segment.dot(segment);
        let scale = light.falloff.map_or(T::ONE, |falloff| attenuation(distance_squared, falloff));
        if scale == T::ZERO {
            return;
        }
        // 4. Lights that something hides.
        if !self.is_hidden(segment, T::ONE, counts) {
            self.shine(row, segment.unit(), color * scale, sums);
        }
    }

    /// Light from a unit direction.
    #[inline(always)]
    fn add_parallel(
        &self,
        row: usize,
        toward: Vector<T>,
        color: Rgb<T>,
        sums: &mut LightSums<T>,
        counts: &mut Counts,
    ) {
        if toward.dot(self.shaded.normal) > T::ZERO && !self.is_hidden(toward, T::INFINITY, counts) {
            self.shine(row, toward, color, sums);
        }
    }

    /// Light from samples of a ball.
    #[inline(never)]
    fn add_ball(
        &self,
        row: usize,
        light: &LightRow<T>,
        ball: Ball<T>,
        color: Rgb<T>,
        sums: &mut LightSums<T>,
        counts: &mut Counts,
    ) {
        let to_center = light.position - self.shaded.point;
        // At its very centre nothing says which way it faces.
        if to_center == Vector::default() {
            return;
        }
        let sequence = self.look.sample.sequence(self.purpose(row));
        let first = self.look.sample.index.wrapping_mul(ball.samples);
        for number in 0..ball.samples {
            let on_disk = disk_point(sequence.point(first.wrapping_add(number)));
            let segment = ball.point(to_center, on_disk);
            self.add_point(row, light, segment, color * ball.share(), sums, counts);
        }
    }

    /// Each pair of ray and light draws points of its own.
    fn purpose(&self, row: usize) -> Purpose {
        // Lights are far fewer than 2^32.
        let [row, lights] = [row, self.tables.lights.len()].map(|n| u32::try_from(n).unwrap_or(u32::MAX));
        Purpose::Light(self.look.ray.wrapping_mul(lights).wrapping_add(row))
    }

    #[inline(always)]
    fn is_hidden(&self, segment: Vector<T>, reach: T, counts: &mut Counts) -> bool {
        counts.rays.shadow += 1;
        let ray = Ray { origin: self.shaded.point, direction: segment };
        is_occluded(self.tables, &ray, &self.shaded.departure, reach)
    }

    #[inline(always)]
    fn shine(&self, row: usize, to_light: Vector<T>, color: Rgb<T>, sums: &mut LightSums<T>) {
        sums.trail = sums.trail.lit_by(row);
        sums.lambert += color * lambert(to_light, self.shaded.normal);
        if let Some(gloss) = self.surface.gloss {
            sums.phong += color * phong(self.mirrored, to_light, gloss.shininess);
        }
    }
}

/// The own colour of an object at a point: plain, or the pattern or image of a checkerboard.
#[inline(always)]
pub(super) fn own_color<T: Real, const EFFECTS: u32>(
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
    match known::<EFFECTS, _>(Effect::Texture, boards.textures.get(row)) {
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
