//! Keys of plots, drawings and animations.

use dalembert_core::Exhibit;

use crate::{bench::Bench, keys::Action, model::Model, plot, view};

/// What is said of a key that would show more.
const ALL_SHOWN: &str = "full range is shown";
/// So much of the axis is shown after a zoom in.
const ZOOM: f64 = 0.5;
/// The share of what is shown that a key moves it by.
const PAN: f64 = 0.25;
/// The angle that a key goes round a scene by: ten degrees.
const TURN: f64 = std::f64::consts::PI / 18.0;

/// Lets the animation on the screen move, holds it, or holds it at a frame beside the one that is shown.
pub(super) fn animation(model: &mut Model, action: Action) {
    let Some(frames) = view::animation(model).map(|(frames, _)| frames) else {
        model.say("no animation on the screen");
        return;
    };
    model.playing = action == Action::Play && !model.playing;
    if let Some(bench) = &mut model.bench {
        let by = match action {
            Action::PreviousFrame => frames - 1,
            Action::NextFrame => 1,
            _ => 0,
        };
        bench.frame = (bench.frame % frames + by) % frames;
    }
}

/// The next one of several, and after the last the first.
pub(super) fn next(at: usize, of: usize) -> usize {
    if of == 0 { 0 } else { (at.min(of - 1) + 1) % of }
}

/// Another part of the plot, or its values spread in another way; what cannot be done is said.
pub(super) fn look_otherwise(model: &mut Model, action: Action) {
    let Some(bench) = &mut model.bench else { return };
    let state = bench.plot_state;
    let Some((plot, _)) = bench.shown_plot() else { return };
    let (to, otherwise) = match action {
        Action::ZoomIn => (state.zoomed(plot, ZOOM), "already at the limit of the zoom"),
        Action::ZoomOut => (state.zoomed(plot, 1.0 / ZOOM), ALL_SHOWN),
        Action::ZoomAll => (state.windowed(None), ALL_SHOWN),
        Action::PanLeft if state.view.window.is_some() => (state.panned(plot, -PAN), "start of the range"),
        Action::PanRight if state.view.window.is_some() => (state.panned(plot, PAN), "end of the range"),
        Action::NextSpread | Action::NextSpreadAcross => {
            let next = match action {
                Action::NextSpread => state.next_spread(plot),
                _ => state.next_spread_across(plot),
            };
            next.map_or_else(|why| (state, why), |to| (to, ""))
        }
        _ => (state, ALL_SHOWN),
    };
    bench.plot_state = to;
    if to == state {
        model.say(otherwise);
    }
}

/// Goes round a scene in space, or back to where it is usually seen from.
pub(super) fn go_round(model: &mut Model, action: Action) {
    let Some(bench) = &mut model.bench else { return };
    let Some(Exhibit::Scene(scene)) = bench.sketch() else {
        model.say("this drawing is planar: it cannot be rotated");
        return;
    };
    let view = bench.view.unwrap_or(scene.view);
    bench.view = match action {
        Action::Left => Some(view.turned(-TURN, 0.0)),
        Action::Right => Some(view.turned(TURN, 0.0)),
        Action::Up => Some(view.turned(0.0, TURN)),
        Action::Down => Some(view.turned(0.0, -TURN)),
        _ => None,
    };
}

/// The cursor of the plot, moved by a share of its axis.
pub(super) fn move_cursor(bench: &mut Bench, share: f64) {
    let state: plot::State = bench.plot_state;
    if let Some(plot) = Bench::nth(bench.plots(), bench.plot) {
        bench.plot_state = state.moved(plot, share);
    }
}
