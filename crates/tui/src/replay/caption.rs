//! The lines below a session that is played: what is to be seen, and the keys that steer it.

use dalembert_core::{Locale, Text};
use dalembert_plot::wrap;
use dalembert_units::{Style, write_number};
use ratatui::{Frame, buffer::Buffer, layout::Rect, style::Modifier};

use crate::{glyphs::filter_untrusted, model::Model, playback::Playback};

/// The most lines of a caption.
const MOST: usize = 3;
/// On a low screen they have one row of so many.
const LEAST_SHARE: u16 = 3;

/// The part of a screen above them: nothing of the workbench is covered.
pub(crate) fn above(model: &Model, screen: Rect) -> Rect {
    let rows = lines(model, screen.width).len() as u16;
    Rect { height: screen.height - rows.min(screen.height / LEAST_SHARE), ..screen }
}

/// Draws them in the last rows of a screen.
pub(crate) fn draw(model: &Model, frame: &mut Frame<'_>) {
    let area = frame.area();
    let above = above(model, area);
    let rows = Rect { y: above.bottom(), height: area.height - above.height, ..area };
    if rows.is_empty() {
        return;
    }
    let lines = lines(model, area.width);
    let style = model.look.title().add_modifier(Modifier::REVERSED | Modifier::BOLD);
    // Apart from the screen, whose cells have the colours of the theme already.
    let mut buffer = Buffer::empty(rows);
    buffer.set_style(rows, style);
    for (line, y) in lines.iter().zip(rows.y..) {
        buffer.set_stringn(rows.x + 1, y, line, usize::from(rows.width.saturating_sub(2)), style);
    }
    model.look.ground(&mut buffer);
    frame.buffer_mut().merge(&buffer);
}

fn lines(model: &Model, width: u16) -> Vec<String> {
    let locale = &model.locale.ascii(model.look.ascii);
    let room = usize::from(width.saturating_sub(2)).max(1);
    let caption = model.caption.iter().flat_map(|caption| {
        let words = filter_untrusted(&caption.render(locale)).into_owned();
        wrap::words(&words, room).into_iter().take(MOST)
    });
    caption.chain(model.playback.map(|playback| keys(playback, locale))).collect()
}

fn keys(playback: Playback, locale: &Locale) -> String {
    let text = match playback {
        Playback { is_tour: true, .. } => Text::new("tour · any key is yours and acts at once"),
        Playback { paused: true, .. } => {
            Text::new("paused · Space continues · any other key ends the replay")
        }
        Playback { speed, .. } => {
            Text::new("replay {speed}× · Space pause · + - speed · any other key ends it")
                .with("speed", write_number(speed, Style { digits: 2, ..locale.style }))
        }
    };
    text.render(locale)
}
