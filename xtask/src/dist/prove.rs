//! The proof that the files run where there is nothing: in an empty root, and installed in an old Debian.

use std::{
    fs,
    path::{Path, PathBuf},
    process::Command,
    time::{Duration, Instant},
};

use anyhow::{Context, Result, ensure};

use super::Release;
use crate::cargo::{output, run as run_command};

/// The oldest Debian that its mirrors still hold, with Python and pip.
const DEBIAN: &str = "bullseye";
const MIRROR: &str = "http://deb.debian.org/debian";
/// Problems of the course, and an answer of each as it is printed.
pub(super) const PROBLEMS: [(&str, &str); 5] = [
    ("vibration/rotating-unbalance", "19.456 mm"),
    ("vibration/shaft-clearance", "every value"),
    ("vibration/beam-and-springs", "474.17 kg"),
    ("virtual-work/virtual-power", "1.03×10⁵ N·m"),
    ("balancing/two-plane", "7.1996 kg"),
];
/// Longest time from the package to the open workbench, beside the download.
const MOST: Duration = Duration::from_mins(1);
/// Sequence that gives the terminal its screen back.
const LEFT: &str = "\u{1b}[?1049l";

/// Runs the program in an empty root, and installs package and wheel in Debian.
pub(super) fn everywhere(release: &Release) -> Result<()> {
    super::needed(&["chroot", "debootstrap", "script"])
        .context("the proof needs root and Debian's debootstrap")?;
    empty_root(release)?;
    let root = release.folder.join("debian");
    run_command(
        Command::new("debootstrap")
            .args(["--variant=minbase", "--include=python3,python3-pip", DEBIAN])
            .arg(&root)
            .arg(MIRROR),
    )?;
    let begun = Instant::now();
    let package = brought(release, &root, ".deb")?;
    inside(&root, &format!("dpkg --install {package}"))?;
    let from = solved(&root, "/usr/bin/dalembert")?;
    inside(&root, "dpkg --purge dalembert")?;
    println!(
        "Debian {DEBIAN}: installed from the package, first answer after {:.1} s",
        (from - begun).as_secs_f64()
    );
    ensure!(from - begun <= MOST, "that is longer than {MOST:?}");
    if let Ok(wheel) = brought(release, &root, ".whl") {
        inside(&root, &format!("pip3 install --no-index {wheel}"))?;
        solved(&root, "/usr/local/bin/dalembert")?;
        let module = "import dalembert; print(dalembert.analyses()[0])";
        inside(&root, &format!("python3 -c '{module}'"))?;
        println!("Debian {DEBIAN}: installed from the wheel");
    }
    Ok(fs::remove_dir_all(&root)?)
}

/// Nothing but the program.
fn empty_root(release: &Release) -> Result<()> {
    let root = release.folder.join("empty");
    fs::create_dir_all(&root)?;
    fs::copy(&release.program, root.join("dalembert"))?;
    solve_problems(&|arguments| {
        let mut command = Command::new("chroot");
        output(command.arg(&root).args(["/dalembert", "--lang", "en"]).args(arguments))
    })?;
    workbench(&root, "/dalembert")?;
    println!("an empty root: {} problems solved", PROBLEMS.len());
    Ok(fs::remove_dir_all(root)?)
}

/// Copies the file with an ending into a root, and gives its path there.
fn brought(release: &Release, root: &Path, ending: &str) -> Result<String> {
    let files = fs::read_dir(&release.folder)?.filter_map(Result::ok).map(|entry| entry.path());
    let found: Option<PathBuf> = files.into_iter().find(|path| path.to_string_lossy().ends_with(ending));
    let found = found.with_context(|| format!("no {ending} was built"))?;
    let name = found.file_name().context("a file has a name")?.to_string_lossy().into_owned();
    fs::copy(&found, root.join("tmp").join(&name))?;
    Ok(format!("/tmp/{name}"))
}

/// Runs a line of the shell in a root, and gives what it prints.
fn inside(root: &Path, line: &str) -> Result<String> {
    output(
        Command::new("chroot")
            .arg(root)
            .env("LC_ALL", "C.UTF-8")
            .env("HOME", "/root")
            .args(["sh", "-c", line]),
    )
}

/// Solves the problems, compares the catalogue, and opens the workbench in a terminal, which it leaves as it was; gives
/// the time of the first answer.
fn solved(root: &Path, program: &str) -> Result<Instant> {
    let run = |arguments: &[&str]| inside(root, &format!("{program} --lang en {}", arguments.join(" ")));
    let first = solve_problems(&run)?;
    compare_catalogue(&run)?;
    workbench(root, program)?;
    Ok(first)
}

/// Solves the problems by a function that runs the program with arguments and gives what it prints in English; gives the
/// time of the first answer.
pub(super) fn solve_problems(run: &dyn Fn(&[&str]) -> Result<String>) -> Result<Instant> {
    let mut first = None;
    for (problem, answer) in PROBLEMS {
        let printed = run(&["solve", problem])?;
        ensure!(printed.contains(answer), "{problem}: `{answer}` is not among the answers:\n{printed}");
        first.get_or_insert_with(Instant::now);
    }
    first.context("a problem was solved")
}

/// Compares the catalogue by such a function.
pub(super) fn compare_catalogue(run: &dyn Fn(&[&str]) -> Result<String>) -> Result<()> {
    let verified = run(&["verify"])?;
    ensure!(verified.contains(" 0 differing"), "the catalogue differs:\n{verified}");
    Ok(())
}

/// Opens the workbench in a terminal of 80 columns, types `q`, and ensures that the terminal has its screen back.
fn workbench(root: &Path, program: &str) -> Result<()> {
    // The terminal is one of this machine: a root may have none.
    let typed = format!(
        "(sleep 3; printf q; sleep 2) | script --quiet --return --command \
         'stty cols 80 rows 24; chroot \"$ROOT\" {program} --lang en {}' /dev/null",
        PROBLEMS[0].0
    );
    let mut shell = Command::new("sh");
    shell.args(["-c", &typed]).env("ROOT", root).env("TERM", "xterm-256color").env("HOME", "/root");
    let screen = output(&mut shell)?;
    ensure!(screen.contains("19.456"), "the workbench does not show the answer:\n{screen}");
    ensure!(screen.contains(LEFT), "the workbench leaves the terminal as it has it:\n{screen}");
    Ok(())
}
