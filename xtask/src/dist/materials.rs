//! The bill of materials: every crate that the program is built of, with its licence and checksum.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs::{self, File},
    process::Command,
};

use anyhow::{Context, Result, ensure};
use flate2::read::ZlibDecoder;
use serde::Deserialize;
use serde_json::{Value as Json, json};

use super::{Release, triple};
use crate::{
    cargo::{cargo, output, run},
    docs::{array, text},
};

/// The graph of crates, as `cargo metadata` writes it.
#[derive(Deserialize)]
struct Metadata {
    packages: Vec<Package>,
    resolve: Resolve,
}

#[derive(Deserialize)]
struct Package {
    id: String,
    targets: Vec<Target>,
    name: String,
    version: String,
    license: Option<String>,
    source: Option<String>,
}

#[derive(Deserialize)]
struct Target {
    kind: Vec<String>,
}

/// The crates that a program names, as `cargo auditable` writes them into it.
#[derive(Deserialize)]
struct Audited {
    packages: Vec<AuditedPackage>,
}

#[derive(Deserialize)]
struct AuditedPackage {
    name: String,
    version: String,
}

#[derive(Deserialize)]
struct Resolve {
    nodes: Vec<Node>,
}

#[derive(Deserialize)]
struct Node {
    id: String,
    deps: Vec<Dependency>,
}

#[derive(Deserialize)]
struct Dependency {
    pkg: String,
    dep_kinds: Vec<DependencyKind>,
}

#[derive(Deserialize)]
struct DependencyKind {
    kind: Option<String>,
}

/// The checksums of the lock file.
#[derive(Deserialize)]
struct Lock {
    package: Vec<Locked>,
}

#[derive(Deserialize)]
struct Locked {
    name: String,
    version: String,
    checksum: Option<String>,
}

/// Writes the bill of materials in CycloneDX 1.5.
pub(super) fn write(release: &Release) -> Result<()> {
    let arguments = ["metadata", "--format-version", "1", "--locked", "--filter-platform", &triple()];
    let metadata: Metadata = serde_json::from_str(&output(cargo(&release.root).args(arguments))?)?;
    let lock: Lock = toml::from_str(&fs::read_to_string(release.root.join("Cargo.lock"))?)?;
    let bill = bill(&metadata, &lock, &release.version)?;
    let listed: BTreeSet<String> =
        array(&bill["components"]).iter().map(|one| named(text(one, "name"), text(one, "version"))).collect();
    let held = held(release)?;
    let missing: Vec<&String> = listed.difference(&held).collect();
    ensure!(missing.is_empty(), "the program does not name {missing:?}, which are in the bill of materials");
    let text = serde_json::to_string_pretty(&bill)?;
    let file = release.folder.join(format!("dalembert-{}.cdx.json", release.version));
    fs::write(&file, text + "\n")?;
    super::report(&file)
}

fn named(name: &str, version: &str) -> String {
    format!("{name} {version}")
}

/// The crates that the program names, with their versions: its parts, and macros and what builds it.
fn held(release: &Release) -> Result<BTreeSet<String>> {
    let [section, copy] = ["crates", "copy"].map(|name| release.folder.join(name));
    run(Command::new("objcopy")
        .arg("--dump-section")
        .arg(format!(".dep-v0={}", section.display()))
        .args([&release.program, &copy]))?;
    let audited: Audited = serde_json::from_reader(ZlibDecoder::new(File::open(&section)?))
        .context("the list of crates in the program cannot be read")?;
    [section, copy].iter().try_for_each(fs::remove_file)?;
    Ok(audited.packages.iter().map(|one| named(&one.name, &one.version)).collect())
}

/// The crates that are linked into the program; those that only build it or test it, and macros, are none of it.
fn bill(metadata: &Metadata, lock: &Lock, version: &str) -> Result<Json> {
    let program = metadata.packages.iter().find(|package| package.name == "dalembert");
    let program = program.context("the program is no package of the workspace")?;
    let nodes: BTreeMap<&str, &Node> = metadata.resolve.nodes.iter().map(|node| (&*node.id, node)).collect();
    let packages: BTreeMap<&str, &Package> = metadata.packages.iter().map(|one| (&*one.id, one)).collect();
    let (mut linked, mut open) = (BTreeSet::new(), vec![&*program.id]);
    while let Some(id) = open.pop() {
        if !linked.insert(id) {
            continue;
        }
        let node = nodes.get(id).with_context(|| format!("{id} is not in the graph"))?;
        let is_macro = |id: &str| {
            packages.get(id).is_some_and(|one| one.targets.iter().any(|target| target.kind == ["proc-macro"]))
        };
        let is_linked =
            |one: &&Dependency| !is_macro(&one.pkg) && one.dep_kinds.iter().any(|kind| kind.kind.is_none());
        open.extend(node.deps.iter().filter(is_linked).map(|one| &*one.pkg));
    }
    let checksum = |package: &Package| {
        let of = |locked: &&Locked| locked.name == package.name && locked.version == package.version;
        lock.package.iter().find(of).and_then(|locked| locked.checksum.clone())
    };
    let component = |package: &Package| {
        let mut component = json!({
            "type": "library",
            "name": package.name,
            "version": package.version,
            "licenses": [{ "expression": package.license.as_deref().unwrap_or("NOASSERTION") }],
        });
        if package.source.is_some() {
            component["purl"] = json!(format!("pkg:cargo/{}@{}", package.name, package.version));
        }
        if let Some(checksum) = checksum(package) {
            component["hashes"] = json!([{ "alg": "SHA-256", "content": checksum }]);
        }
        component
    };
    let is_part = |package: &&Package| linked.contains(&*package.id) && package.id != program.id;
    let components: Vec<Json> = metadata.packages.iter().filter(is_part).map(component).collect();
    Ok(json!({
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "version": 1,
        "metadata": { "component": { "type": "application", "name": "dalembert", "version": version } },
        "components": components,
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_builds_the_program_is_not_part_of_it() {
        let metadata = r#"{
            "packages": [
                { "id": "p", "name": "dalembert", "version": "1.0.0", "license": "MIT", "source": null, "targets": [] },
                { "id": "a", "name": "a", "version": "2.0.0", "license": "MIT", "source": "registry", "targets": [{ "kind": ["lib"] }] },
                { "id": "b", "name": "b", "version": "3.0.0", "license": null, "source": "registry", "targets": [{ "kind": ["lib"] }] },
                { "id": "c", "name": "c", "version": "4.0.0", "license": null, "source": "registry", "targets": [{ "kind": ["lib"] }] },
                { "id": "d", "name": "d", "version": "5.0.0", "license": null, "source": "registry", "targets": [{ "kind": ["proc-macro"] }] }
            ],
            "resolve": { "nodes": [
                { "id": "p", "deps": [
                    { "pkg": "a", "dep_kinds": [{ "kind": null }] },
                    { "pkg": "b", "dep_kinds": [{ "kind": "build" }] }
                ] },
                { "id": "a", "deps": [{ "pkg": "c", "dep_kinds": [{ "kind": "dev" }, { "kind": null }] },
                    { "pkg": "d", "dep_kinds": [{ "kind": null }] }] },
                { "id": "b", "deps": [] },
                { "id": "c", "deps": [{ "pkg": "a", "dep_kinds": [{ "kind": null }] }] },
                { "id": "d", "deps": [] }
            ] }
        }"#;
        let lock = "[[package]]\nname = \"a\"\nversion = \"2.0.0\"\nchecksum = \"12\"\n";
        let (metadata, lock) = (serde_json::from_str(metadata), toml::from_str(lock));
        let bill = bill(&metadata.expect("a graph"), &lock.expect("a lock file"), "1.0.0").expect("a bill");
        let names: Vec<&str> = bill["components"]
            .as_array()
            .into_iter()
            .flatten()
            .filter_map(|one| one["name"].as_str())
            .collect();
        assert_eq!(names, ["a", "c"]);
        assert_eq!(bill["components"][0]["hashes"][0]["content"], "12");
        assert_eq!(bill["components"][1]["licenses"][0]["expression"], "NOASSERTION");
    }
}
