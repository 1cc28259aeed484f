//! The textbook sphere, `b^2 - 4ac`: it must fail the bounds that the kernel keeps, or they show nothing.

use archetrace::geometry::{Ray, SphereShape};

/// The near root by the school formula.
pub(crate) fn near_root(sphere: &SphereShape<f64>, ray: &Ray<f64>) -> Option<f64> {
    let offset = ray.origin - sphere.center;
    let a = ray.direction.dot(ray.direction);
    let b = 2.0 * offset.dot(ray.direction);
    let c = offset.dot(offset) - sphere.radius * sphere.radius;
    let discriminant = b * b - 4.0 * a * c;
    (discriminant >= 0.0).then(|| (-b - discriminant.sqrt()) / (2.0 * a))
}
