//! Words to [`Description`].

use core::fmt::Display;
use core::ops::Range as Span;

use glam::DVec3;

use crate::components::range::{
    COEFFICIENT, COLOR, COORDINATE, CUTOFF, FALLOFF, FIELD_OF_VIEW, LENGTH, MAX_LEVEL, MAX_PIXELS, RATIO,
    Range, SHININESS,
};

use super::description::{
    BoardDescription, Description, LightDescription, ObjectDescription, ShapeDescription, SpotDescription,
    SurfaceDescription,
};
use super::lexer::{Lexer, Word};
use super::problem::{Problem, quoted};
use super::write::Number;

/// Most objects in a file.
pub const MAX_OBJECTS: u32 = 2_000_000;
/// Most lights of each kind in a file.
pub const MAX_LIGHTS: u32 = 10_000;
/// Most problems and most warnings that are worth telling.
const MAX_PROBLEMS: usize = 20;

/// Reads a scene. On success there may be warnings; on failure there is every problem that could be told apart
/// from its consequences, at least one.
pub fn parse(text: &str) -> Result<(Description, Vec<Problem>), Vec<Problem>> {
    let mut parser = Parser {
        text,
        words: Lexer::new(text),
        end: text.trim_end().len(),
        last: 0..0,
        announced: None,
        in_list: false,
        problems: Vec::new(),
        warnings: Vec::new(),
        unshown_warnings: 0,
    };
    match parser.file() {
        Ok(description) if parser.problems.is_empty() => Ok((description, parser.finished_warnings())),
        _ => Err(parser.problems),
    }
}

/// Why the parser leaves a rule early; what is wrong has been noted.
enum Stop {
    /// Here an object starts, before the last one was complete: reading can go on with it.
    AtObject,
    /// Nothing that follows can be made sense of.
    Lost,
}

struct Parser<'a> {
    text: &'a str,
    words: Lexer<'a>,
    /// Where the text ends, blanks left out.
    end: usize,
    /// The word read last.
    last: Span<usize>,
    /// The count that says how many items are being read: where it is wrong, the error shows later.
    announced: Option<Announced>,
    /// Whether these items are bare numbers, without a word at their start.
    in_list: bool,
    problems: Vec<Problem>,
    warnings: Vec<Problem>,
    unshown_warnings: usize,
}

/// A count, with the name of what it counts.
struct Announced {
    what: String,
    count: u32,
    /// Where it stands, in bytes.
    at: usize,
}

const OBJECT_WORDS: [&str; 3] = ["sphere", "cube", "pyramid"];

fn is_object_word(word: &str) -> bool {
    OBJECT_WORDS.contains(&word)
}

impl<'a> Parser<'a> {
    fn file(&mut self) -> Result<Description, Stop> {
        let near = self.number("the distance of the near plane", &LENGTH)?;
        let far = self.number("the distance of the far plane", &LENGTH)?;
        if near >= far {
            let message = format!("the distance of the far plane is {}", Number(far));
            let label = format!("must be greater than that of the near plane, {}", Number(near));
            self.fail(self.last.clone(), message, label)?;
        }
        let fovy = self.number("the vertical field of view", &FIELD_OF_VIEW)?;
        let aspect = self.number("the aspect ratio", &RATIO)?;
        if FIELD_OF_VIEW.contains(fovy) && RATIO.contains(aspect) && !FIELD_OF_VIEW.contains(aspect * fovy) {
            let fovx = Number(rounded(aspect * fovy));
            let message =
                format!("the horizontal field of view, aspect ratio times vertical one, is {fovx} degrees");
            self.fail(self.last.clone(), message, format!("must make it {}", FIELD_OF_VIEW.words))?;
        }
        let level = self.whole("the level of recursion", 0, MAX_LEVEL)?;
        let pixels = self.whole("the number of pixels along each side", 1, MAX_PIXELS)?;
        let board = self.board()?;
        let objects = self.objects()?;
        let lights = self.list("normal light", |parser| parser.light("light"))?;
        let spots = self.list("spotlight", Self::spot)?;
        self.check_rest();
        Ok(Description { near, far, fovy, aspect, level, pixels, board, objects, lights, spots })
    }

    fn board(&mut self) -> Result<BoardDescription, Stop> {
        let cell = self.number("the width of the checkerboard's cells", &LENGTH)?;
        let ambient = self.number("the checkerboard's ambient coefficient", &COEFFICIENT)?;
        let start = self.last.start;
        let diffuse = self.number("the checkerboard's diffuse coefficient", &COEFFICIENT)?;
        let reflection = self.number("the checkerboard's reflection coefficient", &COEFFICIENT)?;
        self.check_sum(start, "ambient + diffuse + reflection", (ambient + diffuse) + reflection);
        Ok(BoardDescription { cell, ambient, diffuse, reflection })
    }

    fn objects(&mut self) -> Result<Vec<ObjectDescription>, Stop> {
        let count = self.count("object", MAX_OBJECTS)?;
        // Grown as objects come: a count alone costs no memory.
        let mut objects = Vec::new();
        for index in 1..=count {
            match self.object(index, count) {
                Ok(object) => objects.push(object),
                Err(Stop::AtObject) => {}
                Err(Stop::Lost) => return Err(Stop::Lost),
            }
        }
        let extra = self.peek().filter(|word| is_object_word(word.text));
        if let Some(word) = extra.filter(|_| self.problems.is_empty()) {
            let message = format!("found {} where the number of normal lights should be", quoted(word.text));
            self.fail_count(word.span(), message, "one object more than announced")?;
        }
        match extra {
            Some(_) => Err(Stop::Lost),
            None => Ok(objects),
        }
    }

    fn object(&mut self, index: u32, count: u32) -> Result<ObjectDescription, Stop> {
        let Some(mut word) = self.next() else {
            return self.ended(&format!("object {index} of {count}"), "sphere, cube or pyramid");
        };
        if !is_object_word(word.text) {
            let message = format!("found {} where object {index} of {count} should start", quoted(word.text));
            self.fail_count(word.span(), message, "must be sphere, cube or pyramid")?;
            self.skip_to_object()?;
            // A number before the object was one too many; any other word was this object's name.
            if !is_number(word.text) {
                return Err(Stop::AtObject);
            }
            word = self.next().ok_or(Stop::Lost)?;
        }
        let name = word.text;
        let position = self.point(format_args!("the {name}'s "), "")?;
        let mut length = |what: &str| self.number(format_args!("the {name}'s {what}"), &LENGTH);
        let shape = match name {
            "sphere" => ShapeDescription::Sphere { radius: length("radius")? },
            "cube" => ShapeDescription::Cube { side: length("side")? },
            _ => ShapeDescription::Pyramid { width: length("width")?, height: length("height")? },
        };
        let surface = self.surface(name)?;
        Ok(ObjectDescription { position, shape, surface })
    }

    fn surface(&mut self, name: &str) -> Result<SurfaceDescription, Stop> {
        let mut channel = |what: &str| self.number(format_args!("the {name}'s {what}"), &COLOR);
        let color = DVec3::new(channel("red")?, channel("green")?, channel("blue")?);
        let ambient = self.number(format_args!("the {name}'s ambient coefficient"), &COEFFICIENT)?;
        let start = self.last.start;
        let mut coefficient =
            |what: &str| self.number(format_args!("the {name}'s {what} coefficient"), &COEFFICIENT);
        let diffuse = coefficient("diffuse")?;
        let specular = coefficient("specular")?;
        let reflection = coefficient("reflection")?;
        let sum = ((ambient + diffuse) + specular) + reflection;
        self.check_sum(start, "ambient + diffuse + specular + reflection", sum);
        let shininess = self.number(format_args!("the {name}'s shininess"), &SHININESS)?;
        Ok(SurfaceDescription { color, ambient, diffuse, specular, reflection, shininess })
    }

    /// A count and that many items. Nothing here has a word of its own, so nothing can be skipped to.
    fn list<I>(
        &mut self,
        name: &str,
        mut item: impl FnMut(&mut Self) -> Result<I, Stop>,
    ) -> Result<Vec<I>, Stop> {
        let count = self.count(name, MAX_LIGHTS)?;
        self.in_list = true;
        let mut items = Vec::new();
        for _ in 0..count {
            items.push(item(self)?);
        }
        Ok(items)
    }

    fn light(&mut self, name: &str) -> Result<LightDescription, Stop> {
        let position = self.point(format_args!("the {name}'s "), "")?;
        let falloff = self.number(format_args!("the {name}'s falloff"), &FALLOFF)?;
        Ok(LightDescription { position, falloff })
    }

    fn spot(&mut self) -> Result<SpotDescription, Stop> {
        let light = self.light("spotlight")?;
        let start = self.peek().map_or(self.end, |word| word.start);
        let target = self.point("the ", " of the point that the spotlight looks at")?;
        if target == light.position {
            let message = "the spotlight looks at its own position, so its cone has no direction";
            self.fail(start..self.last.end, message.into(), "must be another point")?;
        }
        let cutoff = self.number("the spotlight's cutoff angle", &CUTOFF)?;
        Ok(SpotDescription { light, target, cutoff })
    }

    /// Three coordinates; their names stand between `before` and `after`.
    fn point(&mut self, before: impl Display, after: &str) -> Result<DVec3, Stop> {
        let mut coordinate = |axis| self.number(format_args!("{before}{axis}{after}"), &COORDINATE);
        Ok(DVec3::new(coordinate('x')?, coordinate('y')?, coordinate('z')?))
    }

    /// A number in its range. One that is not is noted and read as NaN: the description is dropped then, and NaN
    /// fails no further check.
    ///
    /// Nearly all are, and a large scene has millions: what they are called is put into words for the others only.
    #[inline]
    fn number(&mut self, what: impl Display, range: &Range) -> Result<f64, Stop> {
        let mut ahead = self.words;
        if let Some(word) = ahead.next()
            && let Ok(number) = word.text.parse::<f64>()
            && range.contains(number)
        {
            self.words = ahead;
            self.last = word.span();
            return Ok(number);
        }
        self.wrong_number(&what.to_string(), range)
    }

    #[cold]
    fn wrong_number(&mut self, what: &str, range: &Range) -> Result<f64, Stop> {
        let word = self.value_word(what, range.words)?;
        // Within a list of bare numbers, a word may be what follows the list.
        let too_many = self.in_list && !is_number(word.text);
        let note = self.said_count().filter(|_| too_many);
        self.note(Problem { note, ..not_allowed(word, what, range.words) })?;
        Ok(f64::NAN)
    }

    /// A whole number in its range. Whatever comes after a wrong one cannot be counted, so nothing goes on.
    fn whole(&mut self, what: &str, low: u32, high: u32) -> Result<u32, Stop> {
        let words = format!("a whole number from {low} to {high}");
        let word = self.value_word(what, &words)?;
        match word.text.parse::<u32>() {
            Ok(number) if (low..=high).contains(&number) => Ok(number),
            _ => {
                let problem = not_allowed(word, what, &words);
                self.note(Problem { note: self.said_count(), ..problem })?;
                Err(Stop::Lost)
            }
        }
    }

    /// How many items of a kind follow.
    fn count(&mut self, item: &str, most: u32) -> Result<u32, Stop> {
        let what = format!("the number of {item}s");
        let count = self.whole(&what, 0, most)?;
        self.announced = Some(Announced { what, count, at: self.last.start });
        Ok(count)
    }

    /// The last count with its line, in words.
    fn said_count(&self) -> Option<String> {
        let Announced { what, count, at } = self.announced.as_ref()?;
        let line = self.text[..*at].matches('\n').count() + 1;
        Some(format!("{what} is given as {count} in line {line}"))
    }

    /// The next word, which should be a value and not the start of an object.
    fn value_word(&mut self, what: &str, allowed: &str) -> Result<Word<'a>, Stop> {
        if let Some(word) = self.peek().filter(|word| is_object_word(word.text)) {
            let message = format!("found {} where {what} should be", quoted(word.text));
            self.fail(word.span(), message, format!("{allowed} is missing before this"))?;
            return Err(Stop::AtObject);
        }
        match self.next() {
            Some(word) => Ok(word),
            None => self.ended(what, allowed),
        }
    }

    fn peek(&self) -> Option<Word<'a>> {
        let mut ahead = self.words;
        ahead.next()
    }

    fn next(&mut self) -> Option<Word<'a>> {
        let word = self.words.next()?;
        self.last = word.span();
        Some(word)
    }

    fn ended<R>(&mut self, what: &str, allowed: &str) -> Result<R, Stop> {
        let message = format!("the file ends where {what} should be");
        self.fail_count(self.end..self.end, message, format!("{allowed} is missing"))?;
        Err(Stop::Lost)
    }

    /// Passes over the numbers of an object of unknown kind, up to the next object. Any other word would be read as
    /// what it is not, and so would a word of prose that happens to name an object.
    fn skip_to_object(&mut self) -> Result<(), Stop> {
        while self.peek().is_some_and(|word| is_number(word.text)) {
            self.words.next();
        }
        let mut ahead = self.words;
        let starts_object = ahead.next().is_some_and(|word| is_object_word(word.text))
            && ahead.next().is_some_and(|word| is_number(word.text));
        if starts_object { Ok(()) } else { Err(Stop::Lost) }
    }

    /// Prose may follow the last number. A number there is more likely one that some count left out.
    fn check_rest(&mut self) {
        if let Some(word) = self.peek().filter(|word| is_number(word.text)) {
            let message = format!("found {} after the last number of the scene", quoted(word.text));
            self.warn(Problem::warning(word.span(), message, "this and all that follows is not read"));
        }
    }

    fn check_sum(&mut self, start: usize, names: &str, sum: f64) {
        // The promise is in decimal; sums of doubles meet it only nearly.
        if (sum - 1.0).abs() <= 1e-6 || sum.is_nan() {
            return;
        }
        let message = format!("the coefficients add up to {}", Number(rounded(sum)));
        let label = format!("{names} should be 1");
        self.warn(Problem::warning(start..self.last.end, message, label));
    }

    fn warn(&mut self, warning: Problem) {
        if self.warnings.len() < MAX_PROBLEMS {
            self.warnings.push(warning);
        } else {
            self.unshown_warnings += 1;
        }
    }

    fn finished_warnings(mut self) -> Vec<Problem> {
        if let Some(last) = self.warnings.last_mut().filter(|_| self.unshown_warnings > 0) {
            last.note = Some(format!("{} more warnings are not shown", self.unshown_warnings));
        }
        self.warnings
    }

    fn fail(&mut self, span: Span<usize>, message: String, label: impl Into<String>) -> Result<(), Stop> {
        self.note(Problem::error(span, message, label))
    }

    /// An error that a wrong count, or an item with a number too many or too few, may be behind.
    fn fail_count(
        &mut self,
        span: Span<usize>,
        message: String,
        label: impl Into<String>,
    ) -> Result<(), Stop> {
        let note = self.said_count();
        self.note(Problem { note, ..Problem::error(span, message, label) })
    }

    fn note(&mut self, problem: Problem) -> Result<(), Stop> {
        if self.problems.len() < MAX_PROBLEMS {
            self.problems.push(problem);
            return Ok(());
        }
        if let Some(last) = self.problems.last_mut() {
            last.note = Some("too many problems: what follows was not read".into());
        }
        Err(Stop::Lost)
    }
}

/// A word that is no value, or not an allowed one.
fn not_allowed(word: Word<'_>, what: &str, allowed: &str) -> Problem {
    let found = quoted(word.text);
    let message = if is_number(word.text) {
        format!("{what} is {found}")
    } else {
        format!("found {found} where {what} should be")
    };
    Problem::error(word.span(), message, format!("must be {allowed}"))
}

/// Whether a word is written as a number, be it one too large to hold; `inf` and `nan` are not.
fn is_number(word: &str) -> bool {
    word.parse::<f64>().is_ok() && word.contains(|c: char| c.is_ascii_digit())
}

/// A computed number without the digits that computing it in binary added.
fn rounded(number: f64) -> f64 {
    if number.abs() < 1e-4 { number } else { (number * 1e6).round() / 1e6 }
}
