//! Names beside points, none over another.

/// A rectangle of the drawing: left, top, right, bottom.
#[derive(Clone, Copy, Debug)]
pub(super) struct Area(pub(super) [f64; 4]);

impl Area {
    /// Around a line along an axis, from one end to the other.
    pub(super) fn along([x1, y1]: [f64; 2], [x2, y2]: [f64; 2]) -> Self {
        Self([x1.min(x2) - 1.0, y1.min(y2) - 1.0, x1.max(x2) + 1.0, y1.max(y2) + 1.0])
    }

    /// Around a point.
    pub(super) fn around([x, y]: [f64; 2], half: f64) -> Self {
        Self([x - half, y - half, x + half, y + half])
    }

    fn overlaps(&self, other: &Self) -> bool {
        self.0[0] < other.0[2] && other.0[0] < self.0[2] && self.0[1] < other.0[3] && other.0[1] < self.0[3]
    }

    fn is_within(&self, other: &Self) -> bool {
        self.0[0] >= other.0[0]
            && self.0[1] >= other.0[1]
            && self.0[2] <= other.0[2]
            && self.0[3] <= other.0[3]
    }
}

/// Where a name stands.
#[derive(Clone, Debug)]
pub(super) struct Label {
    /// Its text.
    pub(super) text: String,
    /// A place on its baseline.
    pub(super) at: [f64; 2],
    /// Which part of it is at that place: `start`, `middle` or `end`.
    pub(super) anchor: &'static str,
}

/// Places names one after the other, the important ones first.
pub(super) struct Labels {
    /// What must hold all names.
    pub(super) bounds: Area,
    /// What no name may cover.
    pub(super) taken: Vec<Area>,
    /// The names that have found a place.
    pub(super) placed: Vec<Label>,
}

/// Height of a name, in pixels.
const HEIGHT: f64 = 14.0;
/// From a point to its name.
const GAP: f64 = 10.0;

impl Labels {
    /// Writes a name beside a point where nothing else is; leaves it out where there is no such place.
    pub(super) fn add(&mut self, text: &str, [x, y]: [f64; 2]) {
        let width = width(text);
        let lefts = [x + GAP, x - GAP - width, x - width / 2.0];
        let tops = [y - HEIGHT / 2.0, y - GAP - HEIGHT, y + GAP];
        // Stairs lead to a point from below and on to the right: what is left of it and above is free.
        let order = [(1, 0), (1, 1), (2, 1), (0, 2), (0, 0), (0, 1), (2, 2), (1, 2)];
        let areas =
            order.map(|(left, top)| Area([lefts[left], tops[top], lefts[left] + width, tops[top] + HEIGHT]));
        let is_free = |area: &&Area| {
            area.is_within(&self.bounds) && !self.taken.iter().any(|taken| taken.overlaps(area))
        };
        if let Some(&area) = areas.iter().find(is_free) {
            self.taken.push(area);
            self.placed.push(label(text, x, area));
        }
    }
}

/// The end towards the point is held fast: how wide a font really is, nobody knows.
fn label(text: &str, x: f64, Area([left, _, right, bottom]): Area) -> Label {
    let (place, anchor) = match () {
        () if left > x => (left, "start"),
        () if right < x => (right, "end"),
        () => (x, "middle"),
    };
    Label { text: text.to_owned(), at: [place, bottom - 3.0], anchor }
}

/// About the width of a text of 12 pixels.
pub(super) fn width(text: &str) -> f64 {
    7.4 * f64::from(u32::try_from(text.chars().count()).unwrap_or(u32::MAX))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels() -> Labels {
        Labels { bounds: Area([0.0, 0.0, 200.0, 100.0]), taken: Vec::new(), placed: Vec::new() }
    }

    #[test]
    fn names_make_room_for_each_other() {
        let mut labels = labels();
        for name in ["one", "two", "three"] {
            labels.add(name, [100.0, 50.0]);
        }
        assert_eq!(labels.placed.len(), 3);
        let [a, b, c] = [labels.taken[0], labels.taken[1], labels.taken[2]];
        assert!(!a.overlaps(&b) && !a.overlaps(&c) && !b.overlaps(&c));
    }

    #[test]
    fn a_name_without_a_place_is_left_out() {
        let mut labels = labels();
        labels.taken.push(labels.bounds);
        labels.add("nowhere", [100.0, 50.0]);
        assert!(labels.placed.is_empty());
    }

    #[test]
    fn names_stay_inside() {
        let mut labels = labels();
        labels.add("at the corner", [199.0, 99.0]);
        assert_eq!(labels.placed.len(), 1);
        assert!(labels.taken[0].is_within(&labels.bounds));
    }
}
