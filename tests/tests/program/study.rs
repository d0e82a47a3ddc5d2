//! Studies on the command line: the same table on any number of threads, broken off, resumed, in shards.

use std::{
    f64::consts::PI,
    fs,
    path::Path,
    process::{Command, Output, Stdio},
    thread,
    time::{Duration, Instant},
};

use itertools::zip_eq;
use serde_json::Value as Json;

/// Runs `dalembert study` in a folder.
fn study(folder: &Path, arguments: &[&str]) -> Output {
    command(folder, arguments).output().expect("the program runs")
}

fn command(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = crate::program();
    command.current_dir(folder).arg("study").args(arguments).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&[&output.stdout[..], &output.stderr[..]].concat()).into_owned()
}

/// Output of a study that is carried out.
pub(crate) fn printed(folder: &Path, arguments: &[&str]) -> String {
    let output = study(folder, arguments);
    assert!(output.status.success(), "{arguments:?}: {}", said(&output));
    String::from_utf8(output.stdout).expect("what is printed is UTF-8")
}

/// Reason of a study that is refused, and its exit status.
pub(crate) fn refused(folder: &Path, arguments: &[&str]) -> (String, Option<i32>) {
    let output = study(folder, arguments);
    assert!(!output.status.success(), "{arguments:?} is carried out: {}", said(&output));
    (said(&output), output.status.code())
}

/// A folder with the example: its plan and the problem of it.
pub(crate) fn example() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["fan.toml", "fan_study.toml"] {
        fs::copy(xtask::root().join("examples").join(name), folder.path().join(name)).expect("an example");
    }
    folder
}

pub(crate) fn bytes(folder: &Path, name: &str) -> Vec<u8> {
    fs::read(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

#[test]
fn the_example_is_summarised() {
    let folder = example();
    let printed = printed(folder.path(), &["fan_study.toml"]);
    for part in [
        "Points  10000",
        "standard deviation",
        "Amplitude at this speed above 9 mm",
        "Influence on Natural frequency",
    ] {
        assert!(printed.contains(part), "{part}:\n{printed}");
    }
}

#[test]
fn statistics_are_those_of_the_rows() {
    let folder = example();
    let text = printed(folder.path(), &["fan_study.toml", "--json", "-o", "table.csv"]);
    let json: Json = serde_json::from_str(&text).expect("JSON");
    let table = String::from_utf8(bytes(folder.path(), "table.csv")).expect("UTF-8");
    let lines: Vec<&str> = table.lines().filter(|line| !line.starts_with('#')).collect();
    assert_eq!(
        lines[0],
        "speed [rpm],mass [kg],support.cantilever.young [kN/mm^2],amplitude [mm],natural_frequency [rad/s],refusal"
    );
    let amplitudes: Vec<f64> = lines[1..]
        .iter()
        .map(|line| line.split(',').nth(3).expect("a cell").parse().expect("a number"))
        .collect();
    assert_eq!(amplitudes.len(), 10_000);
    let count = amplitudes.len() as f64;
    let mean = amplitudes.iter().sum::<f64>() / count;
    let deviation = (amplitudes.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (count - 1.0)).sqrt();
    let of = &json["answers"][0];
    let near = |name: &str, value: f64| {
        let found = of[name].as_f64().expect("a number");
        assert!((found - value).abs() <= 1e-12 * value.abs(), "{name}: {found} is not {value}");
    };
    near("mean", mean);
    near("deviation", deviation);
    let above = amplitudes.iter().filter(|x| **x > 9.0).count();
    assert_eq!(of["exceedances"][0]["count"], above);
    assert_eq!(of["unit"], "mm");
}

#[test]
fn threads_and_shards_give_the_same_bytes() {
    let folder = example();
    let whole = |name: &str, more: &[&str]| {
        let arguments = [&["fan_study.toml", "--samples", "5000", "-o", name], more].concat();
        printed(folder.path(), &arguments)
    };
    let summary = whole("one.csv", &["--threads", "1"]);
    assert_eq!(summary, whole("three.csv", &["--threads", "3"]));
    assert_eq!(bytes(folder.path(), "one.csv"), bytes(folder.path(), "three.csv"));
    for shard in ["3/5", "1/5", "5/5", "2/5"] {
        whole("parts.csv", &["--shard", shard]);
    }
    let merge = ["fan_study.toml", "--samples", "5000", "-o", "parts.csv", "--merge"];
    let (why, status) = refused(folder.path(), &merge);
    assert!(why.contains("shards are missing: 4/5") && status == Some(2), "{why}");
    whole("parts.csv", &["--shard", "4/5"]);
    assert_eq!(summary, printed(folder.path(), &merge));
    assert_eq!(bytes(folder.path(), "one.csv"), bytes(folder.path(), "parts.csv"));
    // A shard that is sent again is done.
    let before = fs::metadata(folder.path().join("parts.shard-2-of-5.csv")).and_then(|file| file.modified());
    whole("parts.csv", &["--shard", "2/5"]);
    let after = fs::metadata(folder.path().join("parts.shard-2-of-5.csv")).and_then(|file| file.modified());
    assert_eq!(before.ok(), after.ok());
    // Shards of another number beside them are named.
    whole("parts.csv", &["--shard", "1/2"]);
    let (why, _) = refused(folder.path(), &[&merge[..], &["--force"]].concat());
    assert!(why.contains("shards of 2, 5"), "{why}");
}

#[test]
fn a_table_that_was_broken_off_goes_on_to_the_same_bytes() {
    let folder = example();
    let arguments = ["fan_study.toml", "--samples", "5000", "-o", "whole.csv"];
    let summary = printed(folder.path(), &arguments);
    let whole = bytes(folder.path(), "whole.csv");
    // At every kind of place: in the header, behind it, within a row, behind a row, behind the last one.
    let row = whole.iter().position(|byte| *byte == b'\n').expect("a line") + 1;
    for at in [0, 7, row, whole.len() / 3, whole.len() / 2 + 5, whole.len() - 1, whole.len()] {
        fs::write(folder.path().join("part.csv.part"), &whole[..at]).expect("a file");
        let arguments = ["fan_study.toml", "--samples", "5000", "-o", "part.csv"];
        assert_eq!(summary, printed(folder.path(), &arguments), "broken off at {at}");
        assert_eq!(whole, bytes(folder.path(), "part.csv"), "broken off at {at}");
        assert!(!folder.path().join("part.csv.part").exists());
        fs::remove_file(folder.path().join("part.csv")).expect("the table");
    }
}

#[test]
fn a_study_that_is_killed_is_resumed() {
    let folder = example();
    let arguments = ["fan_study.toml", "--samples", "40000", "-o", "killed.csv"];
    let part = folder.path().join("killed.csv.part");
    let mut killed = 0;
    for share in [1, 2] {
        let mut child = command(folder.path(), &arguments).spawn().expect("the program runs");
        let begun = Instant::now();
        let length = || fs::metadata(&part).map_or(0, |file| file.len());
        while length() < share * 1_000_000 && begun.elapsed() < Duration::from_mins(1) {
            if child.try_wait().expect("a child").is_some() {
                break;
            }
            thread::sleep(Duration::from_millis(1));
        }
        killed += usize::from(child.kill().is_ok());
        child.wait().expect("a child");
    }
    assert!(killed > 0, "every run ended before it could be killed");
    let summary = if folder.path().join("killed.csv").exists() {
        None
    } else {
        Some(printed(folder.path(), &arguments))
    };
    let other = ["fan_study.toml", "--samples", "40000", "-o", "whole.csv"];
    let whole = printed(folder.path(), &other);
    assert!(summary.is_none_or(|summary| summary == whole));
    assert_eq!(bytes(folder.path(), "whole.csv"), bytes(folder.path(), "killed.csv"));
}

#[test]
fn a_part_of_another_plan_is_not_gone_on_with() {
    let folder = example();
    printed(folder.path(), &["fan_study.toml", "-o", "table.csv"]);
    fs::rename(folder.path().join("table.csv"), folder.path().join("table.csv.part")).expect("a file");
    let (why, status) = refused(folder.path(), &["fan_study.toml", "--seed", "2", "-o", "table.csv"]);
    assert!(why.contains("is of another plan") && status == Some(2), "{why}");
    let text = fs::read_to_string(folder.path().join("fan.toml")).expect("the problem");
    fs::write(folder.path().join("fan.toml"), text.replace("1.2 m", "1.3 m")).expect("a file");
    let (why, _) = refused(folder.path(), &["fan_study.toml", "-o", "table.csv"]);
    assert!(why.contains("is of another plan"), "{why}");
}

#[test]
fn a_table_or_a_plan_is_not_written_over() {
    let folder = example();
    let (why, _) = refused(folder.path(), &["fan_study.toml", "-o", "fan_study.toml", "--force"]);
    assert!(why.contains("is the problem itself"), "{why}");
    let (why, _) = refused(folder.path(), &["fan_study.toml", "-o", "fan.toml", "--force"]);
    assert!(why.contains("is a problem file"), "{why}");
    printed(folder.path(), &["fan_study.toml", "-o", "table.csv"]);
    let (why, _) = refused(folder.path(), &["fan_study.toml", "-o", "table.csv"]);
    assert!(why.contains("already exists"), "{why}");
    printed(folder.path(), &["fan_study.toml", "-o", "table.csv", "--force"]);
}

#[test]
fn points_that_are_refused_are_rows_with_their_reason() {
    let folder = example();
    let arguments =
        ["fan.toml", "--vary", "mass=-10 kg..30 kg:5", "--answers", "amplitude", "-o", "table.csv"];
    let summary = printed(folder.path(), &arguments);
    assert!(
        summary.contains("Points without an answer") && summary.contains("point 1: mass: must be above zero"),
        "{summary}"
    );
    let table = String::from_utf8(bytes(folder.path(), "table.csv")).expect("UTF-8");
    let rows: Vec<&str> = table.lines().skip(4).collect();
    assert_eq!(rows[0], "-10,,mass: must be above zero; you wrote -10 kg");
    assert_eq!(rows[1], "0,,mass: must be above zero; you wrote 0 kg");
    assert!(rows[2].starts_with("10,") && rows[2].ends_with(','), "{}", rows[2]);
}

#[test]
fn points_that_do_not_meet_a_condition_are_refused() {
    let folder = example();
    let plan = "problem = \"fan.toml\"\nanswers = [\"amplitude\"]\n[[vary]]\ninput = \"mass\"\nvalues = [\"20 kg\", \"40 kg\", \"60 kg\"]\n[[condition]]\nanswer = \"natural_frequency\"\nbelow = \"120 rad/s\"\n";
    fs::write(folder.path().join("plan.toml"), plan).expect("a plan");
    printed(folder.path(), &["plan.toml", "-o", "table.csv"]);
    let table = String::from_utf8(bytes(folder.path(), "table.csv")).expect("UTF-8");
    let rows: Vec<&str> = table.lines().skip(4).collect();
    // ωₙ = √(451389 N/m / m): 150.2, 106.2 and 86.7 rad/s.
    assert_eq!(rows[0], "20,,,the condition is not met: Natural frequency below 120 rad/s");
    assert!(rows[1..].iter().all(|row| row.ends_with(',') && !row.contains(",,")), "{rows:?}");
}

#[cfg(not(feature = "parquet"))]
#[test]
fn a_build_without_parquet_says_how_to_make_one_with_it() {
    let folder = example();
    let repair = "this program is built without Parquet; take a CSV file, or build it with `cargo build --release --features parquet`";
    let (why, status) = refused(folder.path(), &["fan_study.toml", "-o", "table.parquet"]);
    assert!(why.contains(&format!("table.parquet: {repair}")) && status == Some(2), "{why}");
    let plan = "problem = \"fan.toml\"\n[[vary]]\ntable = \"points.parquet\"\n";
    fs::write(folder.path().join("plan.toml"), plan).expect("a plan");
    let (why, status) = refused(folder.path(), &["plan.toml"]);
    assert!(why.contains(&format!("points.parquet: {repair}")) && status == Some(2), "{why}");
}

#[test]
fn plans_that_do_not_fit_are_refused_with_place_and_repair() {
    let folder = example();
    let with = |plan: &str| {
        fs::write(folder.path().join("plan.toml"), format!("problem = \"fan.toml\"\n{plan}"))
            .expect("a plan");
        refused(folder.path(), &["plan.toml"])
    };
    for (plan, words) in [
        (
            "[[vary]]\ninput = \"mas\"\nvalues = [1]\n",
            "vary[1].input: `mas` is not a number among the inputs; did you mean `mass`?",
        ),
        ("[[vary]]\ninput = \"mass\"\nvalues = []\n", "vary[1].values: the list is empty"),
        ("[[vary]]\ninput = \"mass\"\n", "vary[1]: write one of: values; from, to and points"),
        ("[[vary]]\ninput = \"mass\"\nform = 3\n", "unknown field `form`"),
        ("[[vary]]\ninput = \"mass\"\nfrom = \"1 m\"\nto = \"2 kg\"\npoints = 3\n", "vary[1].from"),
        (
            "[[vary]]\ninput = \"mass\"\nfrom = 1\nto = 2\npoints = 1000000000000\n",
            "1000000000000 × 1 points are more than 1000000000",
        ),
        (
            "[[vary]]\ninput = \"mass\"\nfrom = 0\nto = 2\npoints = 5\nscale = \"log\"\n",
            "a logarithmic range lies above zero",
        ),
        ("[[vary]]\ninput = \"mass\"\ndistribution = \"normal\"\n", "vary[1].deviation: is missing"),
        (
            "[[vary]]\ninput = \"mass\"\ndistribution = \"normal\"\ndeviation = \"2 %\"\nmode = 3\n",
            "vary[1].mode: does not belong here",
        ),
        ("[[vary]]\ninput = \"mass\"\ndistribution = \"data\"\ndata = \"none.csv\"\n", "none.csv"),
        (
            "samples = 5\n[[vary]]\ninput = \"mass\"\nvalues = [1]\n",
            "samples: samples are drawn of inputs that have a distribution",
        ),
        (
            "answers = [\"amplitud\"]\n[[vary]]\ninput = \"mass\"\nvalues = [1]\n",
            "answers[1]: `amplitud` is not a number among the answers; did you mean `amplitude`?",
        ),
        (
            "[[vary]]\ninput = \"mass\"\nvalues = [1]\n[[vary]]\ninput = \"mass\"\nvalues = [2]\n",
            "mass varies twice",
        ),
        (
            "[[vary]]\ninput = \"mass\"\nvalues = [1]\n[[limit]]\nanswer = \"amplitude\"\n",
            "limit[1]: write above or below",
        ),
        (
            "sobol_indices = true\n[[vary]]\ninput = \"mass\"\ndistribution = \"normal\"\ndeviation = \"2 %\"\n[[vary]]\ninput = \"speed\"\nvalues = [900]\n",
            "sobol_indices: Sobol' indices want a distribution of every input that varies; give speed one",
        ),
        (
            "sobol_indices = true\n[[vary]]\ninput = \"mass\"\ndistribution = \"normal\"\ndeviation = \"2 %\"\n[[vary]]\ninput = \"unbalance\"\ndistribution = \"normal\"\ndeviation = \"2 %\"\n[[correlation]]\ninputs = [\"mass\", \"unbalance\"]\ncoefficient = 0.5\n",
            "sobol_indices: Sobol' indices are shares of independent inputs; take the correlations out",
        ),
        (
            "sobol_indices = true\nsamples = 500000000\n[[vary]]\ninput = \"mass\"\ndistribution = \"normal\"\ndeviation = \"2 %\"\n",
            "500000000 × 3 points are more than 1000000000",
        ),
        (
            "[[vary]]\ninput = \"mass\"\nvalues = [1]\n[[map]]\ninputs = [\"mass\", \"sped\"]\n",
            "map[1].inputs: `sped` does not vary in this plan; mass vary",
        ),
    ] {
        let (why, status) = with(plan);
        assert!(why.contains(words) && status == Some(2), "{plan}\n{why}");
    }
}

#[test]
fn tables_data_and_correlations_are_read_from_files_beside_the_plan() {
    let folder = example();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("a file");
    write("points.csv", "mass [g],speed [rpm]\n40000,900\n41000,950\n");
    write("young.csv", "E [GPa]\n198\n200\n203\n205\n");
    write(
        "plan.toml",
        "problem = \"fan.toml\"\nanswers = [\"amplitude\"]\nsamples = 4000\n\n[[vary]]\ntable = \"points.csv\"\n\n[[vary]]\ninput = \"support.cantilever.young\"\ndistribution = \"data\"\ndata = \"young.csv\"\n\n[[vary]]\ninput = \"unbalance\"\ndistribution = \"normal\"\ndeviation = \"5 %\"\n\n[[correlation]]\ninputs = [\"support.cantilever.young\", \"unbalance\"]\ncoefficient = 0.8\n",
    );
    let summary = printed(folder.path(), &["plan.toml", "-o", "table.csv"]);
    assert!(summary.contains("Points  8000"), "{summary}");
    let table = String::from_utf8(bytes(folder.path(), "table.csv")).expect("UTF-8");
    let rows: Vec<Vec<f64>> = table
        .lines()
        .skip(4)
        .map(|line| line.split(',').take(4).map(|cell| cell.parse().expect("a number")).collect())
        .collect();
    assert_eq!((rows[0][0], rows[0][1], rows[7999][0], rows[7999][1]), (40000.0, 900.0, 41000.0, 950.0));
    let column = |at: usize| rows[..4000].iter().map(|row| row[at]).collect::<Vec<f64>>();
    let centred = |values: Vec<f64>| {
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        values.into_iter().map(|value| value - mean).collect::<Vec<f64>>()
    };
    let (young, unbalance) = (centred(column(2)), centred(column(3)));
    let product = |a: &[f64], b: &[f64]| zip_eq(a, b).map(|(a, b)| a * b).sum::<f64>();
    let correlation =
        product(&young, &unbalance) / (product(&young, &young) * product(&unbalance, &unbalance)).sqrt();
    // Of the values themselves, one of which is not normal, a little less than that of their normal scores.
    assert!((0.72..0.82).contains(&correlation), "{correlation}");
}

#[test]
fn a_plan_is_written_from_the_options_and_read_again() {
    let folder = example();
    let options = [
        "fan.toml",
        "--vary",
        "speed=600..1800 rpm:13",
        "--vary",
        "mass=normal(2 %)",
        "--samples",
        "100",
        "--limit",
        "amplitude > 5 mm",
    ];
    let plan = printed(folder.path(), &[&options[..], &["--print-plan"]].concat());
    fs::write(folder.path().join("plan.toml"), plan).expect("a plan");
    assert_eq!(printed(folder.path(), &["plan.toml"]), printed(folder.path(), &options));
}

#[test]
fn the_summary_is_a_report_in_both_languages() {
    let folder = example();
    printed(folder.path(), &["fan_study.toml", "--report", "summary.html"]);
    let page = String::from_utf8(bytes(folder.path(), "summary.html")).expect("UTF-8");
    assert!(page.contains("Statistics of the answers") && page.contains("<svg"), "{page}");
    let printed = printed(folder.path(), &["fan_study.toml", "--lang", "pt-BR"]);
    for part in ["Estatística dos resultados", "desvio-padrão", "mediana"] {
        assert!(printed.contains(part), "{part}:\n{printed}");
    }
}

/// The plan of T. Ishigami and T. Homma's function of three inputs: formulas of a problem as a study sees them.
fn ishigami(folder: &Path) {
    let problem = fs::read_to_string(folder.join("fan.toml")).expect("the problem");
    let definitions = "\n[let]\nu = \"1\"\nv = \"1\"\nw = \"1\"\n\n[ask]\nishigami = \"sin(u) + 7*sin(v)^2 + 0.1*w^4*sin(u)\"\nlinear = \"u + 2*v - 3*w\"\n";
    fs::write(folder.join("ishigami.toml"), problem + definitions).expect("a file");
    let vary = |name: &str| {
        format!(
            "[[vary]]\ninput = \"{name}\"\ndistribution = \"uniform\"\nfrom = -3.141592653589793\nto = 3.141592653589793\n"
        )
    };
    let vary = ["u", "v", "w"].map(vary).concat();
    let plan = format!(
        "problem = \"ishigami.toml\"\nanswers = [\"ishigami\", \"linear\"]\nsamples = 4096\nsampling = \"sobol\"\nsobol_indices = true\n{vary}"
    );
    fs::write(folder.join("plan.toml"), plan).expect("a plan");
}

#[test]
fn sobol_indices_of_formulas_are_those_of_their_closed_forms() {
    let folder = example();
    ishigami(folder.path());
    let json: Json = serde_json::from_str(&printed(folder.path(), &["plan.toml", "--json"])).expect("JSON");
    assert_eq!(json["points"], 4096 * 5);
    let (first, second) = (0.5 * (1.0 + 0.1 * PI.powi(4) / 5.0).powi(2), 49.0 / 8.0);
    let both = 8.0 * 0.01 * PI.powi(8) / 225.0;
    let all = first + second + both;
    let ishigami = [[first, first + both], [second, second], [0.0, both]].map(|of| of.map(|part| part / all));
    // Of a sum of independent terms each has the share of its own variance, alone and in all.
    let linear = [1.0, 4.0, 9.0].map(|part| [part / 14.0; 2]);
    for (answer, closed) in zip_eq(0..2, [ishigami, linear]) {
        let of = &json["answers"][answer]["sobol_indices"];
        assert_eq!((&of["samples"], &of["left_out"]), (&Json::from(4096), &Json::from(0)));
        for (found, closed) in zip_eq(of["inputs"].as_array().expect("indices"), closed) {
            for (name, closed) in zip_eq(["first_order", "total"], closed) {
                let value = found[name]["value"].as_f64().expect("a number");
                let ends = [0, 1].map(|end| found[name]["interval"][end].as_f64().expect("a number"));
                let half = (ends[1] - ends[0]) / 2.0;
                assert!((value - closed).abs() < half, "{name} {value} is not {closed}");
                assert!(half < 3.0 / 64.0, "{name}: {ends:?}");
            }
        }
    }
}

#[test]
fn sobol_indices_are_the_same_on_threads_and_from_shards() {
    let folder = example();
    ishigami(folder.path());
    // A point that is refused leaves its base sample out.
    let plan = fs::read_to_string(folder.path().join("plan.toml")).expect("a plan");
    fs::write(folder.path().join("plan.toml"), plan + "[[condition]]\nanswer = \"linear\"\nabove = -16\n")
        .expect("a plan");
    let one = printed(folder.path(), &["plan.toml", "--json", "--threads", "1", "-o", "one.csv"]);
    assert_eq!(one, printed(folder.path(), &["plan.toml", "--json", "--threads", "3", "-o", "three.csv"]));
    assert_eq!(bytes(folder.path(), "one.csv"), bytes(folder.path(), "three.csv"));
    for shard in ["2/3", "1/3", "3/3"] {
        printed(folder.path(), &["plan.toml", "-o", "parts.csv", "--shard", shard]);
    }
    assert_eq!(one, printed(folder.path(), &["plan.toml", "--json", "-o", "parts.csv", "--merge"]));
    assert_eq!(bytes(folder.path(), "one.csv"), bytes(folder.path(), "parts.csv"));
    let whole = bytes(folder.path(), "one.csv");
    fs::write(folder.path().join("part.csv.part"), &whole[..whole.len() / 2 + 3]).expect("a file");
    assert_eq!(one, printed(folder.path(), &["plan.toml", "--json", "-o", "part.csv"]));
    let table = String::from_utf8(whole).expect("UTF-8");
    let rows: Vec<&str> = table.lines().skip(4).collect();
    let is_left_out = |sample: &&[&str]| sample.iter().any(|row| row.contains("the condition is not met"));
    let left_out = rows.chunks(5).filter(is_left_out).count();
    let json: Json = serde_json::from_str(&one).expect("JSON");
    assert!(left_out > 0);
    assert_eq!(json["answers"][0]["sobol_indices"]["left_out"], left_out);
    assert_eq!(json["answers"][0]["sobol_indices"]["samples"], 4096 - left_out);
    let printed = printed(folder.path(), &["plan.toml"]);
    assert!(printed.contains(&format!("{left_out} of 4096 base samples are left out")), "{printed}");
}

#[test]
fn means_at_levels_and_maps_are_those_of_the_rows() {
    let folder = example();
    let options =
        ["fan.toml", "--vary", "speed=600..1800 rpm:5", "--vary", "mass=normal(2 %)", "--samples", "3000"];
    let options =
        [&options[..], &["--answers", "amplitude", "--map", "mass,speed", "-o", "table.csv", "--json"]]
            .concat();
    let json: Json = serde_json::from_str(&printed(folder.path(), &options)).expect("JSON");
    let table = String::from_utf8(bytes(folder.path(), "table.csv")).expect("UTF-8");
    let rows: Vec<Vec<f64>> = table
        .lines()
        .skip(4)
        .map(|line| line.split(',').take(3).map(|cell| cell.parse().expect("a number")).collect())
        .collect();
    assert_eq!(json["levels"][0], serde_json::json!([600.0, 900.0, 1200.0, 1500.0, 1800.0]));
    // Deciles of the standard normal distribution, in tables of it.
    let deciles = [-1.281552, -0.841621, -0.524401, -0.253347, 0.0, 0.253347, 0.524401, 0.841621, 1.281552];
    let level = |mass: f64| deciles.iter().filter(|decile| mass >= 40.0 + 0.8 * **decile).count();
    let mean = |of: &dyn Fn(&Vec<f64>) -> bool| {
        let values: Vec<f64> = rows.iter().filter(|row| of(row)).map(|row| row[2]).collect();
        (values.len(), values.iter().sum::<f64>() / values.len() as f64)
    };
    let compare = |found: &Json, (count, mean): (usize, f64)| {
        assert_eq!(found["count"], count, "{found}");
        let found = found["mean"].as_f64().expect("a number");
        assert!((found - mean).abs() <= 1e-12 * mean.abs(), "{found} is not {mean}");
    };
    let of = &json["answers"][0];
    // Of five values alone nothing is left between them but the mass; what chance gives is taken off.
    let all = rows.iter().map(|row| row[2]).sum::<f64>() / rows.len() as f64;
    let square = rows.iter().map(|row| (row[2] - all).powi(2)).sum::<f64>();
    let at = |speed: f64| mean(&|row| row[0] == speed);
    let speeds = [600.0, 900.0, 1200.0, 1500.0, 1800.0];
    let between = speeds.map(|speed| at(speed).0 as f64 * (at(speed).1 - all).powi(2)).iter().sum::<f64>();
    let within = (square - between) / (rows.len() - 5) as f64;
    let share = of["shares"][0].as_f64().expect("a number");
    assert!((share - (between - 4.0 * within) / square).abs() < 1e-12, "{share}");
    assert_eq!(json["maps"], serde_json::json!([[1, 0]]));
    for mass in 0..10 {
        compare(&of["effects"][1][mass], mean(&|row| level(row[1]) == mass));
        for (n, speed) in [600.0, 900.0, 1200.0, 1500.0, 1800.0].into_iter().enumerate() {
            compare(&of["maps"][0][5 * mass + n], mean(&|row| level(row[1]) == mass && row[0] == speed));
        }
    }
}

#[test]
fn neighbouring_values_of_a_long_range_are_one_level() {
    let folder = example();
    for range in ["600..1800 rpm:1000", "1800..600 rpm:1000"] {
        let vary = format!("speed={range}");
        let options = ["fan.toml", "--vary", &vary, "--answers", "amplitude", "--json"];
        let json: Json = serde_json::from_str(&printed(folder.path(), &options)).expect("JSON");
        let levels: Vec<f64> = serde_json::from_value(json["levels"][0].clone()).expect("numbers");
        assert!(levels.is_sorted() && levels.len() == 24, "{levels:?}");
        let means = json["answers"][0]["effects"][0].as_array().expect("means");
        let counts: Vec<u64> = means.iter().map(|level| level["count"].as_u64().expect("a count")).collect();
        assert_eq!(counts.iter().sum::<u64>(), 1000);
        assert!(counts.iter().all(|count| [41, 42].contains(count)), "{counts:?}");
        // The resonance is at 106.2 rad/s.
        let largest = (0..24).max_by(|a, b| {
            let mean = |at: &usize| means[*at]["mean"].as_f64().expect("a number");
            mean(a).total_cmp(&mean(b))
        });
        assert!((levels[largest.expect("a level")] - 1014.3).abs() < 100.0, "{levels:?}");
    }
}

#[test]
fn the_summary_shows_tornado_scatter_and_map() {
    let folder = example();
    let printed =
        printed(folder.path(), &["fan_study.toml", "--answers", "amplitude", "--report", "summary.md"]);
    assert!(printed.is_empty(), "{printed}");
    let report = String::from_utf8(bytes(folder.path(), "summary.md")).expect("UTF-8");
    for title in [
        "Mean of Amplitude at this speed over the range of each input",
        "Amplitude at this speed over Speed of the machine",
        "Amplitude at this speed over Speed of the machine and Mass of the machine",
    ] {
        assert!(report.contains(&format!("![{title}](")), "{title}:\n{report}");
    }
}

#[test]
fn figures_of_a_summary_are_drawn_in_letters() {
    let folder = example();
    // Of u + 2 v − 3 w over the same ranges: bars of 1 : 2 : 3, and shares of the variance of 1 : 4 : 9.
    ishigami(folder.path());
    let printed = printed(folder.path(), &["plan.toml", "--answers", "linear", "--map", "v,w"]);
    let tornado = printed.split("Mean of linear over the range of each input\n").nth(1).expect("a tornado");
    let bars: Vec<(&str, usize)> = tornado
        .lines()
        .take(3)
        .map(|line| {
            (line.trim_start().split(' ').next().unwrap_or_default(), line.matches(['=', '|']).count())
        })
        .collect();
    let names: Vec<&str> = bars.iter().map(|(name, _)| *name).collect();
    assert_eq!(names, ["w", "v", "u"], "{printed}");
    // A bar has the letters of both of its ends.
    let steps = bars.iter().map(|(_, letters)| *letters as f64 - 1.0);
    for (steps, share) in zip_eq(steps, [3.0, 2.0, 1.0]) {
        assert!((steps - share * (bars[0].1 as f64 - 1.0) / 3.0).abs() <= 1.0, "{bars:?}");
    }
    // Between ten intervals of a uniform input lie 99 of 100 parts of its variance.
    for (input, share) in [("w", "63.6 %"), ("v", "28.3 %"), ("u", "7.08 %")] {
        let row = printed.lines().find(|line| line.trim_start().starts_with(&format!("{input} ")));
        let row = row.unwrap_or_else(|| panic!("{input}:\n{printed}"));
        let found: f64 =
            row.trim_end_matches(" %").rsplit(' ').next().and_then(|x| x.parse().ok()).unwrap_or(0.0);
        let share: f64 = share.trim_end_matches(" %").parse().expect("a number");
        assert!((found / share - 1.0).abs() < 0.02, "{input}: {found} is not {share}");
    }
    // The map rises with v to the right and falls with w upwards.
    let map = printed.split("linear over v and w\n").nth(1).expect("a map");
    let rows: Vec<Vec<u32>> = map
        .lines()
        .skip(1)
        .take(10)
        .map(|line| {
            let cells = line.split('|').nth(1).unwrap_or_default();
            cells.split_whitespace().map(|digit| digit.parse().expect("a digit")).collect()
        })
        .collect();
    assert_eq!((rows[0][0], rows[9][9]), (0, 9), "{map}");
    assert!(rows.iter().all(|row| row.len() == 10 && row.is_sorted()), "{map}");
    assert!((0..10).all(|column| rows.iter().map(|row| row[column]).is_sorted()), "{map}");
    assert!(printed.contains("linear over w\n"), "the scatter over the first input:\n{printed}");
}
