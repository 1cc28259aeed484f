//! Which effects there are.

use super::survey;

macro_rules! define_effects {
    ({ $($effect:ident $name:ident: $component:ident [$($stage:ident)*] $what:literal;)* }) => {
        /// What a scene may ask for beyond coloured surfaces under plain lights.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum Effect {
            $(#[doc = $what] $effect,)*
        }

        impl Effect {
            /// Every effect, in the order of reports.
            pub const ALL: [Self; [$(Self::$effect),*].len()] = [$(Self::$effect),*];

            /// Name in reports and on the command line.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$effect => stringify!($name),)*
                }
            }
        }
    };
}

survey!(all, define_effects);

/// Some effects.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct EffectSet(u32);

impl EffectSet {
    /// No effect.
    pub const NONE: Self = Self(0);

    /// Every effect.
    pub const ALL: Self = Self::of(&Effect::ALL);

    /// These effects.
    pub const fn of(effects: &[Effect]) -> Self {
        let mut bits = 0;
        let mut index = 0;
        while index < effects.len() {
            bits |= 1 << effects[index] as u32;
            index += 1;
        }
        Self(bits)
    }

    /// Those that are said to be there.
    pub fn present(effects: &[(Effect, bool)]) -> Self {
        effects.iter().filter(|(_, is_there)| *is_there).map(|&(effect, _)| effect).collect()
    }

    /// One bit an effect: what kernels are compiled for.
    pub const fn bits(self) -> u32 {
        self.0
    }

    /// The set of some [`bits`](Self::bits).
    pub const fn from_bits(bits: u32) -> Self {
        Self(bits & Self::ALL.0)
    }

    /// Whether an effect is among these.
    pub const fn contains(self, effect: Effect) -> bool {
        self.0 & (1 << effect as u32) != 0
    }

    /// Whether all of these are among others.
    pub const fn is_subset(self, other: Self) -> bool {
        self.0 & !other.0 == 0
    }

    /// These and others.
    #[must_use]
    pub const fn union(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// These, if they are among others as well.
    #[must_use]
    pub const fn intersection(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    /// These but for others.
    #[must_use]
    pub const fn minus(self, other: Self) -> Self {
        Self(self.0 & !other.0)
    }

    /// Whether there is none.
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// These and one more.
    #[must_use]
    pub const fn with(self, effect: Effect) -> Self {
        Self(self.0 | 1 << effect as u32)
    }

    /// These but for one.
    #[must_use]
    pub const fn without(self, effect: Effect) -> Self {
        Self(self.0 & !(1 << effect as u32))
    }

    /// The effects, in the order of [`Effect::ALL`].
    pub fn iter(self) -> impl Iterator<Item = Effect> {
        Effect::ALL.into_iter().filter(move |&effect| self.contains(effect))
    }
}

impl FromIterator<Effect> for EffectSet {
    fn from_iter<I: IntoIterator<Item = Effect>>(effects: I) -> Self {
        effects.into_iter().fold(Self::NONE, |set, effect| set.union(Self::of(&[effect])))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_effect_has_a_bit_and_a_name_of_its_own() {
        let names: std::collections::BTreeSet<_> = Effect::ALL.into_iter().map(Effect::name).collect();
        assert_eq!(names.len(), Effect::ALL.len());
        assert_eq!(EffectSet::ALL.bits().count_ones() as usize, Effect::ALL.len());
        assert!(Effect::ALL.into_iter().eq(EffectSet::ALL.iter()));
    }

    #[test]
    fn a_set_without_one_is_a_subset_that_lacks_it() {
        for effect in Effect::ALL {
            let others = EffectSet::ALL.without(effect);
            assert!(others.is_subset(EffectSet::ALL) && !EffectSet::ALL.is_subset(others));
            assert!(!others.contains(effect) && others.iter().count() == Effect::ALL.len() - 1);
            assert_eq!(others.with(effect), EffectSet::ALL);
        }
    }
}
