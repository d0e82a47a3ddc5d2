//! Exam questions of several steps, or of an optimum: files of linked problems with a statement and the answers that it
//! asks for. `picture` names the problem whose drawings and plots come first; without it they stand in the order in which
//! the problems are solved.
//!
//! ```toml
//! format = 2
//! title = "Fan on a bracket"
//! source = "…"
//! statement = "A fan of 40 kg stands on …"
//! picture = "bracket"
//!
//! [problem.bracket]
//! analysis = "vibration/equivalent-stiffness"
//! …
//! [expect]
//! "bracket.stiffness" = "25.20 kN/m"
//! ```

use std::sync::OnceLock;

use crate::{About, Entry, cases, find_analysis, intern::intern, linked, registry};

/// The text of an exam question that comes with the program, and the name of its file.
#[doc(hidden)]
pub struct Bundled(pub &'static str, pub &'static str);

inventory::collect!(Bundled);

/// Adds exam questions, TOML files in a folder beside the code, to those that everybody is offered.
#[macro_export]
macro_rules! exams {
    ($folder:literal: $($name:literal),* $(,)?) => {
        $($crate::inventory::submit! {
            $crate::exams::Bundled($name, include_str!(concat!($folder, "/", $name, ".toml")))
        })*
    };
}

/// The topic of exam questions of several problems.
const SEVERAL: &str = "Several steps";
/// The topic of those of one, whose inputs are to be chosen.
const OPTIMUM: &str = "Optimum";

/// The family of exam questions in ids.
pub const FAMILY: &str = "exam";

/// Every exam question, in the order of their ids; each is an entry with one case.
///
/// # Panics
/// If the text of one cannot be read: a test reads them all.
pub fn exams() -> &'static [&'static Entry] {
    static EXAMS: OnceLock<Vec<&'static Entry>> = OnceLock::new();
    EXAMS.get_or_init(|| {
        let bundled = inventory::iter::<Bundled>();
        let mut all: Vec<&'static Entry> = bundled
            .map(|Bundled(name, text)| read(name, text).unwrap_or_else(|why| panic!("{name}: {why}")))
            .collect();
        all.sort_by_key(|entry| entry.about.id);
        all
    })
}

/// Every analysis, and behind them every exam question.
pub fn catalogue() -> &'static [&'static Entry] {
    static ALL: OnceLock<Vec<&'static Entry>> = OnceLock::new();
    ALL.get_or_init(|| registry().iter().chain(exams()).copied().collect())
}

/// The analysis or the exam question of that id.
pub fn find(id: &str) -> Option<&'static Entry> {
    find_analysis(id).or_else(|| {
        let is_exam = id.split_once('/').is_some_and(|(family, _)| family == FAMILY);
        if is_exam { exams().iter().find(|entry| entry.about.id == id).copied() } else { None }
    })
}

fn read(name: &str, text: &'static str) -> Result<&'static Entry, String> {
    let (title, problems, pictured) = cases::exam(text)?;
    let linked = linked::entry(&problems);
    let analyses: Vec<&str> = problems.iter().map(|problem| problem.entry.about.title).collect();
    let (topic, summary) = match linked.linked() {
        [_, _, ..] => (SEVERAL, "Several problems that feed each other."),
        _ => (
            OPTIMUM,
            "The inputs with which an answer is as small or as large as possible, under limits of others.",
        ),
    };
    let about: &'static About = Box::leak(Box::new(About {
        id: intern(&format!("{FAMILY}/{name}")),
        title: intern(&title),
        topic,
        summary,
        main: linked.about.main,
        keywords: intern(&analyses.join(" ")),
        sources: linked.about.sources,
        cases: text,
    }));
    Ok(Box::leak(Box::new(linked.with_about(about).with_pictured(pictured))))
}
