//! The drawings, animations and scenes in space, one at a time.

use std::borrow::Cow;

use dalembert_core::{Drawing as Picture, Exhibit, Locale, Text, Viewpoint3};
use dalembert_report::figure;
use ratatui::{
    buffer::Buffer,
    layout::Rect,
    text::{Line, Span},
};

use super::reasons;
use crate::{
    drawing,
    intent::Intent,
    keys::{
        Action, KeyContext, PaneKeys,
        tables::{DOWN, LEFT, RIGHT, UP, bind, typed},
        turned,
    },
    look::Glyph,
    pane::{Content, Pane, Ui, register_pane},
    pixels::Picture as Pixels,
    problem::Problem,
    text::width,
};

/// Keys of the pane.
static KEYS: PaneKeys = PaneKeys {
    id: "drawing",
    name: "Drawing",
    table: &[&[
        bind(Action::Play, &[typed(' ')], "play or pause the animation", "animation"),
        bind(Action::Left, LEFT, "rotate a 3-D scene to the left", "rotate"),
        bind(Action::Right, RIGHT, "rotate a 3-D scene to the right", ""),
        bind(Action::Up, UP, "rotate a 3-D scene upwards", ""),
        bind(Action::Down, DOWN, "rotate a 3-D scene downwards", ""),
        bind(Action::UsualView, &[typed('i')], "restore the view of a 3-D scene", ""),
        bind(Action::NextExhibit, &[typed('n')], "next plot or drawing", ""),
    ]],
};

/// The angle that a key goes round a scene by: ten degrees.
const TURN: f64 = std::f64::consts::PI / 18.0;
/// A drawing that has no more rows than this has none to spare for the bar of an animation.
const LEAST_UNDER_BAR: u16 = 5;

/// The pane of drawings.
#[derive(Debug, Default)]
pub struct Drawing {
    /// The drawing that is shown, of several.
    at: usize,
    /// The frame that is shown of an animation.
    frame: usize,
    /// From where a scene in space is seen, where it was turned.
    view: Option<Viewpoint3>,
}

register_pane!(Drawing, 40);

impl Pane for Drawing {
    fn name(&self) -> &'static str {
        "Drawing"
    }

    fn place(&self) -> KeyContext {
        KeyContext::Own(&KEYS)
    }

    fn content(&self) -> Content {
        Content::Picture
    }

    fn is_useful(&self, problem: &Problem) -> bool {
        problem.drawings().next().is_some()
    }

    fn draw(&self, problem: &Problem, ui: &Ui<'_>, room: Rect, buffer: &mut Buffer) -> Vec<Pixels> {
        let Some(sketch) = self.sketch(problem) else {
            reasons::draw_nothing(problem, ui, room, buffer);
            return Vec::new();
        };
        let mut room = reasons::draw_stale(problem, ui, room, buffer);
        let (frames, _) = sketch.frames();
        if frames > 1 && !problem.is_stale() && room.height > LEAST_UNDER_BAR {
            room.height -= 1;
            let bar = Rect { y: room.bottom(), height: 1, ..room };
            let begins_at_given = matches!(sketch, Exhibit::Animation(moving) if moving.over.is_some());
            animation_bar(ui, (self.frame % frames, frames), begins_at_given, bar, buffer);
        }
        let Some(seen) = self.seen(problem, ui.covered) else {
            reasons::draw_nothing(problem, ui, room, buffer);
            return Vec::new();
        };
        let placed = drawing::render(&seen, ui.look, ui.locale, room, buffer);
        reasons::dim_stale(problem, ui, room, placed.picture.into_iter().collect(), buffer)
    }

    fn draw_next(&self, problem: &Problem, ui: &Ui<'_>, room: Rect, buffer: &mut Buffer) -> Vec<Pixels> {
        let Some(seen) = self.next(problem).seen(problem, ui.covered) else { return Vec::new() };
        let placed = drawing::render(&seen, ui.look, ui.locale, room, buffer);
        reasons::dim_stale(problem, ui, room, placed.picture.into_iter().collect(), buffer)
    }

    fn about(&self, problem: &Problem, ui: &Ui<'_>) -> Vec<Text> {
        let key = ui.key(self.place(), Action::NextExhibit);
        let several = self.pictures(problem) > 1;
        several.then(|| Text::new("{key} next drawing").with("key", key)).into_iter().collect()
    }

    fn serves(&self, problem: &Problem, action: Action) -> bool {
        action != Action::Left || matches!(self.sketch(problem), Some(Exhibit::Scene(_)))
    }

    fn act(&mut self, problem: &mut Problem, _: &Ui<'_>, action: Action) -> Option<Vec<Intent>> {
        let drawings = self.pictures(problem);
        let (around, up) = match action {
            Action::Left => (-TURN, 0.0),
            Action::Right => (TURN, 0.0),
            Action::Up => (0.0, TURN),
            Action::Down => (0.0, -TURN),
            Action::UsualView => (0.0, 0.0),
            Action::NextExhibit if drawings < 2 => return Some(Intent::say("no other drawing")),
            Action::NextExhibit => {
                self.at = turned(self.at, 1, drawings);
                self.view = None;
                return Some(Vec::new());
            }
            _ => return None,
        };
        let Some(Exhibit::Scene(scene)) = self.sketch(problem) else {
            return Some(Intent::say("this drawing is planar: it cannot be rotated"));
        };
        let view = self.view.unwrap_or(scene.view);
        self.view = (action != Action::UsualView).then(|| view.turned(around, up));
        Some(Vec::new())
    }

    fn pictures(&self, problem: &Problem) -> usize {
        problem.drawings().count()
    }

    fn turn_to(&mut self, problem: &Problem, name: &str) {
        if let Some(at) = problem.first_of(name, |exhibit| exhibit.frames().0 > 0) {
            (self.at, self.view) = (at, None);
        }
    }

    fn shown(&self) -> usize {
        self.at
    }

    /// A scene in space has as many rows from every side, so that the screen keeps its parts while it is rotated.
    fn rows(&self, problem: &Problem, ui: &Ui<'_>, next: bool, width: u16) -> Option<u16> {
        let shown = if next { self.next(problem) } else { Self { at: self.at, ..Self::default() } };
        let (frames, _) = shown.frames(problem);
        let bar = u16::from(frames > 1 && !next);
        Some(drawing::rows(&*shown.seen(problem, ui.covered)?, ui.look, ui.locale, width) + bar)
    }

    fn frames(&self, problem: &Problem) -> (usize, f64) {
        self.sketch(problem).map_or((0, 0.0), Exhibit::frames)
    }

    fn frame(&mut self) -> Option<&mut usize> {
        Some(&mut self.frame)
    }

    fn file_names(&self) -> (&'static str, &'static str) {
        ("drawing", "enter a name ending in .svg")
    }

    fn file(&self, problem: &Problem, ending: &str, locale: &Locale) -> Option<String> {
        let picture = figure::drawing(&*self.seen(problem, problem.found.revealed.is_some())?, locale);
        picture.filter(|_| ending == "svg").map(|picture| picture.svg())
    }
}

impl Drawing {
    /// From where a scene in space is seen, where it was turned.
    pub fn view(&self) -> Option<Viewpoint3> {
        self.view
    }

    /// The next drawing, as it is at first.
    fn next(&self, problem: &Problem) -> Self {
        Self { at: turned(self.at, 1, self.pictures(problem)), ..Self::default() }
    }

    /// The drawing, animation or scene that is shown.
    fn sketch<'p>(&self, problem: &'p Problem) -> Option<&'p Exhibit> {
        Problem::nth(problem.drawings(), self.at)
    }

    /// The picture that is drawn of it: the frame that is shown, from the side that it was turned to; while the
    /// results are covered, without what they add.
    fn seen<'p>(&self, problem: &'p Problem, covered: bool) -> Option<Cow<'p, Picture>> {
        let drawing = self.sketch(problem)?.projected(self.frame, self.view)?;
        Some(if covered { Cow::Owned(drawing.unsolved()) } else { drawing })
    }
}

/// Draws the bar of an animation: it moves or is held, and at this frame: `▶ ◆━━━────── 10/24`. The rhomb stands for the
/// position of the inputs, where it begins, and is named there.
fn animation_bar(
    ui: &Ui<'_>,
    (frame, frames): (usize, usize),
    begins_at_given: bool,
    area: Rect,
    buffer: &mut Buffer,
) {
    let look = ui.look;
    let sign = look.glyph(if ui.playing { Glyph::Right } else { Glyph::Held });
    let digits = frames.to_string().len();
    let mut place = format!("{:>digits$}/{frames}", frame + 1);
    if begins_at_given && frame == 0 {
        place = format!("{}  {place}", Text::new("position of the problem").render(ui.locale));
    }
    let start = match (begins_at_given, look.ascii) {
        (false, _) => "",
        (true, false) => "◆",
        (true, true) => "*",
    };
    let room = usize::from(area.width).saturating_sub(width(&place) + width(start) + 4);
    let done = (frame * room).div_ceil(frames - 1).min(room);
    let (full, rest) = if look.ascii { ("=", "-") } else { ("━", "─") };
    let line = Line::from(vec![
        Span::styled(format!("{sign} "), look.key()),
        Span::styled(start, look.key()),
        Span::styled(full.repeat(done), look.border(true)),
        Span::styled(rest.repeat(room - done), look.dim()),
        Span::styled(format!("  {place}"), look.dim()),
    ]);
    buffer.set_line(area.x, area.y, &line, area.width);
}
