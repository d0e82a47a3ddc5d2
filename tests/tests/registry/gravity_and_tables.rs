//! One gravity in a problem, and tables whose units are known, over the whole registry.

use dalembert_core::{AnswerValue, Number, Solution, Stop, Text, file, registry};
use dalembert_plugins as _;
use dalembert_testkit::inputs;
use toml_edit::DocumentMut;

use super::{number, solved};

fn warnings(solution: &Solution) -> Vec<String> {
    solution.warnings.iter().map(Text::english).collect()
}

#[test]
fn every_gravity_has_the_same_default() {
    let found = inputs::every_gravity_has_the_same_default(registry());
    assert!(found > 60, "{found}");
}

#[test]
fn a_problem_has_one_gravity() {
    let several = inputs::a_problem_has_one_gravity(registry());
    assert!(several > 5, "{several}");
}

#[test]
fn a_weight_is_its_own_normal_force() {
    let rubbing = |analysis: &str, rest: &str| {
        solved(&format!("format = 2\nanalysis = \"vibration/{analysis}\"\n[inputs]\n{rest}"))
    };
    let block = "mass.weight.weight = \"100 N\"\nstiffness = \"1 kN/m\"\n";
    let by_friction = "friction.coefficient.coefficient = \"0.1\"\n";
    let free = rubbing("coulomb-damping", &format!("{block}{by_friction}displacement = \"60 mm\"\n"));
    assert_eq!(number(&free, "friction"), 10.0);
    assert!(number(&free, "rest_position").abs() < 1e-15, "{}", number(&free, "rest_position"));
    let forced = rubbing(
        "forced-coulomb",
        &format!("{block}{by_friction}frequency = \"5 rad/s\"\nexcitation.force.force = \"50 N\"\n"),
    );
    assert_eq!(number(&forced, "friction"), 10.0);
    let decay = "mass.weight.weight = \"5 lbf\"\nstiffness = \"10 lbf/in\"\ndisplacement = \"2 in\"\n\
                 friction.decay = { first_amplitude = \"2 in\", last_amplitude = \"1.2 in\", counted.cycles.cycles = \"4\" }\n";
    let coefficient = number(&rubbing("coulomb-damping", decay), "friction_coefficient");
    assert!((coefficient - 0.1).abs() < 1e-15, "{coefficient}");
}

#[test]
fn gravity_is_32_2_feet_where_every_unit_is_customary() {
    let mass = |weight: &str, stiffness: &str| {
        let text = format!(
            "format = 2\nanalysis = \"vibration/coulomb-damping\"\n[inputs]\nmass.weight.weight = \"{weight}\"\n\
             stiffness = \"{stiffness}\"\nfriction.coefficient.coefficient = \"0.1\"\ndisplacement = \"60 in\"\n"
        );
        (number(&solved(&text), "natural_frequency"), text)
    };
    let pound = 4.448_221_615_260_5;
    let (customary, text) = mass("32.2 lbf", "4 lbf/ft");
    assert!((customary - 2.0).abs() < 1e-14, "{customary}");
    let (mixed, _) = mass("32.2 lbf", "1 kN/m");
    assert!((mixed.powi(2) / (1000.0 * 9.81 / (32.2 * pound)) - 1.0).abs() < 1e-14, "{mixed}");
    // In a file of the first format it stays what it was.
    let old = number(&solved(&text.replace("format = 2\n", "")), "natural_frequency");
    assert!((old.powi(2) * 32.2 * 0.3048 / 4.0 / 9.80665 - 1.0).abs() < 1e-14, "{old}");
}

#[test]
fn two_stated_values_of_gravity_are_warned_of() {
    let text = "format = 2\nanalysis = \"vibration/coulomb-damping\"\n[inputs]\n\
                mass.weight = { weight = \"100 N\", gravity = \"9.80665 m/s^2\" }\nstiffness = \"1 kN/m\"\n\
                friction.coefficient = { coefficient = \"0.1\", gravity = \"9.81 m/s^2\" }\ndisplacement = \"60 mm\"\n";
    let warned = warnings(&solved(text));
    assert!(warned.iter().any(|warning| warning.starts_with("two values of gravity")), "{warned:?}");
}

#[test]
fn files_of_the_first_format_keep_their_answers() {
    // From the program before it knew a second format. What an analysis finds by a better method may differ by
    // rounding; another gravity would change the fourth digit, another unit the first.
    let frozen: serde_json::Value =
        serde_json::from_str(include_str!("../../format-1.json")).expect("the frozen answers can be read");
    let problems = frozen.as_array().expect("a list of problems");
    let (mut compared, mut noted) = (0, 0);
    for problem in problems {
        let text = problem["problem"].as_str().expect("the text of a file");
        let parsed = file::parse(text).unwrap_or_else(|errors| panic!("{text}: {errors:?}"));
        noted += usize::from(!parsed.notes.is_empty());
        let record =
            parsed.draft.read(&parsed.entry.shape()).unwrap_or_else(|errors| panic!("{text}: {errors:?}"));
        let solution = parsed.entry.solve(&record, &Stop::new()).expect("it was solved before");
        // As it is saved: in the second format, with the same meaning.
        let saved = file::write(&parsed, text);
        assert!(
            saved.parse::<DocumentMut>().expect("a saved file can be read").contains_key("format"),
            "{saved}"
        );
        let again = solved(&saved);
        for (name, before) in problem["answers"].as_object().expect("answers by their names") {
            let Some(before) = before.as_f64() else { continue };
            let Some(answer) = solution.answers.iter().find(|answer| answer.name.to_string() == *name) else {
                panic!("{text}: there is no {name} any more");
            };
            let AnswerValue::Number(Number::Scalar(now), _) = answer.value else { panic!("{text}: {name}") };
            assert!((now - before).abs() <= 1e-9 * before.abs().max(1e-9), "{text}: {name} {before} {now}");
            assert_eq!(number(&again, name).to_bits(), now.to_bits(), "{saved}: {name}");
            compared += 1;
        }
    }
    assert!(problems.len() >= 60 && compared > 500 && noted > 40, "{} {compared} {noted}", problems.len());
}

#[test]
fn frequencies_in_tables_are_in_hertz() {
    let found = inputs::frequencies_in_tables_are_in_hertz(registry());
    assert!(found > 8, "{found}");
}

#[test]
fn a_frequency_response_without_a_heading_is_in_hertz_and_reports_it() {
    // 12 kg on 48 kN/m with ζ = 0.02, in m/N.
    let (mass, stiffness, zeta) = (12.0f64, 48e3f64, 0.02);
    let natural = (stiffness / mass).sqrt();
    let receptance = |hertz: f64| {
        let r = std::f64::consts::TAU * hertz / natural;
        1.0 / stiffness / ((1.0 - r * r).powi(2) + (2.0 * zeta * r).powi(2)).sqrt()
    };
    let rows: Vec<String> = (0..=160)
        .map(|n| 8.0 + 0.025 * f64::from(n))
        .map(|hertz| format!("{hertz};{:.9e}", receptance(hertz)))
        .collect();
    let problem = |format: &str, heading: &str| {
        format!(
            "{format}analysis = \"vibration/frequency-response-identification\"\n[inputs]\n\
             measurement.table.points = \"\"\"\n{heading}{}\"\"\"\n",
            rows.join("\n")
        )
    };
    let bare = solved(&problem("format = 2\n", ""));
    assert!((number(&bare, "mass") - mass).abs() < 0.01, "{}", number(&bare, "mass"));
    let warned = warnings(&bare);
    assert!(
        warned.iter().any(|warning| warning.ends_with("no unit in the heading; Hz, m/N assumed")),
        "{warned:?}"
    );
    for heading in ["f / Hz;H / (m/N)\n", "f_Hz;H [m/N]\n", "f in Hz;H in m/N\n", "f;H\nHz;m/N\n"] {
        let stated = solved(&problem("format = 2\n", heading));
        assert_eq!(number(&stated, "mass").to_bits(), number(&bare, "mass").to_bits(), "{heading}");
        assert!(!warnings(&stated).iter().any(|warning| warning.contains("heading")), "{heading}");
    }
    // A file of the first format reads rad/s, and is written so.
    let old = problem("", "");
    let parsed = file::parse(&old).expect("a file of the first format is read");
    assert_eq!(parsed.notes.len(), 1, "{:?}", parsed.notes);
    let ratio = number(&solved(&old), "mass") / mass;
    assert!((ratio - std::f64::consts::TAU.powi(2)).abs() < 0.05, "{ratio}");
    assert!(file::write(&parsed, &old).contains("[rad/s]; [m/N]"), "{}", file::write(&parsed, &old));
}

#[test]
fn published_tables_name_their_units() {
    let tables = inputs::published_tables_name_their_units(registry());
    assert!(tables > 30, "{tables}");
}

#[test]
fn a_table_is_a_list_of_rows_by_name_too() {
    let spectrum = |points: &str| {
        format!(
            "format = 2\nanalysis = \"vibration/response-spectrum\"\n[inputs]\n\
             structure.modes.modes = [{{ frequency = \"1.5 Hz\", share = \"1\" }}]\n{points}"
        )
    };
    let wanted = number(
        &solved(&spectrum("spectrum.table.points = [[\"1 Hz\", \"1 m/s^2\"], [\"2 Hz\", 4]]\n")),
        "displacement_abs",
    );
    for points in [
        "spectrum.table.points = [{ frequency = \"1 Hz\", acceleration = 1 }, { acceleration = 4, frequency = 2 }]\n",
        "[[inputs.spectrum.table.points]]\nfrequency = 1\nacceleration = \"1 m/s^2\"\n\
         [[inputs.spectrum.table.points]]\nfrequency = \"2 Hz\"\nacceleration = 4.0\n",
    ] {
        let text = spectrum(points);
        assert_eq!(number(&solved(&text), "displacement_abs"), wanted, "{text}");
        let parsed = file::parse(&text).expect("it is read");
        assert_eq!(number(&solved(&file::write(&parsed, &text)), "displacement_abs"), wanted);
    }
    for (points, reported) in [
        ("spectrum.table.points = [{ frequency = 1 }]\n", "this row has no acceleration"),
        ("spectrum.table.points = [{ frequency = 1, accel = 1 }]\n", "accel"),
        ("spectrum.table.points = { frequency = 1 }\n", "write a table as lines of text with the heading"),
    ] {
        let errors = file::parse(&spectrum(points)).expect_err("it cannot be read");
        let why = errors.iter().map(|error| error.why.english()).collect::<Vec<_>>().join("; ");
        assert!(why.contains(reported), "{why}");
    }
}

#[test]
fn a_response_spectrum_is_read_between_its_points_as_asked() {
    let wanted = [
        // 1 m/s² at 1 s, 4 m/s² at 0.5 s, read at 1/1.5 s.
        ("", "interpolation = \"linear-in-period\"", 3.0),
        ("", "", 3.0),
        ("", "interpolation = \"linear-in-frequency\"", 2.5),
        ("", "interpolation = \"log-log\"", 2.25),
        ("first", "", 2.25),
    ];
    for (format, interpolation, acceleration) in wanted {
        let format = if format.is_empty() { "format = 2\n" } else { "" };
        let solution = solved(&format!(
            "{format}analysis = \"vibration/response-spectrum\"\n[inputs]\n\
             structure.modes.modes = [{{ frequency = \"1.5 Hz\", share = \"1\" }}]\n\
             [inputs.spectrum.table]\npoints = \"f [Hz]; S [m/s^2]\\n1; 1\\n2; 4\"\n{interpolation}\n"
        ));
        let omega = 3.0 * std::f64::consts::PI;
        let found = number(&solution, "displacement_abs") * omega * omega;
        assert!((found - acceleration).abs() < 1e-14, "{interpolation}: {found}");
        // Its two neighbouring rows stand in the working.
        let locale = dalembert_core::Locale::english();
        let rows: Vec<String> = solution.steps.iter().map(|step| step.why.render(&locale)).collect();
        for row in ["row 1 of the spectrum", "row 2 of the spectrum"] {
            assert!(rows.iter().any(|why| why.contains(row)), "{rows:?}");
        }
    }
}

#[test]
fn a_step_of_a_spectral_density_is_read() {
    let variance = |points: &str| {
        let solution = solved(&format!(
            "format = 2\nanalysis = \"vibration/random-response\"\n[inputs]\n\
             elasticity.natural-frequency.frequency = \"1.2 Hz\"\ndamping.ratio.ratio = \"0.05\"\n\
             excitation.base.density.table = {{ points = \"f [Hz]; S [m^2/s^4/Hz]\\n{points}\", between = \"linear\" }}\n"
        ));
        number(&solution, "displacement").powi(2)
    };
    // Two levels that meet at 1.2 Hz are the sum of two bands.
    let (low, high) = (variance("0.5; 1\\n1.2; 1"), variance("1.2; 3\\n4; 3"));
    let both = variance("0.5; 1\\n1.2; 1\\n1.2; 3\\n4; 3");
    assert!((both / (low + high) - 1.0).abs() < 1e-9, "{both} {low} {high}");
}
