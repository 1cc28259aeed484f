//! Long scenes, which many threads read: they find what one finds, and say what one says.

use core::fmt::Write;

use archetrace::scene::{Description, Problem, parse};
use rayon::ThreadPoolBuilder;

use crate::random::Random;

/// So many that every one of some threads has enough to read.
const OBJECTS: u32 = 30_000;

type Parsed = Result<(Description, Vec<Problem>), Vec<Problem>>;

fn parsed_by(threads: usize, text: &str) -> Parsed {
    ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(|| parse(text))
}

/// Where the object of a number is, which no two share.
fn position(number: u32) -> [f64; 3] {
    let number = f64::from(number);
    [number / 8.0, -number, number * number / 1024.0]
}

/// Objects of every kind, said to be so many, with this between the words of each.
fn scene(count: u32, between: impl Fn(u32) -> &'static str) -> String {
    let mut text = format!("1 1000 60 1.5 3 64\n10\n0.2 0.5 0.3\n{count}\n");
    for number in 0..OBJECTS {
        let [x, y, z] = position(number);
        let shape = ["sphere", "cube", "pyramid"][number as usize % 3];
        let second = if number % 3 == 2 { "2.5" } else { "" };
        let words = format!("{shape} {x} {y} {z} 4 {second} 0.1 0.2 0.3 0.25 0.25 0.25 0.25 5");
        let words: Vec<&str> = words.split_whitespace().collect();
        writeln!(text, "{}", words.join(between(number))).unwrap();
    }
    text + "1\n70 71 100 0.001\n0\n"
}

#[test]
fn every_object_is_read_once_and_in_its_place() {
    for between in [" ", "\n", "\r\n\t", " # sphere 1 2 3 4 0.1 0.2 0.3 0.25 0.25 0.25 0.25 5\n"] {
        let text = scene(OBJECTS, |_| between);
        for threads in [1, 2, 3, 8] {
            let (description, warnings) = parsed_by(threads, &text).unwrap();
            assert_eq!(warnings, []);
            assert_eq!(description.lights.len(), 1);
            let found: Vec<[f64; 3]> =
                description.objects.iter().map(|object| object.position.to_array()).collect();
            assert!(found.into_iter().eq((0..OBJECTS).map(position)), "{between:?}, {threads} threads");
        }
    }
}

#[test]
fn a_text_of_one_line_is_read_too() {
    let text = scene(OBJECTS, |_| " ").replace('\n', " ");
    assert_eq!(parsed_by(4, &text).unwrap(), parsed_by(1, &text).unwrap());
}

#[test]
fn a_wrong_count_is_told_in_the_same_words() {
    for count in [0, 1, 7, OBJECTS / 2, OBJECTS - 1, OBJECTS + 1] {
        let text = scene(count, |_| " ");
        let problems = parsed_by(1, &text).unwrap_err();
        assert_eq!(parsed_by(4, &text).unwrap_err(), problems, "{count} objects announced");
    }
}

#[test]
fn prose_about_objects_is_not_read() {
    let objects = scene(OBJECTS, |_| " ");
    let text = scene(OBJECTS, |_| "\n") + "This was all.\n" + &objects;
    let (description, warnings) = parsed_by(4, &text).unwrap();
    assert_eq!((description.objects.len(), warnings.len()), (OBJECTS as usize, 0));
}

const WRONG: [&str; 8] = ["sphere\n", "cube ", "x ", "-1 ", "# ", "1e999 ", "\u{fffd} ", "\u{a0}"];

/// A text with some of its words gone, doubled or replaced.
fn changed(text: &str, random: &mut Random) -> String {
    let mut words: Vec<&str> = text.split_inclusive([' ', '\n']).collect();
    for _ in 0..=random.below(4) {
        let place = random.below(words.len());
        match random.below(4) {
            0 => drop(words.remove(place)),
            1 => words.insert(place, words[place]),
            // A coefficient with which the sum is another.
            2 => words[place] = "0.5 ",
            _ => words[place] = random.pick(&WRONG),
        }
    }
    words.concat()
}

#[test]
fn what_is_wrong_is_told_in_the_same_words() {
    let text = scene(OBJECTS, |number| if number % 2 == 0 { " " } else { "\n" });
    let (mut read, mut warned, mut refused) = (0, 0, 0);
    for (seed, threads) in (0..100).zip([2, 3, 4, 5].into_iter().cycle()) {
        let text = changed(&text, &mut Random::new(seed));
        let one = parsed_by(1, &text);
        // Texts are too long to be shown.
        assert!(parsed_by(threads, &text) == one, "seed {seed}");
        match one {
            Ok((_, warnings)) if warnings.is_empty() => read += 1,
            Ok(_) => warned += 1,
            Err(_) => refused += 1,
        }
    }
    assert!(read > 3 && warned > 3 && refused > 30, "{read} read, {warned} with warnings, {refused} refused");
}
