//! Which object each pixel shows, by the preview and by the trace.

use archetrace::components::{
    CameraPose, Checkerboard, Color, Cube, Lens, Position, Pyramid, Sphere, Textured,
};
use archetrace::effects::cell_point;
use archetrace::systems::{Tables, extract_schedule, prepare};
use archetrace::trace::{CameraRays, Departure, Kind, closest_hit};
use bevy_ecs::prelude::*;
use glam::DVec3;

use super::canvas::{Canvas, PLAIN, Shot};
use super::support::tracing::workers;

/// What a pixel shows: nothing, a board, or an object by its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Seen {
    Nothing,
    Board,
    Object(u32),
}

/// A cell of a board: column, row, whether it is white.
pub(crate) type Cell = (i64, i64, bool);

/// What the trace says to the ray through each pixel.
pub(crate) struct Truth {
    pub(crate) side: usize,
    pub(crate) seen: Vec<Seen>,
    /// Where a board is seen, its cell.
    pub(crate) cells: Vec<Option<Cell>>,
}

/// A World whose colours say which object is seen.
pub(crate) struct Labelled {
    pub(crate) world: World,
    objects: Vec<Entity>,
}

impl Labelled {
    /// Gives every object a colour of its own with some red, and every board plain blue. Only the colours change.
    pub(crate) fn new(mut world: World) -> Self {
        type Solid = Or<(With<Sphere>, With<Cube>, With<Pyramid>)>;
        let mut objects: Vec<Entity> = world.query_filtered::<Entity, Solid>().iter(&world).collect();
        objects.sort();
        for (number, &object) in (0..).zip(&objects) {
            world.entity_mut(object).insert(Color(DVec3::from_array(label(number).map(exact))));
        }
        let boards: Vec<Entity> = world.query_filtered::<Entity, With<Checkerboard>>().iter(&world).collect();
        for board in boards {
            world.entity_mut(board).remove::<Textured>().insert(Color::new(0.0, 0.0, 1.0));
        }
        Self { world, objects }
    }

    /// What the trace meets.
    pub(crate) fn trace(&mut self, pose: &CameraPose, lens: &Lens, side: usize) -> Truth {
        prepare::<f64>(&mut self.world, workers(1));
        extract_schedule::<f64>().run(&mut self.world);
        let tables = self.world.resource::<Tables<f64>>();
        let rays = CameraRays::<f64>::new(pose, lens, side as u32);
        let mut truth = Truth { side, seen: Vec::new(), cells: Vec::new() };
        for (row, column) in
            (0..side as u32).flat_map(|row| (0..side as u32).map(move |column| (row, column)))
        {
            let ray = rays.ray(column, row);
            let hit = closest_hit(&tables.scene, &ray.ray, &Departure::Free, ray.reach);
            let entity = hit.and_then(|hit| tables.entity(hit.object));
            let is_board = hit.is_some_and(|hit| hit.object.kind == Kind::Board);
            truth.seen.push(match entity {
                None => Seen::Nothing,
                Some(_) if is_board => Seen::Board,
                Some(entity) => {
                    Seen::Object(self.objects.iter().position(|&at| at == entity).unwrap() as u32)
                }
            });
            truth.cells.push(hit.filter(|_| is_board).map(|hit| {
                let board = self.world.entity(entity.unwrap());
                let origin = board.get::<Position>().unwrap().0;
                let width = board.get::<Checkerboard>().unwrap().cell;
                let point = ray.ray.at(hit.crossing.t);
                let (x, y) = (point.x - origin.x, point.y - origin.y);
                let cell = cell_point(x, y, width);
                ((x / width).floor() as i64, (y / width).floor() as i64, cell.white)
            }));
        }
        truth
    }

    /// What the preview shows, with one sample a pixel.
    pub(crate) fn draw(&mut self, canvas: &mut Canvas, pose: &CameraPose, lens: &Lens, side: usize) -> Shot {
        canvas.draw(&mut self.world, (pose, lens), &PLAIN, side)
    }
}

impl Truth {
    /// Whether everything within `reach` pixels is known, and the same by some measure.
    pub(crate) fn is_uniform<V: PartialEq>(&self, at: usize, reach: usize, of: impl Fn(usize) -> V) -> bool {
        let (column, row) = (at % self.side, at / self.side);
        let inside = reach..self.side.saturating_sub(reach);
        let mut around =
            (0..=2 * reach).flat_map(|dy| (0..=2 * reach).map(move |dx| (column + dx, row + dy)));
        inside.contains(&column)
            && inside.contains(&row)
            && around.all(|(x, y)| of((y - reach) * self.side + x - reach) == of(at))
    }

    /// Whether this pixel and all its neighbours show the same.
    pub(crate) fn is_within(&self, at: usize) -> bool {
        self.is_uniform(at, 1, |at| self.seen[at])
    }
}

/// Which object a colour stands for; `None` for a mixture.
pub(crate) fn read_label([red, green, blue]: [u8; 3]) -> Option<Seen> {
    match [red, green, blue] {
        [0, 255, 0] => Some(Seen::Nothing),
        [0, 0, _] => Some(Seen::Board),
        [0, ..] => None,
        _ => Some(Seen::Object(u32::from(red - 1) << 16 | u32::from(green) << 8 | u32::from(blue))),
    }
}

fn label(number: u32) -> [u8; 3] {
    let [_, high, middle, low] = number.to_be_bytes();
    [high + 1, middle, low]
}

/// The colour component that 8 bits show as this level: its middle, so that no rounding matters.
fn exact(level: u8) -> f64 {
    (f64::from(level) + if level == 255 { 0.0 } else { 0.5 }) / 255.0
}

/// What a comparison found.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Tally {
    pub(crate) pixels: usize,
    /// Pixels next to an outline, of which nothing is asked.
    pub(crate) outline: usize,
    /// Of those, the ones that differ.
    pub(crate) outline_differing: usize,
    /// All others that differ. There must be none.
    pub(crate) wrong: usize,
    /// Pixels well within a cell of a board, and those of them that do not show its colour exactly.
    pub(crate) cells: usize,
    pub(crate) wrong_cells: usize,
}

impl core::ops::AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.pixels += other.pixels;
        self.outline += other.outline;
        self.outline_differing += other.outline_differing;
        self.wrong += other.wrong;
        self.cells += other.cells;
        self.wrong_cells += other.wrong_cells;
    }
}

/// Compares pixel by pixel.
pub(crate) fn compare(truth: &Truth, shot: &Shot) -> Tally {
    let mut tally = Tally { pixels: truth.seen.len(), ..Tally::default() };
    for (at, &seen) in truth.seen.iter().enumerate() {
        let agrees = read_label(shot.pixels[at]) == Some(seen);
        if !truth.is_within(at) {
            tally.outline += 1;
            tally.outline_differing += usize::from(!agrees);
        } else if !agrees {
            tally.wrong += 1;
        } else if let Some((.., white)) = truth.cells[at]
            && truth.is_uniform(at, 2, |at| truth.cells[at])
        {
            tally.cells += 1;
            tally.wrong_cells += usize::from(shot.pixels[at][2] != if white { 255 } else { 0 });
        }
    }
    tally
}

/// Draws and traces one view and compares.
#[track_caller]
pub(crate) fn assert_agrees(
    name: &str,
    canvas: &mut Canvas,
    labelled: &mut Labelled,
    (pose, lens): (&CameraPose, &Lens),
    side: usize,
) -> Tally {
    let truth = labelled.trace(pose, lens, side);
    let shot = labelled.draw(canvas, pose, lens, side);
    let tally = compare(&truth, &shot);
    if tally.wrong + tally.wrong_cells > 0 {
        let file = name.replace(|c: char| !c.is_ascii_alphanumeric(), "_");
        let path = std::env::temp_dir().join(format!("archetrace_preview_{file}.png"));
        panels(&truth, &shot).save(&path).unwrap();
        panic!("{name}: {tally:?}, {pose:?}, {lens:?}; see {}", path.display());
    }
    tally
}

/// Preview, trace, and in white what is wrong.
fn panels(truth: &Truth, shot: &Shot) -> image::RgbImage {
    let side = shot.side;
    let paint = |seen| match seen {
        Seen::Nothing => [0, 255, 0],
        Seen::Board => [0, 0, 255],
        Seen::Object(number) => label(number),
    };
    // Labels of few objects look alike; spread them.
    let spread = |[r, g, b]: [u8; 3]| {
        if r == 0 { [r, g, b] } else { [128 + r, b.wrapping_mul(67), b.wrapping_mul(131)] }
    };
    image::RgbImage::from_fn(3 * side as u32, side as u32, |x, y| {
        let at = y as usize * side + x as usize % side;
        image::Rgb(match x as usize / side {
            0 => spread(shot.pixels[at]),
            1 => spread(paint(truth.seen[at])),
            _ if read_label(shot.pixels[at]) == Some(truth.seen[at]) => [0; 3],
            _ if truth.is_within(at) => [255; 3],
            _ => [90; 3],
        })
    })
}
