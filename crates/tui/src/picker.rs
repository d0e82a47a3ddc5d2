//! The list of analyses: what can be picked, as a tree of families and topics, or as what a filter leaves of it.

use std::{
    cell::{OnceCell, RefCell},
    collections::BTreeSet,
};

use dalembert_core::{
    Entry, Language, Locale, Solution, Text,
    cases::{self, Case},
    exercises::{Exercise, Exercises},
    search::{self, Found, Index},
};
use tui_input::Input;

use crate::{
    field::ANALYSIS,
    remembered::{Progress, Remembered},
    solver::CheckedCase,
};

/// Heading of field balancing.
const FIELD: &str = "Field balancing, step by step";
/// Topics are open from the start in a list of so few analyses.
const FEW: usize = 12;

/// An analysis that can be picked.
#[derive(Debug)]
pub struct Listing {
    /// The analysis.
    pub entry: &'static Entry,
    /// Published cases; read on first use, or the first screen would wait for all.
    cases: OnceCell<Vec<Case>>,
    /// They compared with what was printed, once that is done.
    pub checked: Option<Vec<CheckedCase>>,
    /// Everything that the filter looks in; made when somebody types the first filter.
    index: OnceCell<Index>,
}

/// Selection in the list of analyses.
#[derive(Debug, Default)]
pub struct Picker {
    /// Search text.
    pub filter: Input,
    /// True if keys go to the search text.
    pub typing: bool,
    /// The chosen row.
    pub chosen: usize,
    /// The chosen case, while the cases have the focus.
    pub case: Option<usize>,
    /// The case that is shown of the chosen analysis, solved.
    pub preview: Option<Preview>,
    /// The headings that were opened, or folded, by hand.
    pub turned: BTreeSet<Heading>,
    /// The filter that was searched for last, and what it found: the rows are asked for several times at each key.
    found: RefCell<(String, Vec<Found>)>,
}

/// A row of the list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Row {
    /// A heading.
    Heading(Heading),
    /// Something that can be opened.
    Leaf(Leaf),
}

/// Something that can be opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Leaf {
    /// The heading it stands under; `None` of what a filter found.
    pub under: Option<Heading>,
    /// The place of its analysis among the listings.
    pub listing: usize,
    /// The case that it means; `None` is the first, and whatever is open already.
    pub case: Option<usize>,
}

impl Leaf {
    /// True if it is an exercise of a list.
    pub fn is_exercise(self) -> bool {
        matches!(self.under, Some(Heading::Set(_))) && self.case.is_some()
    }
}

/// Heading of a group of rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Heading {
    /// Pinned analyses.
    Pinned,
    /// Analyses that were opened last.
    Recent,
    /// Lists of exercises.
    Exercises,
    /// Field balancing, step by step: it is begun, not opened.
    Field,
    /// One of them.
    Set(usize),
    /// A family.
    Family(&'static str),
    /// A topic of a family.
    Topic(&'static str, &'static str),
}

/// Data of the rows of the list.
#[derive(Clone, Copy, Debug)]
pub struct Contents<'m> {
    /// The analyses.
    pub listings: &'m [Listing],
    /// The lists of exercises.
    pub sets: &'m [Exercises],
    /// Pinned and recent analyses, and how far the exercises are done.
    pub remembered: &'m Remembered,
    /// In the order of this language.
    pub locale: &'m Locale,
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
    /// Solution.
    pub solution: Option<Solution>,
}

impl Listing {
    /// The listing of an analysis.
    pub fn of(entry: &'static Entry) -> Self {
        Self { entry, cases: OnceCell::new(), checked: None, index: OnceCell::new() }
    }

    /// Published cases.
    pub fn cases(&self) -> &[Case] {
        self.cases.get_or_init(|| cases::cases(self.entry).unwrap_or_default())
    }

    /// Title.
    pub fn title(&self, locale: &Locale) -> String {
        Text::from(self.entry.about.title).render(&locale.at(self.entry.about.id))
    }

    pub(crate) fn index(&self) -> &Index {
        self.index.get_or_init(|| Index::of(self.entry, self.cases()))
    }

    fn topic(&self) -> Heading {
        Heading::Topic(self.entry.family(), self.entry.about.topic)
    }
}

impl Picker {
    /// The rows that are shown.
    pub fn rows(&self, of: Contents<'_>) -> Vec<Row> {
        let filter = self.filter.value();
        if filter.trim().is_empty() {
            return self.tree(of);
        }
        let mut found = self.found.borrow_mut();
        if found.0 != filter {
            let indices: Vec<&Index> = of.listings.iter().map(Listing::index).collect();
            *found = (filter.to_owned(), search::find(&indices, filter));
        }
        let leaf = |found: &Found| Leaf { under: None, listing: found.place, case: found.case };
        let field = of.leads_to_field(filter).then_some(Row::Heading(Heading::Field));
        let exercises = of.exercises_of_lists(filter).into_iter().map(Row::Leaf);
        field.into_iter().chain(exercises).chain(found.1.iter().map(|found| Row::Leaf(leaf(found)))).collect()
    }

    /// The chosen row.
    pub fn chosen(&self, of: Contents<'_>) -> Option<Row> {
        let rows = self.rows(of);
        rows.get(self.chosen).or(rows.last()).copied()
    }

    /// Returns true if the group under a heading is expanded.
    pub fn is_open(&self, heading: Heading, listings: &[Listing]) -> bool {
        let from_the_start = match heading {
            Heading::Pinned | Heading::Recent | Heading::Family(_) => true,
            Heading::Exercises | Heading::Set(_) | Heading::Field => false,
            Heading::Topic(..) => listings.len() <= FEW,
        };
        from_the_start != self.turned.contains(&heading)
    }

    /// Opens a heading, or folds it.
    pub fn turn(&mut self, heading: Heading) {
        if !self.turned.remove(&heading) {
            self.turned.insert(heading);
        }
    }

    /// Chooses an analysis in its topic, which is opened for it.
    pub fn show(&mut self, listing: usize, of: Contents<'_>) {
        let Some(entry) = of.listings.get(listing).map(|listing| listing.entry) else { return };
        let topic = of.listings[listing].topic();
        for heading in [Heading::Family(entry.family()), topic] {
            if !self.is_open(heading, of.listings) {
                self.turn(heading);
            }
        }
        let wanted = Row::Leaf(Leaf { under: Some(topic), listing, case: None });
        self.chosen = self.tree(of).iter().position(|row| *row == wanted).unwrap_or(0);
    }

    fn tree(&self, of: Contents<'_>) -> Vec<Row> {
        let mut rows = Vec::new();
        for heading in of.headings() {
            self.grow(heading, of, &mut rows);
        }
        rows
    }

    fn grow(&self, heading: Heading, of: Contents<'_>, rows: &mut Vec<Row>) {
        rows.push(Row::Heading(heading));
        if self.is_open(heading, of.listings) {
            of.below(heading).into_iter().for_each(|inner| self.grow(inner, of, rows));
            rows.extend(of.leaves(heading).into_iter().map(Row::Leaf));
        }
    }
}

impl<'m> Contents<'m> {
    /// The headings of the first level that have something under them.
    pub fn headings(self) -> Vec<Heading> {
        let mut headings = vec![Heading::Pinned, Heading::Recent, Heading::Exercises];
        headings.retain(|heading| !self.below(*heading).is_empty() || !self.leaves(*heading).is_empty());
        headings.extend(self.place(ANALYSIS).map(|_| Heading::Field));
        for listing in self.listings {
            let family = Heading::Family(listing.entry.family());
            if !headings.contains(&family) {
                headings.push(family);
            }
        }
        headings
    }

    /// True if a filter has the words of the heading of field balancing, in either language, and not only `balancing`.
    fn leads_to_field(self, filter: &str) -> bool {
        let is_known = self.place(ANALYSIS).is_some();
        is_known
            && in_any_language(|locale| {
                let name = Text::from(FIELD).render(locale);
                let balancing = search::family("balancing").render(locale);
                search::has_words(&name, filter) && !search::has_words(&balancing, filter)
            })
    }

    /// The exercises of the lists that a filter names, as exercise lists or by two words of a title, in either language.
    /// One word, as of *Mechanical vibration*, asks for analyses.
    fn exercises_of_lists(self, filter: &str) -> Vec<Leaf> {
        let is_one_word = filter.split_whitespace().nth(1).is_none();
        let is_named = |heading: &Heading| {
            in_any_language(|locale| {
                let of = Contents { locale, ..self };
                search::has_words(&of.name(Heading::Exercises), filter)
                    || !is_one_word && search::has_words(&of.name(*heading), filter)
            })
        };
        self.below(Heading::Exercises).into_iter().filter(is_named).flat_map(|set| self.leaves(set)).collect()
    }

    /// The headings under a heading.
    pub fn below(self, heading: Heading) -> Vec<Heading> {
        match heading {
            Heading::Exercises => {
                let known = |set: &usize| self.exercises(*set).next().is_some();
                (0..self.sets.len()).filter(known).map(Heading::Set).collect()
            }
            Heading::Family(family) => {
                let of_family = self.listings.iter().filter(|listing| listing.entry.family() == family);
                let mut topics: Vec<Heading> = Vec::new();
                for topic in of_family.map(Listing::topic) {
                    if !topics.contains(&topic) {
                        topics.push(topic);
                    }
                }
                topics.sort_by_cached_key(|topic| self.name(*topic));
                topics
            }
            _ => Vec::new(),
        }
    }

    /// Entries of a heading itself.
    pub fn leaves(self, heading: Heading) -> Vec<Leaf> {
        let leaf = |listing, case| Leaf { under: Some(heading), listing, case };
        let by_id = |id: &String| Some(leaf(self.place(id)?, None));
        match heading {
            Heading::Pinned => self.remembered.pinned.iter().filter_map(by_id).collect(),
            Heading::Recent => {
                let pinned = &self.remembered.pinned;
                let recent = self.remembered.recent.iter().filter(|id| !pinned.contains(id));
                recent.filter_map(by_id).collect()
            }
            Heading::Set(set) => {
                let of_case = |(listing, exercise): (usize, &Exercise)| {
                    let cases = self.listings[listing].cases();
                    let case = match exercise.case.as_str() {
                        "" => 0,
                        name => cases.iter().position(|case| case.is_named(name))?,
                    };
                    Some(leaf(listing, Some(case)))
                };
                self.exercises(set).filter_map(of_case).collect()
            }
            Heading::Topic(..) => {
                let places = 0..self.listings.len();
                places.filter(|at| self.listings[*at].topic() == heading).map(|at| leaf(at, None)).collect()
            }
            Heading::Exercises | Heading::Family(_) | Heading::Field => Vec::new(),
        }
    }

    /// The exercises of a list whose analyses are known, each with the place of that.
    ///
    /// No case is read for it, or the first screen would wait for all that are named in a list.
    fn exercises(self, set: usize) -> impl Iterator<Item = (usize, &'m Exercise)> {
        let exercises = self.sets.get(set).into_iter().flat_map(|set| &set.list);
        exercises.filter_map(move |exercise| Some((self.place(&exercise.analysis)?, exercise)))
    }

    /// Number of analyses or exercises under a heading, and number of those completed.
    pub fn count(self, heading: Heading) -> (usize, usize) {
        let (own, done) = match heading {
            Heading::Set(set) => {
                let is_done = |(listing, exercise): &(usize, &Exercise)| {
                    let first = || self.listings[*listing].cases().first().map_or("", |case| &case.name);
                    let case = if exercise.case.is_empty() { first() } else { &exercise.case };
                    self.remembered.progress(&exercise.analysis, case).is_done()
                };
                (self.exercises(set).count(), self.exercises(set).filter(is_done).count())
            }
            _ => (self.leaves(heading).len(), 0),
        };
        self.below(heading)
            .into_iter()
            .map(|inner| self.count(inner))
            .fold((own, done), |(all, done), (more, more_done)| (all + more, done + more_done))
    }

    /// Progress of an exercise.
    pub fn progress(self, leaf: Leaf) -> Progress {
        let Some(listing) = self.listings.get(leaf.listing) else { return Progress::NotBegun };
        let case = leaf.case.and_then(|case| listing.cases().get(case));
        case.map_or(Progress::NotBegun, |case| self.remembered.progress(listing.entry.about.id, &case.name))
    }

    /// Title of a heading.
    pub fn name(self, heading: Heading) -> String {
        match heading {
            Heading::Pinned => Text::from("Pinned analyses").render(self.locale),
            Heading::Recent => Text::from("Recent analyses").render(self.locale),
            Heading::Exercises => Text::from("Exercise lists").render(self.locale),
            Heading::Field => Text::from(FIELD).render(self.locale),
            Heading::Set(set) => {
                self.sets.get(set).map_or_else(String::new, |set| set.title(self.locale.language).to_owned())
            }
            Heading::Family(family) => search::family(family).render(self.locale),
            Heading::Topic(_, topic) => Text::from(topic).render(self.locale),
        }
    }

    fn place(self, id: &str) -> Option<usize> {
        self.listings.iter().position(|listing| listing.entry.about.id == id)
    }
}

/// Returns true if something holds in one of the languages.
fn in_any_language(holds: impl Fn(&Locale) -> bool) -> bool {
    Language::ALL.map(Locale::of).iter().any(holds)
}

impl Heading {
    /// The heading it stands under.
    pub fn under(self) -> Option<Heading> {
        match self {
            Heading::Set(_) => Some(Heading::Exercises),
            Heading::Topic(family, _) => Some(Heading::Family(family)),
            _ => None,
        }
    }
}

impl Row {
    /// The heading it stands under.
    pub fn under(self) -> Option<Heading> {
        match self {
            Row::Heading(heading) => heading.under(),
            Row::Leaf(leaf) => leaf.under,
        }
    }

    /// Nesting depth.
    pub fn depth(self) -> usize {
        std::iter::successors(self.under(), |heading| heading.under()).count()
    }
}
