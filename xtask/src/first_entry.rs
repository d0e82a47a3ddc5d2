//! `cargo xtask first-entry`: the rate of published problems that were right at their first entry, from the history.
//!
//! tests/first-entry/README.md states what a set holds, and in which order its files are committed.

use std::{collections::BTreeMap, f64::consts::TAU, fmt, fs, path::Path, process::Command};

use anyhow::{Context, Result, bail, ensure};
use dalembert_units::{Dim, read_any};
use serde::{Deserialize, de::DeserializeOwned};
use serde_json::Value as Json;

use crate::cargo::{Program, git};

const FOLDER: &str = "tests/first-entry";

#[derive(Deserialize)]
struct Problems {
    work: Vec<Work>,
    problem: Vec<Problem>,
}

#[derive(Deserialize)]
struct Work {
    key: String,
}

#[derive(Deserialize)]
struct Problem {
    id: String,
    work: String,
    place: String,
}

/// Names of the answers to a problem, or why it cannot be entered.
#[derive(Deserialize)]
#[serde(untagged)]
enum Asked {
    Answers(Vec<Question>),
    NotEntered(String),
}

/// Names of what a question asks: one answer, or several.
#[derive(Deserialize)]
#[serde(untagged)]
enum Question {
    One(String),
    Several(Vec<String>),
}

impl Question {
    fn into_names(self) -> Vec<String> {
        match self {
            Self::One(name) => vec![name],
            Self::Several(names) => names,
        }
    }
}

#[derive(Deserialize)]
struct AllExpected {
    answer: Vec<Expected>,
}

/// Values printed by a work, in the order of what it asks.
#[derive(Deserialize)]
struct Expected {
    id: String,
    printed: Vec<String>,
    /// True values where the printed ones are wrong or rounded too early; an empty text leaves the printed one.
    truth: Option<Vec<String>>,
    why: Option<String>,
}

/// Outcome of a problem.
enum Outcome {
    Right,
    /// Right by a true value, beside a printed one that is wrong or rounded too early.
    Disputed(String),
    /// Answers other than the printed ones.
    Other(String),
    Refused(String),
    NotEntered(String),
}

impl Outcome {
    fn is_right(&self) -> bool {
        matches!(self, Self::Right | Self::Disputed(_))
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Right => f.write_str("right"),
            Self::Disputed(why) => write!(f, "right, printed value disputed: {why}"),
            Self::Other(what) => write!(f, "other: {what}"),
            Self::Refused(why) => write!(f, "refused: {why}"),
            Self::NotEntered(why) => write!(f, "not entered: {why}"),
        }
    }
}

/// Prints the outcome of each problem, the rate of each work and each set, and that of all.
pub fn run(root: &Path) -> Result<()> {
    let program = Program::built(root, root)?;
    let mut sets: Vec<_> = fs::read_dir(root.join(FOLDER))?.collect::<Result<_, _>>()?;
    sets.retain(|set| set.path().is_dir());
    sets.sort_by_key(fs::DirEntry::file_name);
    let mut rates: BTreeMap<String, [usize; 2]> = BTreeMap::new();
    let mut of_sets: Vec<(String, [usize; 2])> = Vec::new();
    for folder in sets {
        let name = folder.file_name().to_string_lossy().into_owned();
        if !folder.path().join("printed.toml").exists() {
            println!("{name}: listed, but not entered yet");
            continue;
        }
        let set = Set::read(root, &name)?;
        of_sets.push((name, [0, 0]));
        for problem in &set.problems.problem {
            let outcome = set.outcome(root, &program, &problem.id).with_context(|| problem.id.clone())?;
            println!("{} {}, {}: {outcome}", problem.id, problem.work, problem.place);
            let of_set = of_sets.last_mut().map(|(_, rate)| rate);
            for [right, all] in of_set.into_iter().chain([rates.entry(problem.work.clone()).or_default()]) {
                *right += usize::from(outcome.is_right());
                *all += 1;
            }
        }
    }
    println!();
    for (work, [right, all]) in &rates {
        println!("{right:>4} of {all:<4} {work}");
    }
    println!();
    for (set, [right, all]) in &of_sets {
        println!("{right:>4} of {all:<4} {set}");
    }
    let [right, all] = rates.values().fold([0, 0], |sum, rate| [sum[0] + rate[0], sum[1] + rate[1]]);
    ensure!(all > 0, "there are no problems in {FOLDER}");
    println!("{right:>4} of {all:<4} problems of {} works, {} %", rates.len(), 100 * right / all);
    Ok(())
}

/// A folder of problems, as far as it is committed.
struct Set {
    folder: String,
    problems: Problems,
    expected: BTreeMap<String, Expected>,
    /// Commits that added the list and the printed values.
    listed: String,
    compared: String,
}

impl Set {
    fn read(root: &Path, name: &str) -> Result<Self> {
        let folder = format!("{FOLDER}/{name}");
        let of_today = |file: &str| fs::read_to_string(root.join(format!("{folder}/{file}")));
        let problems: Problems = parsed(&of_today("problems.toml")?, "problems.toml")?;
        for problem in &problems.problem {
            ensure!(
                problems.work.iter().any(|work| work.key == problem.work),
                "{}: there is no work `{}`",
                problem.id,
                problem.work
            );
        }
        let rows: AllExpected = parsed(&of_today("printed.toml")?, "printed.toml")?;
        let expected = rows.answer.into_iter().map(|row| (row.id.clone(), row)).collect();
        let listed = first_commit(root, &format!("{folder}/problems.toml"))?
            .with_context(|| format!("{folder}/problems.toml is not committed"))?;
        let compared = first_commit(root, &format!("{folder}/printed.toml"))?
            .with_context(|| format!("{folder}/printed.toml is not committed"))?;
        Ok(Self { folder, problems, expected, listed, compared })
    }

    fn outcome(&self, root: &Path, program: &Program, id: &str) -> Result<Outcome> {
        let expected = self.expected.get(id).context("has no printed values")?;
        let path = format!("{}/{id}.toml", self.folder);
        let Some(entered) = first_commit(root, &path)? else {
            let asked = fs::read_to_string(root.join(&self.folder).join("asked.toml"))?;
            return match asked_in(&asked, id)? {
                Asked::NotEntered(why) => Ok(Outcome::NotEntered(why)),
                Asked::Answers(_) => bail!("{path} is not committed"),
            };
        };
        ensure!(is_before(root, &self.listed, &entered)?, "was entered before it was listed");
        ensure!(is_before(root, &entered, &self.compared)?, "was entered after its printed values");
        let asked = match asked_in(&shown(root, &entered, &format!("{}/asked.toml", self.folder))?, id)? {
            Asked::Answers(questions) => {
                questions.into_iter().flat_map(Question::into_names).collect::<Vec<String>>()
            }
            Asked::NotEntered(why) => return Ok(Outcome::NotEntered(why)),
        };
        ensure!(
            asked.len() == expected.printed.len(),
            "{} answers are named, {} are printed",
            asked.len(),
            expected.printed.len()
        );
        let file =
            std::env::temp_dir().join(format!("dalembert-first-entry-{}-{id}.toml", std::process::id()));
        fs::write(&file, shown(root, &entered, &path)?)?;
        let solved = program.with(&["solve", &file.to_string_lossy(), "--format", "json"]).output();
        // A file that stays behind among the temporary ones does no harm.
        let _ = fs::remove_file(&file);
        let solved = solved?;
        let Ok(solution) = serde_json::from_slice::<Json>(&solved.stdout) else {
            let message = String::from_utf8_lossy(&solved.stderr).into_owned();
            return Ok(Outcome::Refused(message.lines().next().unwrap_or_default().to_owned()));
        };
        compared(&solution, &asked, expected)
    }
}

/// The answers of a solution beside the printed values.
fn compared(solution: &Json, asked: &[String], expected: &Expected) -> Result<Outcome> {
    let mut disputed = false;
    let mut others = Vec::new();
    for (place, (name, text)) in asked.iter().zip(&expected.printed).enumerate() {
        let Some(found) = numbers(solution, name) else {
            let why = solution["refusal"].as_str().map_or(String::new(), |why| format!(": {why}"));
            return Ok(Outcome::Refused(format!("`{name}` has no value{why}")));
        };
        if agrees(&found, text)? {
            continue;
        }
        match expected.truth.as_ref().and_then(|truth| truth.get(place)).filter(|truth| !truth.is_empty()) {
            Some(truth) if agrees(&found, truth)? => disputed = true,
            _ => others.push(format!("`{name}` is {} for {text}", shown_number(solution, name))),
        }
    }
    Ok(if !others.is_empty() {
        Outcome::Other(others.join("; "))
    } else if disputed {
        Outcome::Disputed(expected.why.clone().context("a true value without the reason (`why`)")?)
    } else {
        Outcome::Right
    })
}

/// The SI value of an answer, or those of its components; `name.y` and `name[2]` are one of them.
fn numbers(solution: &Json, name: &str) -> Option<Vec<f64>> {
    let si = |name: &str| {
        let si = &solution["answers"][name]["si"];
        si.as_f64().map(|number| vec![number]).or_else(|| si.as_array()?.iter().map(Json::as_f64).collect())
    };
    // The key of a question is in small letters.
    si(name).or_else(|| si(&name.to_lowercase())).or_else(|| {
        let (whole, place) = match name.strip_suffix(']').and_then(|name| name.rsplit_once('[')) {
            Some((whole, place)) => (whole, place.parse::<usize>().ok()?.checked_sub(1)?),
            None => {
                let (whole, axis) = name.rsplit_once('.')?;
                (whole, ["x", "y", "z"].iter().position(|known| *known == axis)?)
            }
        };
        Some(vec![*si(whole)?.get(place)?])
    })
}

fn shown_number(solution: &Json, name: &str) -> String {
    let shown = &solution["answers"][name]["shown"];
    let [found] = numbers(solution, name).unwrap_or_default()[..] else { return shown.to_string() };
    shown.as_str().map_or_else(|| format!("{found} in SI"), str::to_owned)
}

/// Returns true if numbers in SI are those of a text with their unit, `3.62 Hz` or `(1.2; -0.4) m`, to half a unit of the last
/// place of each.
fn agrees(found: &[f64], text: &str) -> Result<bool> {
    let (parts, unit) = match text.strip_prefix('(').and_then(|text| text.split_once(')')) {
        Some((parts, unit)) => (parts.split(';').map(str::trim).collect(), unit.trim()),
        None => {
            let end = text.find(' ').unwrap_or(text.len());
            (vec![&text[..end]], text[end..].trim())
        }
    };
    // A vector in the plane has a third component, which is zero.
    if parts.len() > found.len() || found[parts.len()..].iter().any(|rest| *rest != 0.0) {
        return Ok(false);
    }
    for (part, found) in parts.iter().zip(found) {
        let read = |number: f64| read_any(&format!("{number:e} {unit}")).with_context(|| text.to_owned());
        let (number, place): (f64, f64) = (part.parse().with_context(|| text.to_owned())?, last_place(part)?);
        let want = read(number)?;
        let half = (read(number + place)?.si - want.si).abs() / 2.0;
        // Whole turns do not change an angle.
        let turn = if want.unit.dim == Dim::ANGLE { TAU } else { f64::INFINITY };
        let off = (found - want.si).abs() % turn;
        if off.min(turn - off) > half * (1.0 + 1e-9) {
            return Ok(false);
        }
    }
    Ok(true)
}

/// One unit of the last place of a number as it is written.
fn last_place(number: &str) -> Result<f64> {
    let (digits, power) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
    let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    Ok(10f64.powi(power.parse::<i32>()? - i32::try_from(decimals)?))
}

fn asked_in(text: &str, id: &str) -> Result<Asked> {
    let mut asked: BTreeMap<String, Asked> = parsed(text, "asked.toml")?;
    asked.remove(id).with_context(|| format!("asked.toml does not name the answers of {id}"))
}

fn parsed<T: DeserializeOwned>(text: &str, file: &str) -> Result<T> {
    toml::from_str(text).with_context(|| file.to_owned())
}

/// The commit that added a file, the first if it was removed between.
fn first_commit(root: &Path, path: &str) -> Result<Option<String>> {
    let added = git(root, &["log", "--diff-filter=A", "--format=%H", "--", path])?;
    Ok(added.lines().last().map(str::to_owned))
}

fn shown(root: &Path, commit: &str, path: &str) -> Result<String> {
    git(root, &["show", &format!("{commit}:{path}")])
}

fn is_before(root: &Path, first: &str, second: &str) -> Result<bool> {
    let status = Command::new("git")
        .current_dir(root)
        .args(["merge-base", "--is-ancestor", first, second])
        .status()
        .context("git cannot be run")?;
    Ok(status.success() && first != second)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_is_right_to_half_a_unit_of_its_last_place() -> Result<()> {
        let hertz = TAU;
        assert!(agrees(&[3.6249 * hertz], "3.62 Hz")?);
        assert!(!agrees(&[3.6251 * hertz], "3.62 Hz")?);
        assert!(agrees(&[1.2e-3, -0.4e-3], "(1.2; -0.4) mm")?);
        assert!(agrees(&[1.2e-3, -0.4e-3, 0.0], "(1.2; -0.4) mm")?);
        assert!(!agrees(&[1.2e-3, 0.4e-3], "(1.2; -0.4) mm")?);
        assert!(!agrees(&[1.2e-3, -0.4e-3, 1.0], "(1.2; -0.4) mm")?);
        assert!(agrees(&[2.05e11], "2.1e11 Pa")? && !agrees(&[2.16e11], "2.1e11 Pa")?);
        assert!(agrees(&[0.3], "0.3")? && !agrees(&[0.36], "0.3")?);
        assert!(agrees(&[5.2], "-62 deg")? && !agrees(&[5.2], "62 deg")?);
        assert!(agrees(&[1.0], "1 furlong-ish").is_err());
        Ok(())
    }

    #[test]
    fn parts_of_an_answer_are_named() {
        let solution = serde_json::json!({ "answers": {
            "v": { "si": [1.0, 2.0], "shown": "(1; 2) m" }, "a": { "si": 3.0, "shown": "3 m" }
        }});
        assert_eq!(numbers(&solution, "v.y"), Some(vec![2.0]));
        assert_eq!(numbers(&solution, "v[1]"), Some(vec![1.0]));
        assert_eq!(numbers(&solution, "a"), Some(vec![3.0]));
        assert_eq!(numbers(&solution, "b"), None);
    }
}
