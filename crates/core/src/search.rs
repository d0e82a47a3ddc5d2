//! Search in the list of analyses, the best matches first.
//!
//! Every word that is typed must be found, in any order: in the names of an analysis, in one of its cases, in what
//! describes it, or in its inputs and answers, in either language and with accents or without. A whole word counts more
//! than the beginning of one, and that more than letters within. Where a word is in no analysis, the letters of the filter
//! may stand scattered in a title: `rotunb` finds `Rotating unbalance`.

use std::{cmp::Reverse, collections::BTreeSet};

use nucleo_matcher::{
    Config, Matcher, Utf32Str,
    pattern::{AtomKind, CaseMatching, Normalization, Pattern},
};

use crate::{ChildList, Entry, Field, Locale, Shape, Text, cases::Case};

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
const TOGETHER: u32 = 8;
/// The shortest word that is searched for within others.
const WITHIN: usize = 3;

/// Texts of an analysis that are searched, folded.
#[derive(Debug)]
pub struct Index {
    /// Titles, topic, family and id.
    names: String,
    /// Keywords.
    keywords: String,
    /// Summaries and books.
    words: String,
    /// Labels and symbols of inputs and alternatives, and names of answers.
    inputs: String,
    /// Name and source of each case, in both languages.
    cases: Vec<String>,
}

/// An analysis that a search leaves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Found {
    /// Place among those that were searched.
    pub place: usize,
    /// The case that the words speak of.
    pub case: Option<usize>,
}

/// The analyses in which every word is found, the best match first.
pub fn find_words(indices: &[&Index], filter: &str) -> Vec<Found> {
    let phrase = folded(filter.trim());
    let words: Vec<&str> = phrase.split_whitespace().collect();
    let scored = indices.iter().enumerate().filter_map(|(place, index)| {
        let (score, case) = index.rank(&words, &phrase)?;
        Some(((score, index.mentions(&phrase)), Found { place, case }))
    });
    ranked(scored.collect())
}

/// The same; where a word is in none, those whose names have the letters in their order.
pub fn find(indices: &[&Index], filter: &str) -> Vec<Found> {
    let found = find_words(indices, filter);
    if found.is_empty() { ranked(scattered(indices, &folded(filter.trim()))) } else { found }
}

/// Returns true if a text has every word of a filter, in upper or lower case and with accents or without.
pub fn has_words(text: &str, filter: &str) -> bool {
    let text = folded(text);
    folded(filter).split_whitespace().all(|word| place(&text, word) == 4)
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
        let portuguese = Locale::portuguese().at(about.id);
        let both = |english: &'static str| [english.to_owned(), Text::from(english).render(&portuguese)];
        let family = family(entry.family());
        let names = [both(about.title), both(about.topic)].into_iter().flatten().chain([
            about.id.to_owned(),
            family.english(),
            family.render(&portuguese),
        ]);
        let books = about.sources.iter().map(|source| format!("{} {}", source.short, source.full));
        let words = both(about.summary).into_iter().chain(books);
        let mut labels = Labels::default();
        labels.fields(entry.fields());
        // The name of an answer is its label in most analyses.
        let answers: BTreeSet<&str> = cases
            .iter()
            .flat_map(|case| &case.expect)
            .map(|expected| expected.answer.split('[').next().unwrap_or_default())
            .collect();
        let answers = answers.into_iter().flat_map(|answer| {
            let label = answer.replace('_', " ");
            [Text::new(label.clone()).render(&portuguese), label]
        });
        let inputs = labels
            .words
            .iter()
            .flat_map(|label| both(label))
            .chain(labels.symbols.iter().map(|&symbol| symbol.to_owned()));
        let of_case = |case: &Case| {
            let both = |text: &Text| [text.english(), text.render(&portuguese)].join("\n");
            folded(&format!("{}\n{}", both(&case.title()), both(&case.source)))
        };
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

    /// Score of the match, and the case that matches best; `None` if a word is missing.
    fn rank(&self, words: &[&str], phrase: &str) -> Option<(u32, Option<usize>)> {
        let together = |text: &str, weight: u32| {
            if words.len() > 1 && place(text, phrase) > 0 { TOGETHER * weight } else { 0 }
        };
        let of_analysis: Vec<u32> = words
            .iter()
            .map(|word| {
                let texts = self.texts();
                texts.into_iter().map(|(text, weight)| weight * place(text, word)).max().unwrap_or(0)
            })
            .collect();
        let spaced = |text: &str| text.replace('-', " ");
        let is_phrase = |name: &str| name.rsplit('/').next().map(spaced) == Some(spaced(phrase));
        let title = if self.names.lines().any(is_phrase) { TOGETHER * NAMES } else { 0 };
        let bonus = self.texts().into_iter().map(|(text, weight)| together(text, weight)).max().unwrap_or(0);
        let bonus = bonus + title;
        let whole = of_analysis.iter().all(|score| *score > 0);
        let mut best = whole.then(|| (of_analysis.iter().sum::<u32>() + bonus, None));
        for (n, case) in self.cases.iter().enumerate() {
            let scores = words.iter().zip(&of_analysis).map(|(word, score)| {
                // Of two analyses with such a case, the one whose own words speak of it comes first.
                let of_case = CASE * place(case, word);
                of_case.max(*score) + u32::from(of_case > *score && *score > 0)
            });
            let total = scores.reduce(|sum, score| if sum == 0 || score == 0 { 0 } else { sum + score });
            let Some(total) = total.filter(|total| *total > 0) else { continue };
            let total = total + together(case, CASE).max(bonus);
            if best.is_none_or(|(score, _)| total > score) {
                best = Some((total, Some(n)));
            }
        }
        if let ([word], Some((score, _))) = (words, &mut best) {
            *score = (*score).max(KEYWORD_ALONE * place(&self.keywords, word));
        }
        best
    }
}

/// Score of a word in a text: 4 as a whole word, 3 as the beginning of one, 1 within one, 0 if absent.
fn place(text: &str, word: &str) -> u32 {
    let mut best = 0;
    for (at, _) in text.match_indices(word) {
        let begins = !text[..at].ends_with(char::is_alphanumeric);
        let ends = !text[at + word.len()..].starts_with(char::is_alphanumeric);
        best = best.max(match (begins, ends) {
            (true, true) => return 4,
            (true, false) => 3,
            (false, _) => u32::from(word.len() >= WITHIN),
        });
    }
    best
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

/// Lower case, and without the accents of the Latin alphabet.
fn folded(text: &str) -> String {
    text.chars()
        .flat_map(char::to_lowercase)
        .map(|character| match character {
            'á' | 'à' | 'â' | 'ã' | 'ä' | 'å' => 'a',
            'ç' => 'c',
            'é' | 'è' | 'ê' | 'ë' => 'e',
            'í' | 'ì' | 'î' | 'ï' => 'i',
            'ñ' => 'n',
            'ó' | 'ò' | 'ô' | 'õ' | 'ö' => 'o',
            'ú' | 'ù' | 'û' | 'ü' => 'u',
            other => other,
        })
        .collect()
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
        ] {
            assert_eq!(place(text, word), score, "{word} in {text}");
        }
        assert_eq!(folded("Vibração À"), "vibracao a");
    }

    #[test]
    fn every_word_must_be_found_and_a_case_is_named_where_it_says_more() {
        let index = Index {
            names: "slider-crank\ncursor-manivela".into(),
            keywords: "piston".into(),
            words: "beer & johnston".into(),
            inputs: "length of the rod\nl".into(),
            cases: vec!["engine\nriul".into(), "two levers\nbeer & johnston, problem 10.1".into()],
        };
        let of =
            |phrase: &str| index.rank(&phrase.split(' ').collect::<Vec<_>>(), phrase).map(|(_, case)| case);
        assert_eq!(of("manivela cursor"), Some(None));
        assert_eq!(of("piston"), Some(None));
        assert_eq!(of("rod length"), Some(None));
        assert_eq!(of("10 beer"), Some(Some(1)));
        assert_eq!(of("riul"), Some(Some(0)));
        assert_eq!(of("riul levers"), None, "no case holds both");
        assert_eq!(of("cursor nothing"), None);
    }
}
