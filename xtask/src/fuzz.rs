//! `cargo xtask fuzz`: a search for input that breaks a reader, by libFuzzer with the coverage of every crate.
//!
//! The instrumentation is that of the stable compiler (`-C passes=sancov-module`), without a sanitizer: the program has no
//! unsafe code of its own.

use std::{
    fs,
    io::Write as _,
    path::{Path, PathBuf},
    process::{Command, Stdio},
};

use anyhow::{Context, Result, bail, ensure};

use crate::cargo::{cargo, run, target};

/// Folder of the package of targets.
pub(crate) const FOLDER: &str = "fuzz";
/// Target of the compiler: with it, build scripts and macros are not instrumented.
const TRIPLE: &str = "x86_64-unknown-linux-gnu";
const FLAGS: [&str; 6] = [
    "-Cpasses=sancov-module",
    "-Cllvm-args=-sanitizer-coverage-level=4",
    "-Cllvm-args=-sanitizer-coverage-inline-8bit-counters",
    "-Cllvm-args=-sanitizer-coverage-pc-table",
    "-Cllvm-args=-sanitizer-coverage-trace-compares",
    "-Awarnings",
];
/// The longest corpus that is kept: what reaches most with least.
const KEPT: usize = 400;

/// Result of a search.
pub(crate) struct Search {
    pub(crate) executions: u64,
    /// Edges of the program that were reached, of those it has.
    pub(crate) edges: [u64; 2],
    /// Execution that reached a new edge last.
    pub(crate) last_new: u64,
    /// Report of libFuzzer on the input that broke the reader, with the path of its file.
    pub(crate) fault: Option<String>,
}

/// Searches in a target with so many executions, prints what was met, and keeps the corpus in `tests/data/fuzz`.
///
/// # Errors
/// A target that does not exist; an input that breaks it.
pub fn run_target(root: &Path, name: &str, executions: &str, seed: &str) -> Result<()> {
    let executions =
        executions.parse().with_context(|| format!("`{executions}` is not a number of executions"))?;
    let seed = seed.parse().with_context(|| format!("`{seed}` is no seed"))?;
    let program = built(root)?;
    let search = search(root, &program, name, executions, seed)?;
    keep(root, &program, name)?;
    println!("{name}: {}", described(&search));
    match search.fault {
        Some(fault) => bail!("{fault}"),
        None => Ok(()),
    }
}

/// The words for a search.
pub(crate) fn described(search: &Search) -> String {
    let Search { executions, edges: [reached, all], last_new, .. } = search;
    format!("{executions} executions, {reached} of {all} edges, the last new one at execution {last_new}")
}

/// The instrumented program.
pub(crate) fn built(root: &Path) -> Result<PathBuf> {
    let folder = target(root).join(FOLDER);
    run(cargo(&root.join(FOLDER))
        .args(["build", "--quiet", "--release", "--locked", "--target", TRIPLE])
        .env("CARGO_TARGET_DIR", &folder)
        .env("RUSTFLAGS", FLAGS.join(" ")))?;
    Ok(folder.join(TRIPLE).join("release").join("dalembert-fuzz"))
}

/// Searches with so many executions.
pub(crate) fn search(root: &Path, program: &Path, name: &str, executions: u64, seed: u64) -> Result<Search> {
    let folder = corpus_folder(root, name)?;
    for (number, bytes) in kept(root, name)?.iter().enumerate() {
        fs::write(folder.join(format!("kept-{number}")), bytes)?;
    }
    // The first run writes the seeds of the target, which the second reads.
    let begin = libfuzzer(program, name, &folder, &["-runs=0"])?;
    ensure!(begin.contains("DONE"), "{name} does not begin:\n{begin}");
    let artifacts = format!("-artifact_prefix={}/fault-", target(root).join(FOLDER).display());
    let options = [format!("-runs={executions}"), format!("-seed={}", seed % 4_294_967_295 + 1), artifacts];
    let options: Vec<&str> =
        options.iter().map(String::as_str).chain(["-print_final_stats=1", "-timeout=20"]).collect();
    let printed = libfuzzer(program, name, &folder, &options)?;
    read(&printed).with_context(|| format!("libFuzzer prints no figures:\n{}", tail(&printed)))
}

fn libfuzzer(program: &Path, name: &str, folder: &Path, options: &[&str]) -> Result<String> {
    let output = Command::new(program)
        .env("DALEMBERT_FUZZ", name)
        .env("DALEMBERT_SEEDS", folder)
        .args(options)
        .arg(folder)
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .output()
        .context("the fuzz program cannot be run")?;
    Ok(String::from_utf8_lossy(&output.stderr).into_owned())
}

fn tail(text: &str) -> String {
    let lines: Vec<&str> = text.lines().collect();
    lines[lines.len().saturating_sub(20)..].join("\n")
}

/// Figures of what libFuzzer prints: `#1234 NEW cov: 56 …`, `(789 inline 8-bit counters)`, `SUMMARY: …`.
fn read(printed: &str) -> Option<Search> {
    let number = |text: &str| text.trim_start_matches('#').parse::<u64>().ok();
    let all = printed.lines().find_map(|line| {
        let (before, _) = line.split_once(" inline 8-bit counters)")?;
        number(before.rsplit('(').next()?)
    })?;
    let (mut reached, mut last_new, mut executions) = (0, 0, 0);
    for line in printed.lines().filter(|line| line.starts_with('#')) {
        let mut words = line.split_whitespace();
        // A dictionary that it recommends ends in a line of `#` too.
        let Some(at) = words.next().and_then(number) else { continue };
        executions = executions.max(at);
        if let Some(edges) =
            line.split_once("cov: ").and_then(|(_, rest)| number(rest.split_whitespace().next()?))
            && edges > reached
        {
            (reached, last_new) = (edges, at);
        }
    }
    let done = printed.lines().find_map(|line| line.strip_prefix("stat::number_of_executed_units:"));
    executions = done.and_then(|count| number(count.trim())).unwrap_or(executions);
    let said = |line: &&str| {
        line.contains("panicked at") || line.starts_with("SUMMARY:") || line.contains("Test unit written to")
    };
    let failed = printed.lines().any(|line| line.starts_with("SUMMARY:"));
    let fault = failed.then(|| printed.lines().filter(said).collect::<Vec<_>>().join("; "));
    Some(Search { executions, edges: [reached, all], last_new, fault })
}

fn corpus_folder(root: &Path, name: &str) -> Result<PathBuf> {
    let folder = target(root).join(FOLDER).join("corpus").join(name);
    fs::create_dir_all(&folder).with_context(|| format!("{} cannot be made", folder.display()))?;
    Ok(folder)
}

fn corpus_file(root: &Path, name: &str) -> PathBuf {
    root.join("tests/data/fuzz").join(format!("{name}.jsonl"))
}

/// The corpus that is kept of a target; none before its first search.
fn kept(root: &Path, name: &str) -> Result<Vec<Vec<u8>>> {
    fs::read_to_string(corpus_file(root, name)).map_or_else(|_| Ok(Vec::new()), |lines| corpus(&lines))
}

/// Inputs of a file of a corpus: one JSON text a line, a character for each byte.
///
/// # Errors
/// A line that is not a text, or has a character that is not a byte.
pub fn corpus(lines: &str) -> Result<Vec<Vec<u8>>> {
    let bytes = |line: &str| {
        let text: String = serde_json::from_str(line)?;
        let bytes = text.chars().map(|byte| u8::try_from(u32::from(byte)));
        bytes
            .collect::<Result<Vec<u8>, _>>()
            .with_context(|| format!("{line} has characters that are not bytes"))
    };
    lines.lines().map(bytes).collect()
}

/// Reduces the corpus to the least that reaches as much, and keeps it: the shortest inputs, if there are many.
fn keep(root: &Path, program: &Path, name: &str) -> Result<()> {
    let (corpus, least) = (corpus_folder(root, name)?, corpus_folder(root, &format!("{name}-least"))?);
    fs::remove_dir_all(&least)?;
    fs::create_dir_all(&least)?;
    let status = Command::new(program)
        .env("DALEMBERT_FUZZ", name)
        .arg("-merge=1")
        .args([&least, &corpus])
        .stderr(Stdio::null())
        .status()
        .context("the fuzz program cannot be run")?;
    ensure!(status.success(), "the corpus of {name} cannot be reduced");
    let mut inputs = Vec::new();
    for file in fs::read_dir(&least)? {
        inputs.push(fs::read(file?.path())?);
    }
    inputs.sort_by(|a, b| a.len().cmp(&b.len()).then_with(|| a.cmp(b)));
    inputs.truncate(KEPT);
    let mut file = fs::File::create(corpus_file(root, name))?;
    for bytes in inputs {
        let text: String = bytes.into_iter().map(char::from).collect();
        writeln!(file, "{}", serde_json::to_string(&text)?)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_of_a_search() {
        let printed = "INFO: Loaded 1 modules   (169 inline 8-bit counters): 169 [0x5, 0x6),\n\
            #2\tINITED cov: 11 ft: 11 corp: 1/1b exec/s: 0 rss: 27Mb\n\
            #5\tNEW    cov: 12 ft: 12 corp: 2/3b lim: 4 exec/s: 0 rss: 27Mb\n\
            #71\tREDUCE cov: 12 ft: 12 corp: 2/2b\n#200000\tDONE   cov: 12 ft: 12\n\
            ###### Recommended dictionary. ######\n\"[20!ed\" # Uses: 47\n\
            stat::number_of_executed_units: 200000\n";
        let search = read(printed).unwrap();
        assert_eq!((search.executions, search.edges, search.last_new), (200_000, [12, 169], 5));
        assert!(search.fault.is_none());
        let broken = printed.to_owned() + "thread panicked at a.rs:1\nSUMMARY: libFuzzer: deadly signal\n";
        assert!(read(&broken).unwrap().fault.unwrap().contains("a.rs:1"));
        assert!(read("nothing").is_none());
    }
}
