//! Pictures and their differences.

use std::path::PathBuf;

use archetrace::film::Film;

/// A square picture in linear colour, row 0 at the top.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Picture {
    pub(crate) side: usize,
    pub(crate) pixels: Vec<[f64; 3]>,
}

impl From<&Film> for Picture {
    fn from(film: &Film) -> Self {
        Self { side: film.side() as usize, pixels: film.pixels().to_vec() }
    }
}

impl Picture {
    pub(crate) fn at(&self, column: usize, row: usize) -> [f64; 3] {
        self.pixels[row * self.side + column]
    }

    /// The middle pixel of an odd picture.
    pub(crate) fn middle(&self) -> [f64; 3] {
        assert_eq!(self.side % 2, 1, "an even picture has no middle pixel");
        self.at(self.side / 2, self.side / 2)
    }

    /// Left and right swapped.
    pub(crate) fn flipped(&self) -> Self {
        let rows = self.pixels.chunks(self.side);
        Self { side: self.side, pixels: rows.flat_map(|row| row.iter().rev().copied()).collect() }
    }

    /// 8 bits a channel, truncated as the assignment has it.
    pub(crate) fn levels(&self) -> Vec<[u8; 3]> {
        self.pixels.iter().map(|pixel| pixel.map(level)).collect()
    }

    /// Number of different pixel values, a guard against pictures that show nothing.
    pub(crate) fn variety(&self) -> usize {
        let mut levels = self.levels();
        levels.sort_unstable();
        levels.dedup();
        levels.len()
    }
}

fn level(channel: f64) -> u8 {
    (channel * 255.0) as u8
}

/// Indices of pixels with a channel that differs by more than `allowed` levels.
pub(crate) fn differing(left: &[[u8; 3]], right: &[[u8; 3]], allowed: u8) -> Vec<usize> {
    assert_eq!(left.len(), right.len(), "pictures of different sizes");
    let apart = |(a, b): (&[u8; 3], &[u8; 3])| (0..3).any(|i| a[i].abs_diff(b[i]) > allowed);
    let pairs = left.iter().zip(right).map(apart).enumerate();
    pairs.filter(|&(_, apart)| apart).map(|(index, _)| index).collect()
}

/// Both pictures hold the same numbers, whatever their signs of zero.
pub(crate) fn assert_same(name: &str, left: &Picture, right: &Picture) {
    let pairs = left.pixels.iter().zip(&right.pixels).enumerate();
    let unequal: Vec<usize> = pairs.filter(|(_, (a, b))| a != b).map(|(i, _)| i).collect();
    assert_eq!(left.side, right.side, "{name}: pictures of different sizes");
    assert!(unequal.is_empty(), "{}", explain(name, left, right, &unequal));
}

/// Both pictures show the same 8-bit levels.
pub(crate) fn assert_same_levels(name: &str, left: &Picture, right: &Picture) {
    let unequal = differing(&left.levels(), &right.levels(), 0);
    assert!(unequal.is_empty(), "{}", explain(name, left, right, &unequal));
}

/// Says where two pictures differ, and draws it: left, right, and the difference.
pub(crate) fn explain(name: &str, left: &Picture, right: &Picture, unequal: &[usize]) -> String {
    let Some(&first) = unequal.first() else {
        return format!("{name}: no difference");
    };
    let (column, row) = (first % left.side, first / left.side);
    format!(
        "{name}: {} of {} pixels differ, first at column {column}, row {row}: {:?} and {:?}; see {}",
        unequal.len(),
        left.pixels.len(),
        left.pixels[first],
        right.pixels[first],
        draw(name, left, right).display(),
    )
}

fn draw(name: &str, left: &Picture, right: &Picture) -> PathBuf {
    let side = left.side as u32;
    let (left, right) = (left.levels(), right.levels());
    let panels = image::RgbImage::from_fn(3 * side, side, |x, y| {
        let index = (y * side + x % side) as usize;
        let (a, b) = (left[index], right[index]);
        image::Rgb(match x / side {
            0 => a,
            1 => b,
            _ => core::array::from_fn(|i| a[i].abs_diff(b[i]).saturating_mul(16)),
        })
    });
    let file = name.replace(|c: char| !c.is_ascii_alphanumeric(), "_");
    let path = std::env::temp_dir().join(format!("archetrace_{file}.png"));
    panels.save(&path).expect("the temporary folder can be written");
    path
}
