//! Two images for the cells of the checkerboard: a boat by day, a house by night. They look different from every
//! side, so that a turned or mirrored image is seen at once. Whole numbers only: the same on every machine.

/// Texels along each side of an image.
const SIDE: i32 = 128;
/// Samples along each side of a texel; their mean smooths the edges.
const SAMPLES: i32 = 4;
/// A drawing is this wide and high: one unit is one sample.
const UNITS: i32 = SIDE * SAMPLES;

type Rgb = [i32; 3];

/// The image for white cells, as width, height and rows of red, green, blue, top row first: a boat sails to the
/// right, the sun is at the top left.
pub(crate) fn white() -> (u32, u32, Vec<[u8; 3]>) {
    image(boat)
}

/// The image for black cells, in the same layout: a house at the left, a crescent moon at the top right.
pub(crate) fn black() -> (u32, u32, Vec<[u8; 3]>) {
    image(house)
}

/// x to the right and y up, both from 0 to [`UNITS`] - 1.
fn boat(x: i32, y: i32) -> Rgb {
    let mast = 250;
    let hull = (80..150).contains(&y) && x > 90 + (150 - y) / 2 && x < 420 - (150 - y);
    let main_sail = x > mast + 8 && y > 170 && 3 * (x - mast) + 2 * (y - 170) < 500;
    let fore_sail = x < mast - 8 && y > 170 && 2 * (mast - x) + (y - 170) < 240;
    if hull {
        [150, 62, 48]
    } else if y < 110 + wave(x) {
        mix([30, 96, 140], [70, 160, 190], y, 130)
    } else if (x - mast).abs() < 6 && (150..440).contains(&y) {
        [92, 64, 50]
    } else if x >= mast && x < mast + 6 + 2 * (440 - y) && y > 405 && y < 440 {
        [206, 70, 60]
    } else if main_sail {
        [252, 248, 236]
    } else if fore_sail {
        [240, 214, 150]
    } else if within(x - 100, y - 410, 52) {
        [250, 196, 70]
    } else {
        mix([244, 234, 208], [168, 208, 228], y, UNITS)
    }
}

fn house(x: i32, y: i32) -> Rgb {
    let hill = 120 + (x - 150) * (UNITS - 40 - x) / 1400;
    let wall = (70..200).contains(&x) && (60..190).contains(&y);
    let roof = (190..280).contains(&y) && (x - 135).abs() < 280 - y;
    let chimney = (165..185).contains(&x) && (190..290).contains(&y);
    let window = |left: i32| (left..left + 30).contains(&x) && (115..155).contains(&y);
    let moon = within(x - 400, y - 400, 56) && !within(x - 372, y - 416, 50);
    if wall && (window(90) || window(150)) {
        [250, 200, 96]
    } else if wall {
        [96, 70, 86]
    } else if roof || chimney {
        [64, 40, 56]
    } else if y < hill.min(170) {
        mix([16, 44, 46], [34, 78, 66], y, 170)
    } else if moon {
        [246, 236, 196]
    } else if STARS.iter().any(|&(at_x, at_y)| within(x - at_x, y - at_y, 7)) {
        [226, 226, 240]
    } else {
        mix([70, 52, 104], [14, 18, 50], y, UNITS)
    }
}

const STARS: [(i32, i32); 7] =
    [(60, 440), (150, 370), (230, 470), (270, 330), (320, 430), (430, 270), (480, 480)];

/// The height of the sea at x: parabolas, up and down.
fn wave(x: i32) -> i32 {
    let along = x % 128;
    let arch = |at: i32| at * (64 - at) / 60;
    if along < 64 { arch(along) } else { -arch(along - 64) }
}

fn within(x: i32, y: i32, radius: i32) -> bool {
    x * x + y * y < radius * radius
}

/// The colour at `part` of `whole` on the way from `low` to `high`.
fn mix(low: Rgb, high: Rgb, part: i32, whole: i32) -> Rgb {
    let part = part.clamp(0, whole);
    core::array::from_fn(|i| (low[i] * (whole - part) + high[i] * part) / whole)
}

fn image(drawing: fn(i32, i32) -> Rgb) -> (u32, u32, Vec<[u8; 3]>) {
    let rows = (0..SIDE).rev();
    let texels = rows.flat_map(|row| (0..SIDE).map(move |column| texel(drawing, column, row)));
    (SIDE.unsigned_abs(), SIDE.unsigned_abs(), texels.collect())
}

/// The mean of a texel's samples, rounded down; rows count from the bottom.
fn texel(drawing: fn(i32, i32) -> Rgb, column: i32, row: i32) -> [u8; 3] {
    let mut sum = [0; 3];
    for y in row * SAMPLES..(row + 1) * SAMPLES {
        for x in column * SAMPLES..(column + 1) * SAMPLES {
            let color = drawing(x, y);
            sum = core::array::from_fn(|i| sum[i] + color[i]);
        }
    }
    sum.map(|channel: i32| u8::try_from(channel / (SAMPLES * SAMPLES)).unwrap_or(u8::MAX))
}
