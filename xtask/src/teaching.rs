//! `cargo xtask teaching`: variants in numbers, and the files for learning platforms read by the platforms' own programs.
//!
//! | format | read by |
//! |---|---|
//! | Moodle XML | the importer of Moodle, with `php` |
//! | QTI 2.1 | the XML Schemas of QTI and IMS Content Packaging, with `xmllint` |
//! | PrairieLearn | its Python package and its element for numbers, with Python 3.13 |
//!
//! Their sources are taken from `teaching` in the target directory, or cloned to there. What cannot be had is reported as
//! not run; what runs and fails is an error.

use std::{
    fs,
    path::{Path, PathBuf},
    process::{Command, Stdio},
};

use anyhow::{Context, Result, bail, ensure};
use serde_json::Value as Json;

use crate::cargo::{Program, cargo, output, run as run_command, target};

/// Problems whose variants are exported: a problem file with a statement, and analyses without.
const PROBLEMS: [&str; 3] =
    ["tests/data/teaching/fan.toml", "vibration/base-excitation", "virtual-work/geared-drive"];
/// Variants of each.
const COUNT: &str = "5";
/// Ten seeds of a test are taken so many times.
const TIMES: &str = "100";

/// A public repository, and the part of it that is needed.
struct Source {
    /// Folder in the target directory.
    folder: &'static str,
    address: &'static str,
    parts: &'static [&'static str],
}

const MOODLE: Source = Source {
    folder: "moodle",
    address: "https://github.com/moodle/moodle",
    parts: &["lib", "question/format", "question/type/multianswer", "question/type/numerical"],
};
const SCHEMAS: Source = Source {
    folder: "qti",
    address: "https://github.com/oat-sa/extension-tao-itemqti",
    parts: &["model/qti/data"],
};
const PRAIRIELEARN: Source = Source {
    folder: "prairielearn",
    address: "https://github.com/PrairieLearn/PrairieLearn",
    parts: &[
        "apps/prairielearn/python",
        "apps/prairielearn/elements/pl-number-input",
        "apps/prairielearn/src/schemas/schemas",
    ],
};

/// Packages that a question of PrairieLearn is run with.
const PACKAGES: [&str; 11] = [
    "chevron",
    "coloraide",
    "jsonschema",
    "lxml",
    "networkx",
    "numpy",
    "pandas",
    "pint",
    "rich",
    "sympy",
    "text-unidecode",
];

/// Draws a thousand variants of each of twenty problems, and has exported files read.
pub fn run(root: &Path) -> Result<()> {
    platforms(root)?;
    let test = ["test", "--locked", "--package", "dalembert-tests", "--test", "registry", "teaching::"];
    run_command(cargo(root).env("DALEMBERT_TIMES", TIMES).args(test))?;
    println!("variants: 1000 of each of 20 problems solved and graded");
    Ok(())
}

/// Has exported files read, without the variants in numbers.
pub fn platforms(root: &Path) -> Result<()> {
    let program = Program::built(root, root)?;
    let place = target(root).join("teaching");
    let written = place.join("written");
    if written.exists() {
        fs::remove_dir_all(&written).with_context(|| format!("{} cannot be removed", written.display()))?;
    }
    let write = |format: &str| -> Result<Vec<PathBuf>> {
        let each = PROBLEMS.iter().enumerate().map(|(n, problem)| {
            let folder = written.join(format).join(n.to_string());
            let path = folder.to_string_lossy();
            let options = ["--seed", "11", "--count", COUNT, "--format", format, "--out", &path];
            let mut command = program.with(&["variants", problem]);
            output(command.current_dir(root).args(options))?;
            Ok(folder)
        });
        each.collect()
    };
    report("Moodle XML", moodle(&place, &write("moodle")?))?;
    report("QTI 2.1", qti(&place, &write("qti")?))?;
    report("PrairieLearn", prairielearn(&place, &write("prairielearn")?))
}

/// Outcome of a platform: its sentence, or why it was not run.
type Outcome = Result<std::result::Result<String, String>>;

fn report(name: &str, outcome: Outcome) -> Result<()> {
    match outcome.with_context(|| name.to_owned())? {
        Ok(done) => println!("{name}: {done}"),
        Err(why) => println!("{name}: not run: {why}"),
    }
    Ok(())
}

/// Folder of a source: as it is there, or cloned.
fn fetched(place: &Path, source: &Source) -> std::result::Result<PathBuf, String> {
    let folder = place.join(source.folder);
    if folder.is_dir() {
        return Ok(folder);
    }
    let why = |what: &str| format!("{what}; put a checkout of {} into {}", source.address, folder.display());
    fs::create_dir_all(place).map_err(|error| why(&error.to_string()))?;
    let git = |arguments: &[&str], folder: &Path| {
        let mut command = Command::new("git");
        command.args(arguments).current_dir(folder).env("GIT_TERMINAL_PROMPT", "0");
        command.stdout(Stdio::null()).stderr(Stdio::null()).status().is_ok_and(|status| status.success())
    };
    let clone =
        ["clone", "--quiet", "--depth", "1", "--filter=blob:none", "--sparse", source.address, source.folder];
    if !git(&clone, place) {
        let _ = fs::remove_dir_all(&folder);
        return Err(why("it cannot be cloned"));
    }
    let sparse: Vec<&str> = ["sparse-checkout", "set"].iter().chain(source.parts).copied().collect();
    if git(&sparse, &folder) { Ok(folder) } else { Err(why("its part cannot be checked out")) }
}

/// Returns true if a program can be run.
fn has(program: &str) -> bool {
    let run = Command::new(program).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    run.is_ok_and(|status| status.success())
}

/// A script of this command, in the place of what it reads.
fn script(place: &Path, name: &str, text: &str) -> Result<PathBuf> {
    let path = place.join(name);
    fs::write(&path, text).with_context(|| format!("{} cannot be written", path.display()))?;
    Ok(path)
}

fn moodle(place: &Path, folders: &[PathBuf]) -> Outcome {
    if !has("php") {
        return Ok(Err("there is no php; install php-cli and php-xml".to_owned()));
    }
    let sources = match fetched(place, &MOODLE) {
        Ok(sources) => sources,
        Err(why) => return Ok(Err(why)),
    };
    // Since version 5.1 the sources stand in a folder of their own.
    let inner = sources.join("public");
    let sources = if inner.is_dir() { inner } else { sources };
    let script = script(place, "moodle.php", include_str!("teaching/moodle.php"))?;
    let files = folders.iter().map(|folder| folder.join("moodle.xml"));
    let said = output(Command::new("php").arg(script).arg(&sources).args(files))?;
    let read: Json = serde_json::from_str(&said).context("the importer prints no JSON")?;
    let questions: Vec<&Json> = read["questions"]
        .as_array()
        .into_iter()
        .flatten()
        .filter(|one| one.get("blanks").is_some())
        .collect();
    let wanted = PROBLEMS.len() * COUNT.parse::<usize>()?;
    ensure!(questions.len() == wanted, "{} questions are read of {wanted}", questions.len());
    let (mut blanks, mut errors) = (0, 0);
    for question in questions {
        for blank in question["blanks"].as_array().context("a question has no blanks")? {
            let lists = ["answers", "fractions", "tolerances", "feedback"];
            let lengths: Vec<usize> =
                lists.iter().map(|key| blank[key].as_array().map_or(0, Vec::len)).collect();
            ensure!(lengths[0] > 0 && lengths.iter().all(|length| *length == lengths[0]), "{blank}");
            ensure!(blank["type"] == "numerical" && blank["fractions"][0] == "1", "{blank}");
            for at in 1..lengths[0] {
                ensure!(blank["fractions"][at].as_str().is_some_and(|share| share == "0"), "{blank}");
                ensure!(blank["feedback"][at].as_str().is_some_and(|words| !words.is_empty()), "{blank}");
            }
            blanks += 1;
            errors += lengths[0] - 1;
        }
    }
    let version = fs::read_to_string(sources.join("version.php")).unwrap_or_default();
    let release = version.lines().find_map(|line| line.trim().strip_prefix("$release")).unwrap_or_default();
    let release = release.split('\'').nth(1).unwrap_or("of unknown version");
    Ok(Ok(format!(
        "{wanted} questions, {blanks} blanks, {errors} common errors read by the importer of Moodle {release}"
    )))
}

fn qti(place: &Path, folders: &[PathBuf]) -> Outcome {
    if !has("xmllint") {
        return Ok(Err("there is no xmllint; install libxml2-utils".to_owned()));
    }
    let schemas = match fetched(place, &SCHEMAS) {
        Ok(sources) => sources.join("model/qti/data"),
        Err(why) => return Ok(Err(why)),
    };
    let valid = |schema: &str, files: &[PathBuf]| -> Result<()> {
        let mut command = Command::new("xmllint");
        command.args(["--nonet", "--noout", "--schema"]).arg(schemas.join(schema)).args(files);
        let done = command.output().context("xmllint cannot be run")?;
        if !done.status.success() {
            bail!("{}", String::from_utf8_lossy(&done.stderr));
        }
        Ok(())
    };
    let mut items = Vec::new();
    for folder in folders {
        valid("imscp_v1p1.xsd", &[folder.join("imsmanifest.xml")])?;
        for entry in fs::read_dir(folder.join("items"))? {
            let path = entry?.path();
            if path.extension().is_some_and(|extension| extension == "xml") {
                items.push(path);
            }
        }
    }
    let wanted = PROBLEMS.len() * COUNT.parse::<usize>()?;
    ensure!(items.len() == wanted, "{} items are written of {wanted}", items.len());
    valid("qtiv2p1/imsqti_v2p1.xsd", &items)?;
    Ok(Ok(format!("{} packages and {wanted} items are valid by the schemas", folders.len())))
}

fn prairielearn(place: &Path, folders: &[PathBuf]) -> Outcome {
    let Some(python) = ["python3.13", "python3"].into_iter().find(|python| is_new_enough(python)) else {
        return Ok(Err("there is no Python 3.13, which its package requires".to_owned()));
    };
    let sources = match fetched(place, &PRAIRIELEARN) {
        Ok(sources) => sources,
        Err(why) => return Ok(Err(why)),
    };
    let environment = place.join("environment");
    let interpreter = environment.join("bin").join("python");
    if !environment.exists() {
        run_command(Command::new(python).args(["-m", "venv"]).arg(&environment))?;
        let mut install = Command::new(&interpreter);
        install.args(["-m", "pip", "install", "--quiet"]).args(PACKAGES);
        if run_command(&mut install).is_err() {
            let _ = fs::remove_dir_all(&environment);
            return Ok(Err("the packages of Python cannot be installed".to_owned()));
        }
    }
    let script = script(place, "question.py", include_str!("teaching/question.py"))?;
    let mut said = Vec::new();
    for folder in folders {
        for entry in fs::read_dir(folder)? {
            let mut command = Command::new(&interpreter);
            command.env("PYTHONPATH", sources.join("apps/prairielearn/python"));
            command.env("PYTHONDONTWRITEBYTECODE", "1");
            said.push(output(command.arg(&script).arg(&sources).arg(entry?.path()))?.trim().to_owned());
        }
    }
    ensure!(said.len() == PROBLEMS.len(), "{} folders are written", said.len());
    Ok(Ok(said.join("; ")))
}

/// Returns true of Python 3.13 or newer.
fn is_new_enough(python: &str) -> bool {
    let mut asked = Command::new(python);
    asked.args(["-c", "import sys; sys.exit(sys.version_info < (3, 13))"]).stderr(Stdio::null());
    asked.status().is_ok_and(|status| status.success())
}
