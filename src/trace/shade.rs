//! The light that a surface point sends back by itself.

use crate::effects::{
    Ball, BoardTexture, CellPoint, Effect, Rgb, attenuation, cell_point, disk_point, lambert, phong,
    texel_index,
};
use crate::geometry::{Ray, Real, Side, SurfacePoint, Vector};

use super::kernel::known;
use super::stages::Stages;
use super::{
    Counts, Departure, Hit, Kind, ObjectId, Purpose, SampleId, SceneTables, SurfaceRow, Trail, is_occluded,
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
    pub(super) stages: &'a Stages<T>,
    pub(super) shaded: &'a Shaded<T>,
    pub(super) surface: &'a SurfaceRow<T>,
    /// Unit direction of the viewing ray after reflection; asked for only where the surface has gloss.
    pub(super) mirrored: Vector<T>,
    pub(super) look: Look,
}

/// Sums over all lights that reach a point; not capped.
#[derive(Clone, Copy)]
pub(super) struct LightSums<T> {
    lambert: Rgb<T>,
    phong: Rgb<T>,
    trail: Trail,
}

/// Light on its way to a point, unless something hides it.
#[derive(Clone, Copy)]
pub(super) struct Arrival<T> {
    /// Of the light.
    row: usize,
    /// From the point to the light, or the unit direction to one that has no place.
    segment: Vector<T>,
    /// Where along the segment the light is: 1, or infinity.
    reach: T,
    /// Share of the light that arrives.
    scale: T,
}

impl<T: Real> Lighting<'_, T> {
    /// Ambient, diffuse and specular radiance of the point: `own * (a + d * lambert + s * phong)`. The lights that reach it
    /// are noted in the trail.
    #[inline(always)]
    pub(super) fn shade(&self, own: Rgb<T>, trail: &mut Trail, counts: &mut Counts) -> Rgb<T> {
        let surface = self.surface;
        let mut sums = LightSums { lambert: Rgb::BLACK, phong: Rgb::BLACK, trail: *trail };
        (self.stages.gather)(self, &mut sums, counts);
        *trail = sums.trail;
        let specular = surface.effects.gloss.map_or(Rgb::BLACK, |gloss| sums.phong * gloss.specular);
        own * ((Rgb::gray(surface.ambient) + sums.lambert * surface.diffuse) + specular)
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
        let cone = known::<EFFECTS, _>(Effect::SpotCone, self.tables.lights.effects.spot_cone.get(row));
        if cone.is_some_and(|cone| !cone.contains(-segment)) {
            return;
        }
        // 3. Lights of which nothing arrives from so far.
        let falloff = known::<EFFECTS, _>(Effect::Falloff, self.tables.lights.effects.falloff.get(row));
        let scale = falloff.map_or(share, |&falloff| share * attenuation(segment.dot(segment), falloff));
        if scale == T::ZERO {
            return;
        }
        (self.stages.shine)(self, Arrival { row, segment, reach: T::ONE, scale }, sums, counts);
    }

    /// Light from a unit direction.
    #[inline(always)]
    fn add_parallel(&self, row: usize, toward: Vector<T>, sums: &mut LightSums<T>, counts: &mut Counts) {
        if toward.dot(self.shaded.normal) > T::ZERO {
            let arrival = Arrival { row, segment: toward, reach: T::INFINITY, scale: T::ONE };
            (self.stages.shine)(self, arrival, sums, counts);
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
}

/// Sums up all lights, with shapes and strengths that have no effects but these.
pub(super) fn gather<T: Real, const EFFECTS: u32>(
    lighting: &Lighting<'_, T>,
    sums: &mut LightSums<T>,
    counts: &mut Counts,
) {
    let lights = &lighting.tables.lights;
    for row in 0..lights.len() {
        if let Some(toward) = known::<EFFECTS, _>(Effect::Directional, lights.effects.directional.get(row)) {
            lighting.add_parallel(row, *toward, sums, counts);
        } else if let Some(ball) = known::<EFFECTS, _>(Effect::AreaLight, lights.effects.area_light.get(row))
        {
            lighting.add_ball::<EFFECTS>(row, ball, sums, counts);
        } else {
            let segment = lights.position(row) - lighting.shaded.point;
            lighting.add_point::<EFFECTS>(row, segment, T::ONE, sums, counts);
        }
    }
}

/// Adds what light does where it arrives, unless it is black or something hides it, with no effects but these.
pub(super) fn shine<T: Real, const EFFECTS: u32>(
    lighting: &Lighting<'_, T>,
    Arrival { row, segment, reach, scale }: Arrival<T>,
    sums: &mut LightSums<T>,
    counts: &mut Counts,
) {
    let color = known::<EFFECTS, _>(Effect::LightColor, lighting.tables.lights.effects.light_color.get(row));
    if color == Some(&Rgb::BLACK) {
        return;
    }
    counts.rays.shadow += 1;
    let &Shaded { point, normal, ref departure } = lighting.shaded;
    if is_hidden(lighting.tables, &Ray { origin: point, direction: segment }, departure, reach) {
        return;
    }
    let to_light = if reach == T::INFINITY { segment } else { segment.unit() };
    let color = color.map_or(Rgb::gray(scale), |&color| color * scale);
    sums.trail = sums.trail.lit_by(row);
    sums.lambert += color * lambert(to_light, normal);
    if let Some(gloss) = known::<EFFECTS, _>(Effect::Gloss, lighting.surface.effects.gloss) {
        sums.phong += color * phong(lighting.mirrored, to_light, gloss.shininess);
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
    match known::<EFFECTS, _>(Effect::Texture, boards.effects.texture.get(row)) {
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
