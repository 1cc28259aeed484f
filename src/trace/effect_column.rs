//! Rows that only some rows of another table have.

/// Rows of an effect, for those rows of another table that have it. It holds nothing at all while none does.
#[derive(Clone, Debug)]
pub struct EffectColumn<R> {
    /// For each row of the other table, 1 + the index in `rows`, or 0; empty while `rows` is. May be shorter than
    /// the other table: what lies beyond has no row.
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
            self.slots.resize(self.pushed, 0);
            self.rows.push(row);
            // At most one row an entity, and entities are counted in 32 bits.
            self.slots.push(u32::try_from(self.rows.len()).unwrap_or(0));
        }
        self.pushed += 1;
    }

    /// The effect of a row of the other table.
    #[inline(always)]
    pub fn get(&self, row: usize) -> Option<&R> {
        let slot = *self.slots.get(row)?;
        self.rows.get((slot as usize).wrapping_sub(1))
    }

    /// Writes over the effect of a row of the other table; `false`, and nothing done, if it comes or goes.
    pub fn replace(&mut self, row: usize, effect: Option<R>) -> bool {
        let slot = self.slots.get(row).map_or(0, |&slot| slot as usize);
        match (self.rows.get_mut(slot.wrapping_sub(1)), effect) {
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
