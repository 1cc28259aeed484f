//! Which kernels there are.

use crate::effects::{Effect, EffectSet};

/// Effects that are no work of a kernel: objects are moved before it, and light becomes bytes after it.
const ELSEWHERE: EffectSet = EffectSet::of(&[Effect::MotionBlur, Effect::Srgb]);

/// Code to trace with, compiled for a set of effects: what is not in the set is not in the code. All that have what a
/// scene asks for trace it to the same bits.
///
/// What they add to a release program of 13994 kB, as `benches/kernel_sizes.sh` says: packets 41 to 80 kB for each precision,
/// level of vector instructions and kernel, 719 in all; the searches of trees and of lists of rays, which know of no effect
/// and are shared, 99 to 150, 1567 in all; stages 227, 180 of them, and 114 for hits and shadows. Two loops with every effect
/// were larger than the stages, and took 4 to 10 % more instructions. `benches/idle_effects.sh` holds all of them against
/// programs without an effect.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kernel {
    /// Coloured surfaces under plain lights, in packets.
    Plain,
    /// The effects that a scene file can ask for, in packets.
    Assignment,
    /// These effects, ray by ray, by stages that have just them.
    Stages(EffectSet),
}

impl Kernel {
    /// The one that can do everything.
    pub const EVERYTHING: Self = Self::Stages(EffectSet::ALL);

    /// Every kernel that can do what these effects are: those in packets first, and of each sort the smallest; none if the
    /// program lacks one of them.
    pub fn all_for(effects: EffectSet) -> impl Iterator<Item = Self> {
        let all = [Self::Plain, Self::Assignment, Self::Stages(effects), Self::EVERYTHING];
        all.into_iter().filter(move |kernel| effects.is_subset(kernel.effects()))
    }

    /// The smallest one in packets that has these effects, otherwise the one that has just them; the largest where none
    /// has them.
    pub fn smallest_for(effects: EffectSet) -> Self {
        Self::all_for(effects).next().unwrap_or(Self::EVERYTHING)
    }

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
            Self::Stages(effects) => effects,
        }
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

    /// What kernels have, and what differs from that by one or two effects.
    fn sets() -> impl Iterator<Item = EffectSet> {
        let kernels = [Kernel::Plain, Kernel::Assignment, Kernel::EVERYTHING].map(Kernel::effects);
        let pairs = || Effect::ALL.into_iter().flat_map(|a| Effect::ALL.map(|b| EffectSet::of(&[a, b])));
        let sets = kernels.into_iter().chain([EffectSet::NONE]);
        sets.flat_map(move |set| pairs().flat_map(move |pair| [set.union(pair), set.minus(pair)]))
    }

    #[test]
    fn every_set_gets_the_smallest_packets_that_have_it_or_stages_of_its_own() {
        for set in sets() {
            let kernels: Vec<_> = Kernel::all_for(set).collect();
            let packets = [Kernel::Plain, Kernel::Assignment];
            let able = packets.into_iter().find(|kernel| set.is_subset(kernel.effects()));
            assert_eq!(Kernel::smallest_for(set), able.unwrap_or(Kernel::Stages(set)));
            assert_eq!(Kernel::smallest_for(set), kernels[0]);
            assert!(kernels.iter().all(|kernel| set.is_subset(kernel.effects())));
            assert!(kernels.contains(&Kernel::EVERYTHING) && kernels.contains(&Kernel::Stages(set)));
        }
    }
}
