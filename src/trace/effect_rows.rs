//! What tables hold of effects, made of the lines of the survey: a field or a column for each.

/// Defines what one row of a table has of each effect in some lines.
macro_rules! define_rows {
    ($(#[$meta:meta])* $rows:ident
        { $($effect:ident $name:ident: $component:ident [$($stage:ident)*] $what:literal;)* }) => {
        $(#[$meta])*
        pub struct $rows<T: Real> {
            $(#[doc = $what] pub $name: Option<RowOf<crate::components::$component, T>>,)*
        }

        impl<T: Real> Default for $rows<T> {
            /// No effect.
            fn default() -> Self {
                Self { $($name: None,)* }
            }
        }

        impl<T: Real> $rows<T> {
            /// The effects that are there.
            pub fn set(&self) -> EffectSet {
                EffectSet::present(&[$((Effect::$effect, self.$name.is_some()),)*])
            }

            /// Rows of an effect, one or none, and the memory that they take.
            pub fn size(&self, effect: Effect) -> (usize, usize) {
                match effect {
                    $(Effect::$effect if self.$name.is_some() => (1, size_of_val(&self.$name)),)*
                    _ => (0, 0),
                }
            }

            /// What code for the effects of these bits knows of it.
            #[inline(always)]
            #[must_use]
            pub fn of_kernel<const EFFECTS: u32>(self) -> Self {
                Self { $($name: known::<EFFECTS, _>(Effect::$effect, self.$name),)* }
            }
        }
    };
}

/// Defines a column for each effect in some lines, for rows that [`define_rows`] has defined.
macro_rules! define_columns {
    ($(#[$meta:meta])* $columns:ident of $rows:ident
        { $($effect:ident $name:ident: $component:ident [$($stage:ident)*] $what:literal;)* }) => {
        $(#[$meta])*
        pub struct $columns<T: Real> {
            $(#[doc = $what] pub $name: EffectColumn<RowOf<crate::components::$component, T>>,)*
        }

        impl<T: Real> Default for $columns<T> {
            /// No row.
            fn default() -> Self {
                Self { $($name: EffectColumn::default(),)* }
            }
        }

        impl<T: Real> $columns<T> {
            /// Adds a row.
            pub fn push(&mut self, row: $rows<T>) {
                $(self.$name.push(row.$name);)*
            }

            /// Writes over a row; `false`, and not all of it written, if an effect comes or goes.
            pub fn replace(&mut self, index: usize, row: $rows<T>) -> bool {
                $(self.$name.replace(index, row.$name))&&*
            }

            /// A row as it was added.
            #[inline(always)]
            pub fn row(&self, index: usize) -> $rows<T> {
                $rows { $($name: self.$name.get(index).cloned(),)* }
            }

            /// The effects that some row has.
            pub fn set(&self) -> EffectSet {
                EffectSet::present(&[$((Effect::$effect, !self.$name.is_empty()),)*])
            }

            /// Rows that have an effect, and the memory that it takes.
            pub fn size(&self, effect: Effect) -> (usize, usize) {
                match effect {
                    $(Effect::$effect => self.$name.size(),)*
                    _ => (0, 0),
                }
            }

            /// Gives back memory that no row takes.
            pub fn shrink_to_fit(&mut self) {
                $(self.$name.shrink_to_fit();)*
            }
        }
    };
}

pub(super) use define_columns;
pub(super) use define_rows;
