//! `dalembert check`

use std::process::ExitCode;

use dalembert_core::{
    Locale, Solution, Stop, Text,
    check::{self, Cause, Mistake, Place, Verdict},
    find as analysis, nearest,
};
use serde_json::{Value as Json, json};

use crate::{
    arguments::Check,
    console::{Console, print, print_json},
    failure::Failure,
    problem::{self, ProblemSource},
    solving,
};

/// Version of the schema of the JSON.
const FORMAT: u32 = 1;

/// The verdict on an answer.
struct Checked<'s> {
    name: String,
    typed: &'s str,
    verdict: Verdict,
    causes: Vec<Cause>,
}

/// Compares answers with the computed ones, and prints the likeliest cause of each wrong one.
pub(crate) fn run(check: &Check, console: &Console) -> Result<ExitCode, Failure> {
    let asked = ProblemSource {
        case: check.case.or_else(|| analysis(&check.problem).map(|_| 1)),
        changes: &check.set,
        ..ProblemSource::named(&check.problem)
    };
    let problem = problem::read(&asked, console)?;
    let solution = solving::solve(problem.entry, &problem.record)?.map_err(Failure::Refused)?;
    let locale = console.locale.at(problem.entry.about.id);
    let typed = typed(&check.answers, &solution)?;
    let causes = solving::guarded(problem.entry, || {
        check::causes(problem.entry, &problem.record, &solution, &typed, &Stop::new(), None)
    })?;
    let checked: Vec<Checked<'_>> = check::compare_all(&solution, &typed)
        .into_iter()
        .zip(&typed)
        .map(|((name, verdict), (_, typed))| {
            let causes = causes.iter().find(|(known, _)| *known == name);
            let causes = causes.map_or_else(Vec::new, |(_, causes)| causes.clone());
            Checked { name, typed, verdict, causes }
        })
        .collect();
    if check.json {
        let answers: Vec<Json> = checked.iter().map(|one| one.json(&solution, &locale)).collect();
        print_json(&json!({ "format": FORMAT, "analysis": problem.entry.about.id, "answers": answers }))?;
    } else {
        for line in checked.iter().flat_map(|one| one.lines(&solution, check.reveal, &locale)) {
            print(&format!("{}\n", console.plain(&line)))?;
        }
    }
    let all_right = checked.iter().all(|one| one.verdict == Verdict::Right);
    Ok(if all_right { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// The answers as they were written: the name of each, and its value.
fn typed(answers: &[String], solution: &Solution) -> Result<Vec<(String, String)>, Failure> {
    let mut typed = Vec::new();
    for written in answers {
        let Some((name, value)) = written.split_once('=') else {
            let why = Text::new("`{written}`: write an answer and its value, as in `amplitude=19.5 mm`");
            return Err(Failure::input(why.with("written", written)));
        };
        let (name, value) = (name.trim(), value.trim());
        let Some(answer) = solution.answers.iter().find(|answer| answer.name.is(name)) else {
            let known: Vec<String> = solution.answers.iter().map(|one| one.name.to_string()).collect();
            let why = match nearest(name, known.iter().map(String::as_str)) {
                Some(near) => {
                    Text::new("there is no answer `{name}`; did you mean `{near}`?").with("near", near)
                }
                None => Text::new("there is no answer `{name}`; the answers are {known}")
                    .with("known", known.join(", ")),
            };
            return Err(Failure::input(why.with("name", name)));
        };
        if value.is_empty() {
            let why = Text::new("the value of `{name}` is missing, as in `{name}={example}`");
            let example = check::example(answer);
            return Err(Failure::input(why.with("name", name).with("example", example)));
        }
        typed.push((answer.name.to_string(), value.to_owned()));
    }
    Ok(typed)
}

impl Checked<'_> {
    /// Name of the verdict in JSON.
    fn verdict_name(&self) -> &'static str {
        match self.verdict {
            Verdict::Right => "correct",
            Verdict::RoundedEarly(_) => "near",
            Verdict::TooFewDigits => "too-few-digits",
            Verdict::Wrong => "incorrect",
            Verdict::Unread(_) => "unreadable",
        }
    }

    fn lines(&self, solution: &Solution, reveals: bool, locale: &Locale) -> Vec<String> {
        let verdict = self.verdict.text().render(&locale.digits(2));
        let verdict = match (&self.verdict, self.causes.is_empty()) {
            (Verdict::Wrong, true) => {
                Text::new("Incorrect. No common error reproduces this value.").render(locale)
            }
            (Verdict::RoundedEarly(_), false) => Verdict::Wrong.text().render(locale),
            _ => verdict,
        };
        let mut lines = vec![format!("{} = {}: {verdict}", self.name, self.typed)];
        let mut say = |indent: usize, text: &Text| {
            lines.push(format!("{}{}", " ".repeat(indent), text.render(locale)));
        };
        let named = self.causes.first().is_some_and(|first| first.is_named);
        for (n, cause) in self.causes.iter().enumerate() {
            match n {
                0 if named => say(2, &Text::new("Likely cause:")),
                0 => say(2, &Text::new("Possible causes:")),
                1 if named => say(2, &Text::new("Other possibilities:")),
                _ => {}
            }
            say(4, &cause.text(solution));
            if n > 0 {
                continue;
            }
            for [wrong, right] in cause.mistakes.iter().filter_map(|one| one.lines(solution, locale)) {
                if reveals {
                    let line = Text::new("{wrong}   (correct: {right})");
                    say(6, &line.with("wrong", wrong).with("right", right));
                } else {
                    say(6, &Text::verbatim(wrong));
                }
            }
        }
        if let (true, Some(answer)) = (reveals, solution.answer(&self.name)) {
            say(2, &Text::new("correct: {value}").with("value", answer.shown(locale)));
        }
        lines
    }

    fn json(&self, solution: &Solution, locale: &Locale) -> Json {
        let causes: Vec<Json> = self
            .causes
            .iter()
            .map(|cause| {
                let one = |mistake: &Mistake| {
                    let (place, at) = match &mistake.place {
                        Place::Answer => ("answer", None),
                        Place::Problem => ("problem", None),
                        Place::Input(path, _) => ("input", Some(path.clone())),
                        Place::Step(_, symbol) => ("step", Some(dalembert_core::printer::symbol(symbol))),
                    };
                    let lines = mistake.lines(solution, locale);
                    json!({
                        "place": place,
                        "at": at,
                        "operation": mistake.operation(),
                        "text": mistake.text(solution).render(locale),
                        "computed": lines.as_ref().map(|[wrong, _]| wrong),
                        "correct": lines.as_ref().map(|[_, right]| right),
                    })
                };
                let mistakes: Vec<Json> = cause.mistakes.iter().map(one).collect();
                let equivalents: Vec<Vec<Json>> =
                    cause.equivalents.iter().map(|all| all.iter().map(one).collect()).collect();
                let text = cause.text(solution).render(locale);
                json!({
                    "text": text,
                    "named": cause.is_named,
                    "mistakes": mistakes,
                    "equivalents": equivalents,
                })
            })
            .collect();
        let text = self.verdict.text().render(&locale.digits(2));
        json!({
            "answer": self.name,
            "typed": self.typed,
            "verdict": self.verdict_name(),
            "text": text,
            "causes": causes,
        })
    }
}
