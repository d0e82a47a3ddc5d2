//! One analysis, one file in the folder of its topic; its id, file, type and case file have the same name.

use std::collections::BTreeSet;

use super::{Tree, lines, loops::imports};
use crate::{
    names::{pascal, snake, snake_of},
    new_plugin,
};

/// Files beside the topics in the sources of a family.
const BESIDE: [&str; 3] = ["lib", "shared", "sources"];

pub(super) fn an_analysis_is_one_file(tree: &Tree) -> Vec<String> {
    let mut faults = Vec::new();
    for (path, text) in tree.sources() {
        let Some((family, file)) = place(path) else { continue };
        let registered: Vec<(usize, &str)> = lines(text)
            .filter_map(|(n, line)| Some((n, line.strip_prefix("register!(")?.strip_suffix(");")?)))
            .collect();
        let Some(&(line, analysis)) = registered.first() else { continue };
        if let Some((line, _)) = registered.get(1) {
            faults.push(format!("{path}:{line}: a second analysis in one file; give it a file of its own"));
        }
        let heading = topic(text).unwrap_or_default();
        let folder = snake_of(heading);
        let name = match file.split_once('/') {
            Some((beside, name)) if beside == folder && !name.contains('/') => name,
            _ => {
                faults.push(format!(
                    "{path}:{line}: an analysis stands in the folder of its topic, plugins/{family}/src/{folder}"
                ));
                continue;
            }
        };
        if analysis != pascal(name) {
            let wanted = pascal(name);
            faults.push(format!("{path}:{line}: `{analysis}` in a file named {name}.rs; call it `{wanted}`"));
        }
        let id = format!("{family}/{}", name.replace('_', "-"));
        if !text.contains(&format!("id: \"{id}\"")) {
            faults.push(format!("{path}:{line}: the id of this analysis must be \"{id}\""));
        }
        let cases = format!("cases/{name}.toml");
        if !text.contains(&format!("include_str!(\"../../{cases}\")"))
            || !tree.has(&format!("plugins/{family}/{cases}"))
        {
            faults.push(format!("{path}:{line}: its cases must be in plugins/{family}/{cases}"));
        }
        for (module, within, wanted) in [
            (name, format!("plugins/{family}/src/{folder}.rs"), format!("//! {heading}.")),
            (folder.as_str(), format!("plugins/{family}/src/lib.rs"), String::new()),
        ] {
            let have = tree.text(&within).unwrap_or_default();
            if !lines(have).any(|(_, line)| line == format!("pub mod {module};")) {
                faults.push(format!("{path}: is not compiled; write `pub mod {module};` in {within}"));
            } else if !have.starts_with(&wanted) {
                faults.push(format!("{within}:1: the topic is written `{wanted}`, as its analyses name it"));
            }
        }
    }
    for (path, _) in tree.iter() {
        let Some((family, name)) = path
            .strip_prefix("plugins/")
            .and_then(|rest| rest.split_once("/cases/"))
            .and_then(|(family, file)| Some((family, file.strip_suffix(".toml")?)))
        else {
            continue;
        };
        let source = |(path, text): (&str, &str)| {
            place(path).is_some_and(|(of, file)| of == family && file.ends_with(&format!("/{name}")))
                && is_registered(text)
        };
        if name != snake(name) || !tree.sources().any(source) {
            faults.push(format!(
                "{path}: no analysis {name}.rs of a topic in plugins/{family}/src has these cases"
            ));
        }
    }
    faults.sort();
    faults.dedup();
    faults
}

/// A topic holds analyses alone: parts that several of them use stand in `shared`.
pub(super) fn a_topic_holds_analyses_alone(tree: &Tree) -> Vec<String> {
    let analyses: BTreeSet<&str> = tree
        .sources()
        .filter(|(_, text)| is_registered(text))
        .map(|(path, _)| path.trim_end_matches(".rs"))
        .collect();
    let topics: BTreeSet<&str> =
        analyses.iter().filter_map(|path| path.rsplit_once('/')).map(|(topic, _)| topic).collect();
    let mut faults = Vec::new();
    for (path, _) in tree.sources() {
        let Some((family, file)) = place(path) else { continue };
        let source = path.trim_end_matches(".rs");
        let above = source.match_indices('/').map(|(at, _)| &source[..at]);
        if BESIDE.iter().any(|beside| file.split('/').next() == Some(beside))
            || topics.contains(source)
            || analyses.contains(source)
            || above.into_iter().any(|folder| analyses.contains(folder))
        {
            continue;
        }
        faults.push(format!(
            "{path}: neither an analysis nor a part of one; what several use stands in plugins/{family}/src/shared"
        ));
    }
    faults
}

/// An analysis is a face, not a library: it can be changed, moved and taken out alone.
pub(super) fn an_analysis_is_imported_by_nothing(tree: &Tree) -> Vec<String> {
    let analyses: BTreeSet<&str> = tree
        .sources()
        .filter(|(path, text)| place(path).is_some() && is_registered(text))
        .map(|(path, _)| path)
        .collect();
    let is_part = |path: &str, analysis: &str| {
        path.strip_prefix(analysis.trim_end_matches(".rs"))
            .is_some_and(|rest| rest == ".rs" || rest.starts_with('/'))
    };
    let mut faults = Vec::new();
    for (path, others) in imports(tree, "plugins/") {
        for other in others {
            let of = analyses.iter().find(|analysis| is_part(other, analysis));
            if let Some(analysis) = of.filter(|analysis| !is_part(path, analysis)) {
                faults
                    .push(format!("{path}: imports the analysis {analysis}; move what both use to `shared`"));
            }
        }
    }
    faults
}

/// With tests inside, a plugin would be compiled a second time for them; its manifest turns them off.
pub(super) fn a_plugin_is_tested_from_outside(tree: &Tree) -> Vec<String> {
    let mut faults = Vec::new();
    let of_plugins =
        tree.sources().filter(|(path, _)| path.starts_with("plugins/") && path.contains("/src/"));
    for (path, text) in of_plugins {
        if let Some((n, _)) = lines(text).find(|(_, line)| line.trim() == "#[test]") {
            let (plugin, _) = path.split_once("/src/").unwrap_or_default();
            faults.push(format!("{path}:{n}: is not run here; write the test in {plugin}/tests"));
        }
    }
    faults
}

pub(super) fn every_plugin_is_in_the_bundle(tree: &Tree) -> Vec<String> {
    let manifest = tree.text("plugins/bundle/Cargo.toml").unwrap_or_default();
    let library = tree.text("plugins/bundle/src/lib.rs").unwrap_or_default();
    let mut faults = Vec::new();
    for family in tree.families() {
        let line = new_plugin::dependency(family);
        if !lines(manifest).any(|(_, have)| have == line) {
            faults.push(format!("plugins/bundle/Cargo.toml: `{line}` is missing"));
        }
        let line = format!("use dalembert_{} as _;", snake(family));
        if !lines(library).any(|(_, have)| have == line) {
            faults.push(format!("plugins/bundle/src/lib.rs: `{line}` is missing"));
        }
    }
    faults
}

/// `plugins/FAMILY/src/FILE.rs` as family and file.
fn place(path: &str) -> Option<(&str, &str)> {
    let (family, file) = path.strip_prefix("plugins/")?.split_once("/src/")?;
    Some((family, file.strip_suffix(".rs")?)).filter(|_| family != "bundle")
}

fn is_registered(text: &str) -> bool {
    text.contains("\nregister!(")
}

/// The topic that an analysis names.
fn topic(text: &str) -> Option<&str> {
    text.split_once("topic: \"")?.1.split('"').next()
}
