//! The keys that hold: those of the tables, unless the user's settings say otherwise.

use dalembert_core::Text;
use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use super::{ALWAYS, Action, Binding, Key, KeyContext};

/// Key bindings, place by place: the tables of the program with the user's changes. The tables of the program, with the
/// user's changes.
#[derive(Clone, Debug, PartialEq)]
pub struct KeyMap {
    /// Every binding that holds in a place, the most useful first.
    places: Vec<(KeyContext, Vec<Bound>)>,
}

/// A line of a table with the keys that hold.
#[derive(Clone, Debug)]
pub struct Bound {
    /// Action and its name.
    pub binding: &'static Binding,
    /// The keys that do it, the usual one first; none where the user took them away.
    pub keys: Vec<Key>,
}

/// A change that the settings ask for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct KeyChange {
    /// Place; `None` for every place in which the action is possible.
    pub place: Option<KeyContext>,
    /// The [`Action::id`] of what is done.
    pub action: &'static str,
    /// The keys that do it from now on.
    pub keys: Vec<Key>,
}

/// Keys that always mean the same, or a user could be caught.
const FIXED: [(Key, Action); 2] = [
    (Key(KeyCode::Esc, KeyModifiers::NONE), Action::Back),
    (Key(KeyCode::Char('c'), KeyModifiers::CONTROL), Action::Quit),
];

impl PartialEq for Bound {
    fn eq(&self, other: &Self) -> bool {
        (self.binding.action, &self.keys) == (other.binding.action, &other.keys)
    }
}

impl KeyMap {
    /// The tables of these places.
    pub fn of(places: &[KeyContext]) -> Self {
        let bound = |binding: &'static Binding| Bound { binding, keys: binding.keys.to_vec() };
        Self { places: places.iter().map(|place| (*place, place.bindings().map(bound).collect())).collect() }
    }

    /// The tables with these changes, and those that were refused, by their number, with the reason.
    ///
    /// What is asked for one place counts more than what is asked for all. Where characters are text, a change for
    /// all places takes no character. A key that would mean two things in a place refuses the later change.
    pub fn changed(places: &[KeyContext], changes: &[KeyChange]) -> (Self, Vec<(usize, Text)>) {
        let mut refused: Vec<(usize, Text)> =
            changes.iter().enumerate().filter_map(|(n, change)| Some((n, change.fault()?))).collect();
        loop {
            let held: Vec<usize> =
                (0..changes.len()).filter(|n| !refused.iter().any(|(other, _)| other == n)).collect();
            let mut map = Self::of(places);
            let (everywhere, somewhere): (Vec<usize>, Vec<usize>) =
                held.iter().partition(|n| changes[**n].place.is_none());
            for n in everywhere.into_iter().chain(somewhere) {
                map.change(&changes[n]);
            }
            let Some((place, key, one, other)) = map.conflict() else {
                refused.sort_by_key(|(n, _)| *n);
                return (map, refused);
            };
            let asks =
                |n: &usize| changes[*n].keys.contains(&key) && changes[*n].place.is_none_or(|at| at == place);
            // Without changes no key means two things, so one of them asked for it.
            let culprit = held.into_iter().rev().find(asks).expect("a conflict comes from a change");
            let taken = if one.id() == changes[culprit].action { other } else { one };
            let why = Text::new("`{key}` already means `{taken}` in [keys.{place}]: choose another key, or write `{taken} = []` there")
                .with("key", key.id())
                .with("taken", taken.id())
                .with("place", place.id());
            refused.push((culprit, why));
        }
    }

    /// Action of a key in a place.
    pub fn action(&self, place: KeyContext, event: KeyEvent) -> Option<Action> {
        let key = Key::of(event);
        self.bindings(place).iter().find(|bound| bound.keys.contains(&key)).map(|bound| bound.binding.action)
    }

    /// Every binding that holds in a place, the most useful first.
    pub fn bindings(&self, place: KeyContext) -> &[Bound] {
        self.places.iter().find(|(known, _)| *known == place).map_or(&[], |(_, bindings)| bindings)
    }

    /// The usual key of an action in a place.
    pub fn key(&self, place: KeyContext, action: Action) -> Option<Key> {
        let mut bounds = self.bindings(place).iter().filter(|bound| bound.binding.action == action);
        bounds.find_map(|bound| bound.keys.first()).copied()
    }

    /// The usual key of an action in the first place that has it.
    pub fn anywhere(&self, action: Action) -> Option<Key> {
        self.places().find_map(|place| self.key(place, action))
    }

    /// The places where keys mean something, as the help and the settings list them.
    pub fn places(&self) -> impl Iterator<Item = KeyContext> {
        self.places.iter().map(|(place, _)| *place)
    }

    /// Every key of a binding, as it holds in a place.
    pub fn keys_of(&self, place: KeyContext, binding: &Binding) -> &[Key] {
        let same = |bound: &&Bound| bound.binding == binding;
        self.bindings(place).iter().find(same).map_or(&[], |bound| &bound.keys)
    }

    fn change(&mut self, change: &KeyChange) {
        for (place, bounds) in
            self.places.iter_mut().filter(|(place, _)| change.place.is_none_or(|at| at == *place))
        {
            let mut keys = change.keys.clone();
            // What holds everywhere has no character of its own, where text is typed as where `?` closes the help.
            let mut same = bounds.iter().filter(|bound| bound.binding.action.id() == change.action);
            let only_always = same.all(|bound| ALWAYS.contains(bound.binding));
            if place.is_text() || (change.place.is_none() && only_always) {
                keys.retain(|key| !key.is_text());
                if keys.is_empty() && !change.keys.is_empty() {
                    continue;
                }
            }
            for bound in bounds {
                if bound.binding.action.id() == change.action {
                    bound
                        .keys
                        .retain(|key| FIXED.iter().any(|(fixed, _)| fixed == key) && !keys.contains(key));
                    bound.keys.splice(..0, std::mem::take(&mut keys));
                }
            }
        }
    }

    /// A key that means two things in a place.
    fn conflict(&self) -> Option<(KeyContext, Key, Action, Action)> {
        for (place, bounds) in &self.places {
            let mut seen: Vec<(Key, Action)> = Vec::new();
            for bound in bounds {
                for key in &bound.keys {
                    match seen.iter().find(|(other, _)| other == key) {
                        Some((_, action)) if *action != bound.binding.action => {
                            return Some((*place, *key, *action, bound.binding.action));
                        }
                        Some(_) => {}
                        None => seen.push((*key, bound.binding.action)),
                    }
                }
            }
        }
        None
    }
}

impl KeyChange {
    /// Reason for which the change is impossible, whatever else is changed.
    fn fault(&self) -> Option<Text> {
        let does = |place: &KeyContext| place.bindings().any(|binding| binding.action.id() == self.action);
        if let Some(place) = self.place.filter(|place| !does(place)) {
            return Some(
                Text::new("`{action}` has no effect in [keys.{place}]")
                    .with("action", self.action)
                    .with("place", place.id()),
            );
        }
        self.keys.iter().find_map(|key| {
            let fixed = FIXED.iter().find(|(fixed, action)| fixed == key && action.id() != self.action);
            if let Some((_, action)) = fixed {
                return Some(
                    Text::new("`{key}` is reserved for `{action}`: choose another key")
                        .with("key", key.id())
                        .with("action", action.id()),
                );
            }
            if let Some(place) = self.place.filter(|place| place.is_text() && key.is_text()) {
                return Some(
                    Text::new("`{key}` is text in [keys.{place}]: choose one such as `ctrl-g` or `f5`")
                        .with("key", key.id())
                        .with("place", place.id()),
                );
            }
            // There a digit begins a text.
            let is_digit = matches!(key.0, KeyCode::Char(character) if character.is_ascii_digit());
            let begins =
                [(KeyContext::Form, key.begins_a_number()), (KeyContext::Cells, key.is_text() && is_digit)];
            let typed = begins.into_iter().filter(|(_, begins)| *begins).map(|(place, _)| place);
            let place = typed.filter(does).find(|place| self.place.is_none_or(|at| at == *place));
            place.map(|place| {
                Text::new("`{key}` starts a number in [keys.{place}]: choose another key")
                    .with("key", key.id())
                    .with("place", place.id())
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::panes::places;

    fn changed(changes: &[KeyChange]) -> (KeyMap, Vec<(usize, Text)>) {
        KeyMap::changed(&places(), changes)
    }

    fn plot() -> KeyContext {
        places().into_iter().find(|place| place.id() == "plot").expect("a place")
    }

    fn change(place: Option<KeyContext>, action: &'static str, keys: &[&str]) -> KeyChange {
        let keys = keys.iter().map(|key| Key::parse(key).expect("a key")).collect();
        KeyChange { place, action, keys }
    }

    fn refusals(changes: &[KeyChange]) -> Vec<(usize, String)> {
        changed(changes).1.into_iter().map(|(n, why)| (n, why.english())).collect()
    }

    #[test]
    fn no_place_is_called_like_an_action() {
        for place in places() {
            let named = |other: KeyContext| other.bindings().any(|binding| binding.action.id() == place.id());
            assert!(!places().into_iter().any(named), "{} is an action too", place.id());
        }
    }

    #[test]
    fn a_change_takes_the_place_of_the_usual_keys() {
        let (map, refused) = changed(&[
            change(None, "save", &["f5"]),
            change(Some(plot()), "zoom-in", &["i"]),
            change(None, "next-frame", &[]),
        ]);
        assert_eq!(refused, []);
        for place in [KeyContext::Form, plot()] {
            assert_eq!(map.key(place, Action::Save), Key::parse("f5").ok());
            assert_eq!(map.action(place, KeyEvent::from(KeyCode::Char('s'))), None);
        }
        assert_eq!(map.action(plot(), KeyEvent::from(KeyCode::Char('i'))), Some(Action::ZoomIn));
        assert_eq!(map.key(plot(), Action::NextFrame), None);
    }

    #[test]
    fn two_keys_can_be_exchanged() {
        let (map, refused) = changed(&[change(None, "undo", &["Z"]), change(None, "redo", &["z"])]);
        assert_eq!(refused, []);
        assert_eq!(
            (map.key(KeyContext::Form, Action::Undo), map.key(KeyContext::Form, Action::Redo)),
            (Key::parse("Z").ok(), Key::parse("z").ok())
        );
    }

    #[test]
    fn a_key_of_two_meanings_is_refused_by_name_and_the_rest_holds() {
        let changes =
            [change(None, "undo", &["W"]), change(None, "save", &["W"]), change(None, "redo", &["y"])];
        assert_eq!(
            refusals(&changes),
            [
                (
                    1,
                    "`W` already means `undo` in [keys.inputs]: choose another key, or write `undo = []` there"
                        .into()
                ),
                (
                    2,
                    "`y` already means `copy` in [keys.inputs]: choose another key, or write `copy = []` there"
                        .into()
                ),
            ]
        );
        let (map, _) = changed(&changes);
        assert_eq!(
            (map.key(KeyContext::Form, Action::Undo), map.key(KeyContext::Form, Action::Save)),
            (Key::parse("W").ok(), Key::parse("s").ok())
        );
    }

    #[test]
    fn nobody_is_caught() {
        assert_eq!(
            refusals(&[
                change(None, "save", &["esc"]),
                change(None, "help", &["ctrl-c"]),
                change(Some(KeyContext::Edit), "enter", &["g"]),
                change(None, "save", &["5"]),
                change(Some(plot()), "add-row", &["w"]),
            ]),
            [
                (0, "`esc` is reserved for `back`: choose another key".into()),
                (1, "`ctrl-c` is reserved for `quit`: choose another key".into()),
                (2, "`g` is text in [keys.field]: choose one such as `ctrl-g` or `f5`".into()),
                (3, "`5` starts a number in [keys.inputs]: choose another key".into()),
                (4, "`add-row` has no effect in [keys.plot]".into()),
            ]
        );
        let (map, _) = changed(&[
            change(None, "back", &["f3"]),
            change(None, "quit", &[]),
            change(None, "enter", &["e"]),
        ]);
        for place in places() {
            assert_eq!(map.action(place, KeyEvent::from(KeyCode::Esc)), Some(Action::Back), "{place:?}");
            let end = KeyEvent::new(KeyCode::Char('c'), KeyModifiers::CONTROL);
            assert_eq!(map.action(place, end), Some(Action::Quit), "{place:?}");
            if place.is_text() {
                assert_eq!(map.action(place, KeyEvent::from(KeyCode::Char('e'))), None, "{place:?}");
            }
        }
    }
}
