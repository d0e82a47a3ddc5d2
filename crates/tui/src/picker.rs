//! The list of analyses: what can be picked, and what a filter leaves of it.

use dalembert_core::{
    Entry, Language, Locale, Solution, Text,
    cases::{self, Case},
};
use nucleo_matcher::{
    Config, Matcher, Utf32Str,
    pattern::{AtomKind, CaseMatching, Normalization, Pattern},
};
use tui_input::Input;

/// An analysis that can be picked.
#[derive(Debug)]
pub struct Listing {
    /// The analysis.
    pub entry: &'static Entry,
    /// Its published cases.
    pub cases: Vec<Case>,
    /// Everything that the filter looks in beside the name, in both languages.
    words: String,
}

/// What is chosen in the list.
#[derive(Debug, Default)]
pub struct Picker {
    /// What is looked for.
    pub filter: Input,
    /// Whether keys go to the filter.
    pub typing: bool,
    /// The chosen line, among those that the filter leaves.
    pub chosen: usize,
    /// The chosen case, while the cases have the focus.
    pub case: Option<usize>,
    /// The first case of the chosen analysis, solved.
    pub preview: Option<Preview>,
}

/// A solved case beside the list.
#[derive(Debug)]
pub struct Preview {
    /// Of which analysis.
    pub id: &'static str,
    /// Of which case.
    pub case: usize,
    /// The job that solves it.
    pub generation: u64,
    /// What it found.
    pub solution: Option<Solution>,
}

impl Listing {
    /// The listing of an analysis.
    pub fn of(entry: &'static Entry) -> Self {
        let cases = cases::cases(entry).unwrap_or_default();
        let about = entry.about;
        let in_portuguese = |text: &'static str| Text::from(text).render(&Locale::portuguese());
        let mut words =
            vec![about.id.to_owned(), about.keywords.to_owned(), about.summary.to_owned(), in_portuguese(about.summary)];
        words.extend(about.sources.iter().map(|source| format!("{} {}", source.short, source.full)));
        words.extend(cases.iter().map(|case| format!("{} {}", case.name, case.source)));
        Self { entry, cases, words: words.join("\n") }
    }

    /// Its title.
    pub fn title(&self, locale: &Locale) -> String {
        Text::from(self.entry.about.title).render(locale)
    }
}

impl Picker {
    /// The places of the analyses that the filter leaves, the best first.
    pub fn visible(&self, listings: &[Listing]) -> Vec<usize> {
        visible(listings, self.filter.value())
    }

    /// The chosen analysis.
    pub fn chosen<'l>(&self, listings: &'l [Listing]) -> Option<&'l Listing> {
        self.visible(listings).get(self.chosen).map(|at| &listings[*at])
    }
}

/// The name of a family for people.
pub fn family(id: &str) -> Text {
    Text::from(match id {
        "balancing" => "Balancing",
        "rigid-body" => "Rigid bodies",
        "vibration" => "Vibration",
        "virtual-work" => "Virtual work",
        _ => return Text::new(id.to_owned()),
    })
}

/// The titles may match with gaps; the other words only as they are, or nearly everything would match.
fn visible(listings: &[Listing], filter: &str) -> Vec<usize> {
    if filter.trim().is_empty() {
        return (0..listings.len()).collect();
    }
    let mut matcher = Matcher::new(Config::DEFAULT);
    let pattern = |kind| Pattern::new(filter, CaseMatching::Ignore, Normalization::Smart, kind);
    let (with_gaps, as_is) = (pattern(AtomKind::Fuzzy), pattern(AtomKind::Substring));
    let mut score = |listing: &Listing| {
        let mut of = |pattern: &Pattern, text: &str| pattern.score(Utf32Str::new(text, &mut Vec::new()), &mut matcher);
        let names = [Language::English, Language::Portuguese].map(|language| {
            let locale = Locale { language, ..Locale::default() };
            of(&with_gaps, &listing.title(&locale)).map(|score| 2 * score)
        });
        names.into_iter().flatten().chain(of(&with_gaps, listing.entry.about.id)).chain(of(&as_is, &listing.words)).max()
    };
    let mut found: Vec<(u32, usize)> =
        listings.iter().enumerate().filter_map(|(at, listing)| Some((score(listing)?, at))).collect();
    found.sort_by_key(|(score, at)| (std::cmp::Reverse(*score), *at));
    found.into_iter().map(|(_, at)| at).collect()
}
