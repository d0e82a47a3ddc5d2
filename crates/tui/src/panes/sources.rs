//! The books an analysis follows, and how its published cases come out.

use dalembert_core::{
    Answer, Entry, Locale, Refusal, SolveError, Text,
    cases::{Case, Comparison, Truth, Verdict},
    find,
};
use dalembert_units::Decimal;
use ratatui::{
    style::Style,
    text::{Line, Span},
};
use unicode_width::UnicodeWidthStr;

use super::{columns::padded, wrap};
use crate::{
    effect::Effect,
    intent::Intent,
    keys::{Action, KeyContext},
    look::{Appearance, Glyph},
    pane::{Page, Pane, Ui, register_pane},
    problem::Problem,
    remembered::{HistoryChange, Progress},
    solver::CheckedCase,
};

/// The pane of books and published cases.
#[derive(Debug, Default)]
pub struct Sources;

register_pane!(Sources, 90);

impl Pane for Sources {
    fn name(&self) -> &'static str {
        "Sources"
    }

    fn page(&self, problem: &Problem, ui: &Ui<'_>, width: u16) -> Page {
        let chosen = ui.focused.then_some(problem.case);
        let answers = problem.found.solution.as_ref().map_or(&[][..], |solution| &solution.answers);
        let answers = problem.found.revealed.is_none().then_some(answers);
        lines(problem.entry(), &problem.cases, chosen, answers, ui.look, ui.locale, width)
    }

    fn about(&self, _: &Problem, ui: &Ui<'_>) -> Vec<Text> {
        vec![
            Text::new("{keys} choose a case; {enter} loads it")
                .with("keys", ui.pair(KeyContext::Pane, Action::Up, Action::Down))
                .with("enter", ui.key(KeyContext::Pane, Action::Enter)),
        ]
    }

    fn act(&mut self, problem: &mut Problem, ui: &Ui<'_>, action: Action) -> Option<Vec<Intent>> {
        match action {
            Action::Enter => Some(load(problem, ui)),
            Action::Up | Action::Down => {
                let last = problem.cases.len().saturating_sub(1);
                let case = problem.case;
                problem.case =
                    if action == Action::Up { case.saturating_sub(1) } else { (case + 1).min(last) };
                Some(vec![Intent::BringIn(problem.case)])
            }
            _ => None,
        }
    }

    fn cursor<'a>(&'a mut self, problem: &'a mut Problem) -> Option<&'a mut usize> {
        Some(&mut problem.case)
    }

    fn turned_to(&mut self, problem: &mut Problem) -> Vec<Intent> {
        if std::mem::replace(&mut problem.checking, true) {
            return Vec::new();
        }
        vec![Intent::Do(Effect::Judge(problem.entry()))]
    }
}

/// Puts the chosen case in the place of the inputs.
fn load(problem: &mut Problem, ui: &Ui<'_>) -> Vec<Intent> {
    let Some(case) = problem.cases.get(problem.case).map(|checked| checked.case.clone()) else {
        return Vec::new();
    };
    let untouched = !problem.is_unsaved() && problem.document.file.is_none();
    let said = Text::new("{case} loaded; {key} restores the previous inputs")
        .with_text("case", case.title())
        .with("key", ui.key(KeyContext::Form, Action::Undo));
    let entry = problem.entry();
    problem.inputs.form.replace(find(entry.about.id).unwrap_or(entry), case.draft.clone());
    problem.document.title.clear();
    problem.document.origin = Some(case);
    if untouched {
        problem.mark_saved();
    }
    let opened = HistoryChange::Open(problem.entry().about.id.to_owned());
    vec![Intent::Say(said), Intent::Changed, Intent::Reach(Progress::Opened), Intent::Remember(opened)]
}

/// Books and cases; the page starts at each case, and `chosen` is the case that the keys act on. Printed answers that
/// are among `answers`, those of any solution, are named by their labels, the others by their keys. Without `answers`
/// what was printed is covered.
pub fn lines(
    entry: &Entry,
    cases: &[CheckedCase],
    chosen: Option<usize>,
    answers: Option<&[Answer]>,
    look: &Appearance,
    locale: &Locale,
    width: u16,
) -> Page {
    let width = usize::from(width).max(1);
    let locale = &locale.ascii(look.ascii);
    let words = Words { answers, look, locale, width };
    let mut page = Page::default();
    heading("Published cases", look, locale, width, &mut page.lines);
    for (n, checked) in cases.iter().enumerate() {
        page.starts.push(page.lines.len());
        case(checked, n, chosen == Some(n), &words, &mut page.lines);
        page.lines.push(Line::default());
    }
    if cases.is_empty() {
        page.lines.push(Line::default());
    }
    heading("Books and notes", look, locale, width, &mut page.lines);
    for source in entry.about.sources {
        let head = vec![Span::styled(look.glyph(Glyph::Bullet), look.dim()), Span::raw(" ")];
        page.lines.extend(wrap::hanging(head, &look.words(&source.full_in(locale)), Style::new(), width));
    }
    page
}

fn heading(
    words: &'static str,
    look: &Appearance,
    locale: &Locale,
    width: usize,
    lines: &mut Vec<Line<'static>>,
) {
    let words = wrap::words(&Text::new(words).render(locale), width);
    lines.extend(words.into_iter().map(|line| Line::styled(line, look.title())));
}

/// So many cells hold a number with its unit.
const A_NUMBER: usize = 20;

/// Wording of cases.
#[derive(Clone, Copy)]
struct Words<'a> {
    answers: Option<&'a [Answer]>,
    look: &'a Appearance,
    locale: &'a Locale,
    width: usize,
}

impl Words<'_> {
    /// The label of the answer with that key; the key in words where no answer has it.
    fn name(&self, key: &str) -> String {
        match self.answers.into_iter().flatten().find(|answer| answer.name.is(key)) {
            Some(answer) => answer.label(self.locale),
            None => Text::new(key.replace('_', " ")).render(self.locale),
        }
    }

    /// A number of ours with the decimal mark of the language.
    fn number(&self, text: &str) -> String {
        let mark = match self.locale.style.decimal {
            Decimal::Point => '.',
            Decimal::Comma => ',',
        };
        // Without a number it is words of the program: `every value`.
        if !text.contains(|c: char| c.is_ascii_digit()) {
            return Text::new(text.to_owned()).render(self.locale);
        }
        self.signed(&replaced(text, '.', mark, |before, after| digit(before) && digit(after)))
    }

    /// The digits that were printed, with the signs of every number on the screen.
    fn printed(&self, text: &str) -> String {
        let has_number = text.contains(|c: char| c.is_ascii_digit());
        if has_number { self.number(text) } else { self.signed(text) }
    }

    /// With the minus signs of every number on the screen.
    fn signed(&self, text: &str) -> String {
        let begins =
            |before: Option<char>| before.is_none_or(|c| c.is_whitespace() || ['(', '[', ','].contains(&c));
        if self.look.ascii {
            text.replace('−', "-")
        } else {
            replaced(text, '-', '−', |before, after| begins(before) && (digit(after) || after == Some('.')))
        }
    }
}

fn digit(c: Option<char>) -> bool {
    c.is_some_and(|c| c.is_ascii_digit())
}

/// The text with `from` replaced by `to` where what stands before and after it is as it must be.
fn replaced(text: &str, from: char, to: char, wanted: impl Fn(Option<char>, Option<char>) -> bool) -> String {
    let mut before = None;
    text.char_indices()
        .map(|(at, c)| {
            let after = text[at + c.len_utf8()..].chars().next();
            let kept = if c == from && wanted(before, after) { to } else { c };
            before = Some(c);
            kept
        })
        .collect()
}

fn case(checked: &CheckedCase, n: usize, chosen: bool, words: &Words, lines: &mut Vec<Line<'static>>) {
    let Words { look, locale, width, .. } = *words;
    let Case { source, note, truth, .. } = &checked.case;
    let [name, source, note] = [&checked.case.title(), source, note].map(|text| text.render(locale));
    let pointer = if chosen { look.glyph(Glyph::Pointer) } else { " " };
    let head = vec![
        Span::styled(format!("{pointer} "), look.key()),
        Span::styled(format!("{}  ", n + 1), look.dim()),
    ];
    let indent = head.iter().map(Span::width).sum::<usize>();
    let space = |more: usize| vec![Span::raw(" ".repeat((indent + more).min(width / 4)))];
    let name_style = if chosen { look.focus() } else { look.title() };
    lines.extend(wrap::hanging(head, &name, name_style, width));
    let kind = Text::new(kind(*truth)).render(locale);
    lines.extend(wrap::hanging(space(0), &format!("{source} ({kind})"), look.dim(), width));
    if !note.is_empty() {
        lines.extend(wrap::hanging(space(0), &note, look.dim(), width));
    }
    match &checked.verdicts {
        _ if words.answers.is_none() => {
            let words = Text::new("published values hidden").render(locale);
            lines.extend(wrap::hanging(space(0), &words, look.dim(), width));
        }
        None => {
            let words = Text::new("not compared yet").render(locale);
            lines.extend(wrap::hanging(space(0), &words, look.dim(), width));
        }
        Some(Err(error)) => {
            let words = match error {
                SolveError::Refused(Refusal::NoAnswer(why)) => why.render(locale),
                SolveError::Refused(Refusal::Stopped) => Text::new("not compared yet").render(locale),
                SolveError::Fields(_) => error.to_string(),
            };
            let mut head = space(0);
            head.push(Span::styled(format!("{} ", look.glyph(Glyph::Bad)), look.error()));
            lines.extend(wrap::hanging(head, &words, look.error(), width));
        }
        Some(Ok(verdicts)) => compared(verdicts, &space(0), words, lines),
    }
}

/// Printed beside ours in columns; below each other where the width does not hold them.
fn compared(verdicts: &[Verdict], space: &[Span<'static>], words: &Words, lines: &mut Vec<Line<'static>>) {
    let Words { look, locale, width, .. } = *words;
    let widest =
        |text: &dyn Fn(&Verdict) -> String| verdicts.iter().map(|one| text(one).width()).max().unwrap_or(0);
    let (printed, ours) = (Text::new("published").render(locale), Text::new("computed").render(locale));
    let name = |one: &Verdict| words.name(&one.answer);
    let theirs = |one: &Verdict| words.printed(&one.printed);
    let mine = |one: &Verdict| words.number(&one.computed);
    let names = widest(&name);
    let printed_width = widest(&theirs).max(printed.width());
    let ours_width = widest(&mine).max(ours.width());
    let outcome = |one: &Verdict| Text::new(one.outcome.name()).render(locale);
    let indent = space.iter().map(Span::width).sum::<usize>();
    let whole = indent + 2 + names + 2 + printed_width + 2 + ours_width + 2 + widest(&outcome);
    let columns = whole <= width;
    if columns && !verdicts.is_empty() {
        let head = format!("  {}  {}  {ours}", padded("", names), padded(&printed, printed_width));
        lines.push(Line::from([space, &[Span::styled(head, look.dim())]].concat()));
    }
    for one in verdicts {
        let (glyph, style) = match one.outcome {
            Comparison::Agreed => (Glyph::Good, look.good()),
            Comparison::Disputed => (Glyph::Warning, look.warning()),
            Comparison::Differing => (Glyph::Bad, look.error()),
        };
        let mark = Span::styled(format!("{} ", look.glyph(glyph)), style);
        if columns {
            let answers = [
                Span::raw(format!("{}  ", padded(&name(one), names))),
                Span::raw(format!("{}  ", padded(&theirs(one), printed_width))),
                Span::raw(format!("{}  ", padded(&mine(one), ours_width))),
                Span::styled(outcome(one), style),
            ];
            lines.push(Line::from([space, &[mark], &answers].concat()));
        } else {
            // A number and its unit stay together; sentences and lists need not.
            let held = |text: &str| {
                if text.width() <= A_NUMBER { text.replace(' ', "\u{A0}") } else { text.to_owned() }
            };
            let (theirs, mine) = (held(&theirs(one)), held(&mine(one)));
            let words = format!("{}: {printed} {theirs}, {ours} {mine}, {}", name(one), outcome(one));
            lines.extend(wrap::hanging([space, &[mark]].concat(), &words, Style::new(), width));
        }
        if !one.why.is_empty() {
            let head = [space, &[Span::raw("    ")]].concat();
            lines.extend(wrap::hanging(head, &one.why.render(locale), look.dim(), width));
        }
    }
}

fn kind(truth: Truth) -> &'static str {
    match truth {
        Truth::Published => "published",
        Truth::ClosedForm => "closed form",
        Truth::OtherProgram => "other program",
        Truth::OwnEarlierValue => "regression value",
    }
}
