//! Files of a crate do not import each other in a loop.

use std::collections::{BTreeMap, BTreeSet};

use syn::{
    UseTree,
    visit::{self, Visit},
};

use super::Tree;

/// A module of a crate: the folder of the crate, and the names from its root.
type Module = (String, Vec<String>);

/// The files below a folder, and those of the same crate that each imports. A module and what lies below it are one
/// thing: its face may name its parts.
pub(super) fn imports<'t>(tree: &'t Tree, below: &str) -> BTreeMap<&'t str, BTreeSet<&'t str>> {
    let sources: BTreeMap<Module, (&str, &str)> = tree
        .sources()
        .filter(|(path, _)| path.starts_with(below))
        .filter_map(|(path, text)| Some((module(path)?, (path, text))))
        .collect();
    let mut imports = BTreeMap::new();
    for (module, (path, text)) in &sources {
        let Ok(parsed) = syn::parse_file(text) else { continue };
        let mut paths = Paths::default();
        paths.visit_file(&parsed);
        let met = paths.0.iter().filter_map(|path| resolved(module, path, &sources));
        let others = met.filter(|other| !is_within(module, other) && !is_within(other, module));
        imports.insert(*path, others.map(|other| sources[other].0).collect());
    }
    imports
}

pub(super) fn files_do_not_import_each_other_in_a_loop(tree: &Tree) -> Vec<String> {
    let mut imports = imports(tree, "");
    // What imports nothing of the rest, or is imported by nothing of it, is in no loop.
    loop {
        let all: BTreeSet<&str> = imports.keys().copied().collect();
        let used: BTreeSet<&str> = imports.values().flatten().copied().collect();
        let before = imports.len();
        imports.retain(|file, others| {
            others.retain(|other| all.contains(other));
            !others.is_empty() && used.contains(file)
        });
        if imports.len() == before {
            break;
        }
    }
    imports
        .iter()
        .map(|(file, others)| {
            let names: Vec<&str> = others.iter().copied().collect();
            format!("{file}: in a loop of imports, with {}", names.join(", "))
        })
        .collect()
}

/// The module that a file holds.
fn module(path: &str) -> Option<Module> {
    let (folder, inner) = path.split_once("/src/")?;
    let names = inner.strip_suffix(".rs")?;
    if names.split('/').any(|name| name == "tests") {
        return None;
    }
    let names = if ["lib", "main"].contains(&names) {
        Vec::new()
    } else {
        names.split('/').map(str::to_owned).collect()
    };
    Some((folder.to_owned(), names))
}

fn is_within(inner: &Module, outer: &Module) -> bool {
    inner.0 == outer.0 && inner.1.starts_with(&outer.1)
}

/// The file that a path leads to from a module: as far as there are modules along it.
fn resolved<'t>(
    from: &Module,
    path: &[String],
    sources: &'t BTreeMap<Module, (&str, &str)>,
) -> Option<&'t Module> {
    let mut rest = path;
    let mut at = from.1.clone();
    match rest.first()?.as_str() {
        "crate" => (at, rest) = (Vec::new(), &rest[1..]),
        "self" => rest = &rest[1..],
        "super" => {
            while rest.first().is_some_and(|name| name == "super") {
                at.pop();
                rest = &rest[1..];
            }
        }
        _ => return None,
    }
    let mut found = None;
    for name in rest {
        at.push(name.clone());
        match sources.get_key_value(&(from.0.clone(), at.clone())) {
            Some((module, _)) => found = Some(module),
            None => break,
        }
    }
    found
}

/// The paths of a file, from its imports and its code; tests are left out.
#[derive(Default)]
struct Paths(Vec<Vec<String>>);

impl<'ast> Visit<'ast> for Paths {
    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        self.flatten(&item.tree, &mut Vec::new());
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        self.0.push(path.segments.iter().map(|segment| segment.ident.to_string()).collect());
        visit::visit_path(self, path);
    }

    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if item.ident != "tests" {
            visit::visit_item_mod(self, item);
        }
    }
}

impl Paths {
    fn flatten(&mut self, tree: &UseTree, before: &mut Vec<String>) {
        match tree {
            UseTree::Path(path) => {
                before.push(path.ident.to_string());
                self.flatten(&path.tree, before);
                before.pop();
            }
            UseTree::Group(group) => group.items.iter().for_each(|item| self.flatten(item, before)),
            UseTree::Name(name) => self.0.push([before.as_slice(), &[name.ident.to_string()]].concat()),
            UseTree::Rename(name) => self.0.push([before.as_slice(), &[name.ident.to_string()]].concat()),
            UseTree::Glob(_) => self.0.push(before.clone()),
        }
    }
}
