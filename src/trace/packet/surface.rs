//! Where the rays of a packet met their objects, and what the surfaces are like there.

use crate::effects::cell_point;
use crate::geometry::{Meeting, Real, Straight, Vector};
use crate::trace::shade::own_color;
use crate::trace::{
    BoardColumns, Kind, ObjectId, SceneTables, ShapeColumns, ShapeTable, SurfaceRow, SurfaceTable,
};

use super::closest::HitLanes;
use super::lanes::{LANES, Lanes, OUTWARD, RayLanes, VectorLanes, mask};

/// Surface points. An effect that a surface does not have counts 0.
#[derive(Clone, Copy, Debug)]
pub(super) struct SurfaceLanes<T> {
    pub(super) point: VectorLanes<T>,
    /// On the side that the ray came from.
    pub(super) normal: VectorLanes<T>,
    /// How a ray leaves on that side: the face that it leaves into the object, or [`OUTWARD`].
    pub(super) face: Lanes<u32>,
    /// Red, green, blue as x, y, z.
    pub(super) color: VectorLanes<T>,
    pub(super) ambient: Lanes<T>,
    pub(super) diffuse: Lanes<T>,
    pub(super) specular: Lanes<T>,
    pub(super) shininess: Lanes<T>,
    pub(super) reflectance: Lanes<T>,
    pub(super) any_gloss: bool,
    pub(super) any_mirror: bool,
}

/// What the active lanes met, one object after the other.
#[inline(always)]
pub(super) fn gather<T: Real>(
    tables: &SceneTables<T>,
    rays: &RayLanes<T>,
    hits: &HitLanes<T>,
    active: u32,
) -> SurfaceLanes<T> {
    let zero = [T::ZERO; LANES];
    let mut found = SurfaceLanes {
        point: VectorLanes::zero(),
        normal: VectorLanes::zero(),
        face: [OUTWARD; LANES],
        color: VectorLanes::zero(),
        ambient: zero,
        diffuse: zero,
        specular: zero,
        shininess: zero,
        reflectance: zero,
        any_gloss: false,
        any_mirror: false,
    };
    let mut left = active;
    while left != 0 {
        let name = hits.name[left.trailing_zeros() as usize];
        left &= !mask(|lane| hits.name[lane] == name);
        let ObjectId { kind, row } = ObjectId::unpacked(name);
        match kind {
            Kind::Sphere => found.add(&tables.spheres, row, name, rays, hits),
            Kind::Cube => found.add(&tables.cubes, row, name, rays, hits),
            Kind::Pyramid => found.add(&tables.pyramids, row, name, rays, hits),
            Kind::Board => {
                found.add(&tables.boards, row, name, rays, hits);
                found.paint(tables, row, name, hits);
            }
        }
    }
    found
}

impl<T: Real> SurfaceLanes<T> {
    /// The lanes that met one object.
    #[inline(always)]
    fn add<C>(
        &mut self,
        table: &ShapeTable<T, C>,
        row: u32,
        name: u32,
        rays: &RayLanes<T>,
        hits: &HitLanes<T>,
    ) where
        C: ShapeColumns<T, Shape: Straight<T>>,
    {
        self.locate(&table.shapes.shape(row as usize), name, rays, hits);
        self.coat(&table.surfaces, row, name, hits);
    }

    #[inline(always)]
    fn locate(&mut self, shape: &impl Straight<T>, name: u32, rays: &RayLanes<T>, hits: &HitLanes<T>) {
        for lane in 0..LANES {
            let ray = rays.get(lane);
            let met = shape.meet(&ray);
            let exits = hits.exit[lane] != OUTWARD;
            let face = if exits { hits.exit[lane] } else { met.face };
            let inside = exits | met.inside;
            let at = shape.surface(&ray, &Meeting { t: hits.t[lane], face, inside });
            let turned = -at.normal;
            let normal = Vector::new(
                if inside { turned.x } else { at.normal.x },
                if inside { turned.y } else { at.normal.y },
                if inside { turned.z } else { at.normal.z },
            );
            let own = hits.name[lane] == name;
            self.point.set_if(own, lane, at.point);
            self.normal.set_if(own, lane, normal);
            self.face[lane] = if own & inside { face } else { self.face[lane] };
        }
    }

    #[inline(always)]
    fn coat(&mut self, surfaces: &SurfaceTable<T>, row: u32, name: u32, hits: &HitLanes<T>) {
        let SurfaceRow { color, ambient, diffuse, gloss, mirror, .. } = surfaces.row(row as usize);
        let color = Vector::new(color.r, color.g, color.b);
        let (specular, shininess) =
            gloss.map_or((T::ZERO, T::ZERO), |gloss| (gloss.specular, gloss.shininess));
        let reflectance = mirror.unwrap_or(T::ZERO);
        self.any_gloss |= gloss.is_some();
        self.any_mirror |= mirror.is_some();
        for lane in 0..LANES {
            let own = hits.name[lane] == name;
            self.color.set_if(own, lane, color);
            self.ambient[lane] = if own { ambient } else { self.ambient[lane] };
            self.diffuse[lane] = if own { diffuse } else { self.diffuse[lane] };
            self.specular[lane] = if own { specular } else { self.specular[lane] };
            self.shininess[lane] = if own { shininess } else { self.shininess[lane] };
            self.reflectance[lane] = if own { reflectance } else { self.reflectance[lane] };
        }
    }

    /// The pattern of a checkerboard.
    #[inline(always)]
    fn paint(&mut self, tables: &SceneTables<T>, row: u32, name: u32, hits: &HitLanes<T>) {
        let boards: &BoardColumns<T> = &tables.boards.shapes;
        if boards.textures.get(row as usize).is_some() {
            return self.paint_texture(tables, row, name, hits);
        }
        let (origin, width) = boards.pattern(row as usize);
        for lane in 0..LANES {
            let point = self.point.get(lane);
            let white = cell_point(point.x - origin.x, point.y - origin.y, width).white;
            let black = (hits.name[lane] == name) & !white;
            self.color.set_if(black, lane, Vector::new(T::ZERO, T::ZERO, T::ZERO));
        }
    }

    #[cold]
    #[inline(never)]
    fn paint_texture(&mut self, tables: &SceneTables<T>, row: u32, name: u32, hits: &HitLanes<T>) {
        let plain = tables.boards.surfaces.row(row as usize).color;
        for lane in 0..LANES {
            if hits.name[lane] == name {
                let color =
                    own_color(tables, ObjectId { kind: Kind::Board, row }, plain, self.point.get(lane));
                self.color.set(lane, Vector::new(color.r, color.g, color.b));
            }
        }
    }
}
