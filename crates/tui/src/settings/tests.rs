use dalembert_core::Locale;

use super::*;
use crate::{keys::Action, panes::places};

fn faults(text: &str) -> Vec<(usize, String)> {
    parse(text).1.into_iter().map(|fault| (fault.line, fault.why.english())).collect()
}

#[test]
fn a_file_sets_what_it_names() {
    let (settings, faults) = parse(
        "language = \"pt-BR\"\ntheme = \"high-contrast\"\nascii = true\nmouse = false\npixels = true\nmarker = \"dots\"\n\
         decimal = \"comma\"\ndigits = 7\nfilm-speed = 2\neditor = \"code --wait\"\n\n\
         [keys]\nsave = [\"f5\", \"ctrl-s\"]\n\n[keys.plot]\nzoom-in = \"i\"\n",
    );
    assert_eq!(faults, []);
    assert_eq!(settings.language, Some(Language::Portuguese));
    assert_eq!((settings.theme, settings.ascii, settings.mouse), (Theme::HighContrast, true, Some(false)));
    assert_eq!(settings.pixels, Some(true));
    assert_eq!((settings.marker, settings.decimal), (Some(Marker::Dot), Some(Decimal::Comma)));
    assert_eq!((settings.digits, settings.animation_speed), (7, 2.0));
    assert_eq!(settings.editor.as_deref(), Some("code --wait"));
    let plot = places().into_iter().find(|place| place.id() == "plot").expect("a place");
    assert_eq!(settings.keys.key(plot, Action::Save), Key::parse("f5").ok());
    assert_eq!(settings.keys.key(plot, Action::ZoomIn), Key::parse("i").ok());
}

#[test]
fn what_cannot_be_taken_is_named_with_its_line_and_the_rest_holds() {
    let text = "lnguage = \"en\"\ntheme = \"drak\"\nascii = \"yes\"\ndigits = 40\n\
                [keys]\nsaev = \"f5\"\nundo = \"ctrl-pup\"\nopen = 5\nredo = \"u\"\n[keys.plto]\nplay = \"w\"\n";
    assert_eq!(
        faults(text),
        [
            (1, "unknown setting `lnguage`; did you mean `language`?".into()),
            (2, "`theme` cannot be `drak`; did you mean `dark`?".into()),
            (3, "`ascii` is true or false, without quotes".into()),
            (4, "`digits` is an integer from 1 to 17".into()),
            (6, "unknown command `saev`; did you mean `save`?".into()),
            (7, "`ctrl-pup` is not a key; did you mean `ctrl-up`?".into()),
            (8, "`open` is a key in quotes, or several: [\"s\", \"ctrl-s\"]".into()),
            (9, "`u` already means `next-unit` in [keys.inputs]: choose another key, or write `next-unit = []` there".into()),
            (10, "unknown table `plto`; did you mean `plot`?".into()),
        ]
    );
    let (settings, _) = parse(&format!("editor = \"nano\"\n{text}"));
    assert_eq!(settings.editor.as_deref(), Some("nano"));
    let (settings, faults) = parse("digits = 7\ntheme = \"dark\n");
    assert_eq!((settings, faults.len(), faults[0].line), (Settings::default(), 1, 2));
}

/// Action of each key, place by place, however the tables divide it.
fn meaning(settings: &Settings) -> Vec<(KeyContext, Key, &'static str)> {
    let mut all: Vec<(KeyContext, Key, &'static str)> = Vec::new();
    for place in places() {
        for bound in settings.keys.bindings(place) {
            all.extend(bound.keys.iter().map(|key| (place, *key, bound.binding.action.id())));
        }
    }
    all.sort_by_key(|(place, key, _)| (place.id(), key.id()));
    all.dedup();
    all
}

#[test]
fn the_file_that_is_begun_with_sets_nothing_commented_or_not() {
    for locale in [Locale::english(), Locale::portuguese()] {
        let file = default_file(&locale);
        assert_eq!(parse(&file), (Settings::default(), Vec::new()), "{file}");
        // What has no value of its own stays out.
        let open: Vec<&str> = file
            .lines()
            .map(|line| line.strip_prefix("# ").unwrap_or(line))
            .filter(|line| !line.contains(" = …"))
            .collect();
        let open = open.join("\n");
        let (settings, faults) = parse(&open);
        assert_eq!(faults, [], "{open}");
        assert_eq!(meaning(&settings), meaning(&Settings::default()), "{open}");
        let rest = |settings: Settings| Settings { keys: KeyMap::default(), ..settings };
        assert_eq!(rest(settings), Settings::default());
    }
    for place in places() {
        assert!(default_file(&Locale::english()).contains(&format!("[keys.{}]", place.id())));
    }
}
