//! Where the rays of a packet met their objects, and what the surfaces are like there.

use crate::effects::{Effect, cell_point};
use crate::geometry::{Real, Straight, Vector};
use crate::trace::hit::FaceCode;
use crate::trace::shade::own_color;
use crate::trace::{
    BoardColumns, Kind, ObjectId, SceneTables, ShapeColumns, ShapeTable, SurfaceRow, SurfaceTable,
};

use super::closest::HitLanes;
use super::has;
use super::lanes::{LANES, Lanes, OUTWARD, RayLanes, StartLanes, VectorLanes, any, least};

/// Surface points. An effect that a surface does not have counts 0. Idle lanes hold anything.
#[derive(Clone, Copy, Debug)]
pub(super) struct SurfaceLanes<T> {
    /// How rays leave, on the side that they came from.
    pub(super) start: StartLanes<T>,
    /// On that side.
    pub(super) normal: VectorLanes<T>,
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

/// What the active lanes met, one object after the other. In place: zeros and a copy for every packet are kilobytes.
#[inline(always)]
pub(super) fn gather<T: Real, const EFFECTS: u32>(
    tables: &SceneTables<T>,
    rays: &RayLanes<'_, T>,
    hits: &HitLanes<T>,
    found: &mut SurfaceLanes<T>,
) {
    found.forget::<EFFECTS>();
    found.start.departed = hits.name;
    let mut left = hits.name;
    loop {
        let name = least(&left);
        if name == ObjectId::NOBODY {
            break;
        }
        for lane in 0..LANES {
            left[lane] = if left[lane] == name { ObjectId::NOBODY } else { left[lane] };
        }
        let ObjectId { kind, row } = ObjectId::unpacked(name);
        match kind {
            Kind::Sphere => found.add::<_, EFFECTS>(&tables.spheres, row, name, rays, hits),
            Kind::Cube => found.add::<_, EFFECTS>(&tables.cubes, row, name, rays, hits),
            Kind::Pyramid => found.add::<_, EFFECTS>(&tables.pyramids, row, name, rays, hits),
            Kind::Board => {
                found.add::<_, EFFECTS>(&tables.boards, row, name, rays, hits);
                found.paint::<EFFECTS>(tables, row, name);
            }
        }
    }
    found.start.any_inward = any(|lane| found.start.face[lane] != OUTWARD);
}

impl<T: Real> SurfaceLanes<T> {
    /// Nothing met yet.
    pub(super) fn none() -> Self {
        let zero = [T::ZERO; LANES];
        Self {
            start: StartLanes::free(),
            normal: VectorLanes::zero(),
            color: VectorLanes::zero(),
            ambient: zero,
            diffuse: zero,
            specular: zero,
            shininess: zero,
            reflectance: zero,
            any_gloss: false,
            any_mirror: false,
        }
    }

    /// Forgets what not every object sets in its lanes.
    #[inline(always)]
    fn forget<const EFFECTS: u32>(&mut self) {
        self.start.face = [OUTWARD; LANES];
        if has::<EFFECTS>(Effect::Gloss) && self.any_gloss {
            self.specular = [T::ZERO; LANES];
            self.any_gloss = false;
        }
        if has::<EFFECTS>(Effect::Mirror) && self.any_mirror {
            self.reflectance = [T::ZERO; LANES];
            self.any_mirror = false;
        }
    }

    /// The lanes that met one object.
    #[inline(always)]
    fn add<C, const EFFECTS: u32>(
        &mut self,
        table: &ShapeTable<T, C>,
        row: u32,
        name: u32,
        rays: &RayLanes<'_, T>,
        hits: &HitLanes<T>,
    ) where
        C: ShapeColumns<T, Shape: Straight<T>>,
    {
        self.locate(&table.shapes.shape(row as usize), name, rays, hits);
        self.coat::<EFFECTS>(&table.surfaces, row, name);
    }

    #[inline(always)]
    fn locate(&mut self, shape: &impl Straight<T>, name: u32, rays: &RayLanes<'_, T>, hits: &HitLanes<T>) {
        // By itself: between points and normals, compilers take it for numbers of f64 that a loop might write.
        let mut face = self.start.face;
        for lane in 0..LANES {
            let met = FaceCode::meeting(hits.face[lane], hits.t[lane]);
            let at = shape.surface(&rays.get(lane), &met);
            let turned = -at.normal;
            let normal = Vector::new(
                if met.inside { turned.x } else { at.normal.x },
                if met.inside { turned.y } else { at.normal.y },
                if met.inside { turned.z } else { at.normal.z },
            );
            let own = hits.name[lane] == name;
            self.start.point.set_if(own, lane, at.point);
            self.normal.set_if(own, lane, normal);
            face[lane] = if own & met.inside { met.face } else { face[lane] };
        }
        self.start.face = face;
    }

    #[inline(always)]
    fn coat<const EFFECTS: u32>(&mut self, surfaces: &SurfaceTable<T>, row: u32, name: u32) {
        let SurfaceRow { color, ambient, diffuse, effects } = surfaces.row(row as usize);
        let color = Vector::new(color.r, color.g, color.b);
        for lane in 0..LANES {
            let own = self.start.departed[lane] == name;
            self.color.set_if(own, lane, color);
            self.ambient[lane] = if own { ambient } else { self.ambient[lane] };
            self.diffuse[lane] = if own { diffuse } else { self.diffuse[lane] };
        }
        // Only for those that have them: selections for all took 1 % of a scene without any mirror.
        if has::<EFFECTS>(Effect::Gloss)
            && let Some(gloss) = effects.gloss
        {
            self.any_gloss = true;
            for lane in 0..LANES {
                let own = self.start.departed[lane] == name;
                self.specular[lane] = if own { gloss.specular } else { self.specular[lane] };
                self.shininess[lane] = if own { gloss.shininess } else { self.shininess[lane] };
            }
        }
        if has::<EFFECTS>(Effect::Mirror)
            && let Some(reflectance) = effects.mirror
        {
            self.any_mirror = true;
            for lane in 0..LANES {
                let own = self.start.departed[lane] == name;
                self.reflectance[lane] = if own { reflectance } else { self.reflectance[lane] };
            }
        }
    }

    /// The pattern of a checkerboard.
    #[inline(always)]
    fn paint<const EFFECTS: u32>(&mut self, tables: &SceneTables<T>, row: u32, name: u32) {
        let boards: &BoardColumns<T> = &tables.boards.shapes;
        if has::<EFFECTS>(Effect::Texture) && boards.effects.texture.get(row as usize).is_some() {
            return self.paint_texture::<EFFECTS>(tables, row, name);
        }
        let (origin, width) = boards.pattern(row as usize);
        // By themselves, as in `locate`.
        let departed = self.start.departed;
        for lane in 0..LANES {
            let point = self.start.point.get(lane);
            let white = cell_point(point.x - origin.x, point.y - origin.y, width).white;
            let black = (departed[lane] == name) & !white;
            self.color.set_if(black, lane, Vector::new(T::ZERO, T::ZERO, T::ZERO));
        }
    }

    #[cold]
    #[inline(never)]
    fn paint_texture<const EFFECTS: u32>(&mut self, tables: &SceneTables<T>, row: u32, name: u32) {
        let plain = tables.boards.surfaces.row(row as usize).color;
        for lane in 0..LANES {
            if self.start.departed[lane] == name {
                let color = own_color::<T, EFFECTS>(
                    tables,
                    ObjectId { kind: Kind::Board, row },
                    plain,
                    self.start.point.get(lane),
                );
                self.color.set(lane, Vector::new(color.r, color.g, color.b));
            }
        }
    }
}
