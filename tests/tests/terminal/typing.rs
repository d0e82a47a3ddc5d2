//! Typing into fields, cells and paths, and the messages that follow.

use std::fs;

use dalembert_core::Language;
use dalembert_tests::person::Person;
use dalembert_tui::{Msg, settings::Fault};

const FAN: &str = "vibration/rotating-unbalance";

fn fan() -> Person {
    Person::at(100, 30).opens(FAN)
}

/// The text of the draft under the cursor.
fn field(person: &Person) -> String {
    let form = &person.model.bench.as_ref().expect("a problem is open").problem.inputs.form;
    match form.line().expect("a line").role {
        dalembert_tui::form::Role::Leaf { text, .. } => text,
        _ => String::new(),
    }
}

#[test]
fn a_sign_before_a_number_is_its_sign() {
    for (typed, wanted) in [
        ("-30 mm<enter>", "-30 mm"),
        ("+30 mm<enter>", "+30 mm"),
        ("-.5<enter>", "-.5 mm"),
        ("-,5<enter>", "-,5 mm"),
        ("---3 mm<enter>", "-3 mm"),
        ("--", "20.1 mm"),
        ("+", "20.4 mm"),
        ("-<down><up>3 mm<enter>", "3 mm"),
        // It is as it was before the sign, not only before the number.
        ("-3<esc>", "20.3 mm"),
        ("-30 mm<enter>z", "20.3 mm"),
        ("--3 mm<enter>z", "20.2 mm"),
        ("-3<esc>-z", "20.3 mm"),
        ("<del><enter>-3 mm<enter>", "-3 mm"),
    ] {
        let mut person = fan();
        person.types("<end><up>").types(typed);
        assert_eq!(field(&person), wanted, "{typed}");
    }
}

#[test]
fn a_number_alone_keeps_the_unit_of_its_field() {
    for (typed, wanted) in [
        ("1200<enter>", "1200 rpm"),
        ("<enter><c-u>1200<enter>", "1200 rpm"),
        ("<del>600+600<enter>", "(600+600) rpm"),
        ("20 Hz<enter>", "20 Hz"),
        ("20 Hz<enter>30<enter>", "30 Hz"),
        ("<del><enter>30<enter>", "30 rad/s"),
        ("<del><enter>1/2<enter>", "1/2 rad/s"),
    ] {
        let mut person = fan();
        person.types("<end>").types(typed);
        assert_eq!(field(&person), wanted, "{typed}");
    }
    let mut person = fan();
    let screen = person.types("<end>12").sees();
    assert!(screen.contains("Speed of the machine · default unit rpm · = 12 rpm"), "{screen}");
    assert!(person.types("<esc>").pastes("1200").sees().contains("1200 rpm"));
    let mut person = Person::in_portuguese(100, 30).opens(FAN);
    let screen = person.types("<end>12").sees();
    assert!(screen.contains("Rotação da máquina · unidade padrão rpm · = 12 rpm"), "{screen}");
}

#[test]
fn a_narrow_screen_says_the_unit_of_a_field_whatever_else_it_cuts() {
    let mut person = Person::at(60, 24).opens(FAN);
    assert!(person.types("<end><up>").sees().contains("default unit mm"), "{}", person.sees());
}

#[test]
fn the_line_below_speaks_of_the_cell_that_is_typed_in() {
    let mut person = fan();
    person.types("]]]]<home>");
    let screen = person.types("4").sees();
    assert!(screen.contains("Amplitude at this speed · default unit mm"), "{screen}");
    let screen = person.types("<esc>]]<home><down><down>5").sees();
    assert!(
        screen.contains("default unit kg · as in 1..9:5") && screen.contains(" · Mass of the machine"),
        "{screen}"
    );
    assert!(!screen.contains("· Speed of the machine"), "{screen}");
    // A vector has a form.
    let mut seen = false;
    for entry in dalembert_core::registry().iter().filter(|entry| entry.family() == "rigid-body") {
        let mut person = Person::at(100, 30).opens(entry.about.id);
        person.types("]]]]]]]]]");
        let solution = person.model.bench.as_ref().and_then(|bench| bench.problem.found.solution.as_ref());
        let at = solution.and_then(|found| {
            found.answers.iter().position(|answer| {
                answer.si().is_none() && dalembert_core::check::example(answer).starts_with("(1; 2; 3)")
            })
        });
        let Some(at) = at else { continue };
        let bench = person.model.bench.as_mut().expect("open");
        bench.tab = bench.tab_named("Check").expect("a pane");
        bench.focus = dalembert_tui::layout::Focus::Pane;
        person.types("<home>").types(&"<down>".repeat(at)).types("(");
        let screen = person.sees();
        assert!(screen.contains("write it as in `(1; 2; 3)"), "{}:\n{screen}", entry.about.id);
        seen = true;
        break;
    }
    assert!(seen, "some answer is a vector");
}

#[test]
fn a_path_is_completed_and_what_is_there_is_listed() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = "analysis = \"vibration/rotating-unbalance\"\ntitle = \"Paint shop\"\n";
    fs::create_dir(folder.path().join("laboratory")).expect("made");
    for name in ["fan.toml", "fan2.toml", "laboratory/lathe.toml"] {
        fs::write(folder.path().join(name), text).expect("written");
    }
    let root = folder.path().display().to_string();
    let mut person = Person::at(100, 30);
    let screen = person.types("<esc>o").types(&format!("{root}/")).sees();
    assert!(["fan.toml", "fan2.toml", "laboratory/"].iter().all(|name| screen.contains(name)), "{screen}");
    let screen = person.types("la<tab>").sees();
    assert!(screen.contains("lathe.toml"), "{screen}");
    assert!(person.types("<tab><enter>").sees().contains("Paint shop"), "{}", person.sees());

    // The ending that a save writes need not be typed.
    let mut person = Person::at(100, 30);
    assert!(person.types("<esc>o").types(&format!("{root}/fan<enter>")).sees().contains("Paint shop"));

    let mut person = Person::at(100, 30);
    let screen = person.types("<esc>o").types(&format!("{root}/fan<tab>")).sees();
    assert!(screen.contains("/fan.toml") && screen.contains("fan2.toml"), "{screen}");
    assert!(person.types("<tab>").sees().contains("/fan2.toml"), "{}", person.sees());
    assert!(person.types("<s-tab>").sees().contains("/fan.toml"), "{}", person.sees());
    assert!(person.types("x").sees().contains("nothing found"), "{}", person.sees());
    assert!(person.types("<esc>:zzzz").sees().contains("nothing found"), "{}", person.sees());
    let mut person = Person::in_portuguese(100, 30);
    assert!(person.types("<esc>:zzzz").sees().contains("nada encontrado"), "{}", person.sees());
}

#[test]
fn every_slip_in_files_of_ones_own_is_reported() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(
        folder.path().join("mine.toml"),
        "title = \"Mine\"\n\n[[exercise]]\nanalysis = \"vibration/rotating-unbalanc\"\n\n[[exercise]]\n\
         analysis = \"vibration/rotating-unbalance\"\ncase = \"Fan on a cantilver\"\n",
    )
    .expect("written");
    fs::write(folder.path().join("broken.toml"), "title = \"Mine\"\n\n[[exercise\n").expect("written");
    let (sets, wrong) = dalembert_tui::files::sets(folder.path());
    assert_eq!(sets.len(), 1);
    for (language, words) in [
        (Language::English, ["there is no analysis", "has no case"]),
        (Language::Portuguese, ["não há análise", "não tem o caso"]),
    ] {
        let mut person = Person::at(120, 30);
        person.model.set_language(language);
        let screen = person.happens(Msg::Faulty(wrong.clone())).sees();
        let all = ["broken.toml", "mine.toml", words[0], words[1], " 3: ", " 4: ", " 8: "];
        assert!(all.iter().all(|words| screen.contains(words)), "{screen}");
    }
    // Many are counted; what is below something else is one line.
    let many = vec![Fault { line: 1, why: "wrong".into() }; 20];
    let mut person = Person::at(100, 30);
    let screen = person.types("<esc>o").happens(Msg::Faulty(vec![("settings.toml".into(), many)])).sees();
    assert!(screen.contains("and 19 more: `dalembert info` lists all"), "{screen}");
}

#[test]
fn an_unknown_unit_is_reported_one_that_fits() {
    let screen = Person::at(160, 30).opens(FAN).types("<end><up>20 mmt").sees();
    assert!(screen.contains("did you mean `mm`"), "{screen}");
}

#[test]
fn the_help_of_the_list_says_what_its_marks_mean() {
    let screen = Person::at(100, 60).types("<esc>?<end>").sees();
    assert!(screen.contains("○ ") && screen.contains("≠ a published value is disputed"), "{screen}");
    let screen = Person::in_portuguese(100, 60).types("<esc>?<end>").sees();
    assert!(screen.contains("≠ um valor publicado é contestado"), "{screen}");
}
