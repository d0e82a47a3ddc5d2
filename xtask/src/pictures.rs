//! `cargo xtask pictures`: the pictures in docs/pictures/, drawn by the built program from the sessions beside them.

use std::{
    env, fs,
    path::{Path, PathBuf},
};

use anyhow::{Context, Result, bail, ensure};

use crate::cargo::{Program, output};

const FOLDER: &str = "docs/pictures";

/// Draws every picture again.
pub fn write(root: &Path) -> Result<()> {
    for (name, svg) in drawn(root)? {
        let path = root.join(FOLDER).join(&name);
        fs::write(&path, svg).with_context(|| format!("{} cannot be written", path.display()))?;
        println!("written: {FOLDER}/{name}");
    }
    Ok(())
}

/// Sees that every picture is what the program draws now.
pub fn check(root: &Path) -> Result<usize> {
    let drawn = drawn(root)?;
    let stale: Vec<&str> = drawn
        .iter()
        .filter(|(name, svg)| {
            fs::read_to_string(root.join(FOLDER).join(name)).ok().as_deref() != Some(svg.as_str())
        })
        .map(|(name, _)| name.as_str())
        .collect();
    if stale.is_empty() {
        return Ok(drawn.len());
    }
    bail!("not what the program draws: {}; run `cargo xtask pictures`", stale.join(", "))
}

/// The pictures, by the names of their files.
fn drawn(root: &Path) -> Result<Vec<(String, String)>> {
    let program = Program::built(root, root)?;
    let mut sessions: Vec<PathBuf> = fs::read_dir(root.join(FOLDER))
        .with_context(|| format!("{FOLDER} cannot be read"))?
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| path.extension().is_some_and(|ending| ending == "replay"))
        .collect();
    sessions.sort();
    ensure!(!sessions.is_empty(), "there is no session in {FOLDER}");
    let folder = env::temp_dir().join(format!("dalembert-pictures-{}", std::process::id()));
    let drawn = sessions.iter().map(|session| draw(&program, session, &folder)).collect();
    // A folder that stays behind among temporary files does no harm.
    let _ = fs::remove_dir_all(&folder);
    drawn
}

/// The picture of a session, which has its name.
fn draw(program: &Program, session: &Path, folder: &Path) -> Result<(String, String)> {
    let (session, folder) = (session.to_string_lossy(), folder.to_string_lossy());
    output(&mut program.with(&["replay", &session, "--headless", "--pictures", &folder]))?;
    let stem = Path::new(&*session).file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let name = format!("{stem}.svg");
    let svg = fs::read_to_string(Path::new(&*folder).join(&name))
        .with_context(|| format!("{session} marks no picture of its own name, `picture {stem}`"))?;
    Ok((name, svg))
}
