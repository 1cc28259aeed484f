//! The light that a surface point sends back by itself.

use crate::effects::{
    Ball, CellPoint, Effect, Rgb, attenuation, cell_point, disk_point, lambert, phong, texel_index,
};
use crate::geometry::{Ray, Real, Side, SurfacePoint, Vector};

use super::kernel::known;
use super::{
    BoardTexture, Counts, Departure, Hit, Kind, ObjectId, Purpose, SampleId, SceneTables, SurfaceRow, Trail,
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

/// Ambient, diffuse and specular radiance of a point: `own * (a + d * lambert + s * phong)`. The lights that reach it are
/// noted in the trail.
pub(super) fn shade<T: Real, const EFFECTS: u32>(
    lighting: &Lighting<'_, T>,
    own: Rgb<T>,
    trail: &mut Trail,
    counts: &mut Counts,
) -> Rgb<T> {
    let surface = lighting.surface;
    let sums = lighting.gather::<EFFECTS>(*trail, counts);
    *trail = sums.trail;
    let gloss = known::<EFFECTS, _>(Effect::Gloss, surface.gloss);
    let specular = gloss.map_or(Rgb::BLACK, |gloss| sums.phong * gloss.specular);
    own * ((Rgb::gray(surface.ambient) + sums.lambert * surface.diffuse) + specular)
}

impl<T: Real> Lighting<'_, T> {
    #[inline(always)]
    fn gather<const EFFECTS: u32>(&self, trail: Trail, counts: &mut Counts) -> LightSums<T> {
        let mut sums = LightSums { lambert: Rgb::BLACK, phong: Rgb::BLACK, trail };
        for row in 0..self.tables.lights.len() {
            let lights = &self.tables.lights;
            if let Some(toward) = known::<EFFECTS, _>(Effect::Directional, lights.toward.get(row)) {
                self.add_parallel::<EFFECTS>(row, *toward, &mut sums, counts);
            } else if let Some(ball) = known::<EFFECTS, _>(Effect::AreaLight, lights.ball.get(row)) {
                self.add_ball::<EFFECTS>(row, ball, &mut sums, counts);
            } else {
                let segment = lights.position(row) - self.shaded.point;
                self.add_point::<EFFECTS>(row, segment, T::ONE, &mut sums, counts);
            }
        }
        sums
    }

    /// Light of a share of a light from `segment` away. What the light is like is asked when it matters.
    #[inline(always)]
    fn add_point<const EFFECTS: u32>(
        &self,
        row: usize,
        segment: Vector<T>,
        share: T,
        sums: &mut LightSums<T>,
        counts: &mut Counts,
    ) {
        // 1. Lights behind the surface, or in it (and a light at the very point, which has no direction).
        if segment.dot(self.shaded.normal) <= T::ZERO {
            return;
        }
        // 2. Lights whose cone does not contain the point.
        let cone = known::<EFFECTS, _>(Effect::SpotCone, self.tables.lights.cone.get(row));
        if cone.is_some_and(|cone| !cone.contains(-segment)) {
            return;
        }
        // 3. Lights of which nothing arrives from so far.
        let falloff = known::<EFFECTS, _>(Effect::Falloff, self.tables.lights.falloff.get(row));
        let scale = falloff.map_or(share, |&falloff| share * attenuation(segment.dot(segment), falloff));
        if scale == T::ZERO {
            return;
        }
        self.shine_unless_hidden::<EFFECTS>(row, (segment, T::ONE), || segment.unit(), scale, sums, counts);
    }

    /// Light from a unit direction.
    #[inline(always)]
    fn add_parallel<const EFFECTS: u32>(
        &self,
        row: usize,
        toward: Vector<T>,
        sums: &mut LightSums<T>,
        counts: &mut Counts,
    ) {
        if toward.dot(self.shaded.normal) > T::ZERO {
            self.shine_unless_hidden::<EFFECTS>(row, (toward, T::INFINITY), || toward, T::ONE, sums, counts);
        }
    }

    /// Light from samples of a ball.
    #[inline(always)]
    fn add_ball<const EFFECTS: u32>(
        &self,
        row: usize,
        ball: &Ball<T>,
        sums: &mut LightSums<T>,
        counts: &mut Counts,
    ) {
        let to_center = self.tables.lights.position(row) - self.shaded.point;
        // At its very centre nothing says which way it faces.
        if to_center == Vector::default() {
            return;
        }
        let sequence = self.look.sample.sequence(self.purpose(row));
        let first = self.look.sample.index.wrapping_mul(ball.samples);
        for number in 0..ball.samples {
            let on_disk = disk_point(sequence.point(first.wrapping_add(number)));
            let segment = ball.point(to_center, on_disk);
            self.add_point::<EFFECTS>(row, segment, ball.share(), sums, counts);
        }
    }

    /// Each pair of ray and light draws points of its own.
    #[inline(always)]
    fn purpose(&self, row: usize) -> Purpose {
        // Lights are far fewer than 2^32.
        let [row, lights] = [row, self.tables.lights.len()].map(|n| u32::try_from(n).unwrap_or(u32::MAX));
        Purpose::Light(self.look.ray.wrapping_mul(lights).wrapping_add(row))
    }

    /// Light from a direction, unless it is black or something in its reach hides it; `to_light` is the direction's unit.
    #[inline(always)]
    fn shine_unless_hidden<const EFFECTS: u32>(
        &self,
        row: usize,
        (segment, reach): (Vector<T>, T),
        to_light: impl FnOnce() -> Vector<T>,
        scale: T,
        sums: &mut LightSums<T>,
        counts: &mut Counts,
    ) {
        let color = known::<EFFECTS, _>(Effect::LightColor, self.tables.lights.color.get(row));
        if color == Some(&Rgb::BLACK) || self.is_hidden(segment, reach, counts) {
            return;
        }
        let color = color.map_or(Rgb::gray(scale), |&color| color * scale);
        self.shine::<EFFECTS>(row, to_light(), color, sums);
    }

    #[inline(always)]
    fn is_hidden(&self, segment: Vector<T>, reach: T, counts: &mut Counts) -> bool {
        counts.rays.shadow += 1;
        let ray = Ray { origin: self.shaded.point, direction: segment };
        is_hidden(self.tables, &ray, &self.shaded.departure, reach)
    }

    #[inline(always)]
    fn shine<const EFFECTS: u32>(
        &self,
        row: usize,
        to_light: Vector<T>,
        color: Rgb<T>,
        sums: &mut LightSums<T>,
    ) {
        sums.trail = sums.trail.lit_by(row);
        sums.lambert += color * lambert(to_light, self.shaded.normal);
        if let Some(gloss) = known::<EFFECTS, _>(Effect::Gloss, self.surface.gloss) {
            sums.phong += color * phong(self.mirrored, to_light, gloss.shininess);
        }
    }
}

/// [`is_occluded`], once for all that shades.
#[inline(never)]
fn is_hidden<T: Real>(tables: &SceneTables<T>, ray: &Ray<T>, departure: &Departure, reach: T) -> bool {
    is_occluded(tables, ray, departure, reach)
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
        Some(texture) => texel_color(texture, &cell),
        None if cell.white => plain,
        None => Rgb::BLACK,
    }
}

/// The texel of a cell's image. Not inlined: boards without images would pay for its registers.
#[inline(never)]
fn texel_color<T: Real>(texture: &BoardTexture, cell: &CellPoint<T>) -> Rgb<T> {
    let image = if cell.white { &texture.white } else { &texture.black };
    let column = texel_index(cell.along_x, image.width());
    let row = texel_index(T::ONE - cell.along_y, image.height());
    Rgb::from_bytes(image.texel(column, row))
}
