//! Each rule holds for a small sound tree and finds the fault that it is there for.

use super::*;

const ANALYSIS: &str = "\
use dalembert_core::register;
pub struct TwoPlane {}

register!(TwoPlane);

const ID: About = About { id: \"balancing/two-plane\", topic: \"Rigid rotors\", cases: include_str!(\"../../cases/two_plane.toml\") };
";

const TWO_PLANE: &str = "plugins/balancing/src/rigid_rotors/two_plane.rs";

const MANIFEST: &str = "\
[lints]
workspace = true

[dependencies]
dalembert-core.workspace = true
nalgebra.workspace = true
";

/// A sound tree with some files in place of its own; an empty text leaves one out.
fn tree(changes: &[(&str, &str)]) -> Tree {
    let mut tree = Tree::of(&[
        ("Cargo.toml", "[workspace.lints.rust]\nunsafe_code = \"forbid\"\n"),
        ("plugins/balancing/Cargo.toml", MANIFEST),
        ("plugins/balancing/src/lib.rs", "pub mod rigid_rotors;\n"),
        ("plugins/balancing/src/rigid_rotors.rs", "//! Rigid rotors.\n\npub mod two_plane;\n"),
        (TWO_PLANE, ANALYSIS),
        ("plugins/balancing/cases/two_plane.toml", "[[case]]\n"),
        (
            "plugins/bundle/Cargo.toml",
            "[lints]\nworkspace = true\n\n[dependencies]\ndalembert-balancing = { version = \"0.1\", path = \"../balancing\" }\n",
        ),
        ("plugins/bundle/src/lib.rs", "use dalembert_balancing as _;\n"),
        (
            "crates/core/Cargo.toml",
            "[lints]\nworkspace = true\n\n[dependencies]\ndalembert-units.workspace = true\n",
        ),
        ("crates/core/src/lib.rs", "use std::{fmt, sync::OnceLock};\n"),
        ("README.md", "See `crates/core/src/lib.rs`, `plugins/NAME/src`, `crates/core`.\n"),
    ]);
    for (path, text) in changes {
        tree.0.insert((*path).to_owned(), (*text).to_owned());
        if text.is_empty() {
            tree.0.remove(*path);
        }
    }
    tree
}

/// The tree has exactly one fault, in these words.
fn finds(changes: &[(&str, &str)], words: &str) {
    let faults = faults(&tree(changes));
    assert_eq!(faults.len(), 1, "{words}: {faults:#?}");
    assert!(faults[0].contains(words), "{words}: {faults:#?}");
}

#[test]
fn a_sound_tree_has_no_faults() {
    assert_eq!(faults(&tree(&[])), [""; 0]);
}

#[test]
fn an_analysis_has_one_name() {
    finds(
        &[(TWO_PLANE, &ANALYSIS.replace("TwoPlane", "Planes"))],
        "two_plane.rs:4: `Planes` in a file named two_plane.rs",
    );
    finds(
        &[(TWO_PLANE, &ANALYSIS.replace("balancing/two", "balance/two"))],
        "must be \"balancing/two-plane\"",
    );
    finds(&[(TWO_PLANE, &format!("{ANALYSIS}register!(Other);\n"))], "a second analysis");
    finds(&[("plugins/balancing/cases/two_plane.toml", "")], "its cases must be in");
    finds(
        &[("plugins/balancing/cases/gone.toml", "[[case]]\n")],
        "no analysis gone.rs of a topic in plugins/balancing/src",
    );
    let topic = "plugins/balancing/src/rigid_rotors.rs";
    finds(
        &[(topic, "//! Rigid rotors.\n")],
        "write `pub mod two_plane;` in plugins/balancing/src/rigid_rotors.rs",
    );
    finds(
        &[("plugins/balancing/src/lib.rs", "//! Nothing.\n")],
        "write `pub mod rigid_rotors;` in plugins/balancing/src/lib.rs",
    );
    finds(
        &[(topic, "//! Rotors.\n\npub mod two_plane;\n")],
        "rigid_rotors.rs:1: the topic is written `//! Rigid rotors.`",
    );
    finds(
        &[(TWO_PLANE, &ANALYSIS.replace("Rigid rotors", "Field balancing"))],
        "two_plane.rs:4: an analysis stands in the folder of its topic, plugins/balancing/src/field_balancing",
    );
}

#[test]
fn a_topic_holds_analyses_alone() {
    let beside = [
        ("plugins/balancing/src/shared.rs", "pub mod rotor;\n"),
        ("plugins/balancing/src/shared/rotor.rs", "pub struct Rotor;\n"),
        ("plugins/balancing/src/sources.rs", "//! Books.\n"),
        ("plugins/balancing/src/rigid_rotors/two_plane/planes.rs", "pub struct Planes;\n"),
    ];
    assert_eq!(faults(&tree(&beside)), [""; 0]);
    for alone in ["planes.rs", "rigid_rotors/planes.rs", "other/planes.rs"] {
        let path = format!("plugins/balancing/src/{alone}");
        finds(&[(&path, "pub struct Planes;\n")], &format!("{alone}: neither an analysis nor a part of one"));
    }
}

#[test]
fn an_analysis_is_imported_by_nothing() {
    let other = "plugins/balancing/src/rigid_rotors/splitting.rs";
    let splitting = ANALYSIS.replace("TwoPlane", "Splitting").replace("two-plane", "splitting");
    let splitting = splitting.replace("two_plane", "splitting");
    let with = |path, text: &str| {
        let topic = "//! Rigid rotors.\n\npub mod splitting;\npub mod two_plane;\n";
        let files = [
            ("plugins/balancing/src/rigid_rotors.rs", topic),
            ("plugins/balancing/cases/splitting.toml", "[[case]]\n"),
            ("plugins/balancing/src/rigid_rotors/two_plane/planes.rs", "pub struct Planes;\n"),
            ("plugins/balancing/src/shared/rotor.rs", "pub struct Rotor;\n"),
            (other, splitting.as_str()),
            (path, text),
        ];
        faults(&tree(&files))
    };
    let uses = |line: &str| format!("{line}\n{splitting}");
    for line in ["use crate::shared::rotor::Rotor;", "use super::splitting::parts::Part;"] {
        assert_eq!(with(other, &uses(line)), [""; 0]);
    }
    let part = "plugins/balancing/src/rigid_rotors/two_plane/planes.rs";
    assert_eq!(with(part, "use super::TwoPlane;\nuse crate::shared::rotor::Rotor;\n"), [""; 0]);
    for line in [
        "use crate::rigid_rotors::two_plane::TwoPlane;",
        "use super::two_plane::planes::Planes;",
        "use crate::{\n    rigid_rotors::two_plane::planes::Planes,\n    shared::rotor::Rotor,\n};",
        "fn x(x: crate::rigid_rotors::two_plane::TwoPlane) {}",
    ] {
        let found = with(other, &uses(line));
        assert_eq!(found.len(), 1, "{line}: {found:#?}");
        assert!(
            found[0].contains(
                "splitting.rs: imports the analysis plugins/balancing/src/rigid_rotors/two_plane.rs"
            )
        );
    }
    let found =
        with("plugins/balancing/src/shared/rotor.rs", "use crate::rigid_rotors::two_plane::TwoPlane;\n");
    assert!(found.len() == 1 && found[0].contains("shared/rotor.rs: imports the analysis"), "{found:#?}");
}

#[test]
fn a_plugin_is_tested_from_outside() {
    let source = "plugins/balancing/src/shared/planes.rs";
    finds(&[(source, "#[test]\nfn sums() {}\n")], "planes.rs:1: is not run here; write the test in");
    assert_eq!(faults(&tree(&[("plugins/balancing/tests/planes.rs", "#[test]\nfn sums() {}\n")])), [""; 0]);
}

#[test]
fn a_plugin_is_in_the_bundle_and_nowhere_else() {
    finds(&[("plugins/bundle/src/lib.rs", "//! None.\n")], "`use dalembert_balancing as _;` is missing");
    let empty = "[lints]\nworkspace = true\n";
    finds(
        &[("plugins/bundle/Cargo.toml", empty)],
        "`dalembert-balancing = { version = \"0.1\", path = \"../balancing\" }` is missing",
    );
    finds(
        &[("crates/core/src/x.rs", "use dalembert_balancing as _;\n")],
        "crates/core/src/x.rs:1: names a plugin",
    );
    let sound =
        "// dalembert-balancing-of-rotors\n#[cfg(test)]\nconst NAME: &str = \"dalembert-balancing\";\n";
    assert_eq!(faults(&tree(&[("crates/core/src/x.rs", sound)])), [""; 0]);
    let named = |line: &str| {
        let manifest = format!("{MANIFEST}{line}\n");
        let faults = faults(&tree(&[("crates/core/Cargo.toml", &manifest)]));
        faults.iter().any(|fault| fault.contains("names a plugin"))
    };
    assert!(named("dalembert-balancing = \"1\"") && !named("[profile.release.package.dalembert-balancing]"));
}

#[test]
fn a_crate_depends_on_what_lies_below() {
    let core = "crates/core/Cargo.toml";
    let with = |line: &str| format!("[lints]\nworkspace = true\n\n[dependencies]\n{line}\n");
    finds(
        &[(core, &with("dalembert-tui.workspace = true"))],
        "crates/core/Cargo.toml:5: may not depend on dalembert-tui",
    );
    finds(&[(core, &with("dalembert = { path = \"../dalembert\" }"))], "may not depend on dalembert");
    finds(
        &[("plugins/balancing/Cargo.toml", &format!("{MANIFEST}ratatui = \"0.30\"\n"))],
        "may not depend on ratatui",
    );
    finds(&[("crates/new/Cargo.toml", &with(""))], "say in xtask/src/tidy/layers.rs");
}

#[test]
fn a_pure_crate_has_no_effects() {
    let source = "crates/core/src/x.rs";
    finds(&[(source, "use std::{\n    fmt::{self, Write},\n    fs,\n};\n")], "std::fs has no place here");
    finds(&[(source, "fn f() { std::fs::read(\"x\"); }\n")], "x.rs:1: std::fs");
    finds(&[(source, "\nfn f() { println!(); }\n")], "x.rs:2: println! has no place");
    finds(&[("crates/tui/src/x.rs", "use std::{io, net::TcpStream};\n")], "std::net has no place here");
    let sound = "/// Not std::fs, and no println!\nuse std::{fmt::{self, fs}, io};\n#[cfg(test)]\nmod tests { use std::fs; }\n";
    assert_eq!(faults(&tree(&[(source, sound)])), [""; 0]);
}

#[test]
fn tests_pair_lists_of_one_length() {
    let source = "plugins/balancing/tests/planes.rs";
    let paired = |of: &str, with: &str| [of, ".zi", "p(", with, ");\n"].concat();
    finds(&[(source, &paired("ours", "theirs"))], "planes.rs:1: lists of different lengths would pass");
    let module = format!("fn f() {{}}\n#[cfg(test)]\nmod tests {{\n    {}}}\n", paired("a", "b"));
    finds(&[("crates/core/src/x.rs", &module)], "x.rs:4: lists of different lengths");
    finds(&[("crates/core/src/x/tests.rs", &paired("a[..2].iter()", "0..3"))], "tests.rs:1: lists");
    for sound in [
        paired("(0..)", "theirs"),
        paired("ours", "1.."),
        paired("ours", "start.."),
        paired("ours", "theirs.cycle()"),
        format!("// {}", paired("ours", "theirs")),
    ] {
        assert_eq!(faults(&tree(&[(source, &sound)])), [""; 0]);
    }
    let code = format!("#[cfg(test)]\nmod tests;\nfn f() {{ {} }}\n", paired("a", "b"));
    assert_eq!(faults(&tree(&[("crates/core/src/x.rs", &code)])), [""; 0]);
}

#[test]
fn a_file_is_written_as_agreed() {
    finds(&[("crates/core/src/a/mod.rs", "//! A.\n")], "write crates/core/src/a.rs");
    finds(&[("crates/core/src/a.rs", &["// TO", "DO\n"].concat())], "is left");
    finds(&[("crates/core/src/a.rs", &["  #[", "allow(dead_code)]\n"].concat())], "write `#[expect(");
    finds(&[("crates/core/Cargo.toml", "[package]\n")], "write `[lints]`");
    finds(&[("Cargo.toml", "[workspace]\n")], "must forbid unsafe code");
    let long = "//\n".repeat(601);
    finds(&[("crates/core/src/a.rs", &long)], "601 lines");
    let with_reason = format!("{long}// Long because it is a table.\n");
    assert_eq!(faults(&tree(&[("crates/core/src/a.rs", &with_reason)])), [""; 0]);
    finds(&[("README.md", "See `crates/gone`.\n")], "README.md:1: there is no crates/gone");
    let begun = "`cargo xtask new-analysis balancing one-plane` writes `plugins/balancing/src/rigid_rotors/one_plane.rs`.\n";
    assert_eq!(faults(&tree(&[("README.md", begun)])), [""; 0]);
}

#[test]
fn a_doc_comment_begins_with_a_noun_or_a_verb() {
    let source = "crates/core/src/x.rs";
    finds(
        &[(source, "struct X {\n    /// Its mass.\n    mass: f64,\n}\n")],
        "x.rs:2: a doc comment begins with a noun or a verb, not with `Its`",
    );
    finds(&[(source, "//! What is shown.\n")], "not with `What`");
    let labels = "/// Hammer.\n#[derive(Clone, Inputs)]\nstruct X {\n    /// Its mass.\n    mass: f64,\n}\n";
    finds(&[(source, &format!("{labels}/// Whether it is open.\nfn f() {{}}\n"))], "x.rs:7: ");
    for sound in [
        labels,
        "/// Mass, kg.\n/// Where it is zero, nothing moves.\nfn f() {}\n",
        "// What follows is no doc comment.\n//// Nor is this.\n",
        "/// Whatever is left.\nfn f() {}\n",
    ] {
        assert_eq!(faults(&tree(&[(source, sound)])), [""; 0]);
    }
}

const GLOSSARY: &str = "\
## Words that do not come back

| Phrase | Write instead | Places | Exceptions |
|---|---|---|---|
| `gap` | residual | code, documents | `crates/core/src/lib.rs`: a gap in a text |
| `mass centre` | centre of mass | messages | |
| `at hand` | given | titles | |

## More
| `sound` | nothing | documents | |
";

#[test]
fn retired_phrases_are_found_in_their_places() {
    let with = |path, text| [("docs/glossary.md", GLOSSARY), (path, text)];
    finds(
        &with("crates/core/src/a.rs", "/// The gap of a loop.\nfn x() {}\n"),
        "a.rs:1: `gap` is retired: write residual",
    );
    finds(&with("crates/core/src/a.rs", "fn largest_gap() {}\n"), "`gap` is retired");
    finds(&with("docs/a.md", "A gap.\n"), "docs/a.md:1: `gap`");
    finds(&with("crates/core/src/a.rs", "const A: &str = \"the mass centre\";\n"), "write centre of mass");
    finds(
        &with("plugins/balancing/cases/two_plane.toml", "note = \"its mass centre\"\n"),
        "two_plane.toml:1: `mass centre`",
    );
    let path = "plugins/balancing/cases/two_plane.toml";
    finds(&with(path, "name = \"A weight at hand\"\n"), "two_plane.toml:1: `at hand`");
    for (path, text) in [
        ("crates/core/src/a.rs", "fn gapless() {}\n"),
        ("crates/core/src/lib.rs", "/// A gap between digits.\nfn x() {}\n"),
        ("crates/core/src/a.rs", "/// The mass centre.\nconst A: &str = \"mass, centre and mass-centre\";\n"),
        (path, "former = \"its mass centre at hand\"\n"),
        (path, "note = \"A weight at hand\"\n"),
        ("docs/a.md", "A sound tree.\n"),
    ] {
        let faults = faults(&tree(&with(path, text)));
        assert!(faults.is_empty(), "{path}: {text}{faults:#?}");
    }
}

#[test]
fn a_loop_of_imports_is_found() {
    let changes = [
        ("crates/core/src/a.rs", "use super::b::B;\npub struct A(B);\n"),
        ("crates/core/src/b.rs", "pub struct B;\nfn x() { crate::c::y() }\n"),
        ("crates/core/src/c.rs", "pub fn y() {}\n"),
    ];
    assert_eq!(faults(&tree(&changes)), [""; 0]);
    let back =
        [changes.as_slice(), &[("crates/core/src/c.rs", "use crate::{a::A, b};\npub fn y() {}\n")]].concat();
    let faults = faults(&tree(&back));
    assert_eq!(faults.len(), 3, "{faults:#?}");
    assert!(
        faults[0].contains("crates/core/src/a.rs: in a loop of imports, with crates/core/src/b.rs"),
        "{faults:#?}"
    );
    // What a module's own test module uses, and what its parts take from it, is no loop.
    let of_tests = [
        ("crates/core/src/a.rs", "mod part;\nuse super::b::B;\n"),
        ("crates/core/src/a/part.rs", "use super::A;\n"),
        ("crates/core/src/b.rs", "pub struct B;\n#[cfg(test)]\nmod tests { use crate::a::A; }\n"),
    ];
    assert_eq!(super::faults(&tree(&of_tests)), [""; 0]);
}

#[test]
fn a_public_module_of_a_library_shows_its_use_and_has_a_topic() {
    let with = |table: &str, module: &str| {
        let library = format!("//! Methods.\n//!\n//! {table}\n\npub mod roots;\nmod real;\n");
        let manifest = "[lints]\nworkspace = true\n";
        tree(&[
            ("crates/numerics/Cargo.toml", manifest),
            ("crates/numerics/src/lib.rs", &library),
            ("crates/numerics/src/roots.rs", module),
            ("crates/numerics/src/real.rs", "//! Numbers.\n"),
        ])
    };
    let (table, example) = ("| zeros | [`roots`] |", "//! ```\n//! assert_eq!(1 + 1, 2);\n//! ```\n");
    let fenced = |words: &str| example.replacen("```", &format!("```{words}"), 1);
    for sound in [example, &fenced("rust"), &fenced("should_panic"), &format!("{}{example}", fenced("text"))]
    {
        assert_eq!(faults(&with(table, &format!("//! Zeros.\n//!\n{sound}"))), [""; 0]);
    }
    let ignored = ["ignore", "text", "no_run", "rust,ignore", "compile_fail"].map(fenced);
    let others =
        ["", "//! ```\n//! 1 + 1;\n//! ```\n", "/// ```\n/// assert!(true);\n/// ```\npub fn f() {}\n"];
    for module in ignored.iter().map(String::as_str).chain(others) {
        let faults = faults(&with(table, &format!("//! Zeros.\n//!\n{module}")));
        assert_eq!(faults.len(), 1, "{module}: {faults:#?}");
        let words =
            "crates/numerics/src/lib.rs:5: the module `roots` has no example that runs and asserts a result";
        assert!(faults[0].starts_with(words), "{faults:#?}");
        assert!(faults[0].contains("the `//!` comment of crates/numerics/src/roots.rs"), "{faults:#?}");
    }
    let faults = faults(&with("See [`roots`].", example));
    assert_eq!(faults.len(), 1, "{faults:#?}");
    assert!(faults[0].contains("write [`roots`] in the table of the front page"), "{faults:#?}");
}
