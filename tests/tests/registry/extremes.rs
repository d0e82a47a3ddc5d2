//! Answers that claim an extreme or a first time over a period remain valid over a longer period.

use dalembert_core::{AnswerValue, Number, Stop, file, registry};
use dalembert_plugins as _;
use dalembert_testkit::extremes;

#[test]
fn a_longer_time_has_no_smaller_maximum() {
    let covered = extremes::a_longer_time_has_no_smaller_maximum(registry());
    for id in [
        "vibration/multi-degree-response",
        "rigid-body/motion",
        "rigid-body/rolling-motion",
        "rigid-body/top-nutation",
        "vibration/large-pendulum",
    ] {
        assert!(covered.contains(id), "{id} is not among {covered:?}");
    }
}

/// The answer of a problem file.
fn answer(text: &str, name: &str) -> f64 {
    let problem = file::parse(text).unwrap_or_else(|errors| panic!("{errors:?}\n{text}"));
    let record = problem.draft.read(&problem.entry.shape()).expect("the inputs can be read");
    let solution =
        problem.entry.solve(&record, &Stop::new()).unwrap_or_else(|error| panic!("{error:?}\n{text}"));
    let answer = solution.answers.iter().find(|answer| answer.name.to_string() == name);
    let answer = answer.unwrap_or_else(|| panic!("there is no {name}"));
    let AnswerValue::Number(Number::Scalar(si), _) = answer.value else { panic!("{name} is not a number") };
    si
}

/// One mass on a spring, hit: the largest displacement is v₀/ω e^(−ζ φ/√(1−ζ²)) with cos φ = ζ, whatever the duration.
#[test]
fn the_largest_displacement_of_a_blow_is_that_of_its_first_swing() {
    for ratio in [0.0, 0.01, 0.3] {
        for duration in [0.3, 1.0, 17.0, 100.0, 200.0, 399.0, 4000.0] {
            let text = format!(
                "analysis = \"vibration/multi-degree-response\"\n[inputs]\nduration = \"{duration} s\"\n\
                 damping.ratio = {{ ratio = \"{ratio}\" }}\n\
                 system.chain = {{ masses = [{{ mass = \"1 kg\", spring = \"4*pi^2 N/m\" }}] }}\n\
                 start = [{{ coordinate = 1, velocity = \"1 m/s\" }}]\nobserved = [{{ coordinate = 1 }}]\ntimes = \"[s]\\n0.1\"\n"
            );
            let phase = f64::acos(ratio);
            let largest = f64::exp(-ratio * phase / f64::sqrt(1.0 - ratio * ratio)) / std::f64::consts::TAU;
            let found = answer(&text, "largest[1]");
            assert!(
                (found - largest).abs() < 1e-9 * largest,
                "{found} is not {largest}: ζ = {ratio}, {duration} s"
            );
        }
    }
}

/// A permanent rotation that carries the axis through the vertical.
#[test]
fn an_axis_that_passes_the_vertical_has_no_angle_to_it() {
    for duration in [10.0, 1.7, 0.9, 33.0] {
        let text = format!(
            "analysis = \"rigid-body/motion\"\n[inputs]\npivot = \"mass-centre\"\nduration = \"{duration} s\"\n\
             moments.principal = {{ x = \"2 kg*m^2\", y = \"3 kg*m^2\", z = \"4 kg*m^2\" }}\n\
             attitude.euler = {{ nutation = \"30 deg\" }}\nvelocity.body.omega = \"(-3; 0; 0) rad/s\"\n"
        );
        assert_eq!(answer(&text, "least_tilt"), 0.0, "{duration} s");
    }
}

/// A disc pushed from a steady circle wobbles: its largest angle is that of the first swing, whatever the duration.
#[test]
fn the_largest_inclination_does_not_hang_on_the_duration() {
    let largest = |duration: f64| {
        let text = format!(
            "analysis = \"rigid-body/rolling-motion\"\n[inputs]\nwheel = \"disc\"\nmass = \"1 kg\"\nradius = \"0.3 m\"\n\
             inclination = \"65 deg\"\nprecession = \"3 rad/s\"\nspin = \"-9 rad/s\"\ntilting = \"0.4 rad/s\"\n\
             duration = \"{duration} s\"\n"
        );
        ["largest_inclination", "least_inclination"].map(|name| answer(&text, name))
    };
    let [most, least] = largest(10.0);
    assert!(most > least + 1e-3);
    for duration in [7.3, 4.0, 3.1] {
        let [other, low] = largest(duration);
        assert!(
            (other - most).abs() < 1e-9 && (low - least).abs() < 1e-9,
            "{duration} s: {other} {low}, {most} {least}"
        );
    }
}
