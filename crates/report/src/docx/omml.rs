//! Formulas as equations of Word (Office Math, ECMA-376 part 1, §22.1).

use crate::{
    math::{Math, closing},
    xml::escaped,
};

/// A formula, to stand within `m:oMath`.
pub(super) fn set(formula: &Math) -> String {
    match formula {
        Math::Row(parts) => parts.iter().map(set).collect(),
        Math::Number(digits) => run(digits, false),
        Math::Upright(words) => words_within(words),
        Math::Symbol(base, index) if index.is_empty() => run(base, false),
        Math::Symbol(base, index) => lowered(&run(base, false), index),
        // Of a formula that was broken: the other bracket stands on another line.
        Math::Operator(bracket @ ('(' | ')' | '[' | ']')) => words_within(&bracket.to_string()),
        Math::Operator(sign) => run(&sign.to_string(), false),
        Math::Gap => run("\u{2009}", false),
        Math::Fraction(top, bottom) => {
            format!("<m:f><m:num>{}</m:num><m:den>{}</m:den></m:f>", set(top), set(bottom))
        }
        Math::Root(degree, of) => {
            let hidden = if degree.is_empty() { "<m:radPr><m:degHide m:val=\"1\"/></m:radPr>" } else { "" };
            let degree = if degree.is_empty() { String::new() } else { run(degree, false) };
            format!("<m:rad>{hidden}<m:deg>{degree}</m:deg><m:e>{}</m:e></m:rad>", set(of))
        }
        Math::Power(base, power) => {
            format!("<m:sSup><m:e>{}</m:e><m:sup>{}</m:sup></m:sSup>", set(base), run(power, false))
        }
        Math::Index(base, index) => lowered(&set(base), index),
        Math::Brackets(open, inner) => {
            let close = closing(*open);
            format!(
                "<m:d><m:dPr><m:begChr m:val=\"{open}\"/><m:endChr m:val=\"{close}\"/></m:dPr><m:e>{}</m:e></m:d>",
                set(inner)
            )
        }
    }
}

/// A formula that is not seen but has its room.
pub(super) fn phantom(formula: &str) -> String {
    format!("<m:phant><m:phantPr><m:show m:val=\"0\"/></m:phantPr><m:e>{formula}</m:e></m:phant>")
}

fn lowered(base: &str, index: &str) -> String {
    format!("<m:sSub><m:e>{base}</m:e><m:sub>{}</m:sub></m:sSub>", run(index, index.chars().count() > 1))
}

/// Words within a formula. The sign between two sides is one: as a relation it would want another side before it, which
/// a line that goes on does not have.
pub(super) fn words_within(text: &str) -> String {
    format!(
        "<m:r><m:rPr><m:nor/></m:rPr><w:rPr><w:rFonts w:ascii=\"Cambria Math\" w:hAnsi=\"Cambria Math\"/></w:rPr><m:t xml:space=\"preserve\">{}</m:t></m:r>",
        escaped(text)
    )
}

/// Letters, italic as Word sets symbols, or upright.
fn run(text: &str, is_upright: bool) -> String {
    let upright = if is_upright { "<m:rPr><m:sty m:val=\"p\"/></m:rPr>" } else { "" };
    format!(
        "<m:r>{upright}<w:rPr><w:rFonts w:ascii=\"Cambria Math\" w:hAnsi=\"Cambria Math\"/></w:rPr><m:t \
         xml:space=\"preserve\">{}</m:t></m:r>",
        escaped(text)
    )
}
