//! Words of a page: orders, and results.

use dalembert_core::{Answer, Locale, Refusal, SolveError, Text};
use dalembert_units::{Style, write_quantity};

use super::{FieldPage, entry, is_met, lines};
use crate::{problem::Problem, solver::JobFailure};

/// Significant digits of what is weighed and measured in the field.
const DIGITS: u8 = 3;

/// Tone of a remark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Tone {
    /// For reading.
    Plain,
    /// The thing to do.
    Order,
    /// More about the thing to do.
    Detail,
    /// Good news.
    Good,
    /// Doubtful.
    Warning,
    /// Nothing goes on like this.
    Wrong,
}

/// The name of a page; the short one for the line of steps.
pub fn title(page: FieldPage, is_short: bool) -> Text {
    let (long, short, number) = match page {
        FieldPage::Job => ("The job", "Job", 0),
        FieldPage::Instrument => ("Instrument and angles", "Setup", 0),
        FieldPage::Initial => ("Run 0: as found", "Run 0", 0),
        FieldPage::Trial(run) => ("Trial run, plane {n}", "Trial {n}", run),
        FieldPage::Correction(0) => ("Correction", "Mount", 0),
        FieldPage::Correction(trim) => ("Trim correction {n}", "Trim {n}", trim),
        FieldPage::Check(run) => ("Check run {n}", "Check {n}", run),
        FieldPage::Report => ("Report", "Report", 0),
    };
    Text::new(if is_short { short } else { long }).with("n", number)
}

/// Orders of a page.
pub(crate) fn task(problem: &Problem, page: FieldPage, locale: &Locale) -> Text {
    match page {
        FieldPage::Job => "Answer line by line. Enter takes a line, a digit chooses an option.".into(),
        FieldPage::Instrument => {
            "These must be the conventions of your instrument and your scale: a wrong one puts the weight at a mirrored angle."
                .into()
        }
        FieldPage::Initial => {
            Text::new("No trial weight on the rotor. Run at {speed}, wait until the readings are steady.")
                .with("speed", speed(problem, locale))
        }
        FieldPage::Trial(run) => {
            let stays = entry::chosen(problem, "measured.influence.runs.after") == Some(1);
            let said = match (run, stays) {
                (1, _) => "Stop and lock the machine. Mount a trial weight in plane 1, safely fastened; run at {speed}.",
                (_, false) => "Stop and lock. Take the trial weight off plane {before}, mount one in plane {n}; run at {speed}.",
                (_, true) => "Stop and lock. Leave the weight in plane {before}, mount one in plane {n}; run at {speed}.",
            };
            Text::new(said).with("n", run).with("before", run.saturating_sub(1)).with("speed", speed(problem, locale))
        }
        FieldPage::Correction(0) if entry::answer(problem, "trim[1]").is_some() => {
            mount("Stop and lock. Leave the trial weights on and add, at radius {radius}:", problem, locale)
        }
        FieldPage::Correction(0) => {
            mount("Stop and lock. Take every trial weight off and mount, at radius {radius}:", problem, locale)
        }
        FieldPage::Correction(_) => {
            mount("Stop and lock. Leave everything on the rotor and add, at radius {radius}:", problem, locale)
        }
        FieldPage::Check(_) => {
            Text::new("Run at {speed} with the weights mounted.").with("speed", speed(problem, locale))
        }
        FieldPage::Report => "The job is done. The report has every reading, weight and step of the working.".into(),
    }
}

/// Results, as far as they belong to a page.
pub(crate) fn remarks(problem: &Problem, page: FieldPage, locale: &Locale) -> Vec<(Tone, Text)> {
    let mut all = match page {
        FieldPage::Trial(run) => trial(problem, run, locale),
        FieldPage::Correction(trims) => {
            mounted(problem, trims).iter().flat_map(|mass| mass.orders(problem, locale)).collect()
        }
        FieldPage::Check(run) => checked(problem, run, locale),
        FieldPage::Report => {
            let last = entry::rows(problem, "measured.checks");
            checked(problem, last, locale)
        }
        FieldPage::Job | FieldPage::Instrument | FieldPage::Initial => Vec::new(),
    };
    all.extend(hindrance(problem));
    if let (FieldPage::Trial(_) | FieldPage::Correction(0), false) = (page, problem.is_stale()) {
        let warnings = problem.found.solution.iter().flat_map(|solution| &solution.warnings);
        all.extend(warnings.map(|warning| (Tone::Warning, warning.clone())));
    }
    all
}

/// The reason for which there is no solution of complete inputs.
fn hindrance(problem: &Problem) -> Option<(Tone, Text)> {
    match &problem.found.failure {
        Some(JobFailure::Unsolved(SolveError::Refused(Refusal::NoAnswer(why)))) => {
            Some((Tone::Wrong, why.clone()))
        }
        Some(JobFailure::Unsolved(SolveError::Fields(errors))) => {
            errors.first().map(|error| (Tone::Wrong, error.why.clone()))
        }
        Some(JobFailure::Fault(_)) => {
            Some((Tone::Wrong, "this analysis failed (internal error); your inputs are kept".into()))
        }
        None | Some(JobFailure::Unsolved(SolveError::Refused(Refusal::Stopped))) => None,
    }
}

/// The trial weight to take, or what the one that was taken did.
fn trial(problem: &Problem, run: usize, locale: &Locale) -> Vec<(Tone, Text)> {
    if let Some(effect) = entry::answer(problem, &format!("trial_effect[{run}]")) {
        let said = Text::new("The trial weight changed the vibration by {change}.");
        let percent = format!("{:.0} %", 100.0 * effect.si().unwrap_or_default());
        return vec![(Tone::Good, said.with("change", percent))];
    }
    let Some(careful) = entry::answer(problem, "trial_mass") else { return Vec::new() };
    let radius = entry::in_style(entry::text_at(problem, "radius"), locale.style);
    let clear = entry::answer(problem, "clear_trial_mass").filter(|clear| clear.si() > careful.si());
    let said = match clear {
        Some(_) => Text::new(
            "Proposed: {careful} to {clear} at {radius}. The first is careful (a force of 10 % of the weight on the plane), the second shows clearly (five times the permissible unbalance).",
        ),
        None => Text::new("Proposed: {careful} at {radius} (a force of 10 % of the weight on the plane)."),
    };
    let said = said.with("careful", quantity(careful, locale)).with("radius", radius);
    let clear = clear.map_or_else(String::new, |clear| quantity(clear, locale));
    vec![(Tone::Plain, said.with("clear", clear))]
}

/// A mass to be mounted.
pub(crate) struct Mounted<'p> {
    /// Plane, counted from 1.
    pub(crate) plane: usize,
    /// Mass.
    pub(crate) mass: &'p Answer,
    /// Angle on the scale of the weights.
    pub(crate) angle: &'p Answer,
}

/// The masses that a correction page asks for; none while they are not known, or not any more.
pub(crate) fn mounted(problem: &Problem, trims: usize) -> Vec<Mounted<'_>> {
    let is_newest = trims == entry::rows(problem, "measured.checks");
    let names = match trims {
        0 if entry::answer(problem, "trim[1]").is_some() => ("trim", "trim_angle"),
        0 => ("correction", "correction_angle"),
        _ if is_newest => ("trim_correction", "trim_correction_angle"),
        _ => return Vec::new(),
    };
    let find = |name: &str, plane: usize| entry::answer(problem, &format!("{name}[{plane}]"));
    (1..)
        .map_while(|plane| Some(Mounted { plane, mass: find(names.0, plane)?, angle: find(names.1, plane)? }))
        .collect()
}

impl Mounted<'_> {
    /// Orders about it.
    fn orders(&self, problem: &Problem, locale: &Locale) -> Vec<(Tone, Text)> {
        let plane = self.plane;
        let part = |name: &str| entry::answer(problem, &format!("{name}[{plane}]"));
        let is_next = entry::rows(problem, "measured.checks") == 0
            || self.mass.name.is(&format!("trim_correction[{plane}]"));
        let split =
            [part("position"), part("position_mass"), part("next_position"), part("next_position_mass")];
        let whole = |said: &'static str| {
            Text::new(said)
                .with("plane", plane)
                .with("mass", quantity(self.mass, locale))
                .with("angle", degrees(self.angle, locale))
        };
        match split {
            [Some(first), Some(one), Some(second), Some(two)] if is_next => {
                let parts = Text::new("Plane {plane}: {one} at position {first}, {two} at position {second}")
                    .with("plane", plane)
                    .with("first", first.si().unwrap_or_default())
                    .with("one", quantity(one, locale))
                    .with("second", second.si().unwrap_or_default())
                    .with("two", quantity(two, locale));
                vec![(Tone::Order, parts), (Tone::Detail, whole("together {mass} at {angle}"))]
            }
            _ => vec![(Tone::Order, whole("Plane {plane}: {mass} at {angle}"))],
        }
    }
}

/// Results of a check run: each reading beside that of the initial run, and whether it is good enough.
fn checked(problem: &Problem, run: usize, locale: &Locale) -> Vec<(Tone, Text)> {
    let checks = entry::rows(problem, "measured.checks");
    let mut all = Vec::new();
    match is_met(problem).filter(|_| run == checks) {
        Some(true) => all.push((Tone::Good, "Requirement met: the rotor is balanced.".into())),
        Some(false) => {
            all.push((Tone::Warning, "Requirement not met yet: go on with the trim.".into()));
        }
        None => {}
    }
    for sensor in 1..=entry::sensors(problem).unwrap_or(0) {
        let before = entry::text_at(problem, &format!("measured.first[{sensor}].amplitude"));
        let now = entry::text_at(problem, &lines::check(run, sensor).0);
        if !now.is_empty() {
            let said = Text::new("Sensor {n}: {before} in run 0, {now} now").with("n", sensor);
            let said = said
                .with("before", entry::in_style(before, locale.style))
                .with("now", entry::in_style(now, locale.style));
            all.push((Tone::Plain, said));
        }
    }
    if run != checks {
        return all;
    }
    for plane in 1..=entry::planes(problem).unwrap_or(0) {
        let residual = entry::answer(problem, &format!("residual_unbalance[{plane}]"));
        let permissible = entry::answer(problem, "permissible");
        if let (Some(residual), Some(permissible)) = (residual, permissible) {
            let said = Text::new("Plane {n}: residual {residual}, permissible {permissible}");
            let said = said.with("n", plane).with("residual", quantity(residual, locale));
            all.push((Tone::Plain, said.with("permissible", quantity(permissible, locale))));
        }
    }
    all
}

fn mount(said: &'static str, problem: &Problem, locale: &Locale) -> Text {
    Text::new(said).with("radius", entry::in_style(entry::text_at(problem, "radius"), locale.style))
}

fn speed(problem: &Problem, locale: &Locale) -> String {
    match entry::text_at(problem, "rotor.speed") {
        "" => Text::from("running speed").render(locale),
        text => entry::in_style(text, locale.style),
    }
}

fn digits(locale: &Locale) -> Style {
    Style { digits: DIGITS, ..locale.style }
}

/// An answer with the digits of the field.
pub(crate) fn quantity(answer: &Answer, locale: &Locale) -> String {
    write_quantity(answer.si().unwrap_or_default(), &answer.unit, digits(locale))
}

/// An angle in whole degrees.
pub(crate) fn degrees(answer: &Answer, locale: &Locale) -> String {
    let degrees = answer.si().unwrap_or_default().to_degrees().round().rem_euclid(360.0);
    write_quantity(degrees.to_radians(), &answer.unit, digits(locale))
}
