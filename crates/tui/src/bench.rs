//! A problem on the screen: its panes, the one that is shown, and what the keys act on.

use std::any::Any;

use dalembert_core::{Locale, Text};

use crate::{
    field::FieldMode,
    glyphs::filter_untrusted,
    keys::KeyContext,
    layout::Focus,
    pane::{Pane, Tab},
    panes,
    plot::Marker,
    problem::{Freshness, Problem},
    text_entry::TextEntry,
};

/// State of the statement above the form.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StatementState {
    /// True if its heading alone is seen.
    pub is_folded: bool,
    /// The first line that is seen.
    pub first: usize,
}

/// A problem on the screen.
#[derive(Debug)]
pub struct Bench {
    /// The problem.
    pub problem: Problem,
    /// The panes, by the places of their tabs.
    pub panes: Vec<Box<dyn Pane>>,
    /// The first line that each shows.
    pub scroll: Vec<usize>,
    /// The pane that is shown.
    pub tab: Tab,
    /// The part of the screen that the keys act on.
    pub focus: Focus,
    /// True if that has the whole screen.
    pub expanded: bool,
    /// True if the next of its pictures stands beside it then.
    pub beside: bool,
    /// The marker that curves are drawn with.
    pub marker: Marker,
    /// The cell of the shown pane that is being typed in.
    pub edit: Option<TextEntry>,
    /// The part of the file that the panes were last turned to, by its name.
    pub turned_to: String,
    /// The number of the job that a pane waits for, and which.
    pub pending: Option<(u64, Tab)>,
    /// State of the statement above the form.
    pub statement: StatementState,
    /// Field mode, while the problem is worked on in it.
    pub field: Option<FieldMode>,
}

impl Bench {
    /// A problem, drawn with some marker.
    pub fn new(problem: Problem, marker: Marker) -> Self {
        let panes = panes::all();
        Self {
            problem,
            scroll: vec![0; panes.len()],
            panes,
            tab: Tab::default(),
            focus: Focus::Form,
            expanded: false,
            beside: false,
            marker,
            edit: None,
            turned_to: String::new(),
            pending: None,
            statement: StatementState::default(),
            field: None,
        }
    }

    /// Every tab, from left to right.
    pub fn all_tabs(&self) -> impl Iterator<Item = Tab> + use<> {
        (0..self.panes.len()).map(Tab)
    }

    /// A pane.
    pub fn pane(&self, tab: Tab) -> &dyn Pane {
        &*self.panes[tab.0]
    }

    /// The pane that is shown.
    pub fn shown(&self) -> &dyn Pane {
        self.pane(self.tab)
    }

    /// True if what was found is not to be seen: the user solves by hand, or the shown pane asks for it.
    pub fn is_covered(&self) -> bool {
        self.problem.found.revealed.is_some() || self.shown().covers_results(&self.problem)
    }

    /// The tab of a name.
    pub fn tab_named(&self, name: &str) -> Option<Tab> {
        self.all_tabs().find(|tab| self.pane(*tab).name() == name)
    }

    /// A pane by its type.
    pub fn find<P: Pane>(&self) -> Option<&P> {
        self.panes.iter().find_map(|pane| (&**pane as &dyn Any).downcast_ref())
    }

    /// The tabs of the panes that have something to show; the first and the last always do.
    pub fn tabs(&self) -> Vec<Tab> {
        self.all_tabs().filter(|tab| self.pane(*tab).is_useful(&self.problem)).collect()
    }

    /// The place where keys are typed.
    pub fn place(&self) -> KeyContext {
        if let Some(field) = &self.field {
            return field.place(&self.problem);
        }
        match self.focus {
            Focus::Form if self.problem.inputs.form.edit.is_some() => KeyContext::Edit,
            Focus::Form => KeyContext::Form,
            Focus::Pane if self.edit.is_some() => KeyContext::Cell,
            Focus::Pane => self.shown().place(),
        }
    }

    /// To where these keys are typed; whether that is there.
    pub fn go_to(&mut self, place: KeyContext) -> bool {
        if place == KeyContext::Form {
            self.focus = Focus::Form;
            return true;
        }
        let has_place = |tab: &Tab| self.pane(*tab).place() == place;
        let tab = match place {
            KeyContext::Pane => self.tab,
            _ if has_place(&self.tab) => self.tab,
            _ => self.all_tabs().find(has_place).unwrap_or(self.tab),
        };
        let is_there = self.tabs().contains(&tab);
        if is_there {
            (self.focus, self.tab) = (Focus::Pane, tab);
        }
        is_there
    }

    /// The part of the page of a pane that its cursor stands on, where it has one.
    pub fn cursor(&mut self, tab: Tab) -> Option<&mut usize> {
        self.panes[tab.0].cursor(&mut self.problem)
    }

    /// The tab of the pane that edits a plan.
    pub fn tab_of_plan(&self) -> Option<Tab> {
        self.all_tabs().find(|tab| self.pane(*tab).place() == KeyContext::Plan)
    }

    /// The place of the picture that a pane shows, counted from 1, and their number; `None` of a single one.
    pub fn place_of_shown(&self, tab: Tab) -> Option<(usize, usize)> {
        let pane = self.pane(tab);
        let of = pane.pictures(&self.problem);
        (of > 1).then(|| (pane.shown().min(of - 1) + 1, of))
    }

    /// The pane with a picture that moves.
    pub fn animated(&self) -> Option<Tab> {
        self.all_tabs().find(|tab| self.pane(*tab).frames(&self.problem).0 > 1)
    }

    /// True if a pane waits for its answer. One that has none and does not wait was stopped.
    pub fn waits(&self, tab: Tab) -> bool {
        self.pending.is_some_and(|(_, asked)| asked == tab)
    }

    /// True if a job is under way for it.
    pub fn is_working(&self) -> bool {
        matches!(self.problem.found.state, Freshness::Solving(_)) || self.pending.is_some()
    }

    /// Gives up the job that is under way, and what was found before it; the pane that waited.
    pub fn stop(&mut self) -> Option<Tab> {
        let (_, tab) = self.pending.take()?;
        self.panes[tab.0].forget(&mut self.problem, false);
        Some(tab)
    }

    /// The inputs are others: what was found for them counts no more.
    pub fn forget(&mut self) {
        self.pending = None;
        for pane in &mut self.panes {
            pane.forget(&mut self.problem, true);
        }
    }

    /// The name of the problem among others: its analysis, and its file or its title.
    pub fn name_among(&self, locale: &Locale) -> String {
        let title = Text::from(self.problem.entry().about.title).render(locale);
        let document = &self.problem.document;
        let own = match document.file.as_ref().and_then(|file| file.path.file_name()) {
            Some(file) => file.to_string_lossy().into_owned(),
            None => document.title.clone(),
        };
        if own.is_empty() {
            return title;
        }
        format!("{title} ({})", filter_untrusted(&own).replace('\n', " "))
    }
}
