//! Reads Rust as text: no compiler is asked, so code that does not compile is read as well.

/// The text with comments, strings and characters blanked out, every line where it was.
pub(super) fn code_only(text: &str) -> String {
    let mut code = String::with_capacity(text.len());
    let mut rest = text;
    while !rest.is_empty() {
        let in_word = code.chars().next_back().is_some_and(|c| c.is_alphanumeric() || c == '_');
        let skipped = comment(rest).or_else(|| literal(rest, in_word)).unwrap_or(0);
        if skipped > 0 {
            let blank = |c| if c == '\n' { '\n' } else { ' ' };
            code.extend(rest[..skipped].chars().map(blank));
            rest = &rest[skipped..];
        } else {
            let next = rest.chars().next().unwrap();
            code.push(next);
            rest = &rest[next.len_utf8()..];
        }
    }
    code
}

/// Length of the comment that the text starts with.
fn comment(text: &str) -> Option<usize> {
    if text.starts_with("//") {
        return Some(text.find('\n').unwrap_or(text.len()));
    }
    if !text.starts_with("/*") {
        return None;
    }
    let (mut depth, mut at) = (0, 0);
    while at < text.len() {
        let here = &text.as_bytes()[at..];
        if here.starts_with(b"/*") {
            depth += 1;
            at += 2;
        } else if here.starts_with(b"*/") {
            depth -= 1;
            at += 2;
        } else {
            at += 1;
        }
        if depth == 0 {
            return Some(at);
        }
    }
    Some(text.len())
}

/// Length of the string or character that the text starts with. A prefix counts only where no word goes on.
fn literal(text: &str, in_word: bool) -> Option<usize> {
    if text.starts_with('\'') {
        return character(text);
    }
    let prefix = ["br", "cr", "b", "c", "r", ""]
        .into_iter()
        .find(|prefix| {
            let quoted = text.strip_prefix(prefix).map(|rest| rest.trim_start_matches('#'));
            quoted.is_some_and(|rest| rest.starts_with('"'))
                && (prefix.ends_with('r') || text[prefix.len()..].starts_with('"'))
        })
        .filter(|prefix| prefix.is_empty() || !in_word)?;
    let body = &text[prefix.len()..];
    let length = if prefix.ends_with('r') { raw_string(body) } else { escaped(body, '"') };
    Some(prefix.len() + length)
}

fn raw_string(body: &str) -> usize {
    let hashes = body.len() - body.trim_start_matches('#').len();
    let end = format!("\"{}", "#".repeat(hashes));
    body[hashes + 1..].find(&end).map_or(body.len(), |at| hashes + 1 + at + end.len())
}

/// Length up to and with the closing quote, where a backslash takes the next character along.
fn escaped(body: &str, quote: char) -> usize {
    let mut characters = body.char_indices().skip(1);
    while let Some((at, c)) = characters.next() {
        if c == '\\' {
            characters.next();
        } else if c == quote {
            return at + 1;
        }
    }
    body.len()
}

/// A character is one character or an escape between quotes; anything else after a quote is a lifetime.
fn character(text: &str) -> Option<usize> {
    let mut after = text[1..].chars();
    let first = after.next()?;
    (first == '\\' || after.next() == Some('\'')).then(|| escaped(text, '\''))
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    Word,
    Number,
    /// `::` or one character.
    Sign,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Token<'a> {
    pub(super) kind: Kind,
    pub(super) text: &'a str,
    pub(super) line: usize,
}

pub(super) fn tokens(code: &str) -> Vec<Token<'_>> {
    let mut found = Vec::new();
    let (mut at, mut line) = (0, 1);
    while let Some(c) = code[at..].chars().next() {
        let rest = &code[at..];
        let (kind, length) = if c.is_ascii_digit() {
            (Kind::Number, number_length(rest))
        } else if c.is_alphabetic() || c == '_' {
            let end = rest.find(|c: char| !(c.is_alphanumeric() || c == '_'));
            (Kind::Word, end.unwrap_or(rest.len()))
        } else if rest.starts_with("::") {
            (Kind::Sign, 2)
        } else {
            (Kind::Sign, c.len_utf8())
        };
        if !c.is_whitespace() {
            let text = &rest[..length];
            found.push(Token { kind, text, line });
        }
        line += usize::from(c == '\n');
        at += length;
    }
    found
}

fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let get = |at: usize| bytes.get(at).copied().unwrap_or(b' ');
    let decimal = !matches!(get(1), b'x' | b'b' | b'o');
    let mut at = 0;
    loop {
        let (here, next) = (get(at), get(at + 1));
        let exponent_sign = matches!(here, b'+' | b'-') && matches!(get(at.wrapping_sub(1)), b'e' | b'E');
        let goes_on = here.is_ascii_alphanumeric()
            || here == b'_'
            || (decimal && exponent_sign && next.is_ascii_digit())
            || (decimal && here == b'.' && next.is_ascii_digit());
        if !goes_on {
            return at;
        }
        at += 1;
    }
}

/// Every path, with groups in `use` taken apart, and the line where it starts.
pub(super) fn paths(tokens: &[Token<'_>]) -> Vec<(usize, Vec<String>)> {
    let mut found = Vec::new();
    let mut at = 0;
    while at < tokens.len() {
        let text_at = |at: usize| tokens.get(at).map_or("", |token| token.text);
        let before = if at == 0 { "" } else { text_at(at - 1) };
        if text_at(at) == "use" && text_at(at + 1) != "<" {
            at = use_tree(tokens, at + 1, &[], &mut found);
        } else if text_at(at) == "extern" && text_at(at + 1) == "crate" {
            found.push((tokens[at].line, vec![text_at(at + 2).to_owned()]));
            at += 3;
        } else if is_name(&tokens[at]) && text_at(at + 1) == "::" && before != "." {
            let (path, end) = path_at(tokens, at);
            // After `::` a path goes on, unless the `::` starts one.
            if before != "::" || at < 2 || !ends_type(&tokens[at - 2]) {
                found.push((tokens[at].line, path));
            }
            at = end;
        } else {
            at += 1;
        }
    }
    found
}

/// A word that can be part of a path.
fn is_name(token: &Token<'_>) -> bool {
    let keyword = matches!(
        token.text,
        "as" | "break" | "dyn" | "else" | "for" | "if" | "impl" | "in" | "match" | "mut" | "return" | "while"
    );
    token.kind == Kind::Word && !keyword
}

/// Whether a `::` after this token goes on with a path, as in `a::b` and `<A as B>::c`.
fn ends_type(token: &Token<'_>) -> bool {
    is_name(token) || token.text == ">"
}

fn path_at(tokens: &[Token<'_>], start: usize) -> (Vec<String>, usize) {
    let mut path = vec![tokens[start].text.to_owned()];
    let mut at = start + 1;
    while tokens.get(at).is_some_and(|token| token.text == "::")
        && tokens.get(at + 1).is_some_and(|token| token.kind == Kind::Word)
    {
        path.push(tokens[at + 1].text.to_owned());
        at += 2;
    }
    (path, at)
}

/// One tree of a `use`; returns the place after it.
fn use_tree(
    tokens: &[Token<'_>],
    start: usize,
    prefix: &[String],
    found: &mut Vec<(usize, Vec<String>)>,
) -> usize {
    let text_at = |at: usize| tokens.get(at).map_or("", |token| token.text);
    let mut path = prefix.to_vec();
    let mut at = start;
    loop {
        match text_at(at) {
            "::" => at += 1,
            "{" => {
                at += 1;
                while !matches!(text_at(at), "}" | "") {
                    at = use_tree(tokens, at, &path, found);
                    at += usize::from(text_at(at) == ",");
                }
                return at + 1;
            }
            "" | "," | ";" | "}" => break,
            "as" => at += 2,
            word => {
                path.push(word.to_owned());
                at += 1;
            }
        }
    }
    if !path.is_empty() {
        found.push((tokens[at.min(tokens.len()) - 1].line, path));
    }
    at
}
