//! Additions to a plan.

use dalembert_core::{Text, study::Correlation, vary::VariedInput};

use super::{
    draft::{Varied, Way, limit_line},
    kind::Kind,
    plan::{Cell, Plan, Subject},
};

impl Plan {
    /// Possible additions: name, explanation, and the word for [`add`](Self::add).
    pub(super) fn additions(&self, of: &Subject<'_>) -> Vec<(Text, Text, String)> {
        let mut all = Vec::new();
        let is_free = |input: &&VariedInput| {
            of.draft.vary.iter().all(|varied| varied.input.as_ref() != Some(&input.path))
        };
        if self.kind == Kind::Find {
            return all;
        }
        for input in of.inputs.iter().filter(is_free) {
            all.push((input.label.clone(), Text::new("vary this input"), format!("vary {}", input.path)));
        }
        if of.names.len() < of.answers.len() && !of.names.is_empty() {
            all.push((Text::new("Answer"), Text::new("another answer of each point"), "answer".into()));
        }
        all.push((
            Text::new("Limit"),
            Text::new("probability that an answer is above or below a value"),
            "limit".into(),
        ));
        all.push((
            Text::new("Condition to meet"),
            Text::new("points that do not meet it are refused"),
            "condition".into(),
        ));
        if self.drawn(of).len() > 1 {
            all.push((
                Text::new("Correlation of inputs"),
                Text::new("of two inputs that have a distribution"),
                "correlation".into(),
            ));
        }
        all.push((
            Text::new("Table"),
            Text::new("rows of a CSV file, whose headings are inputs"),
            "table".into(),
        ));
        all
    }

    /// Adds something; its cell, and whether its text is to be typed now.
    pub(super) fn add(&mut self, what: &str, of: &Subject<'_>) -> (Cell, bool) {
        self.unfolded |= what.starts_with("vary ") || what == "table";
        let answer = of.answer();
        let line = |sign: char| answer.map_or_else(String::new, |answer| limit_line(answer, sign));
        let drawn = self.drawn(of);
        let is_curve = !of.draft.vary.is_empty() && drawn.is_empty();
        let names = of.names.clone();
        match what {
            "answer" => {
                let other = of.answers.iter().find(|answer| !names.iter().any(|name| answer.name.is(name)));
                let all = names.iter().cloned().chain(other.map(|answer| answer.name.to_string()));
                self.slot_mut().answers = Some(all.collect());
                (Cell::Answer(names.len()), false)
            }
            "limit" => {
                let draft = self.edit(of);
                draft.limit.push(line('>'));
                (Cell::Limit(draft.limit.len() - 1), true)
            }
            "condition" => {
                let draft = self.edit(of);
                draft.condition.push(line('<'));
                (Cell::Condition(draft.condition.len() - 1), true)
            }
            "correlation" => {
                let pair: Option<[String; 2]> = drawn.into_iter().take(2).collect::<Vec<_>>().try_into().ok();
                let line = pair.map(|inputs| Correlation { inputs, coefficient: 0.5 }.line());
                let draft = self.edit(of);
                draft.correlation.push(line.unwrap_or_default());
                (Cell::Correlation(draft.correlation.len() - 1), true)
            }
            "table" => {
                let table = Varied::table("table(points.csv)");
                let draft = self.edit(of);
                draft.vary.push(table);
                (Cell::Vary(draft.vary.len() - 1), true)
            }
            what => {
                let path = what.trim_start_matches("vary ");
                let tolerance = of.tolerance(path);
                // Beside a curve, a few values give a family; beside samples, it scatters too.
                let text = match of.input(path) {
                    Some(input) if is_curve => Way::List.line(input, ""),
                    Some(input) if self.kind == Kind::File && !of.draft.vary.is_empty() => Way::Uniform
                        .line(input, if tolerance.is_empty() { input.step_text() } else { tolerance }),
                    _ => String::new(),
                };
                let draft = self.edit(of);
                draft.vary.push(Varied::new(path, text));
                (Cell::Vary(draft.vary.len() - 1), false)
            }
        }
    }

    /// The inputs that have a distribution, by their paths.
    fn drawn(&self, of: &Subject<'_>) -> Vec<String> {
        let all = of.draft.vary.iter().zip(&of.usual);
        all.filter(|(varied, usual)| varied.is_drawn(usual))
            .filter_map(|(varied, _)| varied.input.clone())
            .collect()
    }
}
