//! A study: its cells, and what it found.

mod cells;

use dalembert_core::{Refusal, Text};
use ratatui::{
    buffer::Buffer,
    layout::Rect,
    style::Style,
    text::{Line, Span},
};
use unicode_width::UnicodeWidthStr;

use self::cells::{Cells, Subject};
use super::{
    about_number, answers, begun,
    columns::{padded, typed_in},
    reasons, wrap,
};
use crate::{
    ask::{Question, Reply},
    glyphs::filter_untrusted,
    intent::Intent,
    keys::{Action, KeyContext},
    look::Glyph,
    pane::{Page, Pane, Ui, register_pane},
    plot,
    problem::Problem,
};

/// A plot in fewer rows than these tells nothing.
const LEAST_CURVES: u16 = 7;

/// The pane of a study. What it finds is part of the problem, since its curves are shown among the plots.
#[derive(Debug, Default)]
pub struct Study {
    cells: Cells,
}

register_pane!(Study, 80);

impl Pane for Study {
    fn name(&self) -> &'static str {
        "Study"
    }

    fn place(&self) -> KeyContext {
        KeyContext::Cells
    }

    fn is_useful(&self, problem: &Problem) -> bool {
        problem.found.solution.as_ref().is_some_and(|found| !answers::numbers(found).is_empty())
    }

    fn page(&self, problem: &Problem, ui: &Ui<'_>, width: u16) -> Page {
        if problem.found.revealed.is_some() {
            return reasons::covered(ui, width);
        }
        if problem.found.solution.is_none() || problem.is_stale() {
            return Page::of(reasons::why_not(problem, ui, width));
        }
        self.subject(problem).map_or_else(Page::default, |subject| self.lines(&subject, problem, ui, width))
    }

    /// Shows its curves where there is room below its cells.
    fn draw(&self, problem: &Problem, ui: &Ui<'_>, room: Rect, buffer: &mut Buffer) {
        if room.height >= LEAST_CURVES
            && !problem.is_stale()
            && problem.found.revealed.is_none()
            && let Some(plot) = problem.studied()
        {
            let state = plot::PlotState { marker: ui.marker, ..plot::PlotState::default() };
            plot::render(plot, None, &state, ui.look, ui.locale, room, buffer);
        }
    }

    fn about(&self, _: &Problem, _: &Ui<'_>) -> Vec<Text> {
        vec!["also shown in Plot, with cursor and zoom".into()]
    }

    fn serves(&self, _: &Problem, action: Action) -> bool {
        match action {
            Action::Toggle => false,
            Action::Enter => !self.cells.cell().is_choice(),
            _ => true,
        }
    }

    /// Chooses what stands beside in the cell under the cursor.
    fn act(&mut self, problem: &mut Problem, _: &Ui<'_>, action: Action) -> Option<Vec<Intent>> {
        let by = if action == Action::Left { -1 } else { 1 };
        if !matches!(action, Action::Left | Action::Right) {
            return None;
        }
        let record = problem.record()?;
        let subject = self.cells.subject(&record, problem.found.solution.as_ref()?);
        self.cells.choose(self.cells.cell(), by, &subject);
        problem.found.studied = None;
        Some(vec![Intent::Ask])
    }

    fn cursor<'a>(&'a mut self, _: &'a mut Problem) -> Option<&'a mut usize> {
        Some(&mut self.cells.cursor)
    }

    fn turned_to(&mut self, problem: &mut Problem) -> Vec<Intent> {
        if begun(&mut self.cells.begins, problem) {
            problem.found.studied = None;
        }
        Vec::new()
    }

    fn cells(&self, _: &Problem) -> usize {
        self.cells.cells().len()
    }

    fn cell(&self, _: &Problem) -> Option<String> {
        let cell = self.cells.cell();
        (!cell.is_choice()).then(|| self.cells.text(cell).to_owned())
    }

    fn about_cell(&self, problem: &Problem, ui: &Ui<'_>) -> Vec<Text> {
        let cell = self.cells.cell();
        let form = match self.subject(problem).and_then(|subject| self.cells.unit(cell, &subject)) {
            Some(unit) => about_number(&unit, ui),
            None => Some(Text::new("a whole number")),
        };
        form.into_iter().chain([cell.name()]).collect()
    }

    fn typed(&mut self, problem: &mut Problem, text: String) {
        if let Some(names) = self.subject(problem).map(|subject| subject.names()) {
            self.cells.keep(names);
        }
        self.cells.set(self.cells.cell(), text);
        problem.found.studied = None;
    }

    fn question(&self, problem: &Problem) -> Option<Question> {
        let of = self.subject(problem)?;
        let plan = self.cells.plan(&of, &problem.widths(&of.inputs)).ok()?;
        Some(Question::Study { entry: problem.entry(), record: problem.record()?, plan })
    }

    fn is_answered(&self, problem: &Problem) -> bool {
        problem.found.studied.is_some()
    }

    fn answered(&mut self, problem: &mut Problem, reply: Option<Reply>) -> Vec<Intent> {
        problem.found.studied = Some(match reply {
            Some(Reply::Study(found)) => *found,
            _ => Err(Refusal::because("failed (internal error)").into()),
        });
        Vec::new()
    }

    fn forget(&mut self, problem: &mut Problem, _: bool) {
        problem.found.studied = None;
    }
}

impl Study {
    /// The subject of the study; `None` while there are no inputs or answers to choose from.
    fn subject<'p>(&self, problem: &'p Problem) -> Option<Subject<'p>> {
        Some(self.cells.subject(&problem.record()?, problem.found.solution.as_ref()?))
    }

    /// The cells and what was found; the page starts at each cell.
    fn lines(&self, of: &Subject<'_>, problem: &Problem, ui: &Ui<'_>, width: u16) -> Page {
        let (look, study) = (ui.look, &self.cells);
        let cells = usize::from(width).max(1);
        let locale = &ui.locale.ascii(look.ascii);
        let mut page = Page::default();
        let all = study.cells();
        let label =
            all.iter().map(|cell| cell.name().render(locale).width()).max().unwrap_or(0).min(cells / 2);
        let room = cells.saturating_sub(label + 6).max(1);
        let plan = study.plan(of, &problem.widths(&of.inputs));
        for cell in all {
            page.starts.push(page.lines.len());
            let under_cursor = ui.focused && cell == study.cell();
            let pointer = if under_cursor { look.glyph(Glyph::Pointer) } else { " " };
            let name = look.shortened(&cell.name().render(locale), label);
            let mut line = Line::from(vec![
                Span::styled(format!("{pointer} "), look.border(under_cursor)),
                Span::styled(padded(&name, label), if under_cursor { look.title() } else { Style::new() }),
                Span::raw("  "),
            ]);
            match ui.edit.filter(|_| under_cursor) {
                Some(input) => line.extend(typed_in(input, room.min(24))),
                None => {
                    let shown = study.shown(cell, of, locale.style.decimal).render(locale);
                    let shown = look.shortened(&filter_untrusted(&shown), room);
                    let typed = cell.is_choice() || !study.text(cell).trim().is_empty();
                    let style = match (under_cursor, typed) {
                        (true, _) => look.focus(),
                        (false, true) => Style::new(),
                        (false, false) => look.dim(),
                    };
                    line.push_span(Span::styled(shown, style));
                    if cell.is_choice() {
                        line.push_span(Span::styled(format!(" {}", look.glyph(Glyph::Open)), look.dim()));
                    }
                }
            }
            page.lines.push(line);
            if let Err((wrong, why)) = &plan
                && *wrong == cell
            {
                let why = filter_untrusted(&why.render(locale)).into_owned();
                page.lines.extend(wrap::hanging(vec![Span::raw("    ")], &why, look.error(), cells));
            }
        }
        page.lines.push(Line::default());
        let dim = |word: &'static str| Line::styled(Text::new(word).render(locale), look.dim());
        match &problem.found.studied {
            _ if plan.is_err() => {}
            _ if ui.waits => page.lines.push(dim("solving")),
            None => page.lines.push(dim("cancelled")),
            Some(Err(error)) => page.lines.extend(reasons::refusal(None, error, look, locale, width)),
            Some(Ok(found)) => {
                for text in &found.remarks {
                    page.lines.extend(wrap::words(&text.render(locale), cells).into_iter().map(|line| {
                        Line::styled(line, if found.numbers.is_empty() { look.dim() } else { look.answer() })
                    }));
                }
            }
        }
        page
    }
}
