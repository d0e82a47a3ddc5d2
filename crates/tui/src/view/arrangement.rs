//! The form and the panes on a screen: which are seen, and where.
//!
//! One rule for every size. Below [`TWO_COLUMNS`] one column has what the keys act on, and a strip with the main answers;
//! from there on the form stands beside the shown pane, and from [`THREE_COLUMNS`] on pictures have a column of their
//! own. A drawing has the rows that its shape fills, a plot all that there are; the rows that a column leaves over go to
//! panes that would otherwise wait behind their tabs.

use std::{
    cell::RefCell,
    collections::{HashMap, VecDeque},
    rc::Rc,
};

use ratatui::layout::Rect;

use super::{form, page, surroundings};
use crate::{
    bench::Bench,
    layout::{self, Focus},
    model::Model,
    pane::{Content, Page, Tab},
};

/// From so many columns on inputs and results stand side by side.
const TWO_COLUMNS: u16 = 100;
/// From so many columns on there is a third column, or a second picture beside one that is alone.
const THREE_COLUMNS: u16 = 160;
/// Columns of the narrowest and of the widest form beside a pane.
const FORM: (u16, u16) = (40, 66);
/// Share of the middle one of three columns in what the form leaves: answers with their symbols beside them.
const MIDDLE: (u16, u16) = (11, 20);
/// Rows of the lowest picture, frame included, and of the lowest plot beside another picture in its column.
const PICTURE: (u16, u16) = (10, 18);
/// Rows of the lowest text that is worth a frame of its own.
const TEXT: u16 = 6;
/// Rows of the strip of main answers at most.
const STRIP: u16 = 7;

/// A pane on the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PlacedPane {
    pub(crate) tab: Tab,
    pub(crate) area: Rect,
    /// True of the second picture of a pane that has several: the keys act on the first.
    pub(crate) is_next: bool,
    /// True if the names of all tabs stand above it.
    pub(crate) has_tabs: bool,
}

/// Pages of panes of text, by the place of their tab and the columns inside their frame.
pub(super) type Pages = HashMap<(usize, u16), Rc<Page>>;

/// The parts of the screen of a problem.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Arrangement {
    pub(crate) form: Option<Rect>,
    pub(crate) panes: Vec<PlacedPane>,
    /// The pages whose lines were counted: they need not be set once more to be drawn.
    pub(super) pages: Pages,
}

/// Arranges form and panes in the body of the screen.
pub(super) fn arrange(model: &Model, bench: &Bench, focus: Focus, body: Rect) -> Arrangement {
    let screen = Screen { model, bench, pages: RefCell::default(), pictures: RefCell::default() };
    if bench.expanded || model.look.basic {
        return match focus {
            Focus::Form => Arrangement { form: Some(body), ..Arrangement::default() },
            Focus::Pane => Arrangement { panes: alone(bench, body), ..Arrangement::default() },
        };
    }
    let arrangement = if body.width < TWO_COLUMNS {
        screen.one_column(focus, body)
    } else {
        // A pane that is seen beside the results is not brought in their place.
        let usual = screen.columns(Tab::default(), body);
        let shows_tab = usual.panes.iter().any(|placed| placed.tab == bench.tab);
        if shows_tab { usual } else { screen.columns(bench.tab, body) }
    };
    Arrangement { pages: screen.pages.into_inner(), ..arrangement }
}

/// Returns true if the shown pane has a next picture, and a screen of this width room for it beside the one that is shown.
pub(crate) fn has_room_for_next(bench: &Bench, width: u16) -> bool {
    width >= THREE_COLUMNS && bench.place_of_shown(bench.tab).is_some()
}

/// The shown pane on the whole screen, the next of its pictures beside it where that is wanted.
fn alone(bench: &Bench, body: Rect) -> Vec<PlacedPane> {
    if !(bench.beside && has_room_for_next(bench, body.width)) {
        return vec![placed(bench.tab, body, true)];
    }
    let [left, right] = split(body, body.width.div_ceil(2));
    vec![placed(bench.tab, left, true), PlacedPane { is_next: true, ..placed(bench.tab, right, false) }]
}

fn placed(tab: Tab, area: Rect, has_tabs: bool) -> PlacedPane {
    PlacedPane { tab, area, is_next: false, has_tabs }
}

/// Content of a part of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Slot {
    Form,
    Pane(Tab),
}

/// A part of a column and the rows that it needs.
#[derive(Clone, Copy, Debug)]
struct Part {
    slot: Slot,
    least: u16,
    /// Rows that show all of it; of a plot, as many as there are.
    wanted: u16,
    /// True if it has what it wants before plots: a drawing, the form, and the pane that the keys act on.
    is_first: bool,
}

impl Part {
    fn grows(&self) -> bool {
        self.wanted == u16::MAX
    }
}

/// The problem that is arranged.
struct Screen<'a> {
    model: &'a Model,
    bench: &'a Bench,
    /// Pages that were set: the ways to arrange it ask for the same ones.
    pages: RefCell<Pages>,
    /// Rows of the picture in use of a tab in so many columns, or of the next one, frame included.
    pictures: RefCell<HashMap<(usize, u16, bool), Option<u16>>>,
}

/// Ways to share a wide screen out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sharing {
    /// A third column has all pictures.
    Pictures,
    /// A third column has a picture, the form another one below it.
    PictureBelowForm,
    /// The form beside everything else.
    TwoColumns,
}

impl Screen<'_> {
    /// Form or shown pane, with a strip of the main answers and what there is room for.
    fn one_column(&self, focus: Focus, body: Rect) -> Arrangement {
        let (results, shown) = (Tab::default(), self.bench.tab);
        let mut waiting = self.waiting(shown);
        let first = match focus {
            Focus::Form => self.form(body.width),
            Focus::Pane => self.pane(shown, body),
        };
        let mut parts = vec![first];
        if focus == Focus::Form && self.covers_results(shown) {
            // What is to be found stands where the main answers would.
            parts.push(self.pane(shown, body));
        } else if focus == Focus::Form || (shown != results && !self.covers_results(shown)) {
            // What grows has what the main answers leave.
            let strip = self.strip(body.width);
            parts.push(if first.grows() { Part { wanted: strip.least, ..strip } } else { strip });
        }
        if shown != results && focus == Focus::Form && !self.covers_results(shown) {
            waiting.push_front(shown);
        }
        self.fill(&mut parts, body, &mut waiting);
        let mut arrangement = Arrangement::default();
        self.place(&parts, body, &mut arrangement);
        name_tabs(&mut arrangement.panes);
        arrangement
    }

    /// The form beside a pane, and pictures beside both where there is room: of the ways to share the screen out the first
    /// that leaves no quarter of a column blank, or the one that leaves least.
    fn columns(&self, main: Tab, body: Rect) -> Arrangement {
        let all = [Sharing::Pictures, Sharing::PictureBelowForm, Sharing::TwoColumns];
        let pictures = self.pictures(&self.waiting(main));
        let serves = |sharing: &Sharing| match sharing {
            Sharing::Pictures => body.width >= THREE_COLUMNS && pictures > 0,
            Sharing::PictureBelowForm => body.width >= THREE_COLUMNS && pictures > 1,
            Sharing::TwoColumns => true,
        };
        let mut best: Option<(u16, Arrangement)> = None;
        for sharing in all.into_iter().filter(serves) {
            let (blank, arrangement) = self.shared(sharing, main, body);
            if 4 * blank <= body.height {
                return arrangement;
            }
            if best.as_ref().is_none_or(|(least, _)| blank < *least) {
                best = Some((blank, arrangement));
            }
        }
        best.map(|(_, arrangement)| arrangement).unwrap_or_default()
    }

    /// The screen shared out in one way, and the most rows that a column of it leaves blank.
    fn shared(&self, sharing: Sharing, main: Tab, body: Rect) -> (u16, Arrangement) {
        let mut waiting = self.waiting(main);
        let has_three = sharing != Sharing::TwoColumns;
        let share = if has_three { body.width * 3 / 8 } else { body.width * 9 / 20 };
        let wanted = form::columns_wanted(self.model, self.bench);
        let [left, rest] = split(body, wanted.clamp(FORM.0, FORM.1.min(share)));
        let [middle, right] =
            if has_three { split(rest, rest.width * MIDDLE.0 / MIDDLE.1) } else { [rest, Rect::ZERO] };
        let mut of_left = vec![self.form(left.width)];
        if sharing == Sharing::PictureBelowForm && waiting.len() > 1 {
            of_left.extend(waiting.remove(1).map(|tab| self.pane(tab, left)));
        }
        let mut of_right = Vec::new();
        if has_three {
            self.fill(&mut of_right, right, &mut waiting);
        }
        let mut of_middle = vec![self.pane(main, middle)];
        if main != Tab::default() && !self.covers_results(main) {
            of_middle.push(self.strip(middle.width));
        }
        self.fill(&mut of_middle, middle, &mut waiting);
        self.fill(&mut of_left, left, &mut waiting);
        let mut arrangement = Arrangement::default();
        self.place(&of_middle, middle, &mut arrangement);
        name_tabs(&mut arrangement.panes);
        self.place(&of_right, right, &mut arrangement);
        self.place(&of_left, left, &mut arrangement);
        let blank = [of_left, of_middle, of_right].iter().map(|parts| blank(parts, body.height)).max();
        (blank.unwrap_or(0), arrangement)
    }

    /// The panes that are worth seeing beside the results and another one: pictures, then text.
    fn waiting(&self, main: Tab) -> VecDeque<Tab> {
        let is_other = |tab: &Tab| *tab != Tab::default() && *tab != main;
        let useful = self.bench.tabs().into_iter().filter(is_other);
        let content = |tab: &Tab| self.bench.pane(*tab).content();
        let (pictures, others): (Vec<Tab>, Vec<Tab>) =
            useful.partition(|tab| content(tab) == Content::Picture);
        let is_shown = |tab: &Tab| content(tab) == Content::Text && !self.covers_results(main);
        pictures.into_iter().chain(others.into_iter().filter(is_shown)).collect()
    }

    fn covers_results(&self, tab: Tab) -> bool {
        self.bench.pane(tab).covers_results(&self.bench.problem)
    }

    fn pictures(&self, tabs: &VecDeque<Tab>) -> usize {
        tabs.iter().filter(|tab| self.bench.pane(**tab).content() == Content::Picture).count()
    }

    fn form(&self, width: u16) -> Part {
        let rows = form::rows_wanted(self.model, self.bench, width);
        Part { slot: Slot::Form, least: TEXT.min(rows), wanted: rows, is_first: true }
    }

    fn pane(&self, tab: Tab, area: Rect) -> Part {
        let slot = Slot::Pane(tab);
        let is_first = self.bench.focus == Focus::Pane && self.bench.tab == tab;
        match self.bench.pane(tab).content() {
            Content::Picture => match self.rows(tab, area.width, false) {
                None => Part { slot, least: PICTURE.0, wanted: u16::MAX, is_first },
                Some(rows) => {
                    let next = self.rows_of_next(tab, area.width).filter(|next| rows + next.1 <= area.height);
                    let wanted = next.map_or(rows, |(next, _)| rows + next).min(area.height);
                    Part { slot, least: PICTURE.0.min(rows), wanted, is_first: true }
                }
            },
            Content::Cells => Part { slot, least: TEXT, wanted: u16::MAX, is_first },
            Content::Text => {
                let (lines, head) = self.lines(tab, area.width);
                let rows = framed(lines);
                Part { slot, least: framed(head).max(TEXT).min(rows), wanted: rows, is_first }
            }
        }
    }

    /// The results, as far as the main answers go.
    fn strip(&self, width: u16) -> Part {
        let (lines, head) = self.lines(Tab::default(), width);
        let rows = framed(lines);
        Part {
            slot: Slot::Pane(Tab::default()),
            least: framed(head.max(1)).min(STRIP).min(rows),
            wanted: rows,
            is_first: false,
        }
    }

    /// Rows that the picture in use of a pane fills, or the next one, frame included; `None` where it is the better for
    /// every row.
    fn rows(&self, tab: Tab, width: u16, next: bool) -> Option<u16> {
        *self.pictures.borrow_mut().entry((tab.0, width, next)).or_insert_with(|| {
            let ui = surroundings(self.model, self.bench, tab, Rect::ZERO);
            let rows = self.bench.pane(tab).rows(&self.bench.problem, &ui, next, inner(width));
            rows.map(|rows| framed(rows.into()))
        })
    }

    /// Rows of the picture behind the one in use, and the least of them; `None` without one.
    fn rows_of_next(&self, tab: Tab, width: u16) -> Option<(u16, u16)> {
        let has_next = self.bench.pane(tab).pictures(&self.bench.problem) > 1;
        let rows = has_next.then(|| self.rows(tab, width, true))??;
        Some((rows, rows.min(PICTURE.1)))
    }

    /// Lines of the page of a pane in so many columns, and those of its head.
    fn lines(&self, tab: Tab, width: u16) -> (usize, usize) {
        let width = inner(width);
        let mut pages = self.pages.borrow_mut();
        let page =
            pages.entry((tab.0, width)).or_insert_with(|| Rc::new(page(self.model, self.bench, tab, width)));
        (page.lines.len(), page.head)
    }

    /// Adds panes that wait while more than a third of the rows, or enough for a picture, are left over.
    fn fill(&self, parts: &mut Vec<Part>, area: Rect, waiting: &mut VecDeque<Tab>) {
        while !parts.iter().any(Part::grows) {
            let used: u16 = parts.iter().map(|part| part.wanted).fold(0, u16::saturating_add);
            let left = area.height.saturating_sub(used);
            if left < TEXT.max(area.height / 4) {
                break;
            }
            let rest = Rect { height: left, ..area };
            let fits = |tab: &Tab| self.pane(*tab, rest).least <= left;
            let Some(at) = waiting.iter().position(fits) else { break };
            parts.extend(waiting.remove(at).map(|tab| self.pane(tab, rest)));
        }
        // A plot shares a column that has room for two pictures.
        let is_picture = |tab: &Tab| self.bench.pane(*tab).content() == Content::Picture;
        if parts.iter().filter(|part| part.grows()).count() == 1
            && let Some(tab) = waiting.front().copied().filter(is_picture)
        {
            let rows = parts.iter().map(|part| if part.grows() { PICTURE.1 } else { part.wanted });
            let used = rows.fold(0, u16::saturating_add);
            let rest = Rect { height: area.height.saturating_sub(used), ..area };
            let rows = self.rows(tab, area.width, false).unwrap_or(PICTURE.1);
            if rows.min(PICTURE.1) <= rest.height {
                waiting.pop_front();
                parts.push(self.pane(tab, rest));
            }
        }
    }

    fn place(&self, parts: &[Part], area: Rect, arrangement: &mut Arrangement) {
        let mut y = area.y;
        for (part, height) in parts.iter().zip(heights(parts, area.height)) {
            let area = Rect { y, height, ..area };
            y += height;
            match part.slot {
                _ if height == 0 => {}
                Slot::Form => arrangement.form = Some(area),
                Slot::Pane(tab) => {
                    let rows = self.rows_of_first(tab, area);
                    arrangement.panes.push(placed(tab, Rect { height: rows, ..area }, false));
                    if rows < height {
                        let area = Rect { y: area.y + rows, height: height - rows, ..area };
                        arrangement.panes.push(PlacedPane { is_next: true, ..placed(tab, area, false) });
                    }
                }
            }
        }
    }

    /// Rows of the picture in use in the area of its pane: what the next one leaves it where there is room for both.
    fn rows_of_first(&self, tab: Tab, area: Rect) -> u16 {
        let pictures = self.bench.pane(tab).pictures(&self.bench.problem);
        match (self.rows(tab, area.width, false), self.rows_of_next(tab, area.width)) {
            (Some(first), Some((next, least))) if first + least <= area.height => {
                first + area.height.saturating_sub(first + next) / 2
            }
            (None, _) if pictures > 1 && area.height >= 2 * PICTURE.1 => area.height / 2,
            _ => area.height,
        }
    }
}

/// Two columns, the left one so wide.
fn split(area: Rect, width: u16) -> [Rect; 2] {
    let width = width.min(area.width);
    [Rect { width, ..area }, Rect { x: area.x + width, width: area.width - width, ..area }]
}

/// Columns inside a frame.
fn inner(width: u16) -> u16 {
    layout::inside(Rect::new(0, 0, width, 3)).width
}

/// Rows of lines in a frame.
fn framed(lines: usize) -> u16 {
    u16::try_from(lines).unwrap_or(u16::MAX - 3).saturating_add(2).min(u16::MAX - 1)
}

/// The names of all tabs stand above the first pane.
fn name_tabs(panes: &mut [PlacedPane]) {
    if let Some(pane) = panes.first_mut() {
        pane.has_tabs = true;
    }
}

/// The rows of each part: the least of each, the first ones before later ones, then what each wants in their order, at
/// most half of what is left to a text above a plot; the rest to plots, and without one to all parts by their height.
fn heights(parts: &[Part], height: u16) -> Vec<u16> {
    let mut left = height;
    let mut heights: Vec<u16> = vec![0; parts.len()];
    // The strip below a form that is too long keeps its place.
    let later: u16 = parts.iter().skip(1).map(|part| part.least).sum();
    for (n, (part, rows)) in parts.iter().zip(&mut heights).enumerate() {
        let most = if n == 0 { left.saturating_sub(later).max(part.least.min(left)) } else { left };
        *rows = part.least.min(most);
        left -= *rows;
    }
    let growing = parts.iter().filter(|part| part.grows()).count() as u16;
    for (part, rows) in parts.iter().zip(&mut heights).filter(|(part, _)| !part.grows()) {
        let most = if growing > 0 && !part.is_first { left / 2 } else { left };
        let more = part.wanted.saturating_sub(*rows).min(most);
        *rows += more;
        left -= more;
    }
    let mut share = parts.iter().zip(&mut heights).filter(|(part, _)| part.grows());
    for n in (1..=growing).rev() {
        if let Some((_, rows)) = share.next() {
            let more = left / n;
            *rows += more;
            left -= more;
        }
    }
    // What nobody wants is shared out by height.
    let used = (height - left).max(1);
    for rows in heights.iter_mut().rev() {
        let more = (u32::from(*rows) * u32::from(height - used) / u32::from(used)) as u16;
        *rows += more.min(left);
        left -= more.min(left);
    }
    if let Some(rows) = heights.iter_mut().max() {
        *rows += left;
    }
    heights
}

/// Rows that the parts of a column leave blank.
fn blank(parts: &[Part], height: u16) -> u16 {
    if parts.is_empty() || parts.iter().any(Part::grows) {
        return 0;
    }
    height.saturating_sub(parts.iter().map(|part| part.wanted).fold(0, u16::saturating_add))
}
