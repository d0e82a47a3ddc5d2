//! One analysis, one file; its id, file, type and case file have the same name.

use super::{Tree, lines};
use crate::names::{pascal, snake};

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
        let name = file.trim_end_matches(".rs");
        if name.contains('/') {
            faults.push(format!("{path}:{line}: an analysis stands directly in plugins/{family}/src"));
            continue;
        }
        if analysis != pascal(name) {
            let wanted = pascal(name);
            faults.push(format!("{path}:{line}: `{analysis}` in a file named {file}; call it `{wanted}`"));
        }
        let id = format!("{family}/{}", name.replace('_', "-"));
        if !text.contains(&format!("id: \"{id}\"")) {
            faults.push(format!("{path}:{line}: the id of this analysis must be \"{id}\""));
        }
        let cases = format!("cases/{name}.toml");
        if !text.contains(&format!("include_str!(\"../{cases}\")"))
            || !tree.has(&format!("plugins/{family}/{cases}"))
        {
            faults.push(format!("{path}:{line}: its cases must be in plugins/{family}/{cases}"));
        }
        let library = tree.text(&format!("plugins/{family}/src/lib.rs")).unwrap_or_default();
        if !lines(library).any(|(_, line)| line.ends_with(&format!("mod {name};"))) {
            faults.push(format!(
                "{path}: is not compiled; write `pub mod {name};` in plugins/{family}/src/lib.rs"
            ));
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
        let source = format!("plugins/{family}/src/{}.rs", snake(name));
        if name != snake(name) || !tree.text(&source).is_some_and(|text| text.contains("\nregister!(")) {
            faults.push(format!("{path}: no analysis in {source} has these cases"));
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
        let line = format!("dalembert-{family} = {{ path = \"../{family}\" }}");
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

/// `plugins/FAMILY/src/FILE` as family and file.
fn place(path: &str) -> Option<(&str, &str)> {
    let (family, file) = path.strip_prefix("plugins/")?.split_once("/src/")?;
    (family != "bundle").then_some((family, file))
}
