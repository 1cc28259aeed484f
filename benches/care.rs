//! One frame without numerical care and one with it, for `benches/care.sh` to count instructions of.
//!
//! Usage: `care naive|care|packets f64|f32 SCENE PIXELS`. `naive` is the textbook: `b^2 - 4ac`, a slab test by reciprocals,
//! a pyramid of unit normals, hits and shadows from a thousandth of a unit on. `care` is ray after ray through the
//! library's own kernels, `packets` is how the library traces. Tables, shading and the order of the loops are the same.
#![allow(clippy::print_stdout, reason = "says what it has summed, so that nothing is left out")]

use archetrace::components::Snapshot;
use archetrace::effects::{Rgb, attenuation, lambert, phong, reflect};
use archetrace::film::Film;
use archetrace::geometry::{CubeShape, PyramidShape, Ray, Real, SphereShape, Vector};
use archetrace::scene::{Source, spawn};
use archetrace::systems::{Monitor, Tables, Workers, extract_schedule, prepare, trace_picture};
use archetrace::trace::{
    CameraRay, Counts, Exposure, SampleId, SceneTables, ShapeColumns, SurfaceRow, radiance,
};
use bevy_ecs::prelude::World;

type Failure = Box<dyn std::error::Error>;

fn main() -> Result<(), Failure> {
    // Cargo adds arguments of its own.
    let arguments: Vec<String> = std::env::args().skip(1).filter(|word| word != "--bench").collect();
    let [way, precision, scene, pixels] = arguments.as_slice() else {
        println!("usage: care naive|care|packets f64|f32 SCENE PIXELS (see benches/care.sh)");
        return Ok(());
    };
    let pixels = pixels.parse()?;
    match precision.as_str() {
        "f32" => run::<f32>(way, scene, pixels),
        _ => run::<f64>(way, scene, pixels),
    }
}

fn run<T: Real>(way: &str, scene: &str, pixels: u32) -> Result<(), Failure> {
    let loaded = Source::read(scene.as_ref())?.load()?;
    let mut world = World::new();
    spawn(&mut world, &loaded.description);
    world.resource_mut::<Snapshot>().pixels = pixels;
    prepare::<T>(&mut world, Workers::new(Some(core::num::NonZeroUsize::MIN))?);
    extract_schedule::<T>().run(&mut world);
    let tables = world.resource::<Tables<T>>();
    let camera = tables.camera.as_ref().ok_or("no camera")?;
    let (tables, level) = (&*tables.scene, loaded.description.level);
    let exposure = Exposure::new(tables, camera, level);
    let cell = T::from_f64(loaded.description.board.cell);
    let sum = match way {
        "naive" => {
            each_ray(&exposure, |start| Naive { tables, cell }.radiance(&start.ray, start.reach, level))
        }
        "care" => {
            let sample = SampleId { column: 0, row: 0, index: 0 };
            let depth = exposure.depth;
            each_ray(&exposure, |start| radiance(tables, start, depth, sample, &mut Counts::default()).color)
        }
        _ => {
            let mut film = Film::new(pixels).ok_or("no memory")?;
            trace_picture(&exposure, &mut film, world.resource::<Workers>(), &Monitor::default());
            film.pixels().iter().flatten().sum()
        }
    };
    println!("{sum}");
    Ok(())
}

fn each_ray<T: Real>(exposure: &Exposure<'_, T>, radiance: impl Fn(CameraRay<T>) -> Rgb<T>) -> f64 {
    let pixels = exposure.camera.pixels();
    let mut sum = 0.0;
    for index in 0..pixels * pixels {
        let start = exposure.camera.ray(index % pixels, index / pixels);
        let color = radiance(start).to_f64();
        sum += color.iter().map(|channel| channel.clamp(0.0, 1.0)).sum::<f64>();
    }
    sum
}

/// A tracer as textbooks have it.
struct Naive<'a, T: Real> {
    tables: &'a SceneTables<T>,
    cell: T,
}

#[derive(Clone, Copy)]
enum Body {
    Sphere(usize),
    Cube(usize, usize),
    Pyramid(usize, usize),
    Board,
}

impl<T: Real> Naive<'_, T> {
    fn near() -> T {
        T::from_f64(1e-3)
    }

    fn radiance(&self, ray: &Ray<T>, reach: T, level: u32) -> Rgb<T> {
        let Some((t, body)) = self.closest(ray, reach).filter(|_| level > 0) else { return Rgb::BLACK };
        let point = ray.at(t);
        let outwards = self.normal(body, point);
        let normal = if outwards.dot(ray.direction) > T::ZERO { -outwards } else { outwards };
        let surface = self.surface(body, point);
        let mirrored = reflect(ray.direction, normal);
        let local = self.light(point, normal, mirrored, &surface);
        match surface.effects.mirror.filter(|_| level > 1) {
            None => local,
            Some(share) => {
                let onwards = Ray { origin: point, direction: mirrored };
                local + self.radiance(&onwards, T::INFINITY, level - 1) * share
            }
        }
    }

    fn light(
        &self,
        point: Vector<T>,
        normal: Vector<T>,
        mirrored: Vector<T>,
        surface: &SurfaceRow<T>,
    ) -> Rgb<T> {
        let (mut diffuse, mut specular) = (T::ZERO, T::ZERO);
        for row in 0..self.tables.lights.len() {
            let light = self.tables.lights.row(row);
            let segment = light.position - point;
            if segment.dot(normal) <= T::ZERO
                || light.effects.spot_cone.is_some_and(|cone| !cone.contains(-segment))
            {
                continue;
            }
            let distance = segment.length();
            let scale =
                light.effects.falloff.map_or(T::ONE, |falloff| attenuation(segment.dot(segment), falloff));
            let to_light = segment / distance;
            let shadow = Ray { origin: point, direction: to_light };
            if scale == T::ZERO || self.is_occluded(&shadow, distance - Self::near()) {
                continue;
            }
            diffuse += lambert(to_light, normal) * scale;
            if let Some(gloss) = surface.effects.gloss {
                specular += gloss.specular * phong(mirrored, to_light, gloss.shininess) * scale;
            }
        }
        surface.color * ((surface.ambient + surface.diffuse * diffuse) + specular)
    }

    fn surface(&self, body: Body, point: Vector<T>) -> SurfaceRow<T> {
        let tables = self.tables;
        match body {
            Body::Sphere(row) => tables.spheres.surfaces.row(row),
            Body::Cube(row, _) => tables.cubes.surfaces.row(row),
            Body::Pyramid(row, _) => tables.pyramids.surfaces.row(row),
            Body::Board => {
                let surface = tables.boards.surfaces.row(0);
                let half = ((point.x / self.cell).floor() + (point.y / self.cell).floor()) / T::TWO;
                let color = if half == half.floor() { surface.color } else { Rgb::BLACK };
                SurfaceRow { color, ..surface }
            }
        }
    }

    fn normal(&self, body: Body, point: Vector<T>) -> Vector<T> {
        let tables = self.tables;
        match body {
            Body::Sphere(row) => {
                let sphere = tables.spheres.shapes.shape(row);
                (point - sphere.center) / sphere.radius
            }
            Body::Cube(_, face) => axis_normal::<T>(face),
            Body::Pyramid(row, face) => faces(&tables.pyramids.shapes.shape(row))[face].0,
            Body::Board => Vector::new(T::ZERO, T::ZERO, T::ONE),
        }
    }

    fn closest(&self, ray: &Ray<T>, reach: T) -> Option<(T, Body)> {
        let mut nearest = None;
        let mut reach = reach;
        self.each_hit(ray, |t, body| {
            if t > Self::near() && t < reach {
                reach = t;
                nearest = Some((t, body));
            }
            false
        });
        nearest
    }

    fn is_occluded(&self, ray: &Ray<T>, distance: T) -> bool {
        self.each_hit(ray, |t, _| t > Self::near() && t < distance)
    }

    /// Until a hit is enough.
    fn each_hit(&self, ray: &Ray<T>, mut is_enough: impl FnMut(T, Body) -> bool) -> bool {
        let tables = self.tables;
        for row in 0..tables.spheres.shapes.len() {
            let hit = hit_sphere(&tables.spheres.shapes.shape(row), ray, Self::near());
            if hit.is_some_and(|t| is_enough(t, Body::Sphere(row))) {
                return true;
            }
        }
        for row in 0..tables.cubes.shapes.len() {
            let hit = hit_cube(&tables.cubes.shapes.shape(row), ray, Self::near());
            if hit.is_some_and(|(t, face)| is_enough(t, Body::Cube(row, face))) {
                return true;
            }
        }
        for row in 0..tables.pyramids.shapes.len() {
            let hit = hit_pyramid(&tables.pyramids.shapes.shape(row), ray, Self::near());
            if hit.is_some_and(|(t, face)| is_enough(t, Body::Pyramid(row, face))) {
                return true;
            }
        }
        !tables.boards.shapes.is_empty() && is_enough(-ray.origin.z / ray.direction.z, Body::Board)
    }
}

fn hit_sphere<T: Real>(sphere: &SphereShape<T>, ray: &Ray<T>, least: T) -> Option<T> {
    let offset = ray.origin - sphere.center;
    let b = offset.dot(ray.direction);
    let c = offset.dot(offset) - sphere.radius * sphere.radius;
    let discriminant = b * b - c;
    if discriminant < T::ZERO {
        return None;
    }
    let root = discriminant.sqrt();
    let near = -b - root;
    Some(if near > least { near } else { root - b })
}

fn hit_cube<T: Real>(cube: &CubeShape<T>, ray: &Ray<T>, least: T) -> Option<(T, usize)> {
    let (mut enter, mut leave) = ((-T::INFINITY, 0), (T::INFINITY, 0));
    for axis in 0..3 {
        let inverse = T::ONE / ray.direction[axis];
        let low = (cube.min[axis] - ray.origin[axis]) * inverse;
        let high = (cube.max[axis] - ray.origin[axis]) * inverse;
        let (low, high) = ((low, 2 * axis), (high, 2 * axis + 1));
        let (near, far) = if inverse < T::ZERO { (high, low) } else { (low, high) };
        enter = if near.0 > enter.0 { near } else { enter };
        leave = if far.0 < leave.0 { far } else { leave };
    }
    (enter.0 <= leave.0).then_some(if enter.0 > least { enter } else { leave })
}

fn hit_pyramid<T: Real>(pyramid: &PyramidShape<T>, ray: &Ray<T>, least: T) -> Option<(T, usize)> {
    let (mut enter, mut leave) = ((-T::INFINITY, 0), (T::INFINITY, 0));
    for (face, (normal, through)) in faces(pyramid).into_iter().enumerate() {
        let slope = normal.dot(ray.direction);
        let t = normal.dot(through - ray.origin) / slope;
        if slope < T::ZERO && t > enter.0 {
            enter = (t, face);
        } else if slope > T::ZERO && t < leave.0 {
            leave = (t, face);
        }
    }
    (enter.0 <= leave.0).then_some(if enter.0 > least { enter } else { leave })
}

/// Unit normal of each face, and a point on it.
fn faces<T: Real>(pyramid: &PyramidShape<T>) -> [(Vector<T>, Vector<T>); 5] {
    let (zero, apex) = (T::ZERO, pyramid.apex);
    let length = (pyramid.height * pyramid.height + pyramid.half_width * pyramid.half_width).sqrt();
    let (out, up) = (pyramid.height / length, pyramid.half_width / length);
    [
        (Vector::new(-out, zero, up), apex),
        (Vector::new(out, zero, up), apex),
        (Vector::new(zero, -out, up), apex),
        (Vector::new(zero, out, up), apex),
        (Vector::new(zero, zero, -T::ONE), Vector::new(apex.x, apex.y, pyramid.base)),
    ]
}

fn axis_normal<T: Real>(face: usize) -> Vector<T> {
    let sign = if face.is_multiple_of(2) { -T::ONE } else { T::ONE };
    Vector::new(T::ZERO, T::ZERO, T::ZERO).with(face / 2, sign)
}
