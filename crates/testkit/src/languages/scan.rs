//! The sentences of a source, found as literals.

use std::collections::BTreeSet;

use proc_macro2::{TokenStream, TokenTree};
use syn::Lit;

/// The sentences in the code of an analysis: reasons, labels, warnings, in branches that no case takes as well.
pub(super) fn sentences_of_an_analysis(source: &str) -> BTreeSet<String> {
    let code = source.split("#[cfg(test)]").next().unwrap_or_default();
    let mut found = BTreeSet::new();
    for line in joined(code) {
        let exempt = [
            "keywords:",
            "full:",
            "short:",
            "expect(",
            "unreachable!(",
            "panic!(",
            "reason =",
            "//",
            "cases:",
        ];
        let named = |mark: &&str| {
            line.trim_start().starts_with(*mark) || (!mark.starts_with("//") && line.contains(*mark))
        };
        if exempt.iter().any(named) {
            continue;
        }
        // Literals stand at the odd places between quotes.
        for literal in line.replace("\\\"", "'").split('"').skip(1).step_by(2) {
            let words =
                literal.split(' ').filter(|word| word.chars().filter(char::is_ascii_lowercase).count() > 2);
            if words.count() > 1 {
                found.insert(literal.to_owned());
            }
        }
    }
    found
}

/// The lines of a source, those that a trailing backslash continues joined.
fn joined(code: &str) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    let mut open = false;
    for line in code.lines() {
        let (text, continues) = line.strip_suffix('\\').map_or((line, false), |text| (text, true));
        match lines.last_mut() {
            Some(last) if open => *last += text.trim_start(),
            _ => lines.push(text.to_owned()),
        }
        open = continues;
    }
    lines
}

/// The literals of a source that become a text.
pub(super) fn literals(source: &str) -> BTreeSet<String> {
    let code = source.split("#[cfg(test)]").next().unwrap_or_default();
    let code: Vec<&str> = code.lines().filter(|line| !line.trim_start().starts_with("//")).collect();
    let code = code.join("\n");
    let mut found = BTreeSet::new();
    let marks = [
        "Text::new(",
        "Text::from(",
        "Refusal::because(",
        "FieldError::new(path, ",
        "mismatch(trail, ",
        "fail(",
        "faults.push(",
        "limit(",
        ".unexpected(",
        "expected: ",
        "after: ",
    ];
    for mark in marks {
        for rest in code.split(mark).skip(1) {
            if let Some(literal) = rest.trim_start().strip_prefix('"') {
                found.insert(unescaped(literal));
            }
        }
    }
    found.remove("");
    found
}

/// All string literals of a source, and the paragraphs of its documentation, whole and line by line.
pub(super) fn strings(source: &str) -> Vec<String> {
    let tokens = source.parse().unwrap_or_else(|err| panic!("a source cannot be read: {err}"));
    let mut found = Vec::new();
    collect_strings(tokens, &mut found);
    let mut paragraph = String::new();
    for line in source.lines() {
        match line.trim_start().strip_prefix("/// ") {
            Some(words) => paragraph = format!("{paragraph} {words}"),
            None => found.push(std::mem::take(&mut paragraph)),
        }
    }
    found
}

fn collect_strings(tokens: TokenStream, found: &mut Vec<String>) {
    for token in tokens {
        match token {
            TokenTree::Group(group) => collect_strings(group.stream(), found),
            TokenTree::Literal(literal) => {
                if let Lit::Str(text) = Lit::new(literal) {
                    found.push(text.value());
                }
            }
            TokenTree::Ident(_) | TokenTree::Punct(_) => {}
        }
    }
}

/// A string literal up to its closing quote, its escapes and line joins undone.
fn unescaped(literal: &str) -> String {
    let mut text = String::new();
    let mut chars = literal.chars();
    while let Some(c) = chars.next() {
        match c {
            '"' => break,
            '\\' => match chars.next() {
                Some('n') => text.push('\n'),
                Some('\n') => {
                    let rest = chars.as_str().trim_start();
                    chars = rest.chars();
                }
                Some(other) => text.push(other),
                None => break,
            },
            c => text.push(c),
        }
    }
    text
}

/// The names between two brackets.
pub(super) fn arguments(sentence: &str, open: &str, close: &str) -> BTreeSet<String> {
    let parts = sentence.split(open).skip(1).filter_map(|rest| rest.split_once(close));
    parts.map(|(name, _)| name.trim().to_owned()).collect()
}
