//! The assignment a second time, as plainly as it can be said: a list of objects, an epsilon, a recursion.
//!
//! It shares no code with the tracer. Its formulas are others: the textbook quadratic for spheres, six squares
//! for a cube, four triangles and a square for a pyramid, `acos` for cones.

use std::sync::Arc;

use archetrace::components::Texture;
use archetrace::scene::{LightDescription, ObjectDescription, ShapeDescription};

use crate::support::case::Case;

type Vec3 = [f64; 3];

/// Surfaces whose distances agree to this share are the same place: the first in the list shows.
const SAME_PLACE: f64 = 1e-10;

/// A scene and its screen.
pub(crate) struct Naive {
    objects: Vec<Object>,
    lights: Vec<Light>,
    eye: Vec3,
    look: Vec3,
    right: Vec3,
    up: Vec3,
    near: f64,
    far: f64,
    width: f64,
    height: f64,
    level: u32,
    pixels: u32,
    /// How far secondary rays start from the surface, in world units.
    epsilon: f64,
}

struct Object {
    shape: Shape,
    color: Vec3,
    ambient: f64,
    diffuse: f64,
    specular: f64,
    reflection: f64,
    shininess: f64,
}

enum Shape {
    Sphere { center: Vec3, radius: f64 },
    Cube { low: Vec3, side: f64 },
    Pyramid { low: Vec3, width: f64, height: f64 },
    Board { cell: f64, images: Option<[Arc<Texture>; 2]> },
}

struct Light {
    position: Vec3,
    falloff: f64,
    /// Point looked at, and cutoff in degrees.
    spot: Option<(Vec3, f64)>,
}

impl Naive {
    pub(crate) fn new(case: &Case, epsilon: f64) -> Self {
        let scene = &case.description;
        let mut objects: Vec<Object> = scene.objects.iter().map(object).collect();
        objects.push(Object {
            shape: Shape::Board {
                cell: scene.board.cell,
                images: case.textured.as_ref().map(|images| [images.white.clone(), images.black.clone()]),
            },
            color: [1.0; 3],
            ambient: scene.board.ambient,
            diffuse: scene.board.diffuse,
            specular: 0.0,
            reflection: scene.board.reflection,
            shininess: 1.0,
        });
        let mut lights: Vec<Light> = scene.lights.iter().map(|at| light(at, None)).collect();
        lights.extend(
            scene.spots.iter().map(|spot| light(&spot.light, Some((spot.target.to_array(), spot.cutoff)))),
        );
        let tangent = |degrees: f64| (degrees / 2.0 * core::f64::consts::PI / 180.0).tan();
        Self {
            objects,
            lights,
            eye: case.pose.position.to_array(),
            look: case.pose.l.to_array(),
            right: case.pose.r.to_array(),
            up: case.pose.u.to_array(),
            near: scene.near,
            far: scene.far,
            width: 2.0 * scene.near * tangent(scene.aspect * scene.fovy),
            height: 2.0 * scene.near * tangent(scene.fovy),
            level: scene.level,
            pixels: scene.pixels,
            epsilon,
        }
    }

    /// The colour of a pixel in 8 bits, sampled this far from its centre, in pixels.
    pub(crate) fn pixel(&self, column: u32, row: u32, (dx, dy): (f64, f64)) -> [u8; 3] {
        let middle = add(self.eye, scale(self.look, self.near));
        let left = add(middle, scale(self.right, -self.width / 2.0));
        let corner = add(left, scale(self.up, self.height / 2.0));
        let count = f64::from(self.pixels);
        let step_right = self.width / count * (f64::from(column) + 0.5 + dx);
        let step_down = self.height / count * (f64::from(row) + 0.5 + dy);
        let point = add(corner, sub(scale(self.right, step_right), scale(self.up, step_down)));
        let direction = normalized(sub(point, self.eye));
        let reach = self.far / dot(direction, self.look);
        let color = self.color(point, direction, reach, self.level);
        color.map(|channel| (channel.clamp(0.0, 1.0) * 255.0) as u8)
    }

    /// The assignment's recursive function.
    fn color(&self, start: Vec3, direction: Vec3, reach: f64, depth: u32) -> Vec3 {
        if depth == 0 {
            return [0.0; 3];
        }
        let Some((object, t, outward)) = self.nearest(start, direction) else {
            return [0.0; 3];
        };
        if t > reach {
            return [0.0; 3];
        }
        let point = add(start, scale(direction, t));
        let facing = dot(outward, direction) > 0.0;
        let normal = if facing { scale(outward, -1.0) } else { outward };
        let mirrored = sub(direction, scale(normal, 2.0 * dot(direction, normal)));
        let mirrored = normalized(mirrored);

        let (mut lambert, mut phong) = (0.0, 0.0);
        for light in &self.lights {
            let to_source = normalized(sub(light.position, point));
            if dot(to_source, normal) <= 0.0 || !self.illuminates(light, point) {
                continue;
            }
            let distance = length(sub(light.position, point));
            let scaling = (-distance * distance * light.falloff).exp();
            lambert += dot(to_source, normal) * scaling;
            let cosine = dot(mirrored, to_source);
            if cosine > 0.0 {
                phong += cosine.powf(object.shininess) * scaling;
            }
        }
        let own = own_color(object, point);
        let strength = object.ambient + object.diffuse * lambert + object.specular * phong;
        let mut color = scale(own, strength);
        if object.reflection > 0.0 {
            let from = add(point, scale(mirrored, self.epsilon));
            let reflected = self.color(from, mirrored, f64::INFINITY, depth - 1);
            color = add(color, scale(reflected, object.reflection));
        }
        color
    }

    fn nearest(&self, start: Vec3, direction: Vec3) -> Option<(&Object, f64, Vec3)> {
        let mut best: Option<(&Object, f64, Vec3)> = None;
        for object in &self.objects {
            if let Some((t, normal)) = object.shape.hit(start, direction)
                && best.is_none_or(|(_, nearest, _)| t < nearest * (1.0 - SAME_PLACE))
            {
                best = Some((object, t, normal));
            }
        }
        best
    }

    fn illuminates(&self, light: &Light, point: Vec3) -> bool {
        if let Some((target, cutoff)) = light.spot {
            let v1 = normalized(sub(point, light.position));
            let v2 = normalized(sub(target, light.position));
            let angle = dot(v1, v2).clamp(-1.0, 1.0).acos();
            if angle > cutoff * core::f64::consts::PI / 180.0 {
                return false;
            }
        }
        let to_source = normalized(sub(light.position, point));
        let start = add(point, scale(to_source, self.epsilon));
        let distance = dot(sub(light.position, start), to_source);
        let blocks = |object: &Object| {
            let hit = object.shape.hit(start, to_source);
            hit.is_some_and(|(t, _)| t < distance)
        };
        !self.objects.iter().any(blocks)
    }
}

fn object(object: &ObjectDescription) -> Object {
    let low = object.position.to_array();
    let surface = &object.surface;
    Object {
        shape: match object.shape {
            ShapeDescription::Sphere { radius } => Shape::Sphere { center: low, radius },
            ShapeDescription::Cube { side } => Shape::Cube { low, side },
            ShapeDescription::Pyramid { width, height } => Shape::Pyramid { low, width, height },
        },
        color: surface.color.to_array(),
        ambient: surface.ambient,
        diffuse: surface.diffuse,
        specular: surface.specular,
        reflection: surface.reflection,
        shininess: surface.shininess,
    }
}

fn light(light: &LightDescription, spot: Option<(Vec3, f64)>) -> Light {
    Light { position: light.position.to_array(), falloff: light.falloff, spot }
}

fn own_color(object: &Object, [x, y, _]: Vec3) -> Vec3 {
    let Shape::Board { cell, images } = &object.shape else {
        return object.color;
    };
    let (column, row) = ((x / cell).floor(), (y / cell).floor());
    let white = (column + row).rem_euclid(2.0) == 0.0;
    let Some([on_white, on_black]) = images else {
        return if white { [1.0; 3] } else { [0.0; 3] };
    };
    let image = if white { on_white } else { on_black };
    let from_left = x / cell - column;
    let from_top = 1.0 - (y / cell - row);
    let texel = |share: f64, count: u32| ((share * f64::from(count)) as u32).min(count - 1);
    let [r, g, b] = image.texel(texel(from_left, image.width()), texel(from_top, image.height()));
    [r, g, b].map(|byte| f64::from(byte) / 255.0)
}

impl Shape {
    /// The first crossing ahead, with the outward normal there.
    fn hit(&self, start: Vec3, direction: Vec3) -> Option<(f64, Vec3)> {
        match *self {
            Self::Sphere { center, radius } => hit_sphere(start, direction, center, radius),
            Self::Cube { low, side } => hit_cube(start, direction, low, side),
            Self::Pyramid { low, width, height } => hit_pyramid(start, direction, low, width, height),
            Self::Board { .. } => {
                let t = -start[2] / direction[2];
                (t > 0.0 && t.is_finite()).then_some((t, [0.0, 0.0, 1.0]))
            }
        }
    }
}

fn hit_sphere(start: Vec3, direction: Vec3, center: Vec3, radius: f64) -> Option<(f64, Vec3)> {
    let from_center = sub(start, center);
    let a = dot(direction, direction);
    let b = 2.0 * dot(from_center, direction);
    let c = dot(from_center, from_center) - radius * radius;
    let root = (b * b - 4.0 * a * c).sqrt();
    let roots = [(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)];
    let t = roots.into_iter().find(|&t| t > 0.0)?;
    let point = add(start, scale(direction, t));
    Some((t, normalized(sub(point, center))))
}

fn hit_cube(start: Vec3, direction: Vec3, low: Vec3, side: f64) -> Option<(f64, Vec3)> {
    let mut best: Option<(f64, Vec3)> = None;
    for axis in 0..3 {
        for (offset, sign) in [(0.0, -1.0), (side, 1.0)] {
            let t = (low[axis] + offset - start[axis]) / direction[axis];
            let point = add(start, scale(direction, t));
            let within = |other: usize| (0.0..=side).contains(&(point[other] - low[other]));
            let on_face = within((axis + 1) % 3) && within((axis + 2) % 3);
            if t > 0.0 && on_face && best.is_none_or(|(nearest, _)| t < nearest) {
                let mut normal = [0.0; 3];
                normal[axis] = sign;
                best = Some((t, normal));
            }
        }
    }
    best
}

fn hit_pyramid(start: Vec3, direction: Vec3, low: Vec3, width: f64, height: f64) -> Option<(f64, Vec3)> {
    let corner = |dx: f64, dy: f64| add(low, [dx * width, dy * width, 0.0]);
    let base = [corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)];
    let apex = add(low, [width / 2.0, width / 2.0, height]);
    let mut hits = Vec::new();
    for index in 0..4 {
        // Counter-clockwise seen from outside.
        let triangle = [base[index], base[(index + 1) % 4], apex];
        hits.extend(hit_triangle(start, direction, triangle));
    }
    let t = (low[2] - start[2]) / direction[2];
    let point = add(start, scale(direction, t));
    let within = |axis: usize| (0.0..=width).contains(&(point[axis] - low[axis]));
    if t > 0.0 && within(0) && within(1) {
        hits.push((t, [0.0, 0.0, -1.0]));
    }
    hits.into_iter().min_by(|a, b| a.0.total_cmp(&b.0))
}

/// The ray's crossing of the triangle's plane, if it lies on the inner side of all three edges.
fn hit_triangle(start: Vec3, direction: Vec3, triangle: [Vec3; 3]) -> Option<(f64, Vec3)> {
    let [a, b, c] = triangle;
    let normal = normalized(cross(sub(b, a), sub(c, a)));
    let t = dot(sub(a, start), normal) / dot(direction, normal);
    if !(t > 0.0 && t.is_finite()) {
        return None;
    }
    let point = add(start, scale(direction, t));
    let inner = |from: Vec3, to: Vec3| dot(cross(sub(to, from), sub(point, from)), normal) >= 0.0;
    (inner(a, b) && inner(b, c) && inner(c, a)).then_some((t, normal))
}

fn add(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn sub(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn scale(a: Vec3, factor: f64) -> Vec3 {
    [a[0] * factor, a[1] * factor, a[2] * factor]
}

fn dot(a: Vec3, b: Vec3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn length(a: Vec3) -> f64 {
    dot(a, a).sqrt()
}

fn normalized(a: Vec3) -> Vec3 {
    scale(a, 1.0 / length(a))
}
