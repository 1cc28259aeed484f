//! Problems of a scene file, shown where they are.

use core::ops::Range;

use codespan_reporting::diagnostic::{Diagnostic, Label};
use codespan_reporting::files::{Error, Files};
use codespan_reporting::term::{self, Chars, Config};
use unicode_width::UnicodeWidthChar;

/// How bad a problem is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// The scene cannot be used.
    Error,
    /// The scene can be used, but may not be meant so.
    Warning,
}

/// Something about a scene file that its author should know.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// How bad it is.
    pub severity: Severity,
    /// Bytes of the text that it is about.
    pub span: Range<usize>,
    /// What was found.
    pub message: String,
    /// What is allowed, shown at the marker.
    pub label: String,
    /// A line below, or nothing.
    pub note: Option<String>,
}

impl Problem {
    /// An error.
    pub(super) fn error(span: Range<usize>, message: String, label: impl Into<String>) -> Self {
        Self { severity: Severity::Error, span, message, label: label.into(), note: None }
    }

    /// A warning.
    pub(super) fn warning(span: Range<usize>, message: String, label: impl Into<String>) -> Self {
        Self { severity: Severity::Warning, span, message, label: label.into(), note: None }
    }

    /// The problem with file, line and column, the line quoted and marked.
    pub(super) fn render(&self, name: &str, text: &str) -> String {
        let excerpt = Excerpt::around(name, text, &self.span);
        let diagnostic = match self.severity {
            Severity::Error => Diagnostic::error(),
            Severity::Warning => Diagnostic::warning(),
        };
        let diagnostic = diagnostic
            .with_message(&self.message)
            .with_label(Label::primary((), excerpt.marked.clone()).with_message(&self.label))
            .with_notes(self.note.iter().cloned().collect());
        let config = Config { chars: Chars::ascii(), ..Config::default() };
        // Writing to a string and looking up an excerpt that exists cannot fail; were it to, the place and the
        // message would still be said.
        term::emit_into_string(&config, &excerpt, &diagnostic)
            .unwrap_or_else(|_| format!("{name}:{}:{}: {}", excerpt.line, excerpt.column, self.message))
    }
}

/// The part of one line that is worth quoting. A scene file may be one line of megabytes.
struct Excerpt<'a> {
    name: &'a str,
    text: String,
    marked: Range<usize>,
    line: usize,
    /// Column of the marker.
    column: usize,
}

/// Bytes quoted before and after the start of the marker.
const QUOTED: usize = 80;

impl<'a> Excerpt<'a> {
    fn around(name: &'a str, text: &str, span: &Range<usize>) -> Self {
        let before = &text[..span.start];
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let line_end = text[span.start..].find('\n').map_or(text.len(), |length| span.start + length);
        let from = text.ceil_char_boundary(line_start.max(span.start.saturating_sub(QUOTED)));
        let to = text.floor_char_boundary(line_end.min(span.start + QUOTED)).max(span.start);
        let marked_end = span.end.clamp(span.start, to);
        let left_cut = if from > line_start { "... " } else { "" };
        let right_cut = if to < line_end { " ..." } else { "" };
        let left = left_cut.to_owned() + &printable(&text[from..span.start]);
        let middle = printable(&text[span.start..marked_end]);
        let right = printable(&text[marked_end..to]) + right_cut;
        Self {
            name,
            marked: left.len()..left.len() + middle.len(),
            text: left + &middle + &right,
            line: before.matches('\n').count() + 1,
            column: text[line_start..span.start].chars().count() + 1,
        }
    }
}

/// A text in which every character takes its place in the line: what would move the cursor, turn the direction of
/// writing, colour the terminal or not show at all is replaced.
pub(super) fn printable(text: &str) -> String {
    let visible = |c: char| match c {
        '\t' | '\r' => ' ',
        c if c.width().unwrap_or(0) == 0 => char::REPLACEMENT_CHARACTER,
        c => c,
    };
    text.chars().map(visible).collect()
}

impl<'a> Files<'a> for Excerpt<'_> {
    type FileId = ();
    type Name = &'a str;
    type Source = &'a str;

    fn name(&'a self, (): ()) -> Result<&'a str, Error> {
        Ok(self.name)
    }

    fn source(&'a self, (): ()) -> Result<&'a str, Error> {
        Ok(&self.text)
    }

    fn line_index(&'a self, (): (), _byte: usize) -> Result<usize, Error> {
        Ok(0)
    }

    fn line_number(&'a self, (): (), _line: usize) -> Result<usize, Error> {
        Ok(self.line)
    }

    fn column_number(&'a self, (): (), _line: usize, _byte: usize) -> Result<usize, Error> {
        // Only the marker's column is ever asked for.
        Ok(self.column)
    }

    fn line_range(&'a self, (): (), _line: usize) -> Result<Range<usize>, Error> {
        Ok(0..self.text.len())
    }
}

/// A word for a message: printable and not too long.
pub(super) fn quoted(word: &str) -> String {
    const SHOWN: usize = 40;
    let cut = word.char_indices().nth(SHOWN).map(|(cut, _)| cut);
    let shown = printable(&word[..cut.unwrap_or(word.len())]);
    let ellipsis = if cut.is_some() { "..." } else { "" };
    format!("`{shown}{ellipsis}`")
}
