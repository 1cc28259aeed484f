//! Effects that a program is built without.

use super::{Effect, EffectSet};

impl EffectSet {
    /// The effects that this program can simulate: all, but for those that `ARCHETRACE_WITHOUT` named when it was built
    /// (`ARCHETRACE_WITHOUT="fog glass" cargo build`). Of the others no kernel has a trace, and a World that asks for one is
    /// refused. It is how `benches/idle_effects.sh` shows what an effect costs where nobody asks for it.
    pub const COMPILED: Self = match option_env!("ARCHETRACE_WITHOUT") {
        Some(names) => Self::ALL.minus(Self::named(names)),
        None => Self::ALL,
    };

    /// The effects of a list of names with spaces between them. While compiling, a name that no effect has is an error.
    const fn named(list: &str) -> Self {
        let mut set = Self::NONE;
        let mut rest = list.as_bytes();
        while let [first, others @ ..] = rest {
            if *first == b' ' {
                rest = others;
                continue;
            }
            let (word, after) = rest.split_at(word_length(rest));
            set = set.union(Self::of(&[effect_named(word)]));
            rest = after;
        }
        set
    }
}

/// Bytes up to the next space.
const fn word_length(text: &[u8]) -> usize {
    let mut length = 0;
    while length < text.len() && text[length] != b' ' {
        length += 1;
    }
    length
}

const fn effect_named(word: &[u8]) -> Effect {
    let mut index = 0;
    while index < Effect::ALL.len() && !is_equal(Effect::ALL[index].name().as_bytes(), word) {
        index += 1;
    }
    assert!(index < Effect::ALL.len(), "ARCHETRACE_WITHOUT has a name that is no effect's");
    Effect::ALL[index]
}

const fn is_equal(a: &[u8], b: &[u8]) -> bool {
    let mut index = 0;
    while index < a.len() && index < b.len() && a[index] == b[index] {
        index += 1;
    }
    index == a.len() && index == b.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_names_its_effects_and_no_other() {
        assert_eq!(EffectSet::named(""), EffectSet::NONE);
        assert_eq!(
            EffectSet::named("  texture_filter   fog "),
            EffectSet::of(&[Effect::Fog, Effect::TextureFilter])
        );
        let all = Effect::ALL.map(Effect::name).join(" ");
        assert_eq!(EffectSet::named(&all), EffectSet::ALL);
    }

    #[test]
    #[should_panic = "no effect's"]
    fn the_beginning_of_a_name_is_none() {
        EffectSet::named("gloss text");
    }

    #[test]
    #[should_panic = "no effect's"]
    fn more_than_a_name_is_none() {
        EffectSet::named("glossy");
    }
}
