//! `dalembert study`

use std::{
    cell::RefCell,
    env,
    ffi::OsString,
    io::IsTerminal as _,
    path::{Path, PathBuf},
    process::ExitCode,
    thread,
    time::Duration,
};

use dalembert_core::{
    FieldError, Locale, Refusal, SolveError, Stop, Text, find,
    study::{Design, Limit, MappedInputs, Sampling, Study, StudyPlan, Summary, Variation},
};
use dalembert_report::{DocumentFormat, json_text, study_document, study_json, text};
use dalembert_study::{
    StudyError, data,
    output::{Run, Shard},
    parquet,
    slurm::Cluster,
    table,
};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::{
    arguments,
    commands::solve,
    console::{Console, print},
    failure::Failure,
    output,
    problem::{self, LoadedProblem, ProblemSource},
    snippet, solving,
};

/// Solves a problem at the points of a plan and prints the summary.
pub(crate) fn run(asked: &arguments::Study, console: &Console) -> Result<ExitCode, Failure> {
    let (plan, folder) = plan(asked, console)?;
    if asked.print_plan {
        let written = toml::to_string(&plan).map_err(|error| Failure::Fault(error.to_string()))?;
        print(&written)?;
        return Ok(ExitCode::SUCCESS);
    }
    let problem = problem_of(&plan, &folder, console)?;
    let errors_of = |errors: Vec<FieldError>| {
        let line = |error: FieldError| {
            let text = Text::new("{subject}: {path}: {why}").with("subject", &asked.subject);
            text.with("path", error.path).with_text("why", error.why)
        };
        Failure::Input(errors.into_iter().map(line).collect())
    };
    // What the plan reads belongs to its fingerprint.
    let texts = RefCell::new(Vec::new());
    let read = |name: &str| {
        let columns = data::read(&folder.join(name))?;
        texts.borrow_mut().push(format!("{columns:?}"));
        Ok(columns)
    };
    let design = Design::new(&plan, &problem.record, &read).map_err(errors_of)?;
    let solution = solve::outcome(&problem)?.map_err(Failure::Refused)?;
    let study = match Study::new(problem.entry, &problem.record, &plan, design, &solution) {
        Err(SolveError::Fields(errors)) => return Err(errors_of(errors)),
        study => study.map_err(|error| failure(error.into()))?,
    };
    let fingerprint = table::fingerprint(&plan, &inputs_of(&problem), &texts.take());
    let mut locale = console.locale.at(problem.entry.about.id);
    locale.style.digits = asked.digits.unwrap_or(locale.style.digits);
    let bar = progress_bar(study.design.points(), &console.locale);
    let (stop, progress) = (Stop::new(), |done| bar.set_position(done));
    let threads = asked.threads.map(|threads| threads as usize);
    let run = Run {
        study: &study,
        fingerprint: &fingerprint,
        threads: threads.unwrap_or_else(|| thread::available_parallelism().map_or(1, usize::from)),
        locale: &locale,
        stop: &stop,
        progress: &progress,
    };
    let summary = carry_out(asked, &run, &problem)?;
    bar.finish_and_clear();
    if asked.json {
        print(&json_text(&study_json(&study, &summary, &locale)))?;
    }
    let document = study_document(&study, &title(&problem, &locale), &summary, &locale);
    match &asked.report {
        Some(path) => report(path, &document, asked, &locale)?,
        None if asked.json => {}
        None => print(&text(&document.map(&|words| console.plain(words)), console.width))?,
    }
    let is_empty = summary.refused == summary.points;
    Ok(if is_empty { ExitCode::from(1) } else { ExitCode::SUCCESS })
}

/// Solves the points: without a table, into one, into a shard of one, or merges shards. The rows of a Parquet table are
/// those of a CSV table until they are whole.
fn carry_out(asked: &arguments::Study, run: &Run<'_>, problem: &LoadedProblem) -> Result<Summary, Failure> {
    let Some(path) = &asked.output else {
        return solving::guarded(problem.entry, || run.summarise())?.map_err(failure);
    };
    let shard = match &asked.shard {
        None => None,
        Some(text) => Some(Shard::read(text).ok_or_else(|| {
            let why = Text::new(
                "--shard {text}: write the number of the part and of all parts, as in --shard 3/16",
            );
            Failure::input(why.with("text", text))
        })?),
    };
    let is_parquet = parquet::is_parquet(path);
    if is_parquet {
        let named = |why| Text::new("{file}: {why}").with("file", path.display()).with_text("why", why);
        parquet::available().map_err(|why| Failure::input(named(why)))?;
    }
    let table = if is_parquet { parquet::rows_of(path) } else { path.clone() };
    let written = shard.map_or_else(|| path.clone(), |shard| shard.path(&table));
    // A shard that is there is done: a job that is sent again costs nothing.
    if shard.is_none() || asked.force {
        output::allowed(&written, Path::new(&asked.subject), asked.force)?;
    }
    if let Some(shards) = asked.slurm {
        let command = command_of_shards();
        let cluster = Cluster { command: &command, table: &table, shards, options: &asked.slurm_option };
        let points = run.study.design.points();
        cluster.run(&|done| (run.progress)(points * done / shards)).map_err(failure)?;
    }
    // Rows of a Parquet table that are whole have not been converted yet.
    let rows = shard.map_or_else(|| table.clone(), |shard| shard.path(&table));
    let is_done = (shard.is_some() || is_parquet) && rows.exists() && !asked.force;
    let solved = if asked.merge || asked.slurm.is_some() {
        run.merge(&table)
    } else if is_done {
        run.read(&rows, shard)
    } else {
        solving::guarded(problem.entry, || run.write(&table, shard))?
    };
    let summary = solved.map_err(failure)?;
    if is_parquet && shard.is_none() {
        parquet::write(run, path).map_err(failure)?;
    }
    Ok(summary)
}

/// The command line without what concerns the cluster, the threads and the summary.
fn command_of_shards() -> Vec<OsString> {
    let mut words = env::args_os().skip(1);
    let mut command: Vec<OsString> = env::current_exe().map(OsString::from).into_iter().collect();
    while let Some(word) = words.next() {
        let text = word.to_string_lossy();
        let (option, has_value) = (text.split('=').next().unwrap_or_default(), text.contains('='));
        match option {
            "--slurm" | "--slurm-option" | "--threads" | "--report" if !has_value => drop(words.next()),
            "--slurm" | "--slurm-option" | "--threads" | "--report" | "--json" | "--force" => {}
            _ => command.push(word),
        }
    }
    command
}

/// The plan: a file, or a problem with the options of the command line; and the folder that its files are in.
fn plan(asked: &arguments::Study, console: &Console) -> Result<(StudyPlan, PathBuf), Failure> {
    let subject = &asked.subject;
    let path = Path::new(subject);
    let mut plan = StudyPlan { problem: subject.clone(), ..StudyPlan::default() };
    let mut folder = PathBuf::new();
    if find(subject).is_none() && (path.exists() || !problem::looks_like_an_id(subject)) {
        let text = problem::text_of(subject)?;
        if is_plan(&text) {
            plan = toml::from_str(&text).map_err(|error| {
                let why = Text::verbatim(error.message());
                Failure::InFile(snippet::show(path, &text, &[(why, error.span())], console))
            })?;
            folder = path.parent().map(Path::to_owned).unwrap_or_default();
        }
    }
    let mut errors = Vec::new();
    for text in &asked.vary {
        match variation(text) {
            Some(variation) => plan.vary.push(variation),
            None => {
                let why = Text::new(
                    "--vary {text}: write an input and its values, as in --vary speed='600..1800 rpm:13', --vary mass='40 kg; 45 kg' or --vary mass='normal(2 %)'",
                );
                errors.push(why.with("text", text));
            }
        }
    }
    for text in &asked.limit {
        match Limit::read(text) {
            Some(limit) => plan.limit.push(limit),
            None => {
                let why = Text::new(
                    "--limit {text}: write an answer and a value, as in --limit 'amplitude > 0.2 mm'",
                );
                errors.push(why.with("text", text));
            }
        }
    }
    for text in &asked.map {
        match text.split_once(',') {
            Some((across, upwards)) => {
                let inputs = [across, upwards].map(|name| name.trim().to_owned());
                plan.map.push(MappedInputs { inputs });
            }
            None => {
                let why = Text::new("--map {text}: write two inputs that vary, as in --map speed,mass");
                errors.push(why.with("text", text));
            }
        }
    }
    if !errors.is_empty() {
        return Err(Failure::Input(errors));
    }
    plan.sobol_indices |= asked.sobol_indices;
    if !asked.answers.is_empty() {
        plan.answers = asked.answers.iter().map(|name| name.trim().to_owned()).collect();
    }
    plan.samples = asked.samples.or(plan.samples);
    plan.seed = asked.seed.unwrap_or(plan.seed);
    plan.sampling = match asked.sampling.as_deref() {
        Some("latin-hypercube") => Sampling::LatinHypercube,
        Some("sobol") => Sampling::Sobol,
        Some(_) => Sampling::MonteCarlo,
        None => plan.sampling,
    };
    Ok((plan, folder))
}

/// Returns true if a text is a plan and no problem: its `problem` is a name.
fn is_plan(text: &str) -> bool {
    text.parse::<toml::Table>().is_ok_and(|table| {
        table.contains_key("vary") || table.get("problem").is_some_and(toml::Value::is_str)
    }) || text.lines().any(|line| line.trim() == "[[vary]]")
}

/// The problem of a plan: an analysis, or a file beside the plan.
fn problem_of(plan: &StudyPlan, folder: &Path, console: &Console) -> Result<LoadedProblem, Failure> {
    let beside = folder.join(&plan.problem);
    let named = match find(&plan.problem) {
        Some(_) => plan.problem.clone(),
        None => beside.to_string_lossy().into_owned(),
    };
    problem::read(&ProblemSource::named(&named), console)
}

/// The inputs of a problem as a text, for the fingerprint of a study.
fn inputs_of(problem: &LoadedProblem) -> String {
    format!("{} {:?} {:?}", problem.entry.about.id, problem.draft, problem.show)
}

fn title(problem: &LoadedProblem, locale: &Locale) -> String {
    let name = problem.name.render(locale);
    if name.is_empty() { Text::from(problem.entry.about.title).render(locale) } else { name }
}

/// Reads `INPUT=VALUES`, or `table(FILE)`.
fn variation(text: &str) -> Option<Variation> {
    match text.split_once('=') {
        Some((input, values)) => Variation::read(Some(input.trim()), values),
        None => Variation::read(None, text),
    }
}

/// A bar with rate and time left on the error stream, where that is a terminal.
fn progress_bar(points: u64, locale: &Locale) -> ProgressBar {
    let target = if std::io::stderr().is_terminal() {
        ProgressDrawTarget::stderr_with_hz(5)
    } else {
        ProgressDrawTarget::hidden()
    };
    let bar = ProgressBar::with_draw_target(Some(points), target);
    let remaining = Text::from("remaining").render(locale);
    let template = format!("{{bar:30}} {{percent}} % · {{per_sec}} · {{eta}} {remaining}");
    if let Ok(style) = ProgressStyle::with_template(&template) {
        bar.set_style(style.progress_chars(if locale.style.ascii { "##-" } else { "██░" }));
    }
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}

/// Writes the summary as a report, with its figures beside it where the format has none of its own.
fn report(
    path: &Path,
    document: &dalembert_report::Document,
    asked: &arguments::Study,
    locale: &Locale,
) -> Result<(), Failure> {
    let format = DocumentFormat::of(path).unwrap_or(DocumentFormat::Text);
    let files = match format.files(document, path, locale) {
        Some(files) => files.into_iter().map(|(name, text)| (path.with_file_name(name), text)).collect(),
        None => vec![(path.to_owned(), text(document, 100))],
    };
    for (file, _) in &files {
        output::allowed(file, Path::new(&asked.subject), asked.force)?;
    }
    for (file, text) in &files {
        output::write(file, text, asked.force)?;
    }
    Ok(())
}

fn failure(error: StudyError) -> Failure {
    match error {
        StudyError::Solve(SolveError::Refused(Refusal::NoAnswer(why))) => Failure::Refused(why),
        other => Failure::input(other.text()),
    }
}
