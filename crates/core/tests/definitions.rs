//! Definitions, formulas of inputs, and questions, on a small analysis.

use dalembert_core::{
    About, Analysis, AnswerValue, Draft, Entry, Inputs, Locale, Number, Refusal, Source, Stop, Text,
    Worksheet, cases, file, printer, register, vary,
};
use dalembert_numerics::Real;
use itertools::Itertools as _;
use nalgebra::Vector3;

/// A mass on a spring under a rotating unbalance.
#[derive(Clone, Debug, Inputs)]
pub struct Machine {
    /// Mass.
    #[input("m", "kg", positive)]
    pub mass: f64,
    /// Unbalance.
    #[input("m₀e", "kg*m", nonnegative)]
    pub unbalance: f64,
    /// Support.
    pub support: Support,
    /// Speed.
    #[input("ω", "rad/s", nonnegative)]
    pub speed: f64,
    /// Force.
    #[input("F", "N", default = "(0; 0; 0) N")]
    pub force: Vector3<f64>,
}

/// Support of the machine.
#[derive(Clone, Debug, Inputs)]
pub enum Support {
    /// Stiffness known
    Stiffness {
        /// Stiffness.
        #[input("k", "N/m", positive)]
        stiffness: f64,
    },
    /// Springs in parallel
    Springs {
        /// Springs.
        #[input(min = 1)]
        springs: Vec<Spring>,
    },
}

/// A spring.
#[derive(Clone, Debug, Inputs)]
pub struct Spring {
    /// Stiffness.
    #[input("k", "N/m", positive)]
    pub stiffness: f64,
}

static BOOK: Source = Source { short: "Book", full: "A book" };

register!(Machine);

impl Analysis for Machine {
    const ABOUT: About = About {
        id: "test/machine",
        title: "Machine",
        topic: "Tests",
        summary: "A machine.",
        main: &[],
        keywords: "",
        sources: &[&BOOK],
        cases: "",
    };

    fn solve<W: Worksheet>(&self, given: &MachineGiven<W>, sheet: W) -> Result<(), Refusal> {
        let stiffness = match &given.support {
            SupportGiven::Stiffness { stiffness } => *stiffness,
            SupportGiven::Springs { springs } => {
                let all = W::Num::sum(springs.iter().map(|spring| spring.stiffness));
                sheet.step("k", "N/m", all, "In parallel")
            }
        };
        let natural = sheet.step("ω_n", "rad/s", (stiffness / given.mass).sqrt(), "Natural frequency");
        let ratio = sheet.step("r", "1", given.speed / natural, "Frequency ratio");
        if ratio.value() == 1.0 {
            return Err(Refusal::because("resonance without damping"));
        }
        let size = given.unbalance / given.mass * ratio.powi(2) / (ratio.powi(2) - 1.0).abs();
        let amplitude = sheet.step("X", "mm", size, "Amplitude");
        sheet.answer("natural_frequency", "Natural frequency", natural);
        sheet.answer("amplitude", "Amplitude", amplitude);
        sheet.answer_list("shape", "Mode shape", "1", &[1.0, 0.5, 0.25]);
        let double = sheet.step_vector("F_2", "N", given.force * 2.0.into(), "Twice the force");
        sheet.answer_vector("double_force", "Twice the force", double);
        Ok(())
    }
}

fn entry() -> Entry {
    Entry::of::<Machine>()
}

const FILE: &str = r#"
format = 2
analysis = "test/machine"
title = "Fan"

[let]                        # the order does not matter
G    = "E / (2*(1 + nu))"
nu   = "0.3"
E    = "210 GPa"
bolt = "12 g"

[inputs]
mass = "40 kg"
unbalance = "bolt * 120 mm"
support.stiffness.stiffness = "4e5 N/m"
speed = "1500 rpm"
force = "(3; 4; 0) N"

[ask]
"peak to peak" = "2*X"       # of the amplitude
"force amplitude" = "m0e * omega^2"
"power" = { value = "10 N*s/(1 m)*(omega*X)^2/2", unit = "W", key = "power", symbol = "P" }
"shear modulus" = "G"
"size" = "norm(F) + F.x"
"largest" = "maximum(shape)"
"rows" = "step[3] / (1 rad/s)"
"turning" = "omega*2"
"#;

fn solved(text: &str) -> dalembert_core::Solution {
    let problem = file::parse(text).unwrap_or_else(|errors| panic!("{errors:?}"));
    let record = problem.draft.read(&problem.entry.shape()).unwrap_or_else(|errors| panic!("{errors:?}"));
    problem.entry.solve(&record, &Stop::new()).unwrap_or_else(|error| panic!("{error}"))
}

fn si(solution: &dalembert_core::Solution, name: &str) -> f64 {
    let answer = solution.answer(name).unwrap_or_else(|| panic!("{name}: {:?}", solution.warnings));
    answer.si().unwrap_or_else(|| panic!("{name} is not a number"))
}

fn written(solution: &dalembert_core::Solution, symbol: &str) -> String {
    let locale = Locale::english();
    let all = solution.steps.iter().map(|step| printer::step(solution, step, &locale));
    let step = all.into_iter().find(|step| step.symbol == symbol).unwrap_or_else(|| panic!("{symbol}"));
    format!("{} = {} = {} = {}", step.symbol, step.formula, step.substitution, step.result)
}

#[test]
fn definitions_and_questions_of_a_file_are_answered() {
    let solution = solved(FILE);
    let omega = 1500.0 * std::f64::consts::TAU / 60.0;
    let (unbalance, natural) = (0.012 * 0.12, 1e4f64.sqrt());
    let ratio: f64 = omega / natural;
    let amplitude = unbalance / 40.0 * ratio.powi(2) / (ratio.powi(2) - 1.0).abs();
    let close = |name: &str, want: f64| {
        let have = si(&solution, name);
        assert!((have - want).abs() <= 1e-12 * want.abs(), "{name}: {have} and not {want}");
    };
    close("amplitude", amplitude);
    close("peak_to_peak", 2.0 * amplitude);
    close("force_amplitude", unbalance * omega * omega);
    close("power", 10.0 * (omega * amplitude).powi(2) / 2.0);
    close("shear_modulus", 210e9 / 2.6);
    close("size", 8.0);
    close("largest", 1.0);
    close("rows", 100.0);
    // An angle drops out of a product; a rate keeps it, in the unit of its part.
    let unit = |name: &str| solution.answer(name).expect("it is asked").unit.ascii();
    assert_eq!([unit("force_amplitude"), unit("turning")], ["N", "rpm"]);
    assert!(solution.warnings.is_empty(), "{:?}", solution.warnings);
    assert!(solution.defects.is_empty(), "{:?}", solution.defects);
    let asked: Vec<&str> =
        solution.answers.iter().filter(|answer| answer.asked).map(|answer| answer.label).collect();
    assert_eq!(asked.len(), 8, "{asked:?}");
}

#[test]
fn a_formula_is_a_line_of_the_working() {
    let solution = solved(FILE);
    assert_eq!(written(&solution, "G"), "G = E / (2 (1 + nu)) = 210 GPa / (2 × (1 + 0.3)) = 80.769 GPa");
    assert_eq!(written(&solution, "m₀e"), "m₀e = bolt 120 mm = 12 g × 120 mm = 0.00144 kg·m");
    assert!(written(&solution, "Q₁").starts_with("Q₁ = 2 X = 2 × "), "{}", written(&solution, "Q₁"));
    assert!(written(&solution, "P").ends_with(" W"), "{}", written(&solution, "P"));
}

#[test]
fn the_plain_reading_gives_the_numbers_of_the_worked_one() {
    let problem = file::parse(FILE).expect("the file can be read");
    let record = problem.draft.read(&problem.entry.shape()).expect("the inputs can be read");
    let levers: Vec<String> = vary::inputs(&record).into_iter().map(|input| input.path).collect();
    assert!(levers.contains(&"bolt".to_owned()) && !levers.contains(&"unbalance".to_owned()), "{levers:?}");
    assert!(levers.contains(&"nu".to_owned()) && !levers.contains(&"G".to_owned()), "{levers:?}");
    let wanted = ["amplitude", "peak_to_peak", "force_amplitude", "shear_modulus"];
    for names in [&wanted[..1], &wanted[..]] {
        let mut evaluate =
            problem.entry.prepare(&record, &["bolt", "mass"], names).expect("it can be varied");
        for (bolt, mass) in [(0.012, 40.0), (0.02, 35.0), (0.001, 41.5)] {
            let mut found = vec![0.0; names.len()];
            evaluate.sweep(&[bolt, mass], &mut found, &Stop::new()).expect("nobody stops it");
            let changed = vary::changed(&record, "bolt", bolt).expect("it is a lever");
            let changed = vary::changed(&changed, "mass", mass).expect("it is an input");
            let worked = problem.entry.solve(&changed, &Stop::new()).expect("it has an answer");
            for (name, found) in names.iter().zip_eq(found) {
                assert_eq!(found.to_bits(), si(&worked, name).to_bits(), "{name} with {bolt}, {mass}");
            }
        }
    }
    assert!(problem.entry.prepare(&record, &["unbalance"], &["amplitude"]).is_err());
}

#[test]
fn a_definition_that_no_input_rests_on_may_be_over_answers() {
    let definitions =
        "bolt = \"12 g\"\nhalf = \"natural_frequency/2\"\nv_max = \"half*amplitude*shape[2]/0.5\"\n";
    let text = FILE.replace("bolt = \"12 g\"\n", definitions).replace("\"G\"", "\"m*v_max^2/2\"");
    let solution = solved(&text);
    let energy = 40.0 * (50.0 * si(&solution, "amplitude")).powi(2) / 2.0;
    assert!((si(&solution, "shear_modulus") / energy - 1.0).abs() < 1e-14);
    assert_eq!(written(&solution, "half"), "half = ω_n / 2 = 100 rad/s / 2 = 50 rad/s");
    // Swept, the definition follows the answer.
    let problem = file::parse(&text).expect("the file can be read");
    let record = problem.draft.read(&problem.entry.shape()).expect("the inputs can be read");
    for wanted in [&["amplitude"][..], &["amplitude", "shear_modulus"]] {
        let mut evaluate = problem.entry.prepare(&record, &["mass"], wanted).expect("it can be varied");
        let mut found = vec![0.0; wanted.len()];
        evaluate.sweep(&[35.0], &mut found, &Stop::new()).expect("nobody stops it");
        let changed = vary::changed(&record, "mass", 35.0).expect("it is an input");
        let worked = problem.entry.solve(&changed, &Stop::new()).expect("it has an answer");
        for (name, found) in wanted.iter().zip_eq(found) {
            assert_eq!(found.to_bits(), si(&worked, name).to_bits(), "{name}");
        }
    }
    let refused = |from: &str, to: &str| {
        let problem = file::parse(&text.replace(from, to)).expect("the file can be read");
        match problem.draft.read(&problem.entry.shape()) {
            Err(errors) => errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "),
            Ok(record) => problem.entry.solve(&record, &Stop::new()).expect_err("it is wrong").to_string(),
        }
    };
    let early = refused("speed = \"1500 rpm\"", "speed = \"2*half\"");
    assert!(early.contains("`natural_frequency` is neither an input nor a definition"), "{early}");
    let wrong = refused("\"natural_frequency/2\"", "\"natural_freqency/2\"");
    assert!(wrong.contains("let[5].formula: there is no `natural_freqency` here; did you mean"), "{wrong}");
}

#[test]
fn a_file_is_written_as_it_was_read() {
    let problem = file::parse(FILE).expect("the file can be read");
    assert_eq!(file::write(&problem, FILE), FILE);
    let again = file::parse(&file::write(&problem, "")).expect("what was written can be read");
    assert_eq!(again.draft, problem.draft);
}

#[test]
fn what_is_wrong_is_named_with_its_repair() {
    let with = |from: &str, to: &str| {
        let text = FILE.replace(from, to);
        assert_ne!(text, FILE, "{from}");
        let problem = match file::parse(&text) {
            Ok(problem) => problem,
            Err(errors) => {
                return errors.iter().map(|error| error.why.english()).collect::<Vec<_>>().join("; ");
            }
        };
        match problem.draft.read(&problem.entry.shape()) {
            Err(errors) => errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "),
            Ok(record) => {
                let solution = problem.entry.solve(&record, &Stop::new()).expect("it has an answer");
                solution.warnings.iter().map(Text::english).collect::<Vec<_>>().join("; ")
            }
        }
    };
    for (from, to, words) in [
        ("nu   = \"0.3\"", "nu   = \"G/E\"", "let[1].formula: defined in a circle: G → nu → G"),
        ("nu   = \"0.3\"", "sin  = \"0.3\"", "`sin` is the name of a function"),
        ("nu   = \"0.3\"", "mass  = \"0.3\"", "`mass` is the name of an input"),
        ("bolt * 120 mm", "bolt * 120 s", "unbalance: `bolt * 120 s` is"),
        ("bolt * 120 mm", "bolt - 12 g", "an unbalance expected, e.g. in kg*m"),
        ("bolt * 120 mm", "bolt*120 mm - bolt*60 mm", ""),
        ("bolt * 120 mm", "bolt*(-120 mm)", "must not be below zero"),
        ("bolt * 120 mm", "bolt + 120 mm", "both must be the same kind of quantity"),
        ("bolt * 120 mm", "bolts * 120 mm", "unbalance: there is no `bolts` here; did you mean `bolt`?"),
        ("bolt * 120 mm", "screws * 120 mm", "unbalance: unknown unit `screws`"),
        ("2*X\"       #", "2*Y\"       #", "there is no `Y` here: no input, definition, answer or step"),
        ("2*X\"       #", "2*x\"       #", "there is no `x` here; did you mean `X`? `dalembert show` lists"),
        ("2*X\"       #", "2*wn\"       #", "there is no `wn` here; did you mean `ω_n`"),
        ("2*X\"       #", "2*Amplitude\"       #", "did you mean `amplitude`"),
        ("2*X\"       #", "2*natural_freqency\"       #", "did you mean `natural_frequency`"),
        ("2*X\"       #", "5 lb + 3 lbf\"       #", "write `5 lbf + 3 lbf` or `5 lb + 3 lb`"),
        ("bolt = \"12 g\"", "bolt = \"1 250 mg*Nu\"", "did you mean `nu`"),
        ("2*X\"       #", "2 X\"       #", "write `2*X`"),
        ("2*X\"       #", "3 kg*m\"       #", "write `3 kg m` or `3 kg*(m)`"),
        ("2*X\"       #", "2 N-m\"       #", "both must be the same kind of quantity"),
        ("2*X\"       #", "2 ton\"       #", "write `short ton`, `long ton`, `t`"),
        ("2*X\"       #", "sin(30)\"       #", "write `sin(30 deg)`"),
        ("2*X\"       #", "X + m\"       #", "both must be the same kind of quantity"),
        ("2*X\"       #", "cos(X)\"       #", "cos is of a number without a unit"),
        ("2*X\"       #", "sine(X)\"       #", "did you mean `sin`?"),
        ("2*X\"       #", "(2*X\"       #", "a closing bracket expected"),
        ("maximum(shape)", "shape[4]", "`shape` has 3 elements, counted from 1"),
        ("maximum(shape)", "shape[3] - 0.25", ""),
        ("\"G\"", "\"1/(r - r)\"", "divides by zero"),
        ("unit = \"W\"", "unit = \"kg\"", "which kg does not measure"),
        ("unit = \"W\"", "units = \"kg\"", "did you mean `unit`?"),
    ] {
        let found = with(from, to);
        assert!(found.contains(words), "{to}: {found:?}");
        assert!(!words.is_empty() || found.is_empty(), "{to}: {found:?}");
    }
}

#[test]
fn symbols_are_compared_as_people_write_them() {
    for (question, same) in
        [("omega_n", "natural_frequency"), ("ωₙ", "natural_frequency"), ("ω_n", "natural_frequency")]
    {
        let text = FILE.replace("2*X\"       #", &format!("{question}\"       #"));
        let solution = solved(&text);
        assert_eq!(si(&solution, "peak_to_peak").to_bits(), si(&solution, same).to_bits(), "{question}");
    }
    let springs = r#"
analysis = "test/machine"
[inputs]
mass = "40 kg"
unbalance = "0 kg*m"
speed = "1500 rpm"
support.springs.springs = [{ stiffness = "1 kN/m" }, { stiffness = "3*k_1" }, { stiffness = "k[2] + k₁" }]
[ask]
total = "k₁ + k_2 + k[3]"
several = "k"
"#;
    let solution = solved(springs);
    assert!((si(&solution, "total") - 8000.0).abs() < 1e-9);
    assert!((si(&solution, "several") - 8000.0).abs() < 1e-9);
}

/// Units that are written out, of two words or with a hyphen stand in formulas too; a name goes before them.
#[test]
fn formulas_take_units_as_people_write_them() {
    let definitions = "[let]                        # the order does not matter\nvoltas = \"3\"\nW = \"0.3 long ton\"\nT = \"25 lbf-in\"\n";
    let text = FILE.replace("[let]                        # the order does not matter\n", definitions);
    let lbf = 0.453_592_37 * 9.806_65;
    for (question, value) in [
        ("W", 672.0 * 0.453_592_37),
        ("W*2", 1344.0 * 0.453_592_37),
        ("T", 25.0 * lbf * 0.0254),
        ("2*voltas", 6.0),
        ("2 kg*voltas", 6.0),
        ("2*libras", 2.0 * 0.453_592_37),
        ("2 m-1 mm", 1.999),
    ] {
        let asked = text.replace("2*X\"       #", &format!("{question}\"       #"));
        assert_ne!(asked, text);
        let solution = solved(&asked);
        let found = si(&solution, "peak_to_peak");
        assert!((found / value - 1.0).abs() < 1e-14, "{question}: {found}");
    }
}

#[test]
fn a_question_without_a_value_costs_no_other_answer() {
    let solution = solved(&FILE.replace("\"G\"", "\"sqrt(-1*X/X)\""));
    assert!(solution.answer("shear_modulus").is_none());
    assert!(solution.answer("amplitude").is_some() && solution.answer("largest").is_some());
    let warning = solution.warnings.iter().map(Text::english).collect::<Vec<_>>().join("; ");
    assert!(warning.contains("shear modulus: no value"), "{warning}");
}

#[test]
fn a_problem_without_formulas_is_read_as_before() {
    let mut draft = Draft::blank(&entry().shape());
    let set = [
        ("mass", "2 kg"),
        ("unbalance", "1 kg*m"),
        ("support.stiffness.stiffness", "8 N/m"),
        ("speed", "1 rad/s"),
    ];
    for (path, text) in set {
        draft.set(&entry().shape(), path, text).expect("it is an input");
    }
    let record = draft.read(&entry().shape()).expect("it can be read");
    let solution = entry().solve(&record, &Stop::new()).expect("it has an answer");
    assert_eq!(si(&solution, "natural_frequency"), 2.0);
    assert!(matches!(
        solution.answer("double_force").map(|answer| &answer.value),
        Some(AnswerValue::Number(Number::Vector(_), _))
    ));
    draft.set(&entry().shape(), "mass", "2 kgs").expect("it is an input");
    let errors = draft.read(&entry().shape()).expect_err("that is no mass");
    assert!(errors[0].to_string().starts_with("mass: unknown unit `kgs`"), "{errors:?}");
    assert!(cases::cases(&entry()).is_err());
}
