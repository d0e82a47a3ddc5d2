//! Formulas in the cells of tables, on a small analysis.

use dalembert_core::{About, Analysis, Inputs, Refusal, Source, Stop, Worksheet, file, register, vary};
use dalembert_numerics::Real as _;
use itertools::Itertools as _;

/// Springs between numbered places.
#[derive(Clone, Debug, Inputs)]
pub struct Springs {
    /// Mass.
    #[input("m", "kg", positive)]
    pub mass: f64,
    /// Springs.
    #[input(table)]
    pub springs: Vec<Spring>,
}

/// A spring.
#[derive(Clone, Debug, Inputs)]
pub struct Spring {
    /// Stiffness.
    #[input("k", "N/m", positive)]
    pub stiffness: f64,
    /// Length.
    #[input("l", "m")]
    pub length: f64,
}

static BOOK: Source = Source { short: "Book", full: "A book" };

register!(Springs);

impl Analysis for Springs {
    const ABOUT: About = About {
        id: "test/springs",
        title: "Springs",
        topic: "Tests",
        summary: "Springs.",
        main: &[],
        keywords: "",
        sources: &[&BOOK],
        cases: "",
    };

    fn solve<W: Worksheet>(&self, given: &SpringsGiven<W>, sheet: W) -> Result<(), Refusal> {
        let stiffness: f64 = self.springs.iter().map(|spring| spring.stiffness).sum();
        let total = sheet.step("k_t", "N/m", stiffness.into(), "In parallel");
        let natural = sheet.step("ω_n", "rad/s", (total / given.mass).sqrt(), "Natural frequency");
        let length: f64 = self.springs.iter().map(|spring| spring.length).sum();
        sheet.answer("stiffness", "Stiffness", total);
        sheet.answer("natural_frequency", "Natural frequency", natural);
        sheet.answer("length", "Length", sheet.step("l_t", "m", length.into(), "Together"));
        Ok(())
    }
}

fn with_rows(rows: &str) -> String {
    format!(
        "format = 2\nanalysis = \"test/springs\"\n[let]\nk0 = \"2 N/mm\"\na = \"30 cm\"\n\
         [inputs]\nmass = \"4 kg\"\nsprings = '''\n{rows}\n'''\n[ask]\ntwice = \"2*stiffness\"\n"
    )
}

fn solved(text: &str) -> Result<dalembert_core::Solution, String> {
    let problem = file::parse(text).map_err(|errors| format!("{errors:?}"))?;
    let record = problem.draft.read(&problem.entry.shape());
    let record = record.map_err(|errors| errors.iter().map(ToString::to_string).join("; "))?;
    problem.entry.solve(&record, &Stop::new()).map_err(|error| error.to_string())
}

fn si(solution: &dalembert_core::Solution, name: &str) -> f64 {
    solution.answer(name).and_then(dalembert_core::Answer::si).unwrap_or_else(|| panic!("{name}"))
}

#[test]
fn a_cell_takes_a_formula_and_a_number_alone_is_in_the_unit_of_its_column() {
    for (rows, stiffness, length) in [
        ("k [N/mm]; l [m]\nk0; 2*a\n1; a/2", 3000.0, 0.75),
        ("k [N/mm]; l [m]\n3*k0 - 1 N/mm; 2*3\n1/4; sqrt(16)", 5250.0, 10.0),
        ("2*k0; a\n1000*(1 + 2); pi/pi", 7000.0, 1.3),
        ("1,5*k0; a\n500; 0,5", 3500.0, 0.8),
        ("k0*2; a/2", 4000.0, 0.15),
    ] {
        let solution = solved(&with_rows(rows)).unwrap_or_else(|why| panic!("{rows}: {why}"));
        let found = [si(&solution, "stiffness"), si(&solution, "length")];
        for (found, want) in found.into_iter().zip_eq([stiffness, length]) {
            assert!((found / want - 1.0).abs() < 1e-14, "{rows}: {found} and not {want}");
        }
        // Assumed units are stated.
        let is_stated = rows.starts_with("k [N/mm]") || rows == "k0*2; a/2";
        assert_eq!(solution.warnings.is_empty(), is_stated, "{:?}", solution.warnings);
    }
    // What names a definition is a line of the working.
    let solution = solved(&with_rows("2*k0; a\n1000; 2*3")).expect("it has an answer");
    assert_eq!(si(&solution, "twice"), 1e4);
    let symbols = |symbol: &str| solution.steps.iter().filter(|step| step.symbol.base == symbol).count();
    assert_eq!([symbols("k"), symbols("l")], [1, 0]);
}

#[test]
fn a_definition_in_a_cell_is_varied_as_any_other() {
    let problem = file::parse(&with_rows("2*k0; a\n1000; 2*a")).expect("the file can be read");
    let record = problem.draft.read(&problem.entry.shape()).expect("the inputs can be read");
    let wanted = ["stiffness", "length", "natural_frequency", "twice"];
    for (path, values) in [("k0", [1e3, 5e3]), ("mass", [1.0, 9.0])] {
        for names in [&wanted[..3], &wanted[..]] {
            let mut evaluate = problem.entry.prepare(&record, &[path], names).expect("it can be varied");
            for value in values {
                let mut found = vec![0.0; names.len()];
                evaluate.sweep(&[value], &mut found, &Stop::new()).expect("nobody stops it");
                let changed = vary::changed(&record, path, value).expect("it is a lever");
                let worked = problem.entry.solve(&changed, &Stop::new()).expect("it has an answer");
                for (n, name) in names.iter().enumerate() {
                    assert_eq!(found[n].to_bits(), si(&worked, name).to_bits(), "{name} at {path} = {value}");
                }
            }
        }
    }
}

#[test]
fn what_is_wrong_in_a_cell_is_named_with_its_line() {
    for (rows, words) in [
        ("2*k0; a\n1000; 2*kO", "springs: line 2: unknown unit `kO`"),
        ("2*k0; a\n1000; b/2", "springs: line 2: "),
        ("2*k0; a\n1000; a*k0", "springs: "),
        ("2*k0; a\n1000; k0/0", "springs: "),
        ("2*k0; a\n-1*k0; a", "springs: "),
        ("2*k0; a\n1000; 1/0", "springs: line 2: `1/0` divides by zero"),
        ("2*k0; a\n1000; ?", "springs: line 2: "),
        (
            "k0; a\n1000; 1",
            "springs: line 1: a row of names without a number is a heading, but these are definitions: write 1*k0",
        ),
    ] {
        let found = solved(&with_rows(rows)).map_or_else(|why| why, |_| String::new());
        assert!(found.contains(words) && !found.is_empty(), "{rows}: {found:?}");
    }
    let text = with_rows("2*k0; a\n1000; 2*3");
    let problem = file::parse(&text).expect("the file can be read");
    assert_eq!(
        file::write(&problem, &text),
        text.replace("2*k0; a\n1000; 2*3\n", "[N/m]; [m]\n2*k0; a\n1000; 2*3")
    );
}
