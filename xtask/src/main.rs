//! `cargo xtask`: the automation of this repository.

use std::{env, process::ExitCode};

use xtask::{
    bench, cluster, contact_sheet, dialects, dist, docs, errors, find, first_entry, fuzz, handbook,
    new_analysis, new_plugin, papers, parquet, pictures, python, root, soak, teaching, tidy, trust, verify,
    words,
};

const USAGE: &str = "\
usage: cargo xtask COMMAND

  verify [--quick]           prove the project; --quick leaves out the slow steps
  verify STEP...             the steps of these names, as the summary has them: verify clippy 'new analysis'
  tidy                       check the tree against its own rules
  find TERM                  the file of a thing, by its name in the field or a synonym in docs/glossary.md
  new-analysis FAMILY NAME --topic TOPIC
                             begin an analysis: one file in the folder of its topic, its cases, its translations
  new-plugin NAME            begin a family of analyses
  words [COMMIT]             carry the translations of sentences reworded since COMMIT (HEAD) over to their new keys
  docs [--check]             write the reference, problem files and units in docs/, or see that they are up to date
  handbook [--lang L]        the handbook as pages for a browser, in the target directory; they solve, where Rust has
                             the target wasm32-unknown-unknown
  handbook --check           and its links, problem files, search and widths examined, and every case solved by the pages
  pictures [--check]         draw the pictures in docs/pictures/ from their sessions, or see that they are up to date
  pictures --sheet [--rows R --cols C] [--language L] [NAME]...
                             contact sheets in the target directory: first screen, drawing and plot of every analysis,
                             or of those whose ids contain a NAME
  papers [--format F] [NAME]...
                             every analysis as a note and variants as sheets, or those whose names contain a NAME, in both
                             languages and each format, printed as PDF and measured: letters outside of the text, lone titles
  soak mutants               the result of each function of mechanics times 1.01: does the catalogue notice?
  soak rotors                2000 random rotors: each answered, every check holds?
  soak chains                chains of 1 to 100 four-bars through singular positions
  soak perturb --draws N     every case N times with its numbers changed at random: answered or refused with reason?
  soak nets --times N        N times the points of each plot, every extreme value: path independence and invariance
  dist [--without-wheel]     the static program as archive, Debian package and wheel, with checksums and bill of materials
  dist --windows             and the program for Windows, cross-built with mingw-w64
  dist --prove               and run in an empty root, installed in an old Debian, and under Wine; needs root and debootstrap
  dist --reproduce           and built once more in another folder: the same bytes?
  dist --packages            and every crate packed for a registry, and built from its package
  python                     the wheel of the Python module, built and installed, its tests, notebook and Dask example
  parquet                    the program built with Parquet: clippy, and tables written and read back
  teaching                   1000 variants of 20 problems graded; files for Moodle, QTI and PrairieLearn read by them
  teaching --platforms       the files for the platforms alone
  dialects [--make] [--all]  files as other programs write them: read right, refused with the repair, or silently wrong?
                             --make writes them again (Python), --all prints every refusal
  errors [DIGITS]... [--log] the table of the corpus of student errors: how many causes Check names
  fuzz TARGET --runs N [--seed S]
                             N executions of a reader in search of input that breaks it; targets: quantity expression vector
                             keys problem-file table universal-file replay settings report
  trust [--seed S] [--times N] [ROW]...
                             trials of reliability at full size, or N times, recorded in docs/trust.md
  trust --check [ROW]...     a hundredth of each, recording nothing; --list prints the rows
  cluster [POINTS]           a study killed and resumed, in shards by GNU parallel and by a real Slurm: the same bytes?
  first-entry                the rate of published problems that were right at their first entry, from the history
  bench [PART]...            measure; parts: plain units solve keys causes tui
";

fn main() -> ExitCode {
    let words: Vec<String> = env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let done = match words.as_slice() {
        ["verify"] => verify::run(&root(), verify::Extent::Everything),
        ["verify", "--quick"] => verify::run(&root(), verify::Extent::Quick),
        ["verify", steps @ ..] => verify::run(&root(), verify::Extent::Steps(steps)),
        ["tidy"] => tidy::run(&root()),
        ["find", words @ ..] if !words.is_empty() => {
            tidy::Tree::read(&root()).and_then(|tree| find::run(&tree, &words.join(" ")))
        }
        ["new-analysis", family, name] => new_analysis::run(&root(), family, name, None),
        ["new-analysis", family, name, "--topic", topic] => {
            new_analysis::run(&root(), family, name, Some(topic))
        }
        ["new-plugin", name] => new_plugin::run(&root(), name),
        ["words"] => words::run(&root(), "HEAD"),
        ["words", commit] => words::run(&root(), commit),
        ["docs"] => docs::write(&root()),
        ["docs", "--check"] => docs::check(&root()),
        ["handbook", words @ ..] => handbook::run(&root(), words),
        ["pictures"] => pictures::write(&root()),
        ["pictures", "--check"] => pictures::check(&root()).map(|_| ()),
        ["pictures", "--sheet", words @ ..] => contact_sheet::write(&root(), words),
        ["papers", words @ ..] => papers::run(&root(), words),
        ["soak", words @ ..] => soak::run(&root(), words),
        ["dist", words @ ..] => dist::run(&root(), words),
        ["python"] => python::run(&root()),
        ["parquet"] => parquet::run(&root()),
        ["dialects", words @ ..] => dialects::run(&root(), words),
        ["errors", words @ ..] => errors::run_corpus(&root(), words),
        ["fuzz", target, "--runs", runs] => fuzz::run_target(&root(), target, runs, "1"),
        ["fuzz", target, "--runs", runs, "--seed", seed] => fuzz::run_target(&root(), target, runs, seed),
        ["trust", words @ ..] => trust::run(&root(), words),
        ["teaching"] => teaching::run(&root()),
        ["teaching", "--platforms"] => teaching::platforms(&root()),
        ["cluster"] => cluster::run(&root(), 1_000_000),
        ["cluster", points] => match points.parse() {
            Ok(points) => cluster::run(&root(), points),
            Err(_) => Err(anyhow::anyhow!("write a number of points behind `cargo xtask cluster`")),
        },
        ["first-entry"] => first_entry::run(&root()),
        ["bench", parts @ ..] => bench::run(&root(), parts),
        ["help" | "--help" | "-h"] => {
            print!("{USAGE}");
            Ok(())
        }
        _ => {
            eprint!("{USAGE}");
            return ExitCode::from(2);
        }
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(err) => {
            eprintln!("error: {err:#}");
            ExitCode::FAILURE
        }
    }
}
