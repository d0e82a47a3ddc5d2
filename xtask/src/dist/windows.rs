//! The program for Windows, cross-built with mingw-w64, and the proof under Wine that it solves. Its workbench is built
//! and was never used by a person on Windows.

use std::{
    fs::{self, File},
    io::Write as _,
    path::{Path, PathBuf},
    process::Command,
};

use anyhow::{Context, Result, ensure};
use zip::{CompressionMethod, DateTime, ZipWriter, write::SimpleFileOptions};

use super::{
    DOCUMENTS, Release, built, needed,
    prove::{PROBLEMS, compare_catalogue, solve_problems},
    report,
};
use crate::cargo::{output, run as run_command, target};

const TRIPLE: &str = "x86_64-pc-windows-gnu";
const COMPILER: &str = "x86_64-w64-mingw32-gcc";
/// Library of Windows that Wine has from version 9 on, as a source.
const RANDOM_BYTES: &str = include_str!("bcryptprimitives.c");

/// Builds the program for Windows and writes its archive; gives the path of the program.
pub(super) fn write(release: &Release) -> Result<PathBuf> {
    needed(&[COMPILER]).context("Debian has it in `mingw-w64`")?;
    let program = built(&release.root, &target(&release.root), TRIPLE)?.with_extension("exe");
    let name = format!("dalembert-{}-x86_64-windows", release.version);
    let path = release.folder.join(format!("{name}.zip"));
    let mut archive = ZipWriter::new(File::create(&path)?);
    // Files of an archive have no time of their own: builds of one commit are alike.
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        .last_modified_time(DateTime::default());
    let completions = output(Command::new(&release.program).args(["completions", "powershell"]))?;
    let mut file = |name: &str, bytes: &[u8]| -> Result<()> {
        archive.start_file(name, options)?;
        Ok(archive.write_all(bytes)?)
    };
    file(&format!("{name}/dalembert.exe"), &fs::read(&program)?)?;
    file(&format!("{name}/completions.ps1"), completions.as_bytes())?;
    for document in DOCUMENTS {
        file(&format!("{name}/{document}"), &fs::read(release.root.join(document))?)?;
    }
    archive.finish()?;
    report(&path)?;
    Ok(program)
}

/// Solves the problems and compares the catalogue under Wine.
pub(super) fn prove(release: &Release, program: &Path) -> Result<()> {
    needed(&["wine"]).context("the proof of the program for Windows needs Wine")?;
    let prefix = release.folder.join("wine");
    fs::create_dir_all(&prefix)?;
    let (source, library) = (prefix.join("random.c"), prefix.join("bcryptprimitives.dll"));
    fs::write(&source, RANDOM_BYTES)?;
    run_command(Command::new(COMPILER).args(["-shared", "-o"]).args([&library, &source]).arg("-ladvapi32"))?;
    let beside = prefix.join("dalembert.exe");
    fs::copy(program, &beside)?;
    let run = |arguments: &[&str]| {
        let mut command = Command::new("wine");
        command.arg(&beside).args(["--lang", "en"]).args(arguments);
        // Messages of Wine about itself are none of the program.
        output(command.env("WINEPREFIX", prefix.join("root")).env("WINEDEBUG", "-all"))
    };
    solve_problems(&run)?;
    compare_catalogue(&run)?;
    let note = release.folder.join("note.html");
    run(&["solve", PROBLEMS[0].0, "-o", &format!("Z:{}", note.display())])?;
    let text = fs::read_to_string(&note).context("the note of a solution is not written")?;
    ensure!(text.contains("19.456"), "the note has no answer");
    fs::remove_file(note)?;
    println!(
        "Windows, under Wine: {} problems solved, the catalogue compared, a note written",
        PROBLEMS.len()
    );
    Ok(fs::remove_dir_all(prefix)?)
}
