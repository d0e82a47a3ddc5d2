//! The solver of the pages: the analyses as WebAssembly in a script.

use std::{
    fs,
    path::{Path, PathBuf},
    process::Command,
};

use anyhow::{Context as _, Result};

use crate::cargo::{cargo, installed, output, run, target};

/// Target of the module.
const TARGET: &str = "wasm32-unknown-unknown";
/// Name of the script in the handbook.
pub(super) const SCRIPT: &str = "solver.js";

/// Builds the solver and writes its script into a folder; why it cannot be built, where the machine has not what it needs.
pub(super) fn build(root: &Path, folder: &Path) -> Result<Result<(), String>> {
    if let Some(missing) = missing(root)? {
        return Ok(Err(missing));
    }
    let target = target(root);
    let web = ["--package", "dalembert-web", "--lib", "--crate-type", "cdylib", "--profile", "web"];
    run(cargo(root)
        .args(["rustc", "--quiet", "--locked", "--target", TARGET])
        .args(web)
        .env("CARGO_TARGET_DIR", &target))?;
    let module = target.join(TARGET).join("web/dalembert_web.wasm");
    fs::create_dir_all(folder).with_context(|| format!("{} cannot be made", folder.display()))?;
    let script = ["run", "--quiet", "--locked", "--package", "xtask", "--features", "solver"];
    let paths = [module, folder.join(SCRIPT)].into_iter().chain(cases(root)?);
    run(cargo(root)
        .args(script)
        .args(["--bin", "solver-script", "--"])
        .args(paths)
        .env("CARGO_TARGET_DIR", &target))?;
    Ok(Ok(()))
}

/// The files of published cases.
fn cases(root: &Path) -> Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for family in fs::read_dir(root.join("plugins")).context("plugins cannot be read")? {
        let folder = family?.path().join("cases");
        // The bundle has none.
        for file in fs::read_dir(folder).into_iter().flatten() {
            found.push(file?.path());
        }
    }
    Ok(found)
}

/// The part of the tool chain that the machine lacks, and how to get it.
fn missing(root: &Path) -> Result<Option<String>> {
    let libraries = output(Command::new("rustc").current_dir(root).args([
        "--print",
        "target-libdir",
        "--target",
        TARGET,
    ]))?;
    if !Path::new(libraries.trim()).is_dir() {
        return Ok(Some(format!("Rust has no target {TARGET}: `rustup target add {TARGET}`")));
    }
    // Packages of this target alone may not have been fetched yet.
    let fetched = installed(cargo(root).args(["fetch", "--quiet", "--locked", "--target", TARGET]));
    Ok((!fetched).then(|| "the packages of WebAssembly cannot be fetched".to_owned()))
}
