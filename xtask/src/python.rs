//! `cargo xtask python`: the Python module as a user has it, a wheel in a fresh environment, with its tests, notebook and
//! example of a cluster; and the short proof of it in `verify`.

use std::{
    fs,
    path::{Path, PathBuf},
    process::{Command, Stdio},
};

use anyhow::{Context, Result, ensure};

use crate::cargo::{cargo, output, run as run_command, target};

/// Folder of the module.
pub(crate) const FOLDER: &str = "python";

/// Packages from the index that build and test the module.
const PACKAGES: [&str; 8] =
    ["maturin", "numpy", "pint", "nbclient", "ipykernel", "dask[distributed]", "pytest", "mypy"];

/// Builds the wheel, installs it beside what its tests need, and runs these; prints what a call and a point take.
pub fn run(root: &Path) -> Result<()> {
    let (folder, place) = (root.join(FOLDER), target(root).join("python"));
    let (environment, wheels) = (place.join("environment"), place.join("wheels"));
    for old in [&environment, &wheels] {
        if old.exists() {
            fs::remove_dir_all(old).with_context(|| format!("{} cannot be removed", old.display()))?;
        }
    }
    run_command(Command::new("python3").args(["-m", "venv"]).arg(&environment))?;
    let python = environment.join("bin").join("python");
    run_command(Command::new(&python).args(["-m", "pip", "install", "--quiet"]).args(PACKAGES))?;
    let mut lints = cargo(&folder);
    lints.env("CARGO_TARGET_DIR", target(root)).args(["clippy", "--locked"]).args(EXTENSION);
    run_command(lints.args(["--", "-D", "warnings"]))?;
    // The release profile of the program.
    let mut wheel = Command::new(environment.join("bin").join("maturin"));
    wheel.current_dir(&folder).env("CARGO_TARGET_DIR", target(root));
    wheel.args(["build", "--release", "--locked", "--config", "../Cargo.toml", "--out"]).arg(&wheels);
    run_command(&mut wheel)?;
    let wheel = built(&wheels)?;
    run_command(Command::new(&python).args(["-m", "pip", "install", "--quiet"]).arg(&wheel))?;
    // Away from the sources, so that what is installed is what is imported.
    let installed = |arguments: &[&str]| {
        let mut command = Command::new(&python);
        command.current_dir(&place).args(arguments);
        command
    };
    let tests = folder.join("tests");
    run_command(&mut installed(&["-m", "mypy", "--strict", "-p", "dalembert"]))?;
    run_command(
        installed(&["-m", "pytest", "--quiet", "-p", "no:cacheprovider", "--rootdir"])
            .arg(&place)
            .arg(&tests),
    )?;
    run_command(installed(&[]).arg(tests.join("figures.py")))?;
    let size = fs::metadata(&wheel)?.len();
    println!("{}: {:.1} MB", wheel.file_name().unwrap_or_default().to_string_lossy(), size as f64 / 1e6);
    Ok(())
}

/// The module is an extension: the interpreter that loads it has what it calls.
const EXTENSION: [&str; 2] = ["--features", "pyo3/extension-module"];

/// The wheel in a folder.
pub(crate) fn built(wheels: &Path) -> Result<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(wheels)? {
        found.push(entry?.path());
    }
    ensure!(found.len() == 1, "one wheel is built, and there are {}", found.len());
    found.pop().context("no wheel is built")
}

/// Builds the module without optimisation, with these options of cargo, and solves with it in the interpreter that is
/// there, which needs no other package; `None` where there is none.
pub(crate) fn smoke(root: &Path, options: &[String]) -> Result<Option<String>> {
    let version =
        Command::new("python3").arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    if !version.is_ok_and(|status| status.success()) {
        return Ok(None);
    }
    let folder = root.join(FOLDER);
    let mut build = cargo(&folder);
    build.env("CARGO_TARGET_DIR", target(root)).args(["build", "--quiet", "--locked"]);
    run_command(build.args(EXTENSION).args(options))?;
    let package = target(root).join("python").join("smoke").join("dalembert");
    fs::create_dir_all(&package).with_context(|| format!("{} cannot be made", package.display()))?;
    for entry in fs::read_dir(folder.join("package").join("dalembert"))? {
        let path = entry?.path();
        if let Some(name) = path.file_name().filter(|_| path.is_file()) {
            fs::copy(&path, package.join(name))
                .with_context(|| format!("{} cannot be copied", path.display()))?;
        }
    }
    let library = target(root).join("debug").join("lib_native.so");
    fs::copy(&library, package.join("_native.abi3.so"))
        .with_context(|| format!("{} cannot be copied", library.display()))?;
    let mut solve = Command::new("python3");
    solve.env("PYTHONPATH", package.parent().unwrap_or(&package)).env("PYTHONDONTWRITEBYTECODE", "1");
    let said = output(solve.arg(folder.join("tests").join("smoke.py")))?;
    Ok(Some(said.trim().to_owned()))
}
