use std::env;

use super::*;
use crate::tidy::{Tree, faults};

/// A repository with one family, in a folder of this test.
fn repository(of: &str) -> PathBuf {
    let root = env::temp_dir().join(format!("dalembert-xtask-{}-{of}", std::process::id()));
    let _ = fs::remove_dir_all(&root);
    for (path, text) in [
        ("Cargo.toml", "[workspace.lints.rust]\nunsafe_code = \"forbid\"\n"),
        ("plugins/vibration/Cargo.toml", "[lints]\nworkspace = true\n"),
        (
            "plugins/vibration/src/lib.rs",
            "//! Vibration.\n\npub mod free_vibration;\npub mod shared;\n\nmod sources;\n",
        ),
        (
            "plugins/vibration/src/free_vibration.rs",
            "//! Free vibration.\n\npub mod decay;\npub mod spring;\n",
        ),
        ("plugins/vibration/src/free_vibration/decay.rs", &analysis("Decay", "decay")),
        ("plugins/vibration/cases/decay.toml", "[[case]]\n"),
        ("plugins/vibration/src/shared.rs", "//! Parts that several analyses share.\n"),
        ("plugins/vibration/src/shared/load.rs", "//! Loads.\n"),
        (
            "plugins/vibration/locales/pt-BR.ftl",
            "mass = Massa\nmaximum-speed = Maior rotação\n    .decay = Maior taxa\n",
        ),
        (
            "plugins/bundle/Cargo.toml",
            "[lints]\nworkspace = true\n\n[dependencies]\ndalembert-vibration = { version = \"0.1\", path = \"../vibration\" }\n",
        ),
        ("plugins/bundle/src/lib.rs", "use dalembert_vibration as _;\n"),
        (
            "docs/theory/derivations.toml",
            "# Sections.\n\n[\"vibration/decay\"]\n\"damping#decay\" = [\"\"]\n",
        ),
        ("crates/core/locales/pt-BR.ftl", "period = Período da oscilação\n"),
    ] {
        write(&root.join(path), text).unwrap();
    }
    root
}

fn analysis(type_name: &str, name: &str) -> String {
    format!(
        "//! {type_name}.\n\nregister!({type_name});\n\nconst ABOUT: About = About {{\n    id: \"vibration/{name}\",\n    \
         topic: \"Free vibration\",\n    cases: include_str!(\"../../cases/{name}.toml\"),\n}};\n"
    )
}

#[test]
fn a_new_analysis_is_two_files_and_three_changes_and_tidy() {
    let root = repository("sound");
    run(&root, "vibration", "mass-on-spring", Some("free vibration")).unwrap();
    let source = read(&root.join("plugins/vibration/src/free_vibration/mass_on_spring.rs")).unwrap();
    assert!(source.contains("topic: \"Free vibration\""), "{source}");
    assert!(source.contains("register!(MassOnSpring);") && source.contains("\"vibration/mass-on-spring\""));
    assert!(
        !source.contains("nalysisName")
            && !source.contains("nalysis_name")
            && !source.contains("nalysis-name")
            && !source.contains("opic of it")
    );
    let topic = read(&root.join("plugins/vibration/src/free_vibration.rs")).unwrap();
    assert_eq!(topic, "//! Free vibration.\n\npub mod decay;\npub mod mass_on_spring;\npub mod spring;\n");
    let translations = read(&root.join("plugins/vibration/locales/pt-BR.ftl")).unwrap();
    assert_eq!(
        translations.matches("\nmass = ").count() + usize::from(translations.starts_with("mass = ")),
        1
    );
    // A sentence that the family has in other words is translated for the new analysis alone.
    let speed =
        "maximum-speed = Maior rotação\n    .mass-on-spring = Velocidade máxima\n    .decay = Maior taxa\n";
    assert!(translations.contains(speed), "{translations}");
    assert!(translations.contains("period = Período da oscilação\n"), "{translations}");
    assert!(translations.contains("mass-on-spring = Mass on spring\n"), "{translations}");
    let derivations = read(&root.join(DERIVATIONS)).unwrap();
    let own = "[\"vibration/mass-on-spring\"]\n\"one-degree-of-freedom#viscous-damping\" = [\"\"]\n";
    assert!(derivations.ends_with(&format!("\"damping#decay\" = [\"\"]\n\n{own}")), "{derivations}");
    assert_eq!(faults(&Tree::read(&root).unwrap()), [""; 0]);
    fs::remove_dir_all(&root).unwrap();
}

#[test]
fn tables_of_derivations_keep_their_order() {
    let before = "# Sections.\n\n[\"a/a\"]\nx = [\"\"]\n\n[\"b/b\"]\ny = [\"\"]\n";
    let expected =
        format!("# Sections.\n\n[\"a/a\"]\nx = [\"\"]\n\n[\"a/b\"]\n{SECTION}\n\n[\"b/b\"]\ny = [\"\"]\n");
    assert_eq!(with_derivation(before, "a/b"), expected);
}

#[test]
fn a_topic_is_begun_with_its_first_analysis() {
    let root = repository("topic");
    run(&root, "vibration", "drop-test", Some("Shock and impact")).unwrap();
    let topic = read(&root.join("plugins/vibration/src/shock_and_impact.rs")).unwrap();
    assert_eq!(topic, "//! Shock and impact.\n\npub mod drop_test;\n");
    let library = read(&root.join("plugins/vibration/src/lib.rs")).unwrap();
    assert!(library.contains("pub mod shared;\npub mod shock_and_impact;\n"), "{library}");
    let translations = read(&root.join("plugins/vibration/locales/pt-BR.ftl")).unwrap();
    assert!(translations.contains("shock-and-impact = Shock and impact\n"), "{translations}");
    assert_eq!(faults(&Tree::read(&root).unwrap()), [""; 0]);
    fs::remove_dir_all(&root).unwrap();
}

#[test]
fn without_a_topic_the_family_names_its_own() {
    let known = ["Free vibration".to_owned(), "Shock and impact".to_owned()];
    for (asked, words) in [
        (None, "the family has \"Free vibration\", \"Shock and impact\""),
        (Some("Shock and impacts"), "did you mean \"Shock and impact\"?"),
        (Some("shared"), "\"shared\" cannot be a topic"),
        (Some("../Other"), "cannot be a topic"),
    ] {
        let err = chosen(asked, &known).unwrap_err().to_string();
        assert!(err.contains(words), "{err}");
    }
    assert_eq!(chosen(Some("shock-and-impact"), &known).unwrap(), "Shock and impact");
    assert_eq!(chosen(Some("Wind, waves"), &known).unwrap(), "Wind, waves");
}

#[test]
fn a_name_that_cannot_be_is_refused_and_nothing_is_written() {
    let root = repository("refused");
    for (family, name, words) in [
        ("vibrations", "demo", "did you mean `vibration`?"),
        ("vibration", "decay", "is taken: there is plugins/vibration/src/free_vibration/decay.rs"),
        ("vibration", "Demo Case", "write `demo-case`"),
        ("vibration", "match", "cannot name a file of Rust code"),
        ("bundle", "demo", "there is no family `bundle`"),
    ] {
        let err = run(&root, family, name, Some("Free vibration")).unwrap_err().to_string();
        assert!(err.contains(words), "{err}");
    }
    let files = fs::read_dir(root.join("plugins/vibration/src/free_vibration")).unwrap().count();
    assert_eq!(files, 1);
    let translations = read(&root.join("plugins/vibration/locales/pt-BR.ftl")).unwrap();
    assert!(!translations.contains("demo"), "{translations}");
    fs::remove_dir_all(&root).unwrap();
}

#[test]
fn the_first_module_of_a_library_stands_below_its_documentation() {
    assert_eq!(with_module("//! Vibration.\n", "demo"), "//! Vibration.\n\npub mod demo;\n");
    assert_eq!(with_module("pub mod a;\n\nuse x;\n", "b"), "pub mod a;\npub mod b;\n\nuse x;\n");
}
