//! Intersection kernels, and the turns of a camera: numbers in, numbers out.
//!
//! Nothing here knows an entity or a colour. There is no tolerance but the rounding of a point that was put onto a
//! surface, derived where it is used. Every shape is convex, and that carries the whole
//! treatment of secondary rays: a ray that leaves a convex body outwards cannot meet it again, so the body is
//! skipped and no offset is needed; a ray that goes on inside must leave it once, so it has a kernel of its own
//! ([`Convex::exit`]). Hit points are snapped onto the face they belong to ([`Convex::locate`]).
//!
//! All kernels are generic over the precision ([`Real`]: `f64`, `f32`).

mod basis;
mod bounded;
mod clip;
mod compensated;
mod cube;
mod expansion;
mod exponential;
mod eye;
mod plane;
mod pyramid;
mod ray;
mod real;
mod sphere;
mod straight;
mod unit;
mod vector;

pub use basis::{basis_looking, head_left, is_camera_basis, tilt, turn_left, turn_up};
pub use bounded::{Ball, Bounded, Bounds3};
pub use compensated::{two_diff, two_prod, two_sum};
pub use cube::CubeShape;
pub use eye::{Raised, along, raise};
pub use plane::PlaneShape;
pub use pyramid::PyramidShape;
pub use ray::{Convex, Crossing, Ray, Side, SurfacePoint};
pub use real::{ByPrecision, Real};
pub use sphere::SphereShape;
pub use straight::{Meeting, Straight};
pub use unit::Unit;
pub use vector::Vector;
