//! Rows that only some rows of another table have.

/// Rows of an effect, for those rows of another table that have it. It holds nothing at all while none does.
#[derive(Clone, Debug)]
pub struct EffectColumn<R> {
    /// For each row of the other table, 1 + the index in `rows`, or 0. May be shorter than the other table: what lies
    /// beyond has no row. Empty, too, while every row has the effect: then indices are the same.
    slots: Vec<u32>,
    rows: Vec<R>,
    /// Rows of the other table so far.
    pushed: usize,
}

impl<R> Default for EffectColumn<R> {
    fn default() -> Self {
        Self { slots: Vec::new(), rows: Vec::new(), pushed: 0 }
    }
}

impl<R> EffectColumn<R> {
    /// Adds the next row of the other table, with or without the effect.
    pub fn push(&mut self, row: Option<R>) {
        if let Some(row) = row {
            if !self.is_dense() {
                self.slots.resize(self.pushed, 0);
                self.slots.push(slot(self.rows.len()));
            }
            self.rows.push(row);
        } else if self.is_dense() {
            self.slots = (0..self.pushed).map(slot).collect();
        }
        self.pushed += 1;
    }

    /// Whether every row so far has the effect.
    fn is_dense(&self) -> bool {
        self.rows.len() == self.pushed
    }

    /// The index in `rows` of a row of the other table, or something beyond.
    #[inline(always)]
    fn index(&self, row: usize) -> usize {
        match self.slots.get(row) {
            Some(&slot) => (slot as usize).wrapping_sub(1),
            None if self.slots.is_empty() => row,
            None => usize::MAX,
        }
    }

    /// The effect of a row of the other table.
    #[inline(always)]
    pub fn get(&self, row: usize) -> Option<&R> {
        // First, so that an effect that nothing has costs no more than this.
        if self.rows.is_empty() { None } else { self.rows.get(self.index(row)) }
    }

    /// Writes over the effect of a row of the other table; `false`, and nothing done, if it comes or goes.
    pub fn replace(&mut self, row: usize, effect: Option<R>) -> bool {
        let index = self.index(row);
        match (self.rows.get_mut(index), effect) {
            (Some(place), Some(effect)) => *place = effect,
            (None, None) => {}
            _ => return false,
        }
        true
    }

    /// Gives back memory that no row takes.
    pub fn shrink_to_fit(&mut self) {
        self.slots.shrink_to_fit();
        self.rows.shrink_to_fit();
    }

    /// Number of rows that have the effect.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Rows, and the memory that they take in bytes: nothing where there is none.
    pub fn size(&self) -> (usize, usize) {
        let slots = self.slots.capacity() * size_of::<u32>();
        (self.rows.len(), slots + self.rows.capacity() * size_of::<R>())
    }

    /// Whether no row has the effect.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }
}

/// 1 + an index: at most one row an entity, and entities are counted in 32 bits.
fn slot(index: usize) -> u32 {
    u32::try_from(index + 1).unwrap_or(0)
}
