//! Broken files: bytes and words deleted, doubled, swapped, replaced and inserted.

use crate::random::Random;

/// Words that may do harm.
const INSERTS: [&str; 24] = [
    "4294967295",
    "4294967296",
    "2000000",
    "10000",
    "1e9",
    "-1",
    "0",
    "1e400",
    "nan",
    "inf",
    "sphere",
    "cube",
    "pyramid",
    "#",
    "\n",
    "\0",
    "\u{feff}",
    "é",
    "\u{1b}[2J",
    "1e-400",
    "1e70",
    "-0",
    "spherecube",
    "1 1 1",
];

/// A text broken in up to five places. Every seed breaks it in another way, the same in every run.
pub(crate) fn mutant(seed: u64, text: &str) -> Vec<u8> {
    let mut random = Random::new(seed);
    let mut bytes = text.as_bytes().to_vec();
    for _ in 0..=random.below(4) {
        if random.below(2) == 0 {
            mutate_bytes(&mut random, &mut bytes);
        } else {
            let text = String::from_utf8_lossy(&bytes).into_owned();
            bytes = mutate_words(&mut random, &text).into_bytes();
        }
    }
    bytes
}

fn mutate_bytes(random: &mut Random, bytes: &mut Vec<u8>) {
    if bytes.is_empty() {
        return;
    }
    let at = random.below(bytes.len());
    let other = random.below(bytes.len());
    let any = u8::try_from(random.below(256)).unwrap();
    match random.below(6) {
        0 => drop(bytes.remove(at)),
        1 => bytes.insert(at, bytes[other]),
        2 => bytes.swap(at, other),
        3 => bytes[at] = any,
        4 => bytes.truncate(at),
        _ => drop(bytes.drain(at.min(other)..at.max(other).min(at.min(other) + 8))),
    }
}

fn mutate_words(random: &mut Random, text: &str) -> String {
    let mut words: Vec<&str> = text.split(' ').collect();
    let (at, other) = (random.below(words.len()), random.below(words.len()));
    match random.below(5) {
        0 => drop(words.remove(at)),
        1 => words.insert(at, words[other]),
        2 => words.swap(at, other),
        3 => words[at] = random.pick(&INSERTS),
        _ => words.insert(at, random.pick(&INSERTS)),
    }
    words.join(" ")
}
