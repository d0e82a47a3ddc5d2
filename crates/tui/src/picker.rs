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
    /// The same in lower case: a phrase is looked for at each key, in every analysis.
    lowered: String,
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
        let mut words = vec![
            about.id.to_owned(),
            about.keywords.to_owned(),
            about.summary.to_owned(),
            in_portuguese(about.summary),
        ];
        words.extend(about.sources.iter().map(|source| format!("{} {}", source.short, source.full)));
        words.extend(cases.iter().map(|case| format!("{} {}", case.name, case.source)));
        let words = words.join("\n");
        Self { entry, cases, lowered: words.to_lowercase(), words }
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

/// Whole words of the title come first, then whole words of anything else (those that stand together as they were
/// typed before those that are scattered), then titles that match with gaps; other words do not match with gaps, or
/// nearly everything would.
fn visible(listings: &[Listing], filter: &str) -> Vec<usize> {
    if filter.trim().is_empty() {
        return (0..listings.len()).collect();
    }
    let mut matcher = Matcher::new(Config::DEFAULT);
    let pattern = |kind| Pattern::new(filter, CaseMatching::Ignore, Normalization::Smart, kind);
    let (with_gaps, as_is) = (pattern(AtomKind::Fuzzy), pattern(AtomKind::Substring));
    let phrase = filter.trim().to_lowercase();
    let mut of =
        |pattern: &Pattern, text: &str| pattern.score(Utf32Str::new(text, &mut Vec::new()), &mut matcher);
    let mut rank = |listing: &Listing| {
        let titles = [Language::English, Language::Portuguese]
            .map(|language| listing.title(&Locale { language, ..Locale::default() }));
        let names = [titles[0].as_str(), titles[1].as_str(), listing.entry.about.id];
        let best = |pattern: &Pattern, of: &mut dyn FnMut(&Pattern, &str) -> Option<u32>| {
            names.iter().filter_map(|name| of(pattern, name)).max()
        };
        let together = || u8::from(listing.lowered.contains(&phrase));
        let exact = best(&as_is, &mut of).map(|score| (3, score));
        exact
            .or_else(|| of(&as_is, &listing.words).map(|score| (1 + together(), score)))
            .or_else(|| best(&with_gaps, &mut of).map(|score| (0, score)))
    };
    let mut found: Vec<((u8, u32), usize)> =
        listings.iter().enumerate().filter_map(|(at, listing)| Some((rank(listing)?, at))).collect();
    found.sort_by_key(|(rank, at)| (std::cmp::Reverse(*rank), *at));
    found.into_iter().map(|(_, at)| at).collect()
}
