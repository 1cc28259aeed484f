//! A small valid scene, with the meaning of each of its tokens, and places in a text.

use archetrace::scene::{Description, Problem, parse};

/// One of everything. No warning.
pub(crate) const SAMPLE: &str = "\
1 1000  # near, far
60 1.5  # field of view, aspect ratio
3
64

10
0.2 0.5 0.3

3

sphere
1 2 3
4
0.1 0.2 0.3
0.1 0.2 0.3 0.4
5

cube
-1 -2 -3
2.5
0.4 0.5 0.6
0.4 0.3 0.2 0.1
6

pyramid
7 8 9
1.25 2.75
0.7 0.8 0.9
0.25 0.25 0.25 0.25
7.5

1
70 71 100 0.001

1
-70 72 80 0.002  -10 10 11  30
";

/// What a token means.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Kind {
    Near,
    Far,
    FieldOfView,
    Aspect,
    Level,
    Pixels,
    Length,
    Coefficient,
    Objects,
    Word,
    Coordinate,
    Color,
    Shininess,
    Lights,
    Falloff,
    Cutoff,
}

/// What each token of [`SAMPLE`] means.
pub(crate) fn kinds() -> Vec<Kind> {
    use Kind::{
        Aspect, Coefficient, Color, Coordinate, Cutoff, Falloff, Far, FieldOfView, Length, Level, Lights,
        Near, Objects, Pixels, Shininess, Word,
    };
    let object = |lengths: usize| {
        let mut kinds = vec![Word, Coordinate, Coordinate, Coordinate];
        kinds.extend(vec![Length; lengths]);
        kinds.extend([Color; 3]);
        kinds.extend([Coefficient; 4]);
        kinds.push(Shininess);
        kinds
    };
    let mut kinds = vec![Near, Far, FieldOfView, Aspect, Level, Pixels];
    kinds.extend([Length, Coefficient, Coefficient, Coefficient, Objects]);
    kinds.extend([object(1), object(1), object(2)].concat());
    kinds.extend([Lights, Coordinate, Coordinate, Coordinate, Falloff]);
    kinds.extend([Lights, Coordinate, Coordinate, Coordinate, Falloff]);
    kinds.extend([Coordinate, Coordinate, Coordinate, Cutoff]);
    kinds
}

/// A token and where it starts, in bytes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Token<'a> {
    pub(crate) text: &'a str,
    pub(crate) start: usize,
}

/// The tokens of an ASCII text.
pub(crate) fn tokens(text: &str) -> Vec<Token<'_>> {
    let mut tokens = Vec::new();
    let mut line_start = 0;
    for line in text.split_inclusive('\n') {
        let code = line.split('#').next().unwrap();
        for word in code.split_ascii_whitespace() {
            let start = line_start + word.as_ptr().addr() - line.as_ptr().addr();
            tokens.push(Token { text: word, start });
        }
        line_start += line.len();
    }
    tokens
}

/// The token texts of [`SAMPLE`].
pub(crate) fn words() -> Vec<&'static str> {
    tokens(SAMPLE).iter().map(|token| token.text).collect()
}

/// The sample on one line with other words in some places.
pub(crate) fn sample_with(changes: &[(usize, &str)]) -> String {
    let mut words = words();
    for &(index, word) in changes {
        words[index] = word;
    }
    words.join(" ")
}

/// A text with one token replaced.
pub(crate) fn replaced(text: &str, token: Token<'_>, by: &str) -> String {
    let end = token.start + token.text.len();
    [&text[..token.start], by, &text[end..]].concat()
}

/// Line and column of a byte, both from 1; columns are characters.
pub(crate) fn place(text: &str, at: usize) -> (usize, usize) {
    let before = &text[..at];
    let line = before.split('\n').count();
    let column = before.rsplit('\n').next().unwrap().chars().count() + 1;
    (line, column)
}

/// The index of the token that a byte is the start of.
pub(crate) fn token_at(text: &str, at: usize) -> Option<usize> {
    tokens(text).iter().position(|token| token.start == at)
}

/// A scene that must be valid and give no warning.
pub(crate) fn read(text: &str) -> Description {
    match parse(text) {
        Ok((description, warnings)) => {
            assert_eq!(warnings, [], "warnings for:\n{text}");
            description
        }
        Err(problems) => panic!("{problems:?} for:\n{text}"),
    }
}

/// The problems of a scene that must be refused.
pub(crate) fn refused(text: &str) -> Vec<Problem> {
    match parse(text) {
        Ok((description, _)) => panic!("read as {description:?}:\n{text}"),
        Err(problems) => {
            assert!(!problems.is_empty(), "refused without a reason:\n{text}");
            problems
        }
    }
}

#[test]
fn the_sample_is_valid_and_every_token_has_a_meaning() {
    read(SAMPLE);
    assert_eq!(words().len(), kinds().len());
    for (word, kind) in words().iter().zip(kinds()) {
        assert_eq!(word.parse::<f64>().is_err(), kind == Kind::Word, "{word} {kind:?}");
    }
}
