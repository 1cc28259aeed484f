//! Objects of a long scene, read by many threads ahead of their turn.
//!
//! What an object means depends on nothing before it, so a text can be cut wherever one may start. A cut may be wrong:
//! prose behind the last number may name a sphere, too. So nothing is concluded from what is read ahead. The parser goes
//! through the text as ever, and where it comes to objects that have been read without anything to be said of them, it
//! takes them.

use core::iter::Peekable;
use core::ops::Range;
use std::vec::IntoIter;

use rayon::prelude::*;

use super::description::ObjectDescription;
use super::lexer::Lexer;
use super::values::{Parser, is_object_word};

/// Least bytes of text in a piece: thousands of objects, which take far longer than to hand them to a thread.
const LEAST: usize = 1 << 19;

/// Objects that follow each other, none of which is worth a word.
struct Stretch<'a> {
    start: usize,
    objects: Vec<ObjectDescription>,
    /// What comes after them.
    rest: Lexer<'a>,
    /// The last word of theirs.
    last: Range<usize>,
}

/// What has been read ahead, in the order of the text.
pub(super) struct Ahead<'a> {
    stretches: Peekable<IntoIter<Stretch<'a>>>,
}

impl<'a> Ahead<'a> {
    /// Reads objects from here on, on rayon's current threads, a piece each and at most `most` in a piece. A short text and
    /// a single thread read nothing ahead.
    pub(super) fn read(parser: &Parser<'a>, most: u32) -> Self {
        let start = parser.words.at();
        let length = parser.end.saturating_sub(start);
        // Of a short text it is not even asked how many threads there are: that would start them.
        let pieces = if length < 2 * LEAST { 1 } else { rayon::current_num_threads().min(length / LEAST) };
        if pieces == 1 {
            return Self { stretches: Vec::new().into_iter().peekable() };
        }
        let cut = |piece: usize| start + length / pieces * piece;
        let read = |piece| Stretch::read(parser.text, cut(piece)..cut(piece + 1), most as usize);
        let stretches: Vec<_> = (0..pieces).into_par_iter().filter_map(read).collect();
        Self { stretches: stretches.into_iter().peekable() }
    }

    /// Adds the objects that have been read from just here to those that the parser has, and moves the parser behind them.
    /// Nothing happens where there are none, or more than `room`.
    pub(super) fn take(
        &mut self,
        parser: &mut Parser<'a>,
        objects: &mut Vec<ObjectDescription>,
        room: u32,
    ) -> Option<u32> {
        let start = self.stretches.peek().and_then(|_| parser.peek())?.start;
        while self.stretches.next_if(|stretch| stretch.start < start).is_some() {}
        let stretch = self.stretches.next_if(|stretch| stretch.start == start)?;
        let taken = u32::try_from(stretch.objects.len()).ok().filter(|&taken| taken <= room)?;
        // The first of them grows, so that half of the objects of a large scene are never copied.
        if objects.is_empty() {
            *objects = stretch.objects;
        } else {
            objects.extend(stretch.objects);
        }
        (parser.words, parser.last) = (stretch.rest, stretch.last);
        Some(taken)
    }
}

impl<'a> Stretch<'a> {
    /// The objects that start in a piece of text, from its second line on, up to the first of which something is to be
    /// said; `None` if there are none.
    fn read(text: &'a str, piece: Range<usize>, most: usize) -> Option<Self> {
        let mut parser = Parser::new(text);
        parser.words = Lexer::after_line(text, piece.clone())?;
        let next = |parser: &Parser<'a>| parser.peek().filter(|word| word.start < piece.end);
        let mut first = next(&parser)?;
        while !is_object_word(first.text) {
            parser.next();
            first = next(&parser)?;
        }
        let mut stretch = Self { start: first.start, objects: Vec::new(), rest: parser.words, last: 0..0 };
        while stretch.objects.len() < most && next(&parser).is_some_and(|word| is_object_word(word.text)) {
            let object = parser.object(0, 0).ok().filter(|_| parser.has_nothing_to_say());
            let Some(object) = object else { break };
            stretch.objects.push(object);
            (stretch.rest, stretch.last) = (parser.words, parser.last.clone());
        }
        (!stretch.objects.is_empty()).then_some(stretch)
    }
}
