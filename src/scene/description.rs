//! What a scene file says, as plain values.

use glam::DVec3;

/// A whole scene file. Units and ranges are those of the components that its values become.
#[derive(Clone, Debug, PartialEq)]
pub struct Description {
    /// Distance of the near plane.
    pub near: f64,
    /// Distance of the far plane from the near one.
    pub far: f64,
    /// Vertical field of view in degrees.
    pub fovy: f64,
    /// Horizontal by vertical field of view, as angles.
    pub aspect: f64,
    /// Rays that may follow each other.
    pub level: u32,
    /// Pixels along each side of the picture.
    pub pixels: u32,
    /// The infinite checkerboard.
    pub board: BoardDescription,
    /// Objects in file order.
    pub objects: Vec<ObjectDescription>,
    /// Lights that shine in all directions, in file order.
    pub lights: Vec<LightDescription>,
    /// Spotlights, in file order.
    pub spots: Vec<SpotDescription>,
}

/// The checkerboard at z = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoardDescription {
    /// Width of a cell.
    pub cell: f64,
    /// Ambient coefficient.
    pub ambient: f64,
    /// Diffuse coefficient.
    pub diffuse: f64,
    /// Reflection coefficient.
    pub reflection: f64,
}

/// A sphere, cube or pyramid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ObjectDescription {
    /// Centre of a sphere, least corner of the others.
    pub position: DVec3,
    /// Kind and size.
    pub shape: ShapeDescription,
    /// Look.
    pub surface: SurfaceDescription,
}

/// Kind and size of an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ShapeDescription {
    /// A sphere.
    Sphere {
        /// Radius.
        radius: f64,
    },
    /// A cube.
    Cube {
        /// Edge length.
        side: f64,
    },
    /// A pyramid.
    Pyramid {
        /// Width of the base.
        width: f64,
        /// Height of the apex above the base.
        height: f64,
    },
}

/// Look of an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceDescription {
    /// Red, green, blue.
    pub color: DVec3,
    /// Ambient coefficient.
    pub ambient: f64,
    /// Diffuse coefficient.
    pub diffuse: f64,
    /// Specular coefficient.
    pub specular: f64,
    /// Reflection coefficient.
    pub reflection: f64,
    /// Phong exponent.
    pub shininess: f64,
}

/// A light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightDescription {
    /// Position.
    pub position: DVec3,
    /// Falloff in 1/unit^2.
    pub falloff: f64,
}

/// A light within a cone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpotDescription {
    /// Position and falloff.
    pub light: LightDescription,
    /// Point that the axis runs through.
    pub target: DVec3,
    /// Angle between axis and side in degrees.
    pub cutoff: f64,
}
