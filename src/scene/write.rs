//! [`Description`] to text.

use core::fmt;

use glam::DVec3;

use super::description::{Description, LightDescription, ObjectDescription, ShapeDescription};

/// The scene file that reads back to exactly this description: every number in the fewest digits that do.
impl fmt::Display for Description {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let board = &self.board;
        writeln!(f, "{} {}  # near, far", Number(self.near), Number(self.far))?;
        writeln!(f, "{}  # vertical field of view", Number(self.fovy))?;
        writeln!(f, "{}  # aspect ratio", Number(self.aspect))?;
        writeln!(f, "{}  # level of recursion", self.level)?;
        writeln!(f, "{}  # pixels\n", self.pixels)?;
        writeln!(f, "{}  # checkerboard: cell width", Number(board.cell))?;
        let coefficients = [board.ambient, board.diffuse, board.reflection];
        writeln!(f, "{}  # ambient, diffuse, reflection\n", Numbers(&coefficients))?;
        writeln!(f, "{}  # objects", self.objects.len())?;
        self.objects.iter().try_for_each(|object| write_object(f, object))?;
        writeln!(f, "\n{}  # normal lights: position, falloff", self.lights.len())?;
        for light in &self.lights {
            writeln!(f, "{}", Light(light))?;
        }
        writeln!(f, "\n{}  # spotlights: position, falloff, point looked at, cutoff", self.spots.len())?;
        for spot in &self.spots {
            writeln!(f, "{}  {}  {}", Light(&spot.light), Point(spot.target), Number(spot.cutoff))?;
        }
        Ok(())
    }
}

fn write_object(f: &mut fmt::Formatter<'_>, object: &ObjectDescription) -> fmt::Result {
    let position = Point(object.position);
    match object.shape {
        ShapeDescription::Sphere { radius } => writeln!(f, "\nsphere\n{position}\n{}", Number(radius))?,
        ShapeDescription::Cube { side } => writeln!(f, "\ncube\n{position}\n{}", Number(side))?,
        ShapeDescription::Pyramid { width, height } => {
            writeln!(f, "\npyramid\n{position}\n{} {}", Number(width), Number(height))?;
        }
    }
    let surface = &object.surface;
    let coefficients = [surface.ambient, surface.diffuse, surface.specular, surface.reflection];
    writeln!(f, "{}\n{}\n{}", Point(surface.color), Numbers(&coefficients), Number(surface.shininess))
}

/// A number in the fewest digits that read back to it, with an exponent where it would be long.
pub(crate) struct Number(pub(crate) f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let magnitude = self.0.abs();
        if magnitude == 0.0 || (1e-6..1e15).contains(&magnitude) {
            write!(f, "{}", self.0)
        } else {
            write!(f, "{:e}", self.0)
        }
    }
}

struct Numbers<'a>(&'a [f64]);

impl fmt::Display for Numbers<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, &number) in self.0.iter().enumerate() {
            let gap = if index == 0 { "" } else { " " };
            write!(f, "{gap}{}", Number(number))?;
        }
        Ok(())
    }
}

struct Point(DVec3);

impl fmt::Display for Point {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Numbers(&self.0.to_array()).fmt(f)
    }
}

struct Light<'a>(&'a LightDescription);

impl fmt::Display for Light<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}  {}", Point(self.0.position), Number(self.0.falloff))
    }
}
