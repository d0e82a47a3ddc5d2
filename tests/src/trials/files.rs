//! Hostile problem files.

use std::{
    panic::{AssertUnwindSafe, catch_unwind},
    sync::{Mutex, mpsc},
    thread,
    time::{Duration, Instant},
};

use dalembert_core::{AnswerValue, Number, SolveError, Stop, cases, file, registry};
use dalembert_testkit::on_all_cores;

use super::{Outcome, Random};

/// Time in which a file is solved or refused.
const LIMIT: Duration = Duration::from_secs(5);

/// Values that no field expects.
const VALUES: [&str; 14] = [
    "nan",
    "inf",
    "1e400",
    "-1e300",
    "1e-300",
    "0",
    "",
    "-1 m",
    "1 furlong",
    "{}",
    "[[1]]",
    "2020-01-01",
    "\\u0000",
    "((((((((1))))))))",
];

/// Changes every case of the catalogue at random, as text, `times` times in all: each is solved with finite numbers or
/// refused, within five seconds.
pub(super) fn hostile(times: u64, seed: u64) -> Outcome {
    let sound: Vec<String> = registry()
        .iter()
        .flat_map(|entry| {
            let head = format!("format = 2\nanalysis = \"{}\"\n", entry.about.id);
            let empty = file::parse(&head).expect("a file of an analysis alone is read");
            let cases = cases::cases(entry).expect("the cases are read");
            cases
                .into_iter()
                .map(move |case| file::write(&file::ProblemFile { draft: case.draft, ..empty.clone() }, ""))
        })
        .collect();
    let jobs: Vec<u64> = (0..times).collect();
    let met = Mutex::new((Outcome { tried: times, ..Outcome::default() }, [0_u64; 3], Duration::ZERO));
    on_all_cores(&jobs, |_, key| {
        let mut random = Random::new(seed, *key);
        let mut text = sound[random.below(sound.len())].clone();
        for _ in 0..=random.below(3) {
            text = mutated(&text, &mut random);
        }
        let start = Instant::now();
        let verdict = within_limit(&text);
        let mut met = met.lock().expect("no panic while it is held");
        met.2 = met.2.max(start.elapsed());
        match verdict {
            Ok(kind) => met.1[kind] += 1,
            Err(why) => met.0.failures.push(format!("seed {seed}, file {key}: {why}")),
        }
    });
    let (mut outcome, [solved, refused, invalid], slowest) =
        met.into_inner().expect("no panic while it was held");
    outcome.note = format!(
        "{solved} solved, {refused} without an answer, {invalid} refused as they are read; slowest {:.1} s",
        slowest.as_secs_f64()
    );
    outcome
}

/// Place of the verdict among solved, without an answer, refused as it is read; or the fault.
fn within_limit(text: &str) -> Result<usize, String> {
    let (send, receive) = mpsc::channel();
    let text = text.to_owned();
    thread::spawn(move || {
        let verdict = catch_unwind(AssertUnwindSafe(|| solved(&text)));
        let _ = send.send(verdict.unwrap_or_else(|_| Err("panics".to_owned())));
    });
    receive.recv_timeout(LIMIT).unwrap_or_else(|_| Err(format!("runs for more than {LIMIT:?}")))
}

fn solved(text: &str) -> Result<usize, String> {
    let Ok(problem) = file::parse(text) else { return Ok(2) };
    let record = match problem.draft.read(&problem.entry.shape()) {
        Ok(record) => record,
        Err(errors) => {
            file::locate(text, &errors);
            return Ok(2);
        }
    };
    match problem.entry.solve(&record, &Stop::new()) {
        Ok(solution) => {
            let finite = |number: &Number| number.is_finite();
            let faulty = solution.answers.iter().find(|answer| match &answer.value {
                AnswerValue::Number(number, _) => !finite(number),
                AnswerValue::List(numbers) => numbers.iter().any(|x| !x.is_finite()),
                AnswerValue::Set(..) => false,
            });
            match faulty {
                Some(answer) => Err(format!("{}: {} is not finite", problem.entry.about.id, answer.name)),
                None => Ok(0),
            }
        }
        Err(SolveError::Refused(_)) => Ok(1),
        Err(other) => Err(format!("{}: {other:?}", problem.entry.about.id)),
    }
}

/// A text with one of many changes.
fn mutated(text: &str, random: &mut Random) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    if lines.is_empty() {
        return "analysis = 3".to_owned();
    }
    let at = random.below(lines.len());
    let other = random.below(lines.len());
    let value = |line: &str, new: &str| match line.split_once('=') {
        Some((key, _)) => format!("{key}= {new}"),
        None => line.to_owned(),
    };
    match random.below(16) {
        0 => _ = lines.remove(at),
        1 => lines.insert(at, lines[other].clone()),
        2 => lines.swap(at, other),
        3 => {
            let row = lines[at].clone();
            let count = [3, 30, 300][random.below(3)];
            lines.splice(at..at, std::iter::repeat_n(row, count));
        }
        4 => lines[at] = value(&lines[at], &format!("\"{}\"", random.one(&VALUES))),
        5 => {
            lines[at] = value(
                &lines[at],
                random.one(&["true", "[]", "{}", "1979-05-27", "-0.0", "nan", "+inf", "9999999999999999999"]),
            );
        }
        6 => lines[at] = lines[at].replace('=', ""),
        7 => {
            lines[at] =
                lines[at].replacen(|c: char| c.is_ascii_digit(), random.one(&["0", "9e99", "-", "", "٣"]), 1);
        }
        8 => lines[at] = lines[at].replace(|c: char| c.is_ascii_digit(), "0"),
        9 => lines[at] = format!("{}.{}", "a".repeat(50), lines[at]),
        10 => lines[at] += random.one(&["\u{feff}", "\r", " # \u{202e}", "\"\"\"", "\u{0}", " = ="]),
        11 => lines[at] = value(&lines[at], &format!("\"{}1{}\"", "(".repeat(80), ")".repeat(80))),
        12 => lines.truncate(at + 1),
        13 => lines[at] = value(&lines[at], &format!("\"1e{}\"", [300, -300, 308, -320][random.below(4)])),
        14 => lines.insert(
            at,
            format!(
                "{} = \"1\"",
                random.one(&["format", "analysis", "let", "inputs", "show", "units", "vary"])
            ),
        ),
        _ => {
            // A unit in place of another.
            let unit = random.one(&["mm", "kg", "rpm", "deg", "N", "dB", "%", "m^9", "lbf", "s^-1"]);
            if let Some((head, _)) = lines[at].rsplit_once(' ') {
                lines[at] = format!("{head} {unit}\"");
            }
        }
    }
    lines.join("\n") + "\n"
}
