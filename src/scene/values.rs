//! Words to numbers within their ranges, and what is said of those that are not.

use core::fmt::Display;
use core::ops::Range as Span;

use glam::DVec3;

use crate::components::range::{COORDINATE, Range};

use super::lexer::{Lexer, Word};
use super::problem::{Problem, quoted};

/// Most problems and most warnings that are worth telling.
const MAX_PROBLEMS: usize = 20;

/// Why the parser leaves a rule early; what is wrong has been noted.
pub(super) enum Stop {
    /// Here an object starts, before the last one was complete: reading can go on with it.
    AtObject,
    /// Nothing that follows can be made sense of.
    Lost,
}

/// What is being read, and what is wrong with it.
pub(super) struct Parser<'a> {
    pub(super) text: &'a str,
    pub(super) words: Lexer<'a>,
    /// Where the text ends, blanks left out.
    pub(super) end: usize,
    /// The word read last.
    pub(super) last: Span<usize>,
    /// The count that says how many items are being read: where it is wrong, the error shows later.
    pub(super) announced: Option<Announced>,
    /// Whether these items are bare numbers, without a word at their start.
    pub(super) in_list: bool,
    pub(super) problems: Vec<Problem>,
    pub(super) warnings: Vec<Problem>,
    pub(super) unshown_warnings: usize,
}

/// A count, with the name of what it counts.
pub(super) struct Announced {
    what: String,
    count: u32,
    /// Where it stands, in bytes.
    at: usize,
}

const OBJECT_WORDS: [&str; 3] = ["sphere", "cube", "pyramid"];

pub(super) fn is_object_word(word: &str) -> bool {
    OBJECT_WORDS.contains(&word)
}

impl<'a> Parser<'a> {
    /// Before the first word.
    pub(super) fn new(text: &'a str) -> Self {
        Self {
            text,
            words: Lexer::new(text),
            end: text.trim_end().len(),
            last: 0..0,
            announced: None,
            in_list: false,
            problems: Vec::new(),
            warnings: Vec::new(),
            unshown_warnings: 0,
        }
    }

    /// Three coordinates; their names stand between `before` and `after`.
    pub(super) fn point(&mut self, before: impl Display, after: &str) -> Result<DVec3, Stop> {
        let mut coordinate = |axis| self.number(format_args!("{before}{axis}{after}"), &COORDINATE);
        Ok(DVec3::new(coordinate('x')?, coordinate('y')?, coordinate('z')?))
    }

    /// A number in its range. One that is not is noted and read as NaN: the description is dropped then, and NaN
    /// fails no further check.
    ///
    /// Nearly all are, and a large scene has millions: what they are called is put into words for the others only.
    #[inline]
    pub(super) fn number(&mut self, what: impl Display, range: &Range) -> Result<f64, Stop> {
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
    pub(super) fn wrong_number(&mut self, what: &str, range: &Range) -> Result<f64, Stop> {
        let word = self.value_word(what, range.words)?;
        // Within a list of bare numbers, a word may be what follows the list.
        let too_many = self.in_list && !is_number(word.text);
        let note = self.said_count().filter(|_| too_many);
        self.note(Problem { note, ..not_allowed(word, what, range.words) })?;
        Ok(f64::NAN)
    }

    /// A whole number in its range. Whatever comes after a wrong one cannot be counted, so nothing goes on.
    pub(super) fn whole(&mut self, what: &str, low: u32, high: u32) -> Result<u32, Stop> {
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
    pub(super) fn count(&mut self, item: &str, most: u32) -> Result<u32, Stop> {
        let what = format!("the number of {item}s");
        let count = self.whole(&what, 0, most)?;
        self.announced = Some(Announced { what, count, at: self.last.start });
        Ok(count)
    }

    /// The last count with its line, in words.
    pub(super) fn said_count(&self) -> Option<String> {
        let Announced { what, count, at } = self.announced.as_ref()?;
        let line = self.text[..*at].matches('\n').count() + 1;
        Some(format!("{what} is given as {count} in line {line}"))
    }

    /// The next word, which should be a value and not the start of an object.
    pub(super) fn value_word(&mut self, what: &str, allowed: &str) -> Result<Word<'a>, Stop> {
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

    pub(super) fn peek(&self) -> Option<Word<'a>> {
        let mut ahead = self.words;
        ahead.next()
    }

    pub(super) fn next(&mut self) -> Option<Word<'a>> {
        let word = self.words.next()?;
        self.last = word.span();
        Some(word)
    }

    pub(super) fn ended<R>(&mut self, what: &str, allowed: &str) -> Result<R, Stop> {
        let message = format!("the file ends where {what} should be");
        self.fail_count(self.end..self.end, message, format!("{allowed} is missing"))?;
        Err(Stop::Lost)
    }
}

/// What is wrong.
impl Parser<'_> {
    pub(super) fn warn(&mut self, warning: Problem) {
        if self.warnings.len() < MAX_PROBLEMS {
            self.warnings.push(warning);
        } else {
            self.unshown_warnings += 1;
        }
    }

    pub(super) fn has_nothing_to_say(&self) -> bool {
        self.problems.is_empty() && self.warnings.is_empty()
    }

    pub(super) fn finished_warnings(mut self) -> Vec<Problem> {
        if let Some(last) = self.warnings.last_mut().filter(|_| self.unshown_warnings > 0) {
            last.note = Some(format!("{} more warnings are not shown", self.unshown_warnings));
        }
        self.warnings
    }

    pub(super) fn fail(
        &mut self,
        span: Span<usize>,
        message: String,
        label: impl Into<String>,
    ) -> Result<(), Stop> {
        self.note(Problem::error(span, message, label))
    }

    /// An error that a wrong count, or an item with a number too many or too few, may be behind.
    pub(super) fn fail_count(
        &mut self,
        span: Span<usize>,
        message: String,
        label: impl Into<String>,
    ) -> Result<(), Stop> {
        let note = self.said_count();
        self.note(Problem { note, ..Problem::error(span, message, label) })
    }

    pub(super) fn note(&mut self, problem: Problem) -> Result<(), Stop> {
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
pub(super) fn not_allowed(word: Word<'_>, what: &str, allowed: &str) -> Problem {
    let found = quoted(word.text);
    let message = if is_number(word.text) {
        format!("{what} is {found}")
    } else {
        format!("found {found} where {what} should be")
    };
    Problem::error(word.span(), message, format!("must be {allowed}"))
}

/// Whether a word is written as a number, be it one too large to hold; `inf` and `nan` are not.
pub(super) fn is_number(word: &str) -> bool {
    word.parse::<f64>().is_ok() && word.contains(|c: char| c.is_ascii_digit())
}

/// A computed number without the digits that computing it in binary added.
pub(super) fn rounded(number: f64) -> f64 {
    if number.abs() < 1e-4 { number } else { (number * 1e6).round() / 1e6 }
}
