//! The tour: a session of a minute and a half that plays itself and ends in the user's own.

use std::time::Duration;

use dalembert_core::{Language, Text};

use super::{Act, LOOKS, Replay};
use crate::keys::notation::keys_of;

/// The analysis that it begins with.
const BEGIN: &str = "vibration/rotating-unbalance";

/// A scene: its caption, the keys, each after a pause so long, and the time that the screen rests then, in milliseconds.
struct Scene {
    caption: Text,
    keys: &'static str,
    between: u64,
    rest: u64,
}

/// The session of the tour in a language.
pub fn tour(language: Language) -> Replay {
    let mut acts = Vec::new();
    for Scene { caption, keys, between, rest } in scenes() {
        acts.push(Act::Caption(caption));
        acts.push(Act::Wait(Duration::from_millis(2500)));
        for key in keys_of(keys).unwrap_or_default() {
            acts.push(Act::Type(vec![key]));
            acts.push(Act::Wait(Duration::from_millis(between)));
        }
        acts.push(Act::Wait(Duration::from_millis(rest)));
    }
    let acts = acts.into_iter().map(|act| (0, act)).collect();
    Replay { screen: (120, 36), language, look: LOOKS[0].1, open: Some(BEGIN.to_owned()), field: None, acts }
}

fn scenes() -> Vec<Scene> {
    let scene = |caption: &'static str, keys, between, rest| Scene {
        caption: Text::new(caption),
        keys,
        between,
        rest,
    };
    vec![
        scene(
            "A fan on a beam vibrates: on the left what is given, in any unit, on the right what follows",
            "<end>",
            300,
            4500,
        ),
        scene(
            "The speed is raised key by key, and every answer follows at once",
            "<s-up><s-up><s-up><s-up><s-up><s-up><s-up><s-up><s-up><s-up>",
            350,
            3000,
        ),
        scene(
            "The worked solution is the computation itself: formula, numbers, result and source",
            "]<pgdn><pgdn>",
            1800,
            4000,
        ),
        scene(
            "The curve with its operating point, read by the arrow keys or under the mouse",
            "]<right><right><right><right>",
            500,
            4000,
        ),
        scene("The same in decibels", "aa", 900, 4000),
        scene(
            "A result is pinned, the speed is lowered: the old curve and its point stay for comparison",
            "<esc>a<tab>c<s-down><s-down><s-down><s-down><s-down><s-down><s-down><s-down><s-down><s-down>",
            350,
            6000,
        ),
        scene("The machine, with the letters of the form", "]", 300, 6000),
        scene("Type your own result: it is right, or you learn which slip would give it", "]", 300, 6000),
        scene(
            "All analyses in one list: type a word of your problem, Enter opens it. The keyboard is yours.",
            "<esc><esc>",
            300,
            6000,
        ),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tour_takes_a_minute_and_a_half() {
        let session = tour(Language::English);
        let waits = session.acts.iter().map(|(_, act)| match act {
            Act::Wait(time) => *time,
            Act::Type(_) => Duration::from_millis(100),
            _ => Duration::ZERO,
        });
        let all: Duration = waits.sum();
        assert!((80..=100).contains(&all.as_secs()), "{all:?}");
        let keys = session.acts.iter().filter(|(_, act)| matches!(act, Act::Type(_))).count();
        assert!(keys > 30, "every scene has its keys: {keys}");
    }
}
