//! Search in the list of analyses, the best matches first.
//!
//! Every word that is typed must be found, in any order: in the names of an analysis, in one of its cases, or in what
//! describes it, in either language and with accents or without. A whole word counts more than the beginning of one,
//! and that more than letters within. Where a word is in no analysis, the letters of the filter may stand scattered in
//! a title: `rotunb` finds `Rotating unbalance`.

use dalembert_core::{Locale, Text, cases::Case};
use nucleo_matcher::{
    Config, Matcher, Utf32Str,
    pattern::{AtomKind, CaseMatching, Normalization, Pattern},
};

use super::{Listing, family};

/// Weights of a word in the names of an analysis, in a case, and in its description.
const WEIGHT: (u32, u32, u32) = (8, 4, 3);
/// Weight of the words standing together as they were typed.
const TOGETHER: u32 = 8;
/// The shortest word that is searched for within others.
const WITHIN: usize = 3;

/// Everything that the filter looks in, folded.
#[derive(Debug)]
pub(super) struct Index {
    /// Titles, topic, family and id.
    names: String,
    /// Keywords, summaries and books.
    words: String,
    /// Name and source of each case, in both languages.
    cases: Vec<String>,
}

/// The places of the analyses that a filter leaves, and the case of each that it speaks of.
pub(super) fn find(listings: &[Listing], filter: &str) -> Vec<(usize, Option<usize>)> {
    let phrase = folded(filter.trim());
    let words: Vec<&str> = phrase.split_whitespace().collect();
    let mut found: Vec<(u32, usize, Option<usize>)> = listings
        .iter()
        .enumerate()
        .filter_map(|(at, listing)| {
            let (score, case) = listing.index.get_or_init(|| Index::of(listing)).rank(&words, &phrase)?;
            Some((score, at, case))
        })
        .collect();
    if found.is_empty() {
        found = scattered(listings, &phrase);
    }
    found.sort_by_key(|(score, at, _)| (std::cmp::Reverse(*score), *at));
    found.into_iter().map(|(_, at, case)| (at, case)).collect()
}

impl Index {
    fn of(listing: &Listing) -> Self {
        let about = listing.entry.about;
        let both =
            |english: &'static str| [english.to_owned(), Text::from(english).render(&Locale::portuguese())];
        let family = family(listing.entry.family());
        let names = [both(about.title), both(about.topic)].into_iter().flatten().chain([
            about.id.to_owned(),
            family.english(),
            family.render(&Locale::portuguese()),
        ]);
        let books = about.sources.iter().map(|source| format!("{} {}", source.short, source.full));
        let words = both(about.summary).into_iter().chain([about.keywords.to_owned()]).chain(books);
        let of_case = |case: &Case| {
            let both = |text: &Text| [text.english(), text.render(&Locale::portuguese())].join("\n");
            folded(&format!("{}\n{}", both(&case.title()), both(&case.source)))
        };
        let joined = |texts: &mut dyn Iterator<Item = String>| folded(&texts.collect::<Vec<_>>().join("\n"));
        Self {
            names: joined(&mut names.into_iter()),
            words: joined(&mut words.into_iter()),
            cases: listing.cases().iter().map(of_case).collect(),
        }
    }

    /// Score of the match, and the case that matches best; `None` if a word is missing.
    fn rank(&self, words: &[&str], phrase: &str) -> Option<(u32, Option<usize>)> {
        let together = |text: &str, weight: u32| {
            if words.len() > 1 && place(text, phrase) > 0 { TOGETHER * weight } else { 0 }
        };
        let of_analysis: Vec<u32> = words
            .iter()
            .map(|word| (WEIGHT.0 * place(&self.names, word)).max(WEIGHT.2 * place(&self.words, word)))
            .collect();
        let bonus = together(&self.names, WEIGHT.0).max(together(&self.words, WEIGHT.2));
        let whole = of_analysis.iter().all(|score| *score > 0);
        let mut best = whole.then(|| (of_analysis.iter().sum::<u32>() + bonus, None));
        for (n, case) in self.cases.iter().enumerate() {
            let scores = words.iter().zip(&of_analysis).map(|(word, score)| {
                // Of two analyses with such a case, the one whose own words speak of it comes first.
                let of_case = WEIGHT.1 * place(case, word);
                of_case.max(*score) + u32::from(of_case > *score && *score > 0)
            });
            let total = scores.reduce(|sum, score| if sum == 0 || score == 0 { 0 } else { sum + score });
            let Some(total) = total.filter(|total| *total > 0) else { continue };
            let total = total + together(case, WEIGHT.1).max(bonus);
            if best.is_none_or(|(score, _)| total > score) {
                best = Some((total, Some(n)));
            }
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
fn scattered(listings: &[Listing], phrase: &str) -> Vec<(u32, usize, Option<usize>)> {
    let mut matcher = Matcher::new(Config::DEFAULT);
    let pattern = Pattern::new(phrase, CaseMatching::Ignore, Normalization::Smart, AtomKind::Fuzzy);
    let score = |listing: &Listing| {
        let index = listing.index.get()?;
        let names = index.names.lines();
        names.filter_map(|name| pattern.score(Utf32Str::new(name, &mut Vec::new()), &mut matcher)).max()
    };
    let scores: Vec<Option<u32>> = listings.iter().map(score).collect();
    scores.into_iter().enumerate().filter_map(|(at, score)| Some((score?, at, None))).collect()
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
            words: "piston beer & johnston".into(),
            cases: vec!["engine\nriul".into(), "two levers\nbeer & johnston, problem 10.1".into()],
        };
        let of =
            |phrase: &str| index.rank(&phrase.split(' ').collect::<Vec<_>>(), phrase).map(|(_, case)| case);
        assert_eq!(of("manivela cursor"), Some(None));
        assert_eq!(of("piston"), Some(None));
        assert_eq!(of("10 beer"), Some(Some(1)));
        assert_eq!(of("riul"), Some(Some(0)));
        assert_eq!(of("riul levers"), None, "no case holds both");
        assert_eq!(of("cursor nothing"), None);
    }
}
