//! Search in the list of analyses, the best matches first.
//!
//! Every word that is typed must be found, in any order: in the names of an analysis, in one of its cases, in what
//! describes it, or in its inputs and answers, in either language and with accents or without. A whole word counts more
//! than the beginning of one, that more than another form of it (`balancing`, `balance`), and that more than letters
//! within. Articles and prepositions do not count, and words such as `method` need not be found. A hyphen is as good as
//! a space, and words are found joined or apart: `runout`, `run-out`. Where fewer than three analyses have every word,
//! as of a heading of a book, those follow that have most of them. Where none has, the letters of the filter may stand
//! scattered in a title: `rotunb` finds `Rotating unbalance`.

use std::{cmp::Reverse, collections::BTreeSet};

use itertools::Itertools;
use nucleo_matcher::{
    Config, Matcher, Utf32Str,
    pattern::{AtomKind, CaseMatching, Normalization, Pattern},
};

use crate::{ChildList, Entry, Field, Language, Locale, Shape, Text, cases::Case};

/// Weight of a word in the names of an analysis.
const NAMES: u32 = 8;
/// Weight of a keyword that is searched for alone: as a whole, it says more than the beginning of a word in a name.
const KEYWORD_ALONE: u32 = 7;
/// Weight of a word in a case.
const CASE: u32 = 4;
/// Weight of a word in the description.
const DESCRIPTION: u32 = 3;
/// Weight of a word in the labels and symbols of inputs and answers.
const INPUTS: u32 = 1;
/// Weight of the words standing together as they were typed.
const TOGETHER: u32 = 9;
/// The shortest word that is searched for within others, in bytes.
pub const WITHIN: usize = 3;
/// The shortest stem of a word, in bytes.
pub const STEM: usize = 4;
/// The shortest word that is searched for as two words, in letters.
pub const JOINED: usize = 6;
/// Number of analyses with every word from which on those with most of the words are left out.
const ENOUGH: usize = 3;

/// Words of a filter that do not count beside others, folded.
pub const SMALL_WORDS: &[&str] = &[
    "a", "an", "the", "of", "in", "on", "to", "by", "and", "or", "with", "for", "from", "at", "under", "its",
    "between", "o", "as", "os", "um", "uma", "de", "da", "do", "das", "dos", "em", "no", "na", "nos", "nas",
    "e", "ou", "com", "por", "para", "sob", "sobre", "ao", "entre", "pelo", "pela",
];

/// Words of a filter that count where they are found and need not be, beside others, folded.
pub const OPTIONAL_WORDS: &[&str] = &[
    "method",
    "methods",
    "equation",
    "equations",
    "system",
    "systems",
    "metodo",
    "metodos",
    "equacao",
    "equacoes",
    "sistema",
    "sistemas",
];

/// Names that standards begin with, folded: a number beside one need not be found.
pub const STANDARDS: &[&str] =
    &["iso", "api", "nbr", "abnt", "din", "vdi", "ansi", "agma", "mil std", "iec", "en"];

/// Endings of words of both languages, folded, that make another form of a word.
pub const ENDINGS: &[&str] = &[
    "ations", "ation", "ings", "ing", "ions", "ion", "ers", "er", "ed", "es", "s", "ally", "ly", "ical",
    "al", "e", "ity", "acoes", "acao", "icoes", "icao", "oes", "ao", "amentos", "amento", "imentos",
    "imento", "ados", "adas", "ado", "ada", "idos", "idas", "ido", "ida", "ivel", "iveis", "icos", "icas",
    "ico", "ica", "os", "as", "o", "a", "ais", "eis", "ens", "em",
];

/// Texts of an analysis that are searched, folded.
#[derive(Debug)]
pub struct Index {
    /// Titles, topic, family and id.
    pub names: String,
    /// Keywords.
    pub keywords: String,
    /// Summaries and books.
    pub words: String,
    /// Labels and symbols of inputs and alternatives, and names of answers.
    pub inputs: String,
    /// Name and source of each case, in both languages.
    pub cases: Vec<String>,
}

/// An analysis that a search leaves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Found {
    /// Place among those that were searched.
    pub place: usize,
    /// The case that the words speak of.
    pub case: Option<usize>,
}

/// A filter, folded.
struct Filter {
    /// The words as they were typed, and spaces between them.
    phrase: String,
    /// Those that count.
    words: Vec<Word>,
}

/// A word of a filter.
struct Word {
    whole: String,
    /// The same as two words, where only these are known; empty otherwise.
    parted: String,
    /// The beginning that other forms of the word have; empty where it has none.
    stem: String,
    /// True if the word must be found.
    is_needed: bool,
    /// True if only the whole word counts.
    is_exact: bool,
}

impl Filter {
    fn of(indices: &[&Index], filter: &str) -> Self {
        let typed: Vec<String> = filter.split_whitespace().flat_map(|word| parts(indices, word)).collect();
        let counting = typed.iter().filter(|word| !SMALL_WORDS.contains(&word.as_str()));
        let counting: Vec<&str> = counting.map(String::as_str).collect();
        let words = if counting.is_empty() { typed.iter().map(String::as_str).collect() } else { counting };
        let is_number = |word: &str| word.starts_with(|first: char| first.is_ascii_digit());
        let is_standard = |word: &str| STANDARDS.contains(&word);
        let has = |is: &dyn Fn(&str) -> bool| words.iter().any(|word| is(word));
        let has_standard = has(&is_standard) && has(&is_number);
        let is_optional = |word: &str| OPTIONAL_WORDS.contains(&word) || has_standard && is_number(word);
        let all_optional = words.iter().all(|word| is_optional(word));
        let word = |&whole: &&str| Word {
            whole: whole.to_owned(),
            parted: parted(indices, whole),
            stem: stem(whole).to_owned(),
            is_needed: all_optional || !is_optional(whole),
            is_exact: has_standard && is_standard(whole),
        };
        Self { words: words.iter().map(word).collect(), phrase: folded(filter.trim()) }
    }

    /// Number of words that must be found.
    fn needed(&self) -> usize {
        self.words.iter().filter(|word| word.is_needed).count()
    }
}

impl Word {
    /// Score of the word in a text, in the better of its spellings.
    fn place(&self, text: &str) -> u32 {
        let written = place(text, &self.whole, if self.is_exact { "" } else { &self.stem });
        let is_parted = || !self.parted.is_empty() && place(text, &self.parted, "") == WHOLE;
        match written {
            WHOLE => WHOLE,
            _ if self.is_exact => 0,
            _ if is_parted() => WHOLE,
            _ => written,
        }
    }
}

/// The shortest of the beginnings that other forms of a word may have; empty where it has none.
fn stem(whole: &str) -> &str {
    let stems = ENDINGS.iter().filter_map(|ending| whole.strip_suffix(ending));
    stems.filter(|stem| stem.len() >= STEM).min_by_key(|stem| stem.len()).unwrap_or_default()
}

/// Returns true if an analysis has these words together, whole.
fn is_known(indices: &[&Index], words: &str) -> bool {
    let has = |text: &str| place(text, words, "") == WHOLE;
    indices.iter().any(|index| {
        index.texts().into_iter().any(|(text, _)| has(text)) || index.cases.iter().any(|case| has(case))
    })
}

/// A word as it was typed; of one with hyphens that no analysis has its parts, unless one is a letter or a number.
fn parts(indices: &[&Index], typed: &str) -> Vec<String> {
    // A mark that ends a clause belongs to no word; one alone may be a symbol.
    let bare = typed.trim_end_matches([',', ':', ';', '?', '!']);
    let word = folded(if bare.is_empty() { typed } else { bare });
    let owner = word.strip_suffix("'s").or(word.strip_suffix("’s")).filter(|owner| !owner.is_empty());
    let whole = owner.unwrap_or(&word);
    let is_long = |part: &str| part.chars().nth(1).is_some() && part.chars().all(char::is_alphabetic);
    let is_parted = whole.contains(' ') && whole.split(' ').all(is_long) && !is_known(indices, whole);
    if is_parted { whole.split(' ').map(str::to_owned).collect() } else { vec![whole.to_owned()] }
}

/// Two words for one that no analysis has: `run out` for `runout`, `g 2.5` for `g2.5`; empty where none has these.
fn parted(indices: &[&Index], whole: &str) -> String {
    if is_known(indices, whole) {
        return String::new();
    }
    let letters = whole.chars().count();
    let is_joined = letters >= JOINED && whole.chars().all(char::is_alphabetic);
    let places = whole.char_indices().tuple_windows().enumerate();
    let places = places.filter(|(before, ((_, last), (_, first)))| {
        let is_within = *before >= 1 && before + 2 < letters;
        is_joined && is_within || last.is_alphabetic() && first.is_ascii_digit()
    });
    let mut parted = places.map(|(_, (_, (at, _)))| format!("{} {}", &whole[..at], &whole[at..]));
    parted.find(|parted| is_known(indices, parted)).unwrap_or_default()
}

/// The analyses in which every word is found, the best match first.
pub fn find_words(indices: &[&Index], filter: &str) -> Vec<Found> {
    let filter = Filter::of(indices, filter);
    with_words(indices, &filter, filter.needed())
}

/// The same; where they are few, those follow that have more than half of the words; where there are none, those whose
/// names have the letters in their order.
pub fn find(indices: &[&Index], filter: &str) -> Vec<Found> {
    let filter = Filter::of(indices, filter);
    let needed = filter.needed();
    let mut found = with_words(indices, &filter, needed);
    if found.len() < ENOUGH && needed > 2 {
        let others = with_words(indices, &filter, needed / 2 + 1);
        let known: BTreeSet<usize> = found.iter().map(|found| found.place).collect();
        found.extend(others.into_iter().filter(|other| !known.contains(&other.place)));
    }
    if found.is_empty() { ranked(scattered(indices, &filter.phrase)) } else { found }
}

/// The analyses in which at least so many of the words are found, the best match first.
fn with_words(indices: &[&Index], filter: &Filter, least: usize) -> Vec<Found> {
    let scored = indices.iter().enumerate().filter_map(|(place, index)| {
        let (score, case) = index.rank(filter, least)?;
        Some(((score, index.mentions(&filter.phrase)), Found { place, case }))
    });
    ranked(scored.collect())
}

/// Returns true if a text has every word of a filter, in upper or lower case and with accents or without.
pub fn has_words(text: &str, filter: &str) -> bool {
    let text = folded(text);
    folded(filter).split_whitespace().all(|word| place(&text, word, "") == WHOLE)
}

fn ranked<S: Ord + Copy>(mut found: Vec<(S, Found)>) -> Vec<Found> {
    found.sort_by_key(|(score, found)| (Reverse(*score), found.place));
    found.into_iter().map(|(_, found)| found).collect()
}

/// The name of a family for people.
pub fn family(id: &str) -> Text {
    Text::from(match id {
        "balancing" => "Balancing",
        "rigid-body" => "Rigid bodies",
        "vibration" => "Vibration",
        "virtual-work" => "Virtual work",
        "exam" => "Exam questions",
        _ => return Text::new(id.to_owned()),
    })
}

impl Index {
    /// Index of an analysis and its cases.
    pub fn of(entry: &Entry, cases: &[Case]) -> Self {
        let about = entry.about;
        let locales = Language::ALL.map(|language| Locale::of(language).at(about.id));
        let in_each = |text: &Text| locales.map(|locale| text.render(&locale));
        let names = [Text::from(about.title), Text::from(about.topic), family(entry.family())];
        let names = names.iter().flat_map(in_each).chain([about.id.to_owned()]);
        let books = about.sources.iter().map(|source| format!("{} {}", source.short, source.full));
        let words = in_each(&about.summary.into()).into_iter().chain(books);
        let mut labels = Labels::default();
        labels.fields(entry.fields());
        // The name of an answer is its label in most analyses.
        let answers: BTreeSet<&str> = cases
            .iter()
            .flat_map(|case| &case.expect)
            .map(|expected| expected.answer.split('[').next().unwrap_or_default())
            .collect();
        let answers = answers.into_iter().flat_map(|answer| in_each(&Text::new(answer.replace('_', " "))));
        let inputs = labels
            .words
            .iter()
            .flat_map(|label| in_each(&Text::new(*label)))
            .chain(labels.symbols.iter().map(|&symbol| symbol.to_owned()));
        let of_case =
            |case: &Case| folded(&[case.title(), case.source.clone()].iter().flat_map(in_each).join("\n"));
        let joined = |texts: &mut dyn Iterator<Item = String>| folded(&texts.collect::<Vec<_>>().join("\n"));
        Self {
            names: joined(&mut names.into_iter()),
            keywords: folded(about.keywords),
            words: joined(&mut words.into_iter()),
            inputs: joined(&mut inputs.chain(answers)),
            cases: cases.iter().map(of_case).collect(),
        }
    }

    /// Texts of the analysis itself, with their weights.
    fn texts(&self) -> [(&str, u32); 4] {
        [
            (&self.names, NAMES),
            (&self.keywords, DESCRIPTION),
            (&self.words, DESCRIPTION),
            (&self.inputs, INPUTS),
        ]
    }

    /// Number of texts and cases in which the words stand together: of equal matches, the one with more comes first.
    fn mentions(&self, phrase: &str) -> usize {
        let texts = self.texts().into_iter().map(|(text, _)| text);
        texts.chain(self.cases.iter().map(String::as_str)).filter(|text| text.contains(phrase)).count()
    }

    /// Score of the match, and the case that matches best; `None` where fewer than `least` of the words that must be
    /// found are found together.
    fn rank(&self, filter: &Filter, least: usize) -> Option<(u32, Option<usize>)> {
        let Filter { phrase, words } = filter;
        let together = |text: &str, weight: u32| {
            if words.len() > 1 && place(text, phrase, "") > 0 { TOGETHER * weight } else { 0 }
        };
        let of_analysis: Vec<u32> = words
            .iter()
            .map(|word| {
                let texts = self.texts();
                texts.into_iter().map(|(text, weight)| weight * word.place(text)).max().unwrap_or(0)
            })
            .collect();
        let spaced = |text: &str| text.replace('-', " ");
        let is_phrase = |name: &str| name.rsplit('/').next().map(spaced) == Some(spaced(phrase));
        let title = if self.names.lines().any(is_phrase) { TOGETHER * NAMES } else { 0 };
        let bonus = self.texts().into_iter().map(|(text, weight)| together(text, weight)).max().unwrap_or(0);
        let bonus = bonus + title;
        let has_enough = |scores: &[u32]| {
            scores.iter().zip(words).filter(|(score, word)| **score > 0 && word.is_needed).count() >= least
        };
        let mut best = has_enough(&of_analysis).then(|| (of_analysis.iter().sum::<u32>() + bonus, None));
        for (n, case) in self.cases.iter().enumerate() {
            let scores = words.iter().zip(&of_analysis).map(|(word, score)| {
                // Of two analyses with such a case, the one whose own words speak of it comes first.
                let of_case = CASE * word.place(case);
                of_case.max(*score) + u32::from(of_case > *score && *score > 0)
            });
            let scores: Vec<u32> = scores.collect();
            if !has_enough(&scores) {
                continue;
            }
            let total = scores.iter().sum::<u32>() + together(case, CASE).max(bonus);
            if best.is_none_or(|(score, _)| total > score) {
                best = Some((total, Some(n)));
            }
        }
        if let ([word], Some((score, _))) = (words.as_slice(), &mut best) {
            *score = (*score).max(KEYWORD_ALONE * word.place(&self.keywords));
        }
        best
    }
}

/// Score of a whole word.
const WHOLE: u32 = 4;

/// Score of a word in a text: 4 as a whole word, 3 as the beginning of one, 2 with its stem alone, 1 within one, 0 if
/// absent.
fn place(text: &str, word: &str, stem: &str) -> u32 {
    let begins = |at: usize| !text[..at].ends_with(char::is_alphanumeric);
    let mut best = 0;
    for (at, _) in text.match_indices(word) {
        let ends = !text[at + word.len()..].starts_with(char::is_alphanumeric);
        best = best.max(match (begins(at), ends) {
            (true, true) => return WHOLE,
            (true, false) => 3,
            (false, _) => u32::from(word.len() >= WITHIN),
        });
    }
    let has_stem = || !stem.is_empty() && text.match_indices(stem).any(|(at, _)| begins(at));
    if best < 2 && has_stem() { 2 } else { best }
}

/// Titles and ids that hold the letters in their order, with gaps.
fn scattered(indices: &[&Index], phrase: &str) -> Vec<(u32, Found)> {
    let mut matcher = Matcher::new(Config::DEFAULT);
    let pattern = Pattern::new(phrase, CaseMatching::Ignore, Normalization::Smart, AtomKind::Fuzzy);
    let scored = indices.iter().enumerate().filter_map(|(place, index)| {
        let names = index.names.lines();
        let score = names
            .filter_map(|name| pattern.score(Utf32Str::new(name, &mut Vec::new()), &mut matcher))
            .max()?;
        Some((score, Found { place, case: None }))
    });
    scored.collect()
}

/// Labels and symbols of inputs and alternatives, each once.
#[derive(Default)]
struct Labels {
    words: BTreeSet<&'static str>,
    symbols: BTreeSet<&'static str>,
    seen: Vec<ChildList>,
}

impl Labels {
    fn fields(&mut self, fields: &'static [Field]) {
        for field in fields {
            self.words.insert(field.label);
            self.symbols.insert(field.symbol);
            self.shape(&field.shape);
        }
    }

    fn shape(&mut self, shape: &Shape) {
        if let Some(list) = shape.child_list() {
            if self.seen.contains(&list) {
                return;
            }
            self.seen.push(list);
        }
        match shape {
            Shape::Group(fields) | Shape::Table(fields) => self.fields(fields()),
            Shape::OneOf(variants) => {
                for variant in variants() {
                    self.words.insert(variant.label);
                    self.fields((variant.fields)());
                }
            }
            Shape::Rows { item, .. } => self.shape(item()),
            Shape::Optional(inner) => self.shape(inner()),
            _ => {}
        }
    }
}

/// Lower case, without the accents of the Latin alphabet, and with a space for a hyphen within a word.
fn folded(text: &str) -> String {
    let letters = text.chars().flat_map(char::to_lowercase).map(|character| match character {
        'á' | 'à' | 'â' | 'ã' | 'ä' | 'å' => 'a',
        'ç' => 'c',
        'é' | 'è' | 'ê' | 'ë' => 'e',
        'í' | 'ì' | 'î' | 'ï' => 'i',
        'ñ' => 'n',
        'ó' | 'ò' | 'ô' | 'õ' | 'ö' => 'o',
        'ú' | 'ù' | 'û' | 'ü' => 'u',
        other => other,
    });
    let mut folded = String::with_capacity(text.len());
    let mut letters = letters.peekable();
    while let Some(letter) = letters.next() {
        let is_hyphen = letter == '-'
            && folded.ends_with(char::is_alphanumeric)
            && letters.peek().is_some_and(|next| next.is_alphanumeric());
        folded.push(if is_hyphen { ' ' } else { letter });
    }
    folded
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_found_whole_before_beginnings_and_those_before_letters_within() {
        for (text, word, score) in [
            ("problem 18.46", "18", 4),
            ("dynamics, 2018", "18", 0),
            ("rotating unbalance", "unb", 3),
            ("rotating unbalance", "bal", 1),
            ("rotating unbalance", "al", 0),
            ("rotating unbalance", "rotating", 4),
            ("rotating unbalance", "rotation", 2),
            ("desbalanceamento rotativo", "rotativa", 2),
            ("the rotor", "rotation", 0),
        ] {
            assert_eq!(place(text, word, stem(word)), score, "{word} in {text}");
        }
        assert_eq!(folded("Vibração À"), "vibracao a");
        assert_eq!(folded("V-twin - 3-2-1"), "v twin - 3 2 1");
    }

    #[test]
    fn every_word_must_be_found_and_a_case_is_named_where_it_says_more() {
        let index = Index {
            names: folded("slider-crank\ncursor-manivela"),
            keywords: folded("piston run-out Holzer iso 21940 G 2.5"),
            words: "beer & johnston".into(),
            inputs: "length of the rod\nl".into(),
            cases: vec!["engine\nriul".into(), "two levers\nbeer & johnston, problem 10.1".into()],
        };
        let of = |phrase: &str| {
            let filter = Filter::of(&[&index], phrase);
            index.rank(&filter, filter.needed()).map(|(_, case)| case)
        };
        assert_eq!(of("manivela cursor"), Some(None));
        assert_eq!(of("piston"), Some(None));
        assert_eq!(of("the length of a rod:"), Some(None));
        assert_eq!(of("10 beer"), Some(Some(1)));
        assert_eq!(of("riul"), Some(Some(0)));
        assert_eq!(of("riul levers"), None, "no case holds both");
        assert_eq!(of("cursor nothing"), None);
        for words in ["crank-slider", "runout", "Holzer's method", "método de Holzer", "ISO 1940", "G2.5"] {
            assert_eq!(of(words), Some(None), "{words}");
        }
        for words in ["method", "crank-nothing", "iso nothing"] {
            assert_eq!(of(words), None, "{words}");
        }
    }
}
