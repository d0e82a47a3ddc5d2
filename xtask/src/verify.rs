//! `cargo xtask verify`: everything that proves the project, cheap things first.

use std::{
    env, fs,
    io::{BufRead, BufReader},
    path::{Path, PathBuf},
    process::{Command, Stdio},
    thread,
    time::{Duration, Instant, SystemTime, UNIX_EPOCH},
};

use anyhow::{Context, Result, ensure};

use crate::{
    cargo::{Program, cargo, git, installed, output, run as run_command, target},
    docs::{self, ids},
    fuzz, new_analysis, pictures, python, tidy,
};

/// Extent of the verification.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent<'a> {
    /// All of it.
    Everything,
    /// All steps but those that build the program again.
    Quick,
    /// The steps of these names.
    Steps(&'a [&'a str]),
}

/// Result of a step.
type Found = Result<Verdict>;

/// Verdict on a step that did not fail, with a few words for the summary.
enum Verdict {
    Passed(String),
    /// A tool is missing; the words name it.
    NotRun(String),
}

struct Step {
    name: &'static str,
    prove: fn(&Path) -> Found,
    slow: bool,
}

const STEPS: [Step; 13] = [
    Step { name: "tidy", prove: tree, slow: false },
    Step { name: "spelling", prove: spelling, slow: false },
    Step { name: "dependencies", prove: dependencies, slow: false },
    Step { name: "formatting", prove: formatting, slow: false },
    Step { name: "clippy", prove: clippy, slow: false },
    Step { name: "tests", prove: tests, slow: false },
    Step { name: "catalogue", prove: catalogue, slow: false },
    Step { name: "documentation", prove: documentation, slow: false },
    Step { name: "reference", prove: reference, slow: false },
    Step { name: "pictures", prove: drawn, slow: false },
    Step { name: "out of tree", prove: out_of_tree, slow: true },
    Step { name: "python", prove: python_module, slow: true },
    Step { name: "new analysis", prove: template, slow: true },
];

/// The steps of a verification, in their order.
fn steps(extent: Extent<'_>) -> Result<Vec<&'static Step>> {
    if let Extent::Steps(names) = extent {
        for name in names {
            let known = || STEPS.map(|step| step.name).join(", ");
            ensure!(STEPS.iter().any(|step| step.name == *name), "no step {name:?}; steps: {}", known());
        }
    }
    let taken = |step: &&Step| match extent {
        Extent::Everything => true,
        Extent::Quick => !step.slow,
        Extent::Steps(names) => names.contains(&step.name),
    };
    Ok(STEPS.iter().filter(taken).collect())
}

/// Takes the steps, goes on after one that failed, and ends with a summary of all.
///
/// # Errors
///
/// A step that does not exist; a step that failed.
pub fn run(root: &Path, extent: Extent<'_>) -> Result<()> {
    let (mut summary, mut faults) = (String::new(), String::new());
    let (mut passed, mut failed, mut skipped) = (0, 0, 0);
    for step in steps(extent)? {
        println!("\n== {}", step.name);
        let start = Instant::now();
        let found = (step.prove)(root);
        let (verdict, words) = match found {
            Ok(Verdict::Passed(words)) => {
                passed += 1;
                ("ok", words)
            }
            Ok(Verdict::NotRun(words)) => {
                skipped += 1;
                ("NOT RUN", words)
            }
            Err(err) => {
                failed += 1;
                ("FAILED", format!("{err:#}"))
            }
        };
        println!("{verdict} {words}");
        summary += &line(step.name, start.elapsed(), verdict, &words);
        // What a step has to say beyond its line stands at the end too, where it is searched for.
        if let Some((_, more)) = words.split_once('\n') {
            faults += &format!("\n== {}\n{more}\n", step.name);
        }
    }
    println!("{faults}\n== summary\n{summary}\n{passed} passed, {failed} failed, {skipped} skipped");
    ensure!(failed == 0, "the verification failed");
    Ok(())
}

fn line(name: &str, time: Duration, verdict: &str, words: &str) -> String {
    format!(
        "{name:<16}{:>6.1} s  {verdict:<8}{}",
        time.as_secs_f64(),
        words.lines().next().unwrap_or_default()
    )
    .trim_end()
    .to_owned()
        + "\n"
}

fn tree(root: &Path) -> Found {
    tidy::run(root)?;
    Ok(Verdict::Passed(String::new()))
}

/// Only where the tool is installed: nothing is fetched.
fn spelling(root: &Path) -> Found {
    if !installed(Command::new("typos").arg("--version")) {
        return Ok(Verdict::NotRun("typos is not installed: `pip install typos`".to_owned()));
    }
    run_command(Command::new("typos").current_dir(root))?;
    Ok(Verdict::Passed(String::new()))
}

/// Only where the tool is installed; without the list of advisories, which is a clone of a repository.
fn dependencies(root: &Path) -> Found {
    if !installed(cargo(root).args(["deny", "--version"])) {
        return Ok(Verdict::NotRun("cargo-deny is not installed: `cargo install cargo-deny`".to_owned()));
    }
    run_command(cargo(root).args(["deny", "--locked", "check", "bans", "licenses", "sources"]))?;
    Ok(Verdict::Passed(String::new()))
}

fn formatting(root: &Path) -> Found {
    run_command(cargo(root).args(["fmt", "--all", "--", "--check", "--files-with-diff"]))?;
    for folder in [OUT_OF_TREE, python::FOLDER, fuzz::FOLDER] {
        run_command(cargo(&root.join(folder)).args(["fmt", "--", "--check", "--files-with-diff"]))?;
    }
    Ok(Verdict::Passed(String::new()))
}

fn clippy(root: &Path) -> Found {
    let workspace = ["clippy", "--workspace", "--all-targets", "--locked", "--keep-going"];
    run_command(cargo(root).args(workspace).args(["--", "-D", "warnings"]))?;
    Ok(Verdict::Passed(String::new()))
}

fn tests(root: &Path) -> Found {
    let seed = env::var(SEED).unwrap_or_else(|_| seed_of_commit(root).to_string());
    let mut tests = cargo(root)
        .args(["test", "--workspace", "--locked", "--no-fail-fast"])
        .env(SEED, &seed)
        // A snapshot that is missing is a fault here, while a user who begins one gets it written.
        .env("INSTA_UPDATE", "no")
        .env("RUST_TEST_THREADS", threads().to_string())
        .stdout(Stdio::piped())
        .spawn()
        .context("the tests cannot be run")?;
    let (mut failures, mut within) = (String::new(), false);
    for line in BufReader::new(tests.stdout.take().context("the tests print nothing")?).split(b'\n') {
        let line = String::from_utf8_lossy(&line?).into_owned();
        println!("{line}");
        within = line == "failures:" || within && !line.starts_with("test result:");
        if within {
            failures += &format!("{line}\n");
        }
    }
    let status = tests.wait()?;
    ensure!(status.success(), "ended with {status}; {SEED}={seed} draws the same again\n{failures}");
    Ok(Verdict::Passed(format!("{SEED}={seed}")))
}

/// Tests at a time, twice the processors: those of the terminal wait for most of their time.
fn threads() -> usize {
    2 * thread::available_parallelism().map_or(1, usize::from)
}

/// The seed of what property tests draw, an unsigned integer.
const SEED: &str = "PROPTEST_RNG_SEED";

/// The same seed for the same commit, so that a verdict can be had again, and other draws with the next one.
fn seed_of_commit(root: &Path) -> u64 {
    let commit = git(root, &["rev-parse", "HEAD"]).unwrap_or_default();
    commit.get(..15).and_then(|digits| u64::from_str_radix(digits, 16).ok()).unwrap_or_default()
}

/// Every published answer beside ours.
fn catalogue(root: &Path) -> Found {
    let program = Program::built(root, root)?;
    let (counts, status) = docs::json_and_status(&program, &["verify", "--json"])?;
    if !status.success() {
        // The rows in words, with what differs.
        program.with(&["verify"]).status().context("the program cannot be run")?;
    }
    let count =
        |name: &str| counts[name].as_u64().with_context(|| format!("`verify --json` counts no {name}"));
    let (agreed, disputed, differing) = (count("agreed")?, count("disputed")?, count("differing")?);
    // What somebody printed is said apart from what was computed.
    let printed = &counts["by_truth"]["published"];
    let words = format!(
        "{agreed} agreed, {disputed} disputed, {differing} differing; {} and {} of these were printed",
        printed["agreed"], printed["disputed"]
    );
    ensure!(differing == 0 && agreed > 0 && status.success(), words);
    Ok(Verdict::Passed(words))
}

fn documentation(root: &Path) -> Found {
    run_command(
        cargo(root)
            .args(["doc", "--workspace", "--no-deps", "--locked", "--keep-going"])
            .env("RUSTDOCFLAGS", "-D warnings"),
    )?;
    Ok(Verdict::Passed(String::new()))
}

/// Generated files agree with those that would be generated now.
fn reference(root: &Path) -> Found {
    docs::check(root)?;
    Ok(Verdict::Passed(String::new()))
}

/// The pictures of the documents are what the program draws.
fn drawn(root: &Path) -> Found {
    Ok(Verdict::Passed(format!("{} pictures", pictures::check(root)?)))
}

const OUT_OF_TREE: &str = "examples/out-of-tree";

/// The analysis that the program in [`OUT_OF_TREE`] adds.
const OF_THE_LABORATORY: &str = "laboratory/torsional-pendulum";

/// A laboratory's own program has its own analysis beside ours, and the tests of every analysis over it. What it shares
/// with ours is built once.
fn out_of_tree(root: &Path) -> Found {
    let ours = ids(&docs::json(&Program::built(root, root)?, &["list", "--json"])?);
    let plain = compiled_quickly(root)?;
    let with_cargo = |verb: &str| {
        let mut command = cargo(&root.join(OUT_OF_TREE));
        command.env("CARGO_TARGET_DIR", target(root)).args([verb, "--quiet", "--locked"]).args(&plain);
        command
    };
    let theirs = |arguments: &[&str]| {
        let mut command = with_cargo("run");
        command.arg("--").args(arguments);
        command
    };
    let listed = ids(&serde_json::from_str(&output(&mut theirs(&["list", "--json"]))?)?);
    for id in ours.iter().map(String::as_str).chain([OF_THE_LABORATORY]) {
        ensure!(listed.iter().any(|listed| listed == id), "the laboratory's program lacks {id}");
    }
    run_command(&mut theirs(&["solve", OF_THE_LABORATORY]))?;
    run_command(&mut theirs(&["verify", OF_THE_LABORATORY]))?;
    run_command(&mut with_cargo("test"))?;
    Ok(Verdict::Passed(format!("{} analyses", listed.len())))
}

/// The Python module solves. What it shares with the program out of tree is built once; the whole proof, with a wheel and
/// packages from the index, is `cargo xtask python`.
fn python_module(root: &Path) -> Found {
    let solved = python::smoke(root, &compiled_quickly(root)?)?;
    Ok(solved.map_or_else(|| Verdict::NotRun("there is no Python".to_owned()), Verdict::Passed))
}

/// Checks that a member of the workspace here, which is a dependency there, is not compiled for speed: options that
/// compile it as quickly as can be, since little is solved with it.
fn compiled_quickly(root: &Path) -> Result<Vec<String>> {
    let mut options = Vec::new();
    for group in ["crates", "plugins"] {
        for folder in fs::read_dir(root.join(group))? {
            let folder = folder?.file_name().to_string_lossy().into_owned();
            let package = match folder.as_str() {
                "dalembert" => folder,
                "bundle" => "dalembert-plugins".to_owned(),
                _ => format!("dalembert-{folder}"),
            };
            options.extend(["--config".to_owned(), format!("profile.dev.package.{package}.opt-level=0")]);
        }
    }
    // The other packages as in this workspace, so that they are the same and not built again.
    let manifest = fs::read_to_string(root.join("Cargo.toml"))?;
    for section in manifest.split("\n[profile.dev.package.").skip(1) {
        if let Some((package, level)) = section.split_once("]\nopt-level = ")
            && !package.starts_with("dalembert")
            && let Some(level) = level.lines().next()
        {
            options
                .extend(["--config".to_owned(), format!("profile.dev.package.{package}.opt-level={level}")]);
        }
    }
    Ok(options)
}

/// A new analysis, in a copy of the tree, is listed, solved and tested at once.
fn template(root: &Path) -> Found {
    const NAME: &str = "mass-released-from-rest";
    let id = format!("vibration/{NAME}");
    let copy = Copy::of(root)?;
    new_analysis::run(&copy.0, "vibration", NAME, Some("Free vibration"))?;
    let program = Program::built(&copy.0, root)?;
    ensure!(ids(&docs::json(&program, &["list", "--json"])?).contains(&id), "{id} is not listed");
    let solved = docs::json(&program, &["solve", &id, "--format", "json"])?;
    let frequency = solved["answers"]["natural_frequency"]["si"].as_f64();
    ensure!(frequency == Some(20.0), "{id} answers {frequency:?} and not 20 rad/s");
    let mut tests = cargo(&copy.0);
    // All packages are selected, as for the tests of the tree itself, so that they rest on the same dependencies.
    tests.args(["test", "--workspace", "--test", "registry", "--"]);
    tests.args(["catalogue::", "invariance::", "languages::"]);
    // The other analyses were compared with what holds for every problem by the tests of the tree itself.
    tests.env("CARGO_TARGET_DIR", target(root)).env("INSTA_UPDATE", "unseen").env("DALEMBERT_ONLY", &id);
    run_command(&mut tests)?;
    tidy::run(&copy.0)?;
    run_command(cargo(&copy.0).args(["fmt", "--all", "--", "--check", "--files-with-diff"]))?;
    Ok(Verdict::Passed(String::new()))
}

/// The crates that a new analysis of vibration changes, and those that know where their tree stands.
const CHANGED: [&str; 5] = ["plugins/vibration", "plugins/bundle", "crates/dalembert", "tests", "xtask"];

/// The version of those in the copy: another one, that what depends on the version of the workspace accepts.
const COPIED: &str = concat!(env!("CARGO_PKG_VERSION_MAJOR"), ".", env!("CARGO_PKG_VERSION_MINOR"), ".1000");

/// A copy of the tree, removed in the end.
struct Copy(PathBuf);

impl Copy {
    fn of(root: &Path) -> Result<Self> {
        let now = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_nanos());
        let copy = Self(env::temp_dir().join(format!("dalembert-template-{}-{now}", std::process::id())));
        copy_folder(root, &copy.0)?;
        // In a workspace cargo tells crates by their place in it, their version and the dates of their sources. What
        // the new analysis changes gets another version, so that it is built beside ours; the rest is ours, built.
        for folder in CHANGED {
            let manifest = copy.0.join(folder).join("Cargo.toml");
            let text = new_analysis::read(&manifest)?;
            let own = "version.workspace = true\n";
            ensure!(text.contains(own), "{folder} has not the version of the workspace");
            new_analysis::write(&manifest, &text.replacen(own, &format!("version = \"{COPIED}\"\n"), 1))?;
        }
        Ok(copy)
    }
}

impl Drop for Copy {
    fn drop(&mut self) {
        // A copy that stays behind in the folder for temporary files does no harm.
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn copy_folder(from: &Path, to: &Path) -> Result<()> {
    fs::create_dir_all(to).with_context(|| format!("{} cannot be made", to.display()))?;
    for entry in fs::read_dir(from).with_context(|| format!("{} cannot be read", from.display()))? {
        let entry = entry?;
        let (path, name) = (entry.path(), entry.file_name());
        if name == "target" || name == ".git" {
            continue;
        }
        if entry.file_type()?.is_dir() {
            copy_folder(&path, &to.join(name))?;
        } else {
            copy_file(&path, &to.join(name))
                .with_context(|| format!("{} cannot be copied", path.display()))?;
        }
    }
    Ok(())
}

/// A file with its date.
fn copy_file(from: &Path, to: &Path) -> std::io::Result<()> {
    fs::copy(from, to)?;
    fs::File::options().append(true).open(to)?.set_modified(fs::metadata(from)?.modified()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_by_their_names() {
        let names =
            |extent| steps(extent).map(|steps| steps.iter().map(|step| step.name).collect::<Vec<_>>());
        assert_eq!(names(Extent::Steps(&["python", "tidy"])).unwrap(), ["tidy", "python"]);
        assert_eq!(names(Extent::Everything).unwrap().len(), STEPS.len());
        assert!(!names(Extent::Quick).unwrap().contains(&"new analysis"));
        let unknown = names(Extent::Steps(&["snake"])).unwrap_err().to_string();
        assert!(unknown.starts_with("no step \"snake\"; steps: tidy, "), "{unknown}");
    }

    #[test]
    fn a_line_of_the_summary() {
        let time = Duration::from_millis(1250);
        assert_eq!(line("tests", time, "ok", ""), "tests              1.2 s  ok\n");
        assert_eq!(
            line("tidy", time, "FAILED", "2 faults\nmore"),
            "tidy               1.2 s  FAILED  2 faults\n"
        );
    }
}
