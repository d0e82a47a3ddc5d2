//! The lines of a page: what is asked, and which inputs of the problem answer it.

use dalembert_core::Text;

use super::{
    FieldPage, entry, is_met,
    line::{Choice, FieldLine, Go, LineKind},
};
use crate::problem::Problem;

fn line(label: impl Into<Text>, help: &'static str, kind: LineKind) -> FieldLine {
    let required = !matches!(kind, LineKind::Go(_) | LineKind::Title);
    FieldLine { label: label.into(), help: help.into(), kind, required }
}

fn choice(label: &'static str, help: &'static str, of: Choice, options: &[&'static str]) -> FieldLine {
    line(label, help, LineKind::Choice(of, options.iter().map(|option| Text::from(*option)).collect()))
}

fn value(label: impl Into<Text>, help: &'static str, path: impl Into<String>, unit: &str) -> FieldLine {
    line(label, help, LineKind::Value(path.into(), unit.to_owned()))
}

fn go(label: &'static str, to: Go) -> FieldLine {
    line(label, "", LineKind::Go(to))
}

/// The lines of a page.
pub fn lines(problem: &Problem, page: FieldPage) -> Vec<FieldLine> {
    match page {
        FieldPage::Job => job(problem),
        FieldPage::Instrument => instrument(problem),
        FieldPage::Initial => {
            let mut lines = readings(problem, initial);
            lines.push(go("Next: trial weight", Go::Next));
            lines
        }
        FieldPage::Trial(run) => trial(problem, run),
        FieldPage::Correction(_) => {
            let positions = value(
                "Holes or blades",
                "If any, how many: number 1 at 0°, the others as angles grow; the weight is split between two",
                "positions.count",
                "",
            );
            vec![positions.optional(), go("Next: check run", Go::Next)]
        }
        FieldPage::Check(run) => {
            let mut lines = readings(problem, |sensor| check(run, sensor));
            match is_met(problem) {
                Some(false) => {
                    lines.extend([go("Trim correction", Go::Next), go("Leave it: report", Go::End)]);
                }
                _ => lines.push(go("Next: report", Go::End)),
            }
            lines
        }
        FieldPage::Report => {
            vec![
                go("Write the report to a file", Go::Report),
                go("Open the job in the workbench", Go::Workbench),
            ]
        }
    }
}

fn job(problem: &Problem) -> Vec<FieldLine> {
    let mut lines = vec![
        line("Rotor", "A name for the job, such as fan 3", LineKind::Title),
        choice(
            "Correction planes",
            "One for a narrow disc, two for a rotor longer than about half its diameter",
            Choice::Planes,
            &["one", "two"],
        ),
    ];
    if entry::planes(problem).unwrap_or(1) < 2 {
        lines.push(choice(
            "Sensors",
            "One at each bearing is usual; one is enough for one plane",
            Choice::Sensors,
            &["one", "two"],
        ));
    }
    lines.extend([
        choice(
            "Readings in",
            "The unit of the instrument at the speed of rotation; peak, peak to peak or rms, but always the same",
            Choice::ReadingUnit,
            &["mm/s", "µm", "m/s²", "mil", "in/s", "divisions"],
        ),
        choice("Weights in", "", Choice::WeightUnit, &["g", "oz"]),
        value("Speed of the runs", "The same for all runs, in rpm", "rotor.speed", "rpm"),
        value("Mass of the rotor", "In kg; as well as it is known", "rotor.mass", "kg"),
        value("Radius of the weights", "From the axis to where the weights are mounted, in mm", "radius", "mm"),
        choice(
            "Requirement",
            "What the contract or the standard of the machine says",
            Choice::OneOf("rotor.requirement"),
            &["grade G (ISO 21940-11)", "limit of the vibration"],
        ),
    ]);
    match entry::chosen(problem, "rotor.requirement") {
        Some(0) => lines.push(value(
            "Grade G",
            "G 6.3: fans, pumps, general machinery. G 2.5: turbines, machine tools. G 16: crushers, farm machinery",
            "rotor.requirement.grade.grade",
            "mm/s",
        )),
        Some(_) => lines.push(value(
            "Limit",
            "For every sensor, at the speed of rotation, in the unit of the readings",
            "rotor.requirement.vibration.limit",
            &entry::reading_unit(problem).unwrap_or_default(),
        )),
        None => {}
    }
    lines.push(go("Next: instrument", Go::Next));
    lines
}

fn instrument(problem: &Problem) -> Vec<FieldLine> {
    let mut lines = vec![
        choice(
            "Rotor turns",
            "As seen from the drive end: stand at motor or pulley and look at the rotor",
            Choice::OneOf("view.rotation"),
            &["clockwise", "counter-clockwise"],
        ),
        choice(
            "You stand at the",
            "The end at which you stand to mount the weights; the pictures show the rotor from there",
            Choice::OneOf("view.end"),
            &["drive end", "opposite end"],
        ),
        choice(
            "Weight angles",
            "The way you count the angles of weights from 0°; 0° is the mark if you have no other scale",
            Choice::OneOf("angles"),
            &["with rotation", "against rotation"],
        ),
        choice(
            "Phase",
            "Move a weight 30° with the rotation: lead reads 30° more, lag 30° less; or see the manual",
            Choice::OneOf("phase"),
            &["lead, reads more", "lag, reads less"],
        ),
        value(
            "Mark at",
            "The reflective tape or keyway on your scale of angles: 0° if the scale begins there",
            "view.mark",
            "deg",
        ),
    ];
    for sensor in 1..=entry::sensors(problem).unwrap_or(0) {
        lines.push(value(
            Text::new("Sensor {n} at").with("n", sensor),
            "From pickup to sensor with the rotation; only shows the high spots, the correction does not need it",
            format!("view.sensors[{sensor}].angle"),
            "deg",
        ));
    }
    lines.push(go("Next: run 0", Go::Next));
    lines
}

/// The lines of a reading of each sensor, from the paths of amplitude and phase.
fn readings(problem: &Problem, paths: impl Fn(usize) -> (String, String)) -> Vec<FieldLine> {
    let unit = entry::reading_unit(problem).unwrap_or_default();
    let of = |sensor| {
        let (amplitude, phase) = paths(sensor);
        line(
            Text::new("Sensor {n}").with("n", sensor),
            "Amplitude and phase, such as 4.2 @ 120",
            LineKind::Pair(amplitude, phase, unit.clone()),
        )
    };
    (1..=entry::sensors(problem).unwrap_or(1)).map(of).collect()
}

fn trial(problem: &Problem, run: usize) -> Vec<FieldLine> {
    let row = format!("{}[{run}]", entry::RUNS);
    let weight = line(
        "Trial weight",
        "Mass and angle as they are, such as 20 @ 0",
        LineKind::Pair(format!("{row}.mass"), format!("{row}.angle"), entry::weight_unit(problem)),
    );
    let mut lines = vec![weight];
    lines.extend(readings(problem, |sensor| {
        (format!("{row}.readings[{sensor}].amplitude"), format!("{row}.readings[{sensor}].phase"))
    }));
    if run == 1 && entry::rows(problem, entry::RUNS) > 0 {
        lines.push(choice(
            "After the run",
            "Taken off after its run; or left on, also in all later runs and under the correction",
            Choice::OneOf("measured.influence.runs.after"),
            &["taken off", "left on"],
        ));
    }
    let last = run >= entry::trials(problem);
    lines.push(go(if last { "Next: correction" } else { "Next: trial run in the other plane" }, Go::Next));
    lines
}

/// The paths of a reading of the initial run.
fn initial(sensor: usize) -> (String, String) {
    let row = format!("measured.first[{sensor}]");
    (format!("{row}.amplitude"), format!("{row}.phase"))
}

/// The paths of a reading of a check run.
pub(super) fn check(run: usize, sensor: usize) -> (String, String) {
    let row = format!("measured.checks[{run}].readings[{sensor}]");
    (format!("{row}.amplitude"), format!("{row}.phase"))
}
