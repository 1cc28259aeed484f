//! Which kernels there are.

use crate::effects::{Effect, EffectSet};

/// Effects that are no work of a kernel: objects are moved before it, and light becomes bytes after it.
const ELSEWHERE: EffectSet = EffectSet::of(&[Effect::MotionBlur, Effect::Srgb]);

/// Code to trace with, compiled for a set of effects: what is not in the set is not in the code. Each kernel can
/// trace all that the ones before it can, to the same bits.
///
/// A kernel between the first two, with gloss and mirrors alone, saved 1.3 % of the instructions of a picture that asks for
/// no more, and is not worth its copies; the first saves 4.7 % of one that asks for nothing. Glass is the one effect that
/// costs more than 1 % where nobody asks for it (2.5 %), for it makes two rays of one: hence a kernel without. More of
/// them are not needed: what few scenes ask for lies in functions of its own, and what is left is a test for each.
/// `benches/idle_effects.sh` holds that against programs that have no code for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kernel {
    /// Coloured surfaces under plain lights, in packets.
    Plain,
    /// The effects that a scene file can ask for, in packets.
    Assignment,
    /// Every effect but glass and what is in it, ray by ray.
    Opaque,
    /// Every effect, ray by ray.
    Everything,
}

impl Kernel {
    /// Every kernel, the smallest first.
    pub const ALL: [Self; 4] = [Self::Plain, Self::Assignment, Self::Opaque, Self::Everything];

    /// The effects that it is compiled for.
    pub const fn effects(self) -> EffectSet {
        self.intended().intersection(EffectSet::COMPILED)
    }

    const fn intended(self) -> EffectSet {
        match self {
            Self::Plain => ELSEWHERE,
            Self::Assignment => EffectSet::of(&[
                Effect::Gloss,
                Effect::Mirror,
                Effect::Texture,
                Effect::Falloff,
                Effect::SpotCone,
            ])
            .union(ELSEWHERE),
            Self::Opaque => EffectSet::ALL.without(Effect::Glass).without(Effect::Absorption),
            Self::Everything => EffectSet::ALL,
        }
    }

    /// The smallest one that has these effects; the largest where none has them.
    pub fn smallest_for(effects: EffectSet) -> Self {
        let mut able = Self::ALL.into_iter().filter(|kernel| effects.is_subset(kernel.effects()));
        able.next().unwrap_or(Self::Everything)
    }
}

/// Whether code for the effects of these bits has one of them.
#[inline(always)]
pub(super) const fn has<const EFFECTS: u32>(effect: Effect) -> bool {
    EFFECTS & (1 << effect as u32) != 0
}

/// What a row has of an effect, for code that may not know of it: nothing then, and nobody looks.
#[inline(always)]
pub(super) fn known<const EFFECTS: u32, R>(effect: Effect, row: Option<R>) -> Option<R> {
    if has::<EFFECTS>(effect) { row } else { None }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_kernel_can_do_what_the_ones_before_it_can() {
        for pair in Kernel::ALL.windows(2) {
            assert!(pair[0] < pair[1] && pair[0].effects().is_subset(pair[1].effects()));
        }
    }

    /// What kernels have, and what differs from that by one or two effects.
    fn sets() -> impl Iterator<Item = EffectSet> {
        let kernels = Kernel::ALL.into_iter().map(Kernel::effects).chain([EffectSet::NONE]);
        let pairs = || Effect::ALL.into_iter().flat_map(|a| Effect::ALL.map(|b| EffectSet::of(&[a, b])));
        kernels.flat_map(move |set| pairs().flat_map(move |pair| [set.union(pair), set.minus(pair)]))
    }

    #[test]
    fn every_set_gets_the_smallest_kernel_that_has_it() {
        for set in sets() {
            let chosen = Kernel::smallest_for(set);
            assert!(set.is_subset(chosen.effects()));
            assert!(Kernel::ALL.into_iter().all(|k| k >= chosen || !set.is_subset(k.effects())));
        }
    }
}
