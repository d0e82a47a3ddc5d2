//! The verdict on a user's answers and the likely causes of wrong ones, as text and JSON.

use dalembert_core::{
    Locale, Solution, Text,
    check::{self, Cause, Causes, Mistake, Place, Verdict},
    printer,
};
use serde_json::{Value as Json, json};

/// The verdict on an answer.
#[derive(Clone, Debug)]
pub struct CheckedAnswer {
    /// Name of the answer.
    pub name: String,
    /// Text as typed.
    pub typed: String,
    /// Verdict on it.
    pub verdict: Verdict,
    /// Causes that give the value that was typed, the likeliest first.
    pub causes: Vec<Cause>,
}

/// The verdicts on typed answers, each with its causes among all that were found.
pub fn checked_answers(
    solution: &Solution,
    typed: &[(String, String)],
    causes: &Causes,
) -> Vec<CheckedAnswer> {
    let compared = check::compare_all(solution, typed).into_iter().zip(typed);
    let with_causes = compared.map(|((name, verdict), (_, typed))| {
        let causes = causes.iter().find(|(known, _)| *known == name);
        let causes = causes.map_or_else(Vec::new, |(_, causes)| causes.clone());
        CheckedAnswer { name, typed: typed.clone(), verdict, causes }
    });
    with_causes.collect()
}

impl CheckedAnswer {
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

    /// Verdict and causes as lines of text; `reveals` adds the computed value.
    pub fn lines(&self, solution: &Solution, reveals: bool, locale: &Locale) -> Vec<String> {
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

    /// Verdict and causes for another program.
    pub fn json(&self, solution: &Solution, locale: &Locale) -> Json {
        let causes: Vec<Json> = self
            .causes
            .iter()
            .map(|cause| {
                let one = |mistake: &Mistake| {
                    let (place, at) = match &mistake.place {
                        Place::Answer => ("answer", None),
                        Place::Problem => ("problem", None),
                        Place::Input(path, _) => ("input", Some(path.clone())),
                        Place::Step(_, symbol) => ("step", Some(printer::symbol(symbol))),
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
