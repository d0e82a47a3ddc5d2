//! Causes of wrong answers: those of the course's own errors, and of a part of the corpus of student errors.

use std::{
    collections::{BTreeMap, BTreeSet},
    f64::consts::{FRAC_1_SQRT_2, PI},
    path::Path,
};

use dalembert_core::{
    Answer, Entry, Record, Solution, Stop, cases,
    check::{self, Change, Verdict},
    find, registry,
    vary::{self, VariedInput},
};
use dalembert_testkit::{SolvedCase, for_each_problem};
use dalembert_tests::errors::{corpus, tally};
use dalembert_units::{Style, unit, write_quantity};

/// Analysis, case counted from 1, answer, what was written, and words of the cause that comes first.
const OF_THE_COURSE: [(&str, usize, &str, &str, &str); 18] = [
    ("virtual-work/virtual-power", 1, "torque", "82350 N*m", "−45 000 W instead of the −450 000 W"),
    ("virtual-work/virtual-power", 1, "torque", "102600 N*m", "sign error in the term I_G₁ α₁"),
    ("virtual-work/virtual-power", 1, "torque", "82750 N*m", "computing P_Fi₁"),
    ("vibration/rotating-unbalance", 1, "amplitude", "1.743 mm", "assumed ζ = 0.707"),
    ("vibration/rotating-unbalance", 1, "damping_ratio", "0.0616", "light damping"),
    ("vibration/rotating-unbalance", 1, "damping_ratio", "0.707", "assumes 0.707"),
    ("vibration/rotating-unbalance", 1, "worst_speed", "1014.4 rpm", "another answer: Natural frequency"),
    (
        "vibration/rotating-unbalance",
        1,
        "stiffness",
        "7222.2 kN/m",
        "Simply supported beam in place of Cantilever",
    ),
    (
        "vibration/rotating-unbalance",
        1,
        "amplitude",
        "20.3 mm",
        "given value: Maximum steady-state amplitude",
    ),
    ("vibration/rotating-unbalance", 1, "transmitted_force", "8782 N", "the term (c ω)² omitted"),
    (
        "vibration/shaft-clearance",
        1,
        "diameters",
        "≥ 0.44 m",
        "the damping ratio in place of the coefficient",
    ),
    ("vibration/shaft-clearance", 1, "diameters", "440 mm", "the damping ratio in place of the coefficient"),
    ("vibration/shaft-clearance", 3, "diameters", "0.44 m", "one limit or one part of the set only"),
    ("vibration/shaft-clearance", 3, "diameters", ">= 440 mm", "one limit or one part of the set only"),
    ("vibration/beam-and-springs", 1, "mass", "910.17 kg", "incorrectly copied stiffness"),
    ("vibration/beam-and-springs", 1, "damping", "350660 N*s/m", "The decay ratio 15:1 was not used"),
    ("vibration/beam-and-springs", 1, "transmissibility", "1.001", "Follows from ζ = 12"),
    ("balancing/two-plane", 1, "mass_a", "5.531 kg", "measured from the other end of: Position of plane B"),
];

/// An analysis and the inputs of one of its cases, counted from 1.
fn published(id: &str, case: usize) -> (&'static Entry, Record) {
    let entry = find(id).expect("there is such an analysis");
    let cases = cases::cases(entry).expect("the cases can be read");
    (entry, cases[case - 1].record(entry).expect("the case can be read"))
}

fn solved(entry: &Entry, record: &Record) -> Solution {
    entry.solve(record, &Stop::new()).expect("the problem has an answer")
}

#[test]
fn the_errors_of_the_course_have_their_cause_first() {
    for (id, case, answer, typed, words) in OF_THE_COURSE {
        let (entry, record) = published(id, case);
        let solution = solved(entry, &record);
        let typed = [(answer.to_owned(), typed.to_owned())];
        let causes = check::causes(entry, &record, &solution, &typed, &Stop::new(), None);
        let first = causes.first().and_then(|(_, causes)| causes.first());
        let first = first.map_or_else(String::new, |cause| cause.text(&solution).english());
        assert!(first.contains(words), "{id} {typed:?}: {first}");
    }
}

/// The numbers among the inputs of a problem, by their paths, in SI.
struct Inputs<'a>(&'a [VariedInput]);

impl Inputs<'_> {
    fn of(&self, path: &str) -> f64 {
        let input = self.0.iter().find(|input| input.path == path);
        input.unwrap_or_else(|| panic!("there is no input {path}")).si
    }
}

const CRANK: &str = "virtual-work/virtual-power";
const FAN: &str = "vibration/rotating-unbalance";
const TURBINE: &str = "vibration/shaft-clearance";
const BEAM: &str = "vibration/beam-and-springs";
const ROTOR: &str = "balancing/two-plane";

/// Torque of example 1 with the powers of the inertia force and of the inertia couple of the rod so many times as large.
fn torque(of: &Inputs<'_>, force: f64, couple: f64) -> f64 {
    let dot = |a: &str, b: &str| {
        let axes = ["x", "y"].iter();
        axes.map(|axis| of.of(&format!("{a}.{axis}")) * of.of(&format!("{b}.{axis}"))).sum::<f64>()
    };
    let (rod, slider) = ("bodies[1]", "bodies[2]");
    let weight = |body: &str| of.of(&format!("{body}.mass")) * dot("gravity", &format!("{body}.velocity"));
    let inertia = |body: &str| {
        -of.of(&format!("{body}.mass")) * dot(&format!("{body}.acceleration"), &format!("{body}.velocity"))
    };
    let turning = -of.of("bodies[1].inertia")
        * of.of("bodies[1].angular_acceleration")
        * of.of("bodies[1].angular_velocity");
    let load = dot("forces[1].force", "bodies[2].velocity");
    let power =
        load + weight(rod) + weight(slider) + inertia(slider) + force * inertia(rod) + couple * turning;
    -power / of.of("unknown.driving-torque.link.turning.speed")
}

fn inertia_power_of_rod(of: &Inputs<'_>) -> f64 {
    let along = |axis: &str| {
        of.of(&format!("bodies[1].acceleration.{axis}")) * of.of(&format!("bodies[1].velocity.{axis}"))
    };
    -of.of("bodies[1].mass") * (along("x") + along("y"))
}

/// Stiffness of the fan's beam with a coefficient of a formula: 3 at the end of a cantilever.
fn stiffness_of_fan(of: &Inputs<'_>, coefficient: f64) -> f64 {
    let beam = |name: &str| of.of(&format!("support.cantilever.{name}"));
    coefficient * beam("young") * beam("section.given.second_moment") / beam("length").powi(3)
}

fn natural_of_fan(of: &Inputs<'_>) -> f64 {
    (stiffness_of_fan(of, 3.0) / of.of("mass")).sqrt()
}

/// Amplitude of the fan with a damping ratio.
fn amplitude_of_fan(of: &Inputs<'_>, zeta: f64) -> f64 {
    let r = of.of("speed") / natural_of_fan(of);
    of.of("unbalance") / of.of("mass") * r * r / (1.0 - r * r).hypot(2.0 * zeta * r)
}

/// The diameter from which on a shaft runs below its critical speed, with a coefficient of damping that does nothing.
fn stiff_diameter(of: &Inputs<'_>) -> f64 {
    let sought = |name: &str| of.of(&format!("sought.diameter.{name}"));
    let speed = sought("speeds.highest") * (1.0 + sought("speeds.margin"));
    let k = (of.of("mass") + sought("unbalance") / of.of("clearance")) * speed * speed;
    let second_moment = k * sought("shaft.length").powi(3) / (3.0 * sought("shaft.young"));
    (64.0 * second_moment / PI).powf(0.25)
}

fn stiffness_on_beam(of: &Inputs<'_>) -> f64 {
    let member = |name: &str| of.of(&format!("springs.series.members{name}"));
    let beam = |name: &str| member(&format!("[1].parallel.members[1].cantilever.{name}"));
    let cantilever = 3.0 * beam("young") * beam("section.given.second_moment") / beam("length").powi(3);
    let parallel = cantilever + member("[1].parallel.members[2].stiffness.stiffness");
    1.0 / (1.0 / parallel + 1.0 / member("[2].stiffness.stiffness"))
}

/// Correction of example 2 in plane A, with the second mass measured from plane B.
fn correction(of: &Inputs<'_>) -> [f64; 2] {
    let mut sum = [0.0; 2];
    let (a, b) = (of.of("plane_a"), of.of("plane_b"));
    for n in [1, 2] {
        let mass = |name: &str| of.of(&format!("masses[{n}].{name}"));
        let position = if n == 2 { b - mass("position") } else { mass("position") };
        let share = (b - position) / (b - a) * mass("mass") * mass("radius");
        sum[0] -= share * mass("angle").cos();
        sum[1] -= share * mass("angle").sin();
    }
    sum
}

/// Damping ratio that the printed solution of question 4 computes in place of using the decay: ω/ω_d = √(1 − 2ζ²), without
/// the sign of ζ².
fn ratio_without_decay(of: &Inputs<'_>) -> f64 {
    let ratio = of.of("excitation.frequency") / of.of("damped_frequency");
    ((ratio * ratio - 1.0).abs() / 2.0).sqrt()
}

/// Natural frequency that follows from the frequency of the free vibration and that ratio.
fn natural_without_decay(of: &Inputs<'_>) -> f64 {
    of.of("damped_frequency") / (1.0 - ratio_without_decay(of).powi(2)).sqrt()
}

/// Damping that follows from that ratio.
fn damping_without_decay(of: &Inputs<'_>) -> f64 {
    2.0 * ratio_without_decay(of) * stiffness_on_beam(of) / natural_without_decay(of)
}

/// Transmissibility that follows from that ratio.
fn transmissibility_without_decay(of: &Inputs<'_>) -> f64 {
    let r = of.of("excitation.frequency") / natural_without_decay(of);
    let damper = 2.0 * ratio_without_decay(of) * r;
    1.0_f64.hypot(damper) / (1.0 - r * r).hypot(damper)
}

/// Transmitted force of the fan by its spring alone.
fn spring_force_of_fan(of: &Inputs<'_>) -> f64 {
    let peak = of.of("mass") * of.of("damping.largest-amplitude.amplitude") / of.of("unbalance");
    let zeta = ((1.0 - (1.0 - peak.powi(-2)).sqrt()) / 2.0).sqrt();
    stiffness_of_fan(of, 3.0) * amplitude_of_fan(of, zeta)
}

fn light_damping_of_fan(of: &Inputs<'_>) -> f64 {
    of.of("unbalance") / (2.0 * of.of("mass") * of.of("damping.largest-amplitude.amplitude"))
}

fn mass_by_frequency_of_force(of: &Inputs<'_>) -> f64 {
    stiffness_on_beam(of) / of.of("excitation.frequency").powi(2)
}

fn correction_mass(of: &Inputs<'_>) -> f64 {
    let [x, y] = correction(of);
    x.hypot(y) / of.of("correction_a.radius.radius")
}

fn correction_angle(of: &Inputs<'_>) -> f64 {
    let [x, y] = correction(of);
    y.atan2(x).rem_euclid(2.0 * PI)
}

type Recipe = fn(&Inputs<'_>) -> f64;

/// Analysis, case, the answers that were written, each with a sign, its unit and how it was computed from the inputs, and words
/// of the cause of the first.
type Recomputed =
    (&'static str, usize, &'static [(&'static str, &'static str, &'static str, Recipe)], &'static str);

/// The errors of the course that can be made with any inputs.
#[rustfmt::skip]
const RECOMPUTED: [Recomputed; 18] = [
    (CRANK, 1, &[("torque", "", "N*m", |of| torque(of, 1.0, -1.0))], "sign error in the term I_G₁ α₁"),
    (CRANK, 1, &[("torque", "", "N*m", |of| torque(of, 0.1, 1.0))], "computing P_Fi₁"),
    (CRANK, 1, &[("rod_inertia_force_power", "", "W", |of| inertia_power_of_rod(of) / 10.0)], "10 times too small"),
    (FAN, 1, &[("damping_ratio", "", "", light_damping_of_fan)], "light damping"),
    (FAN, 1, &[("damping_ratio", "", "", |_| FRAC_1_SQRT_2)], "1/√2 assumed"),
    (FAN, 1, &[("amplitude", "", "mm", |of| amplitude_of_fan(of, FRAC_1_SQRT_2))], "1/√2 assumed"),
    (FAN, 1, &[("worst_speed", "", "rpm", natural_of_fan)], "another answer: Natural frequency"),
    (FAN, 1, &[("stiffness", "", "kN/m", |of| stiffness_of_fan(of, 48.0))], "Simply supported beam in place of Cantilever"),
    (FAN, 1, &[("amplitude", "", "mm", |of| of.of("damping.largest-amplitude.amplitude"))], "given value: Maximum steady-state amplitude"),
    (FAN, 1, &[("transmitted_force", "", "N", spring_force_of_fan)], "the term (c ω)² omitted"),
    (TURBINE, 1, &[("diameters", ">= ", "m", stiff_diameter)], "Damping coefficient given in place of Damping ratio given"),
    (TURBINE, 3, &[("diameters", "", "m", stiff_diameter)], "one limit or one part of the set only"),
    (TURBINE, 3, &[("diameters", "d >= ", "mm", stiff_diameter)], "one limit or one part of the set only"),
    (BEAM, 1, &[("mass", "", "kg", mass_by_frequency_of_force)], "the frequency of the force used as the natural frequency"),
    (BEAM, 1, &[("damping", "", "N*s/m", damping_without_decay), ("damping_ratio", "", "", ratio_without_decay)], "consistent with your earlier answer"),
    (BEAM, 1, &[("transmissibility", "", "", transmissibility_without_decay), ("damping_ratio", "", "", ratio_without_decay)], "consistent with your earlier answer"),
    (ROTOR, 1, &[("mass_a", "", "kg", correction_mass)], "measured from the other end of: Position of plane B"),
    (ROTOR, 1, &[("angle_a", "", "deg", correction_angle)], "measured from the other end of: Position of plane B"),
];

/// First cause of an error, with inputs so many times as large.
fn first_cause((id, case, written, _): &Recomputed, factor: &dyn Fn(usize) -> f64) -> String {
    let (entry, printed) = published(id, *case);
    let mut record = printed.clone();
    for (place, input) in vary::inputs(&printed).iter().enumerate() {
        record = vary::changed(&record, &input.path, factor(place) * input.si).expect("the input varies");
    }
    let solution = solved(entry, &record);
    let inputs = vary::inputs(&record);
    let text = |(answer, sign, of, recipe): &(&str, &str, &str, Recipe)| {
        let style = Style { digits: 6, ..Style::default() };
        let number = write_quantity(recipe(&Inputs(&inputs)), &unit(of).expect("a unit"), style);
        ((*answer).to_owned(), format!("{sign}{number}"))
    };
    let typed: Vec<_> = written.iter().map(text).collect();
    let causes = check::causes(entry, &record, &solution, &typed, &Stop::new(), None);
    let of_first =
        causes.iter().find(|(answer, _)| answer == written[0].0).and_then(|(_, causes)| causes.first());
    format!("{id} {typed:?}: {}", of_first.map_or_else(String::new, |cause| cause.text(&solution).english()))
}

#[test]
fn the_errors_of_the_course_have_their_cause_first_with_other_inputs() {
    let mut missed = Vec::new();
    for error in &RECOMPUTED {
        for (all, factor) in
            [("larger", &(|_| 1.07) as &dyn Fn(usize) -> f64), ("mixed", &|place| [1.07, 0.93][place % 2])]
        {
            let found = first_cause(error, factor);
            if !found.contains(error.3) {
                missed.push(format!("{all}: {found}, not {}", error.3));
            }
        }
    }
    assert!(missed.is_empty(), "{}", missed.join("\n"));
}

/// Causes of an answer to the first case of an analysis or another one, in words, each reading of a number on its own.
fn readings(id: &str, case: usize, answer: &str, typed: &str) -> Vec<Vec<String>> {
    let (entry, record) = published(id, case);
    let solution = solved(entry, &record);
    let typed = [(answer.to_owned(), typed.to_owned())];
    let causes = check::causes(entry, &record, &solution, &typed, &Stop::new(), None);
    let of_cause = |cause: &check::Cause| {
        let words = |mistakes: &Vec<check::Mistake>| {
            mistakes.iter().map(|one| one.text(&solution).english()).collect::<Vec<_>>().join(", and ")
        };
        cause.all_mistakes().map(words).collect()
    };
    causes.iter().flat_map(|(_, causes)| causes.iter().map(of_cause)).collect()
}

#[test]
fn no_cause_is_listed_twice() {
    for (id, answer, typed) in [
        (FAN, "natural_frequency", "11285 rpm"),
        (ROTOR, "angle_a", "76.82 deg"),
        (FAN, "damping", "1048.6 N*s/m"),
        (FAN, "phase", "-76.9 deg"),
        (FAN, "stiffness", "451390 N/mm"),
        (FAN, "amplitude", "20.022 mm"),
        (FAN, "transmitted_force", "106.2 N"),
        (CRANK, "torque", "185000 N*m"),
    ] {
        let found = readings(id, 1, answer, typed);
        let mut all: Vec<&String> = found.iter().flatten().collect();
        all.sort_unstable();
        let count = all.len();
        all.dedup();
        assert_eq!(all.len(), count, "{id} {answer} = {typed}: {found:#?}");
        // The finished answer and the step that holds it are one.
        let is_sign = |words: &&&String| {
            words.starts_with("computing") && words.ends_with(": sign error") || **words == "sign error"
        };
        assert!(all.iter().filter(is_sign).count() <= 1, "{id} {answer} = {typed}: {found:#?}");
    }
    let found = readings(FAN, 1, "amplitude", "20.022 mm");
    // Both give one number: r² / √((1 − r²)² + …) with 1/r for r is the fraction without r².
    for words in ["computing r (Frequency ratio): inverted", "the factor r² omitted"] {
        assert!(found[..2].iter().flatten().any(|reading| reading.contains(words)), "{found:#?}");
    }
}

#[test]
fn an_angle_without_its_quadrant_is_named_before_another_axis() {
    for (typed, words) in [
        ("-10.73 deg", "arctangent taken without regard to the quadrant"),
        ("10.73 deg", "acute angle taken, without regard to the quadrant"),
    ] {
        let found = readings(FAN, 6, "phase", typed);
        assert!(found.first().is_some_and(|first| first[0].contains(words)), "{typed}: {found:#?}");
        let is_vague = |words: &String| words.contains("measured from another axis");
        assert!(!found.iter().flatten().any(is_vague), "{typed}: {found:#?}");
    }
}

#[test]
fn a_set_is_read_with_the_symbol_of_its_quantity() {
    let (entry, record) = published(TURBINE, 3);
    let solution = solved(entry, &record);
    let answer = solution.answer("diameters").unwrap();
    for (typed, verdict) in [
        ("d <= 113.4 mm or d >= 439.9 mm", Verdict::Right),
        ("<= 113.4 mm or >= 439.9 mm", Verdict::Right),
        ("diameter ≤ 113.4 mm or 439.9 mm <= diameter", Verdict::Right),
        ("d <= 113.4 mm or d >= 449.9 mm", Verdict::Wrong),
        ("d >= 113.4 mm or d >= 439.9 mm", Verdict::Wrong),
        ("113.4 mm <= d <= 439.9 mm", Verdict::Wrong),
        ("d < 113 mm", Verdict::Wrong),
    ] {
        assert_eq!(check::compare(answer, typed), verdict, "{typed}");
    }
    for part in ["d < 113 mm", "113.4 mm >= d", "d >= 440 mm"] {
        let found = readings(TURBINE, 3, "diameters", part);
        assert!(found[0][0].contains("one limit or one part of the set only"), "{part}: {found:#?}");
    }
}

#[test]
fn every_error_that_is_declared_gives_a_wrong_number_in_some_case() {
    let mut declared: BTreeMap<String, bool> = BTreeMap::new();
    for_each_problem(registry(), |SolvedCase { solution, .. }| {
        for error in &solution.common_errors {
            declared.entry(error.what.english()).or_default();
        }
        for answer in &solution.answers {
            for (si, mistake) in check::declared_errors(solution, &answer.name.to_string()) {
                let Change::Common(what) = &mistake.change else { unreachable!("{mistake:?}") };
                *declared.entry(what.english()).or_default() |= is_wrong(answer, si);
            }
        }
    });
    let never: Vec<&String> =
        declared.iter().filter(|(_, is_wrong)| !**is_wrong).map(|(what, _)| what).collect();
    assert!(never.is_empty(), "{} of {}: {never:#?}", never.len(), declared.len());
    assert!(declared.len() > 500, "{} errors are declared", declared.len());
}

/// A number as it is typed.
fn typed(si: f64, answer: &Answer) -> String {
    write_quantity(si, &answer.unit, Style { digits: 6, ..Style::default() })
}

/// True for another number than the right one, and than the rounding of what cancels.
fn is_wrong(answer: &Answer, si: f64) -> bool {
    si.is_finite() && si.abs() > answer.noise && check::compare(answer, &typed(si, answer)) == Verdict::Wrong
}

#[test]
fn an_error_that_is_declared_is_listed_for_its_number() {
    let (mut missed, mut tried) = (Vec::new(), BTreeSet::new());
    // Each search takes its time: those of every third analysis.
    let some: Vec<_> = registry().iter().copied().step_by(3).collect();
    for_each_problem(&some, |SolvedCase { name, entry, record, solution }| {
        if tried.contains(entry.about.id) {
            return;
        }
        let of = |answer: &Answer| {
            let declared = check::declared_errors(solution, &answer.name.to_string());
            let wrong = declared.into_iter().find(|(si, _)| is_wrong(answer, *si));
            wrong.map(|(si, mistake)| (answer.name.to_string(), typed(si, answer), mistake))
        };
        let Some((answer, typed, mistake)) = solution.answers.iter().find_map(of) else { return };
        tried.insert(entry.about.id);
        let words = mistake.text(solution).english();
        let wrong = [(answer, typed)];
        let found = check::causes(entry, record, solution, &wrong, &Stop::new(), None);
        let mut causes = found.iter().flat_map(|(_, causes)| causes);
        if !causes.any(|cause| cause.text(solution).english().contains(&words)) {
            missed.push(format!("{name}: {wrong:?} is no longer {words:?}"));
        }
    });
    // More causes than are listed may give one number.
    assert!(20 * missed.len() <= tried.len(), "{} of {}: {missed:#?}", missed.len(), tried.len());
    assert!(tried.len() > 30, "{tried:?}");
}

#[test]
fn most_errors_of_the_corpus_have_their_cause_first() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/errors");
    let all = corpus(&folder);
    let errors: usize = all.iter().map(|problem| problem.errors.len()).sum();
    assert!(errors > 800, "{errors}");
    let sample: Vec<_> = all.into_iter().step_by(6).collect();
    let mut log = String::new();
    let [singles, _] = tally(&sample, 6, &|_| 1.0, &mut log);
    assert!(singles.made > 80, "{singles:?}");
    assert!(singles.right_share() > 65.0, "{singles:?}\n{log}");
}
