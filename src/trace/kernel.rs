//! Which kernels there are.

use crate::effects::{Effect, EffectSet};

/// Effects that are no work of a kernel: objects are moved before it, and light becomes bytes after it.
const ELSEWHERE: EffectSet = EffectSet::of(&[Effect::MotionBlur, Effect::Srgb]);

/// Code to trace with, compiled for a set of effects: what is not in the set is not in the code. Each kernel can
/// trace all that the ones before it can, to the same bits.
///
/// A kernel between the first two, with gloss and mirrors alone, saved 1.3 % of the instructions of a picture that asks for
/// no more, and is not worth its copies; the first saves 4.7 % of one that asks for nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kernel {
    /// Coloured surfaces under plain lights, in packets.
    Plain,
    /// The effects that a scene file can ask for, in packets.
    Assignment,
    /// Every effect, ray by ray.
    Everything,
}

impl Kernel {
    /// Every kernel, the smallest first.
    pub const ALL: [Self; 3] = [Self::Plain, Self::Assignment, Self::Everything];

    /// The effects that it is compiled for.
    pub const fn effects(self) -> EffectSet {
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
            Self::Everything => EffectSet::ALL,
        }
    }

    /// The smallest one that has these effects.
    pub fn smallest_for(effects: EffectSet) -> Self {
        let mut able = Self::ALL.into_iter().filter(|kernel| effects.is_subset(kernel.effects()));
        able.next().unwrap_or(Self::Everything)
    }
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

    #[test]
    fn every_set_gets_the_smallest_kernel_that_has_it() {
        for bits in 0..=EffectSet::ALL.bits() {
            let set = EffectSet::from_bits(bits);
            let chosen = Kernel::smallest_for(set);
            assert!(set.is_subset(chosen.effects()));
            assert!(Kernel::ALL.into_iter().all(|k| k >= chosen || !set.is_subset(k.effects())));
        }
    }
}
