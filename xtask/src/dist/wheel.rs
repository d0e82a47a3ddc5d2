//! The wheel: the Python module, and the program as its script, so that `pip`, `pipx` and `uv` install both.

use std::{
    fs,
    path::{Path, PathBuf},
    process::Command,
};

use anyhow::{Context, Result};

use super::Release;
use crate::{
    cargo::{run as run_command, target},
    python::{self, FOLDER},
};

/// Packages of the index that build a wheel; Zig links the module with an old C library.
const PACKAGES: [&str; 3] = ["maturin", "ziglang", "wheel"];
/// The oldest C library that the module runs with: Debian 9, Ubuntu 18.04, RHEL 7.
const OLDEST: &str = "manylinux_2_17";

/// Builds the module and puts the program into its wheel.
pub(super) fn write(release: &Release) -> Result<()> {
    super::needed(&["python3"])?;
    let place = target(&release.root).join("wheel");
    let _ = fs::remove_dir_all(&place);
    let (environment, modules, contents) =
        (place.join("environment"), place.join("module"), place.join("contents"));
    run_command(Command::new("python3").args(["-m", "venv"]).arg(&environment))?;
    let python = environment.join("bin").join("python");
    run_command(Command::new(&python).args(["-m", "pip", "install", "--quiet"]).args(PACKAGES))?;
    // Zig is found by the interpreter of the environment.
    let path = format!("{}:{}", environment.join("bin").display(), std::env::var("PATH").unwrap_or_default());
    let mut build = Command::new(environment.join("bin").join("maturin"));
    build
        .current_dir(release.root.join(FOLDER))
        .env("PATH", path)
        .env("CARGO_TARGET_DIR", target(&release.root));
    build.args(["build", "--release", "--locked", "--config", "../Cargo.toml"]);
    build.args(["--zig", "--compatibility", OLDEST, "--out"]).arg(&modules);
    run_command(&mut build)?;
    let wheel = |arguments: &[&str], paths: [&Path; 2]| {
        let mut command = Command::new(&python);
        command.env("SOURCE_DATE_EPOCH", &release.time).args(["-m", "wheel"]).args(arguments);
        run_command(command.arg("-d").args(paths))
    };
    wheel(&["unpack"], [&contents, &python::built(&modules)?])?;
    let unpacked = only(&contents)?;
    let scripts = unpacked.join(format!("dalembert-{}.data", release.version)).join("scripts");
    fs::create_dir_all(&scripts)?;
    fs::copy(&release.program, scripts.join("dalembert"))?;
    wheel(&["pack"], [&release.folder, &unpacked])?;
    Ok(())
}

/// The only entry of a folder.
fn only(folder: &Path) -> Result<PathBuf> {
    let entry = fs::read_dir(folder)?.next().with_context(|| format!("{} is empty", folder.display()))?;
    Ok(entry?.path())
}
