//! Text to words.

use core::ops::Range;

/// A run of characters between white space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Word<'a> {
    /// The characters.
    pub(super) text: &'a str,
    /// Where they start, in bytes.
    pub(super) start: usize,
}

impl Word<'_> {
    /// The bytes it covers.
    pub(super) fn span(&self) -> Range<usize> {
        self.start..self.start + self.text.len()
    }
}

/// The words of a text, one after the other; comments and white space are passed over.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lexer<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Lexer<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        // A byte order mark is an editor's, not the author's.
        Self { text, at: if text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 } }
    }

    /// The words behind the first line that ends in a range of bytes: nothing before it says whether they are a comment.
    pub(super) fn after_line(text: &'a str, range: Range<usize>) -> Option<Self> {
        let newline = text
            .as_bytes()
            .get(range.start..range.end.min(text.len()))?
            .iter()
            .position(|&byte| byte == b'\n')?;
        Some(Self { text, at: range.start + newline + 1 })
    }

    /// Where the next character is, in bytes.
    pub(super) fn at(&self) -> usize {
        self.at
    }

    /// The next character, and whether it is white space. Nearly all are ASCII and need no decoding.
    #[inline]
    fn character(&self) -> Option<(char, bool)> {
        let byte = *self.text.as_bytes().get(self.at)?;
        if byte.is_ascii() {
            return Some((char::from(byte), matches!(byte, b' ' | b'\t'..=b'\r')));
        }
        self.text[self.at..].chars().next().map(|c| (c, c.is_whitespace()))
    }

    fn skip_blank(&mut self) {
        while let Some((c, is_blank)) = self.character() {
            if is_blank {
                self.at += c.len_utf8();
            } else if c == '#' {
                let rest = &self.text[self.at..];
                self.at += rest.find('\n').unwrap_or(rest.len());
            } else {
                return;
            }
        }
    }

    fn skip_word(&mut self) {
        loop {
            let rest = &self.text.as_bytes()[self.at..];
            self.at += rest.iter().take_while(|byte| matches!(byte, b'!'..=b'~') && **byte != b'#').count();
            match self.character() {
                Some((c, false)) if c != '#' => self.at += c.len_utf8(),
                _ => return,
            }
        }
    }
}

impl<'a> Iterator for Lexer<'a> {
    type Item = Word<'a>;

    #[inline]
    fn next(&mut self) -> Option<Word<'a>> {
        self.skip_blank();
        let start = self.at;
        self.skip_word();
        let text = &self.text[start..self.at];
        (!text.is_empty()).then_some(Word { text, start })
    }
}
