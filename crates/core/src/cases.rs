//! Published cases: inputs and answers that somebody printed, and how near to them we come.

use dalembert_units::{self as units, Dim};
use toml_edit::{Item, TableLike};

use crate::{
    Answer, AnswerValue, Draft, Entry, LinkedProblem, Locale, Number, Record, Refusal, Solution, SolveError,
    Stop, Text,
    file::{self, FileError, FileNotes},
    statement::{self, Statement, words},
};

/// A problem with printed answers.
#[derive(Clone, Debug)]
pub struct Case {
    /// Name in files; [`title`](Self::title) is for display.
    pub name: String,
    /// Name that it had before; files and exercise lists that say it are still read.
    pub former: Option<String>,
    /// Publication of the problem.
    pub source: Text,
    /// Kind of truth of its answers.
    pub truth: Truth,
    /// Form in which its published answers were seen; `None` for all other kinds of truth.
    pub seen: Option<Seen>,
    /// Remarks; may be empty.
    pub note: Text,
    /// Statement of the exercise that the problem is, in sentences; empty where it is none.
    pub statement: Text,
    /// Names of the answers that the statement asks for, in its order; of a problem without a statement those that are
    /// expected.
    pub asked: Vec<String>,
    /// Ranges of the data of variants, by the paths of their inputs; empty where none is declared.
    pub vary: Vec<(String, String)>,
    /// Inputs, as they are typed.
    pub draft: Draft,
    /// Expected answers.
    pub expect: Vec<Expected>,
    /// Words of the refusal it must meet, for a problem without an answer.
    pub refused: Option<String>,
}

/// Kind of truth that an answer is compared with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Truth {
    /// Somebody printed it.
    Published,
    /// A formula gives it exactly.
    ClosedForm,
    /// Another program gave it.
    OtherProgram,
    /// This program gave it before.
    OwnEarlierValue,
}

/// Form in which a published answer was seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seen {
    /// In the book, paper, manual or standard that printed it.
    Book,
    /// In the worked output of a companion: scripts that somebody wrote to the examples of a book.
    Companion,
    /// On a page that quotes or works the problem: course notes, an answer site, a repository.
    Site,
    /// Nowhere again: it is quoted from memory, or how it came here is not known.
    Recalled,
}

/// A printed answer.
#[derive(Clone, Debug)]
pub struct Expected {
    /// The name of the answer.
    pub answer: String,
    /// As it was printed, with its unit.
    pub printed: String,
    /// Rule of comparison and tolerance.
    pub how: ComparisonRule,
}

/// Rule by which an expected answer is compared with the computed one.
#[derive(Clone, Debug, PartialEq)]
pub enum ComparisonRule {
    /// To half a unit in the last printed place.
    ToTheLastPlace,
    /// To half a unit in the last place, and to four significant digits where fewer are written: what is computed is
    /// known as well as it is wanted, so `0.3 N` is 0.3000 N and `0 N` is nothing.
    Computed,
    /// To a share of itself, because its source rounded on the way.
    Within(f64, Text),
    /// It is wrong. Agreeing with it is a fault: the dispute is stale.
    Disputed {
        /// Reason for which the published value is disputed.
        why: Text,
        /// The right value, compared with half a unit in its last place.
        computed: String,
    },
}

/// A printed answer beside ours.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// The name of the answer.
    pub answer: String,
    /// As it was printed.
    pub printed: String,
    /// Ours, in the unit of the printed one.
    pub computed: String,
    /// Result of the comparison.
    pub outcome: Comparison,
    /// Reason of a difference; empty where there is none.
    pub why: Text,
}

/// Result of comparing a published answer with the computed one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// They agree.
    Agreed,
    /// They differ, and we say why.
    Disputed,
    /// They differ, or a dispute is stale.
    Differing,
}

/// The cases of an analysis. `Err` says what is wrong with its case file.
pub fn cases(entry: &Entry) -> Result<Vec<Case>, String> {
    let text = entry.about.cases;
    let listed = |errors: Vec<FileError>| {
        errors
            .iter()
            .map(|err| format!("{}{}", line_of(text, err), err.why.english()))
            .collect::<Vec<_>>()
            .join("; ")
    };
    let document = file::document(text).map_err(listed)?;
    if !entry.linked().is_empty() {
        return exam_case(document.as_table()).map(|case| vec![case]);
    }
    let list =
        document.as_table().get("case").and_then(Item::as_array_of_tables).ok_or("there is no [[case]]")?;
    list.iter().map(|table| case(entry, table)).collect()
}

/// Title and problems of an exam question, and the name of the problem whose pictures come first.
pub(crate) fn exam(text: &str) -> Result<(String, Vec<LinkedProblem>, &'static str), String> {
    let document = file::document(text)
        .map_err(|errors| errors.first().map_or_else(String::new, |error| error.why.english()))?;
    let root = document.as_table();
    let title = root.get("title").and_then(Item::as_str).ok_or("`title` is missing")?;
    let problems = file::exam_problems(root).map_err(|why| why.english())?;
    let pictured = root.get("picture").and_then(Item::as_str).unwrap_or_default();
    let named = problems.iter().map(|problem| problem.name).find(|name| *name == pictured);
    let pictured = match named {
        None if !pictured.is_empty() => return Err(format!("`picture`: there is no problem `{pictured}`")),
        named => named.unwrap_or_default(),
    };
    Ok((title.to_owned(), problems, pictured))
}

/// The keys of an exam question.
const EXAM_KEYS: [&str; 11] =
    ["format", "title", "source", "statement", "picture", "vary", "let", "problem", "given", "ask", "expect"];

/// The case of an exam question.
fn exam_case(root: &toml_edit::Table) -> Result<Case, String> {
    let text = |key: &str| {
        root.get(key).and_then(Item::as_str).map(words).ok_or_else(|| format!("`{key}` is missing"))
    };
    let name = text("title")?;
    if let Some((key, _)) = root.iter().find(|(key, _)| !EXAM_KEYS.contains(key)) {
        return Err(format!("{name}: there is no key `{key}` in an exam question"));
    }
    let mut reading = FileNotes::latest();
    let draft = file::exam_of(root, &mut reading);
    if let Some(err) = reading.errors.first() {
        return Err(format!("{name}: {}", err.why.english()));
    }
    let truth = Truth::ClosedForm;
    let table = root.get("expect").and_then(Item::as_table_like).into_iter().flat_map(TableLike::iter);
    let expect = table
        .map(|(answer, item)| expected(answer, item, truth).map_err(|why| format!("{name}: {answer}: {why}")))
        .collect::<Result<Vec<_>, _>>()?;
    if expect.is_empty() {
        return Err(format!("{name}: nothing is expected"));
    }
    let (source, statement) = (Text::new(text("source")?), Text::new(text("statement")?));
    let asked = expect.iter().map(|expected| expected.answer.clone()).collect();
    let vary = statement::vary(root).map_err(|why| format!("{name}: {}", why.english()))?;
    let (former, seen, refused, note) = (None, None, None, Text::from(""));
    Ok(Case { name, former, source, truth, seen, note, statement, asked, vary, draft, expect, refused })
}

/// The case that a problem opens with.
pub fn first(entry: &Entry) -> Option<Case> {
    cases(entry).ok().and_then(|cases| cases.into_iter().next())
}

impl Case {
    /// Returns true if it has this name, or had it before.
    pub fn is_named(&self, name: &str) -> bool {
        self.name == name || self.former.as_deref() == Some(name)
    }

    /// Statement of the exercise, with the answers it asks for and the ranges of its data.
    pub fn exercise(&self) -> Statement {
        Statement { text: self.statement.clone(), asked: self.asked.clone(), vary: self.vary.clone() }
    }

    /// Title for display.
    pub fn title(&self) -> Text {
        Text::new(self.name.clone())
    }

    /// Inputs as read.
    pub fn record(&self, entry: &Entry) -> Result<Record, SolveError> {
        self.draft.read(&entry.shape()).map_err(SolveError::Fields)
    }

    /// Solves the case and holds every answer to what was printed. A check of the solution that fails differs too.
    pub fn verify(&self, entry: &Entry) -> Result<Vec<Verdict>, SolveError> {
        let solved = self.record(entry).and_then(|record| entry.solve(&record, &Stop::new()));
        match (&self.refused, solved) {
            (Some(words), Err(SolveError::Refused(Refusal::NoAnswer(why)))) => {
                let computed = why.english();
                let agreed = computed.to_lowercase().contains(&words.to_lowercase());
                let outcome = if agreed { Comparison::Agreed } else { Comparison::Differing };
                let (answer, printed) = ("refusal".to_owned(), words.clone());
                Ok(vec![Verdict { answer, printed, computed, outcome, why: Text::from("") }])
            }
            (Some(words), Ok(_)) => Ok(vec![Verdict {
                answer: "refusal".into(),
                printed: words.clone(),
                computed: "an answer".into(),
                outcome: Comparison::Differing,
                why: Text::from(""),
            }]),
            (_, Err(err)) => Err(err),
            (None, Ok(solution)) => Ok(self.verdicts(&solution)),
        }
    }

    /// Compares a solution with every expected answer, and adds a verdict for each of its checks that fails.
    pub fn verdicts(&self, solution: &Solution) -> Vec<Verdict> {
        let answers = self.expect.iter().map(|expected| verdict(expected, solution));
        answers.chain(failed_checks(solution)).collect()
    }
}

/// Compares an answer with a printed one to its last place; `None` where the two cannot be compared.
pub fn agrees(answer: &Answer, printed: &str) -> Option<bool> {
    let expected =
        Expected { answer: String::new(), printed: printed.to_owned(), how: ComparisonRule::ToTheLastPlace };
    compare(answer, &expected).1
}

impl Truth {
    /// The name in case files.
    pub const fn name(self) -> &'static str {
        match self {
            Truth::Published => "published",
            Truth::ClosedForm => "closed form",
            Truth::OtherProgram => "other program",
            Truth::OwnEarlierValue => "own earlier value",
        }
    }
}

impl Seen {
    /// The name in case files.
    pub fn name(self) -> &'static str {
        match self {
            Seen::Book => "book",
            Seen::Companion => "companion",
            Seen::Site => "site",
            Seen::Recalled => "from memory",
        }
    }
}

impl Comparison {
    /// `agreed`, `disputed` or `differing`.
    pub fn name(self) -> &'static str {
        match self {
            Comparison::Agreed => "agreed",
            Comparison::Disputed => "disputed",
            Comparison::Differing => "differing",
        }
    }
}

/// The keys of a case.
const KEYS: [&str; 16] = [
    "name",
    "former",
    "source",
    "truth",
    "seen",
    "note",
    "statement",
    "asked",
    "vary",
    "let",
    "inputs",
    "configuration",
    "given",
    "ask",
    "expect",
    "refused",
];

fn case(entry: &Entry, table: &toml_edit::Table) -> Result<Case, String> {
    let text = |key: &str| table.get(key).and_then(Item::as_str).map(str::to_owned);
    let name = text("name").ok_or("a case has no name")?;
    for (key, _) in table {
        if !KEYS.contains(&key) {
            return Err(format!("{name}: there is no key `{key}` in a case"));
        }
    }
    let source = text("source").ok_or_else(|| format!("{name}: the source is not named"))?;
    let truth = match text("truth").as_deref() {
        None | Some("published") => Truth::Published,
        Some("closed form") => Truth::ClosedForm,
        Some("other program") => Truth::OtherProgram,
        Some("own earlier value") => Truth::OwnEarlierValue,
        Some(other) => return Err(format!("{name}: `{other}` is not a kind of truth")),
    };
    let seen = match text("seen").as_deref() {
        None => None,
        Some("book") => Some(Seen::Book),
        Some("companion") => Some(Seen::Companion),
        Some("site") => Some(Seen::Site),
        Some("recalled") => Some(Seen::Recalled),
        Some(other) => return Err(format!("{name}: nothing is seen in a `{other}`")),
    };
    if !table.contains_key("inputs") {
        return Err(format!("{name}: there are no inputs"));
    }
    let mut reading = FileNotes::latest();
    let draft = file::case_of(table, entry, &mut reading);
    if let Some(err) = reading.errors.first() {
        return Err(format!("{name}: {}", err.why.english()));
    }
    let mut expect = Vec::new();
    for (answer, item) in
        table.get("expect").and_then(Item::as_table_like).into_iter().flat_map(TableLike::iter)
    {
        expect.push(expected(answer, item, truth).map_err(|why| format!("{name}: {answer}: {why}"))?);
    }
    let refused = text("refused");
    if expect.is_empty() && refused.is_none() {
        return Err(format!("{name}: nothing is expected"));
    }
    match (truth, seen) {
        (Truth::Published, None) if !expect.is_empty() => {
            return Err(format!(
                "{name}: say where its answers were seen: `seen` is book, companion, site or recalled"
            ));
        }
        (Truth::ClosedForm | Truth::OtherProgram | Truth::OwnEarlierValue, Some(_)) => {
            return Err(format!("{name}: only published answers were `seen`"));
        }
        _ => {}
    }
    let Statement { text: statement, mut asked, vary } =
        Statement::of(table).map_err(|(_, why)| format!("{name}: {}", why.english()))?;
    if asked.is_empty() {
        asked = expect.iter().map(|expected| expected.answer.clone()).collect();
    }
    let (source, note) = (Text::new(source), Text::new(text("note").unwrap_or_default()));
    let former = text("former");
    Ok(Case { name, former, source, truth, seen, note, statement, asked, vary, draft, expect, refused })
}

fn expected(answer: &str, item: &Item, truth: Truth) -> Result<Expected, String> {
    let answer = answer.to_owned();
    let to_the_last_place =
        if truth == Truth::Published { ComparisonRule::ToTheLastPlace } else { ComparisonRule::Computed };
    if let Some(printed) = item.as_str() {
        return Ok(Expected { answer, printed: printed.to_owned(), how: to_the_last_place });
    }
    let table = item.as_table_like().ok_or("write a text, or a table with `printed`")?;
    let text = |key: &str| table.get(key).and_then(Item::as_str).map(str::to_owned);
    let printed = text("printed").ok_or("`printed` is missing")?;
    let within = table.get("within").and_then(Item::as_float);
    let how = match (text("disputed"), text("ours"), within, text("because")) {
        (Some(why), Some(computed), None, None) => ComparisonRule::Disputed { why: Text::new(why), computed },
        (Some(_), None, None, None) => return Err("a disputed answer needs `ours`, the right value".into()),
        (None, None, Some(share), Some(why)) if share < 0.05 => ComparisonRule::Within(share, Text::new(why)),
        (None, None, Some(_), Some(_)) => return Err("a share of 5 % or more holds nothing".into()),
        (None, None, None, None) => to_the_last_place,
        _ => return Err("write `disputed` and `ours`, or `within` and `because`".into()),
    };
    Ok(Expected { answer, printed, how })
}

fn verdict(expected: &Expected, solution: &Solution) -> Verdict {
    let (computed, near) = match solution.answer(&expected.answer) {
        None => ("no such answer".to_owned(), None),
        Some(answer) => compare(answer, expected),
    };
    let right = |computed: &str| {
        solution.answer(&expected.answer).and_then(|answer| agrees(answer, computed)).unwrap_or(false)
    };
    let (outcome, why) = match (&expected.how, near) {
        (ComparisonRule::Disputed { computed, .. }, Some(false)) if !right(computed) => {
            let why = Text::new("the computed value in place of the disputed one is {right}");
            (Comparison::Differing, why.with("right", computed))
        }
        (ComparisonRule::Disputed { why, .. }, Some(false)) => (Comparison::Disputed, why.clone()),
        (ComparisonRule::Disputed { .. }, Some(true)) => {
            (Comparison::Differing, Text::from("outdated dispute: the published value agrees"))
        }
        (ComparisonRule::Within(_, why), Some(true)) => (Comparison::Agreed, why.clone()),
        (_, Some(true)) => (Comparison::Agreed, Text::from("")),
        (_, None) => (
            Comparison::Differing,
            Text::from("the published value cannot be compared with the computed one"),
        ),
        _ => (Comparison::Differing, Text::from("")),
    };
    Verdict { answer: expected.answer.clone(), printed: expected.printed.clone(), computed, outcome, why }
}

/// A verdict for each check that fails.
fn failed_checks(solution: &Solution) -> impl Iterator<Item = Verdict> {
    solution.checks.iter().filter(|check| !check.passed).map(|check| Verdict {
        answer: "check".into(),
        printed: check.what.english(),
        computed: format!("{:e}", check.residual),
        outcome: Comparison::Differing,
        why: Text::from("a check of the solution failed"),
    })
}

/// Ours as it is written beside the printed answer, and whether they agree.
fn compare(answer: &Answer, expected: &Expected) -> (String, Option<bool>) {
    match &answer.value {
        AnswerValue::Number(Number::Scalar(si), _) => compare_scalar(*si, answer.dim(), expected),
        AnswerValue::Number(Number::Vector(si), _) => compare_vector(*si, &answer.unit, expected),
        AnswerValue::List(numbers) => compare_list(numbers, &answer.unit, expected),
        AnswerValue::Set(..) => {
            let computed = answer.shown(&Locale::english().digits(6));
            let near = compare_set(&answer.shown(&Locale::english().digits(15)), &expected.printed, expected);
            (computed, near)
        }
    }
}

/// Half a unit in the last printed place, or the share that the case grants.
fn tolerance(expected: &Expected, printed: f64, last_place: f64) -> f64 {
    let half = 0.5 * last_place * (1.0 + 1e-9) + 1e-12 * printed.abs();
    match expected.how {
        ComparisonRule::Within(share, _) => share * printed.abs(),
        // A nought without decimals says nothing of how small it is.
        ComparisonRule::Computed if printed == 0.0 && expected.printed.contains('.') => half,
        ComparisonRule::Computed if printed == 0.0 => 1e-4 * half,
        ComparisonRule::Computed => half.min(FOUR_DIGITS * printed.abs()),
        ComparisonRule::ToTheLastPlace | ComparisonRule::Disputed { .. } => half,
    }
}

/// Half a unit in the fourth significant digit of 1, as a share of it.
const FOUR_DIGITS: f64 = 5e-4;

fn compare_scalar(si: f64, dim: Dim, expected: &Expected) -> (String, Option<bool>) {
    let printed = match units::read_any(&expected.printed) {
        Ok(printed) => printed,
        Err(err) => return (err.to_string(), None),
    };
    let computed = units::write_quantity(si, &printed.unit, Locale::english().digits(6).style);
    if !printed.unit.dim.agrees(dim) {
        return (computed, None);
    }
    let mut off = (si - printed.si).abs();
    if dim == Dim::ANGLE {
        // Directions are the same a turn apart.
        off = off.rem_euclid(std::f64::consts::TAU);
        off = off.min(std::f64::consts::TAU - off);
    }
    (computed, Some(off <= tolerance(expected, printed.si, printed.last_place)))
}

fn compare_vector(si: [f64; 3], unit: &units::Unit, expected: &Expected) -> (String, Option<bool>) {
    let printed = match units::read_vector(&expected.printed, unit, units::Kind::of(unit), 3) {
        Ok(printed) => printed,
        Err(err) => return (err.to_string(), None),
    };
    let computed = units::write_components(&si, &printed.unit, Locale::english().digits(6).style);
    let size = printed.si.iter().fold(0.0f64, |size, x| size.max(x.abs()));
    let near = si
        .iter()
        .zip(printed.si)
        .all(|(a, b)| (a - b).abs() <= tolerance(expected, size, printed.last_place));
    (computed, Some(near))
}

/// Numbers in order, in the unit behind them: `0.3473; 0.6527; 1; …` or `(5.53; 10.89) Hz`. The `…` says that there are
/// more.
fn compare_list(si: &[f64], unit: &units::Unit, expected: &Expected) -> (String, Option<bool>) {
    let all = expected.printed.trim_start_matches('(');
    let end = all
        .rfind(|c: char| c.is_ascii_digit() || c == '…' || c == ')')
        .map_or(0, |at| at + all[at..].chars().next().map_or(0, char::len_utf8));
    let (numbers, tail) = all.split_at(end);
    let printed_unit = match tail.trim() {
        "" => unit.clone(),
        tail => match units::unit(tail) {
            Ok(unit) => unit,
            Err(err) => return (err.to_string(), None),
        },
    };
    let computed = units::write_components(si, &printed_unit, Locale::english().digits(6).style);
    let mut numbers: Vec<&str> = numbers.trim_end_matches(')').split(';').map(str::trim).collect();
    let more = numbers.pop_if(|last| *last == "…").is_some();
    let read = |text: &&str| units::read_quantity(text, &printed_unit, units::Kind::Other);
    let printed: Vec<units::Quantity> = match numbers.iter().map(read).collect() {
        Ok(printed) => printed,
        Err(err) => return (units::ReadError::to_string(&err), None),
    };
    let fits = if more { printed.len() < si.len() } else { printed.len() == si.len() };
    if !fits || !printed_unit.dim.agrees(unit.dim) {
        return (computed, None);
    }
    let near = |(si, printed): (&f64, &units::Quantity)| {
        (si - printed.si).abs() <= tolerance(expected, printed.si, printed.last_place)
    };
    (computed, Some(si.iter().zip(&printed).all(near)))
}

/// Sets are printed as ours are shown: `≤ 113.4 mm or ≥ 439.9 mm`, `2 m … 3 m`, `every value`, `no value`. Each end is
/// compared with the last place printed.
fn compare_set(computed: &str, printed: &str, expected: &Expected) -> Option<bool> {
    /// The words or the sign of a part, and its ends.
    fn part(text: &str) -> Option<(&str, Vec<units::Quantity>)> {
        let read = units::quantity_of;
        let text = text.trim();
        if let Some((from, to)) = text.split_once('…') {
            return Some(("…", vec![read(from)?, read(to)?]));
        }
        match text.strip_prefix(['≤', '≥', '<', '>']) {
            Some(rest) => Some((&text[..text.len() - rest.len()], vec![read(rest)?])),
            None => Some((text, Vec::new())),
        }
    }
    let parts = |text| -> Option<Vec<_>> { str::split(text, " or ").map(part).collect() };
    let (computed, printed) = (parts(computed)?, parts(printed)?);
    if computed.len() != printed.len() {
        return Some(false);
    }
    let near = |(computed, printed): (&units::Quantity, &units::Quantity)| {
        (computed.si - printed.si).abs() <= tolerance(expected, printed.si, printed.last_place)
            && computed.unit.dim.agrees(printed.unit.dim)
    };
    Some(computed.iter().zip(&printed).all(|((sign, computed), (other, printed))| {
        sign == other && computed.len() == printed.len() && computed.iter().zip(printed).all(near)
    }))
}

fn line_of(text: &str, error: &FileError) -> String {
    error.span.as_ref().map_or_else(String::new, |span| format!("line {}: ", file::line_of(text, span.start)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_are_held_number_by_number() {
        let si = [0.00034, -0.00065, 0.001];
        let mm = units::unit("mm").expect("a unit");
        let held = |printed: &str| {
            let printed = printed.to_owned();
            compare_list(
                &si,
                &mm,
                &Expected { answer: String::new(), printed, how: ComparisonRule::ToTheLastPlace },
            )
            .1
        };
        let agreed =
            ["0.34; -0.65; 1.0", "(0.34; -0.65; 1.0) mm", "340; -650; 1000 um", "0.34; -0.65; …", "(0.3; …)"];
        for printed in agreed {
            assert_eq!(held(printed), Some(true), "{printed}");
        }
        let other = ["0.35; -0.65; 1.0", "0.34; 0.65; …", "0.34; -0.65; 1.1"];
        for printed in other {
            assert_eq!(held(printed), Some(false), "{printed}");
        }
        let unfit = ["0.34; -0.65", "0.34; -0.65; 1.0; …", "0.34; -0.65; 1.0; 0", "1; 2; 3 kg", "…; 1", ""];
        for printed in unfit {
            assert_eq!(held(printed), None, "{printed}");
        }
    }
}
