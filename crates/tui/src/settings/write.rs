//! The file of settings as it is begun: everything that can be set, all of it commented out.

use dalembert_core::{Language, Locale, Text};

use super::{DECIMALS, MARKERS, Settings};
use crate::{
    keys::{ALWAYS, Binding, COMMON, Key, PANES, PROBLEM},
    look::Theme,
    panes::places,
};

/// A file that says what can be set, in the user's language, and what it is without a word. It sets nothing; nor
/// does it where its lines are taken out of their comments.
pub fn default_file(locale: &Locale) -> String {
    let default = Settings::default();
    let say = |text: Text| text.render(locale);
    let quoted = |name: &str| format!("\"{name}\"");
    let names = |names: &[&str]| names.iter().map(|name| quoted(name)).collect::<Vec<_>>().join(", ");
    let mut file = String::new();
    comment(
        &mut file,
        &say(Text::new(
            "Settings of dalembert. Lines that start with # are comments: remove the # and change the value.",
        )),
    );
    let settings = [
        (
            "language",
            String::new(),
            Text::new("Language: {known}; default: that of the environment.")
                .with("known", names(&Language::ALL.map(Language::tag))),
        ),
        (
            "theme",
            quoted(default.theme.id()),
            Text::new("Theme: {known}. `terminal` uses the palette of your terminal.")
                .with("known", names(&Theme::ALL.map(Theme::id))),
        ),
        ("ascii", default.ascii.to_string(), Text::new("ASCII characters only.")),
        (
            "mouse",
            String::new(),
            Text::new(
                "Mouse: true or false; default: true, over ssh false. With the mouse in use, selecting text needs Shift.",
            ),
        ),
        (
            "pixels",
            String::new(),
            Text::new(
                "Pictures in pixels: true or false; default: true where the terminal shows them, over ssh false.",
            ),
        ),
        (
            "marker",
            String::new(),
            Text::new("Curve markers: {known}; default: the finest that the terminal supports.")
                .with("known", names(&MARKERS.map(|(name, _)| name))),
        ),
        (
            "decimal",
            String::new(),
            Text::new("Decimal mark: {known}; default: that of the language.")
                .with("known", names(&DECIMALS.map(|(name, _)| name))),
        ),
        ("digits", default.digits.to_string(), Text::new("Significant digits of results: 1 to 17.")),
        (
            "animation-speed",
            format!("{:?}", default.animation_speed),
            Text::new(
                "Speed of animations: 0.5 is half speed; at 0 they stay paused until a key plays them.",
            ),
        ),
        ("editor", String::new(), Text::new("Command that edits a problem; default: $VISUAL or $EDITOR.")),
    ];
    for (key, value, about) in settings {
        file += "\n";
        comment(&mut file, &say(about));
        // What has no value of its own is shown with nothing to take out of the comment.
        file += &if value.is_empty() { format!("#   {key} = …\n") } else { format!("# {key} = {value}\n") };
    }
    file += "\n";
    comment(
        &mut file,
        &say(Text::new(
            "Keys: a character, or such as \"space\", \"f5\", \"page-up\", \"ctrl-s\", \"alt-x\", \"shift-up\"; one, several or none. In [keys] they hold wherever the action is known, in a part such as [keys.plot] there alone. Esc always goes one step back and Ctrl-C always ends the program.",
        )),
    );
    file += "[keys]\n";
    let mut written: Vec<&str> = Vec::new();
    let shared = [PANES, PROBLEM, COMMON, ALWAYS];
    for binding in shared.into_iter().flatten() {
        let id = binding.action.id();
        if written.contains(&id) {
            continue;
        }
        written.push(id);
        let all = shared.into_iter().flatten().filter(|other| other.action.id() == id);
        file += &line(binding, all.flat_map(|other| other.keys).copied(), locale);
    }
    for place in places() {
        file += &format!("\n[keys.{}]  # {}\n", place.id(), say(Text::new(place.name())));
        let mut written: Vec<&str> = Vec::new();
        for binding in place.table().iter().copied().flatten() {
            if written.contains(&binding.action.id()) {
                continue;
            }
            written.push(binding.action.id());
            let same = place.bindings().filter(|other| other.action.id() == binding.action.id());
            file += &line(binding, same.flat_map(|other| other.keys).copied(), locale);
        }
    }
    file
}

/// `# save = ["s", "ctrl-s"]  # save the problem`
fn line(binding: &Binding, keys: impl Iterator<Item = Key>, locale: &Locale) -> String {
    let keys: Vec<String> = keys.map(|key| toml_edit::Value::from(key.id()).to_string()).collect();
    let keys = if let [key] = &keys[..] { key.clone() } else { format!("[{}]", keys.join(", ")) };
    let name = Text::new(binding.name).render(locale);
    format!("# {} = {keys}  # {name}\n", binding.action.id())
}

/// A text as lines of a comment.
fn comment(file: &mut String, text: &str) {
    const WIDEST: usize = 98;
    let mut line = String::from("##");
    for word in text.split(' ') {
        if line.chars().count() + 1 + word.chars().count() > WIDEST {
            *file += &line;
            *file += "\n";
            line = String::from("##");
        }
        line.push(' ');
        line += word;
    }
    *file += &line;
    *file += "\n";
}
