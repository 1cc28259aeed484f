//! What is drawn: one row an object, in the order in which ties between surfaces are won.

use glam::{DVec2, DVec3};

use crate::components::{Checkerboard, Cube, Pyramid, Sphere, SpotCone, Textured};

use super::lines::{axes, cone, outline};
use super::rows::{Row, Rows, is_drawable_length, is_drawable_point, pair, pairs, tint};

/// Colour of a light's marker.
const LIGHT_COLOR: DVec3 = DVec3::new(1.0, 0.93, 0.75);

/// An object: its shape, where it is, its plain colour, and its place in the scene's order.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed<S> {
    /// The shape.
    pub shape: S,
    /// Where the shape is placed, in world units.
    pub position: DVec3,
    /// Linear red, green, blue, each 0 to 1.
    pub color: DVec3,
    /// Of surfaces in the same place the lower one shows; equal ones as they stand in their list, cubes first.
    pub order: u32,
}

/// Plain numbers of everything that the preview draws. Each kind is replaced as a whole; what is not replaced is not
/// sent to GL again. Objects whose numbers are not finite, or beyond 1e30, are left out.
#[derive(Clone, Debug, Default)]
pub struct DrawList {
    pub(super) spheres: Rows<3>,
    pub(super) solids: Solids,
    pub(super) boards: Vec<Board>,
    pub(super) markers: Rows<3>,
    pub(super) cones: Rows<5>,
    pub(super) axes: Rows<5>,
    pub(super) outline: Rows<5>,
    outlined: Option<[DVec3; 2]>,
    extents: Extents,
    axes_length: f64,
}

/// Cubes and pyramids, which can touch face to face and hence share one order.
#[derive(Clone, Debug, Default)]
pub(super) struct Solids {
    pub(super) rows: Rows<5>,
    /// Order of each row.
    pub(super) order: Vec<u32>,
    cubes: Vec<(u32, Row<5>)>,
    pyramids: Vec<(u32, Row<5>)>,
}

/// A checkerboard.
#[derive(Clone, Debug)]
pub(super) struct Board {
    pub(super) height: [f32; 2],
    pub(super) origin: DVec2,
    pub(super) cell: f64,
    pub(super) tint: [f32; 4],
    pub(super) order: u32,
    pub(super) textured: Option<Textured>,
}

/// How far objects of each kind, and lights, reach from the world's origin along any axis.
#[derive(Clone, Copy, Debug, Default)]
struct Extents {
    spheres: Extent,
    cubes: Extent,
    pyramids: Extent,
    lights: Extent,
    /// Of boards the widest cell, since none of them ends.
    boards: Extent,
}

/// What was found about one kind.
#[derive(Clone, Copy, Debug, Default)]
struct Extent {
    reach: f64,
    left_out: usize,
}

impl DrawList {
    /// Replaces the spheres.
    pub fn set_spheres(&mut self, spheres: &[Placed<Sphere>]) {
        let row = |sphere: &Placed<Sphere>| {
            let [high, low] = pairs(sphere.position, sphere.shape.radius);
            [high, low, tint(sphere.color)]
        };
        let drawable: Vec<_> =
            spheres.iter().filter(|sphere| sphere.is_drawable(sphere.shape.radius)).collect();
        self.spheres = Rows::new(drawable.iter().map(|sphere| row(sphere)).collect());
        let reaches = drawable.iter().map(|sphere| sphere.reach(sphere.shape.radius));
        self.extents.spheres = Extent::of(reaches, spheres.len());
        self.measure_axes();
    }

    /// Replaces the cubes.
    pub fn set_cubes(&mut self, cubes: &[Placed<Cube>]) {
        let row = |cube: &Placed<Cube>| {
            let side = DVec3::splat(cube.shape.side);
            let ([low, low_rest], [high, high_rest]) =
                (pairs(cube.position, 0.0), pairs(cube.position + side, 0.0));
            (cube.order, [low, low_rest, high, high_rest, tint(cube.color)])
        };
        let drawable: Vec<_> = cubes.iter().filter(|cube| cube.is_drawable(cube.shape.side)).collect();
        self.solids.cubes = drawable.iter().map(|cube| row(cube)).collect();
        self.solids.merge();
        let reaches = drawable.iter().map(|cube| cube.reach(cube.shape.side));
        self.extents.cubes = Extent::of(reaches, cubes.len());
        self.measure_axes();
    }

    /// Replaces the pyramids.
    pub fn set_pyramids(&mut self, pyramids: &[Placed<Pyramid>]) {
        let row = |pyramid: &Placed<Pyramid>| {
            let Pyramid { width, height } = pyramid.shape;
            let half_width = 0.5 * width;
            let apex = pyramid.position + DVec3::new(half_width, half_width, height);
            let foot = apex.with_z(pyramid.position.z);
            let ([low, low_rest], [high, high_rest]) = (pairs(foot, half_width), pairs(apex, height));
            (pyramid.order, [low, low_rest, high, high_rest, tint(pyramid.color)])
        };
        let is_drawable = |pyramid: &&Placed<Pyramid>| {
            pyramid.is_drawable(pyramid.shape.width) && pyramid.is_drawable(pyramid.shape.height)
        };
        let drawable: Vec<_> = pyramids.iter().filter(is_drawable).collect();
        self.solids.pyramids = drawable.iter().map(|pyramid| row(pyramid)).collect();
        self.solids.merge();
        let reach = |pyramid: &&Placed<Pyramid>| pyramid.reach(pyramid.shape.width.max(pyramid.shape.height));
        self.extents.pyramids = Extent::of(drawable.iter().map(reach), pyramids.len());
        self.measure_axes();
    }

    /// Replaces the checkerboards.
    pub fn set_boards(&mut self, boards: &[(Placed<Checkerboard>, Option<Textured>)]) {
        let is_drawable = |(board, _): &&(Placed<Checkerboard>, _)| board.is_drawable(board.shape.cell);
        let drawable = boards.iter().filter(is_drawable).map(|(board, textured)| Board {
            height: pair(board.position.z),
            origin: board.position.truncate(),
            cell: board.shape.cell,
            tint: tint(board.color),
            order: board.order,
            textured: textured.clone(),
        });
        self.boards = drawable.collect();
        self.extents.boards = Extent::of(self.boards.iter().map(|board| board.cell), boards.len());
        self.measure_axes();
    }

    /// Replaces the lights: their places and cones.
    pub fn set_lights(&mut self, lights: &[(DVec3, Option<SpotCone>)]) {
        let drawable: Vec<_> = lights.iter().filter(|(position, _)| is_drawable_point(*position)).collect();
        let marker = |position: DVec3| {
            let [high, low] = pairs(position, 0.0);
            [high, low, tint(LIGHT_COLOR)]
        };
        self.markers = Rows::new(drawable.iter().map(|(position, _)| marker(*position)).collect());
        let cones =
            drawable.iter().filter_map(|(position, spot)| spot.as_ref().map(|spot| cone(*position, spot)));
        self.cones = Rows::new(cones.flatten().collect());
        let reaches = drawable.iter().map(|(position, _)| position.abs().max_element());
        self.extents.lights = Extent::of(reaches, lights.len());
        self.measure_axes();
    }

    /// Shows the edges of a box between two opposite corners, in world units, or no box.
    pub fn set_outline(&mut self, corners: Option<[DVec3; 2]>) {
        let corners = corners.filter(|corners| corners.iter().all(|corner| is_drawable_point(*corner)));
        if self.outlined != corners {
            self.outlined = corners;
            self.outline = Rows::new(corners.map(outline).unwrap_or_default());
        }
    }

    /// How many objects and lights cannot be drawn because their numbers are not finite, or beyond 1e30.
    pub fn left_out(&self) -> usize {
        let Extents { spheres, cubes, pyramids, lights, boards } = self.extents;
        [spheres, cubes, pyramids, lights, boards].iter().map(|kind| kind.left_out).sum()
    }

    /// The axes reach as far as the scene does.
    fn measure_axes(&mut self) {
        let Extents { spheres, cubes, pyramids, lights, boards } = self.extents;
        let scene = [spheres, cubes, pyramids, lights].iter().fold(0.0, |most, kind| kind.reach.max(most));
        let length = if scene > 0.0 { scene } else { 10.0 * boards.reach };
        if self.axes_length != length {
            self.axes_length = length;
            self.axes = Rows::new(axes(length));
        }
    }
}

impl Solids {
    fn merge(&mut self) {
        let mut all: Vec<&(u32, Row<5>)> = self.cubes.iter().chain(&self.pyramids).collect();
        all.sort_by_key(|(order, _)| *order);
        self.order = all.iter().map(|(order, _)| *order).collect();
        self.rows = Rows::new(all.iter().map(|(_, row)| *row).collect());
    }
}

impl<S> Placed<S> {
    fn is_drawable(&self, length: f64) -> bool {
        is_drawable_point(self.position) && is_drawable_length(length)
    }

    fn reach(&self, length: f64) -> f64 {
        self.position.abs().max_element() + length
    }
}

impl Extent {
    /// Of those that are drawn, out of so many.
    fn of(reaches: impl ExactSizeIterator<Item = f64>, all: usize) -> Self {
        Self { left_out: all - reaches.len(), reach: reaches.fold(0.0, f64::max) }
    }
}
