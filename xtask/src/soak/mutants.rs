//! `cargo xtask soak mutants`: the result of each function of `mechanics` times 1.01, one after the other, with
//! `dalembert verify` as the judge. A function whose mutant passes is seen by no answer of the catalogue.

use std::{
    fmt::Write as _,
    fs,
    path::{Path, PathBuf},
    process::{Command, Stdio},
    sync::{
        Mutex,
        atomic::{AtomicUsize, Ordering},
    },
    thread,
};

use anyhow::{Context, Result, bail, ensure};
use proc_macro2::{LineColumn, Span};
use syn::{
    Attribute, Block, Generics, ImplItemFn, ItemFn, ItemImpl, ItemMod, Path as SynPath, ReturnType,
    Signature, Type, TypeParamBound, WherePredicate, visit::Visit,
};

use crate::cargo::{cargo, copy_tracked, run, target};

/// The variable that names the function to be mutated, from 1; without it, or with 0, none is.
const VARIABLE: &str = "DALEMBERT_MUTANT";
/// The share of noticed mutants below which the command fails.
const WANTED: f64 = 0.95;
/// Number types and their operations are no formulas.
const LEFT_OUT: [&str; 2] = ["real.rs", "lanes.rs"];

/// Takes its place in the copy of `mechanics`.
const SWITCH: &str = "
/// Returns true if this function's result is to be wrong by 1 %.
#[doc(hidden)]
#[inline]
pub fn mutated(id: u32) -> bool {
    static CHOSEN: std::sync::OnceLock<u32> = std::sync::OnceLock::new();
    *CHOSEN.get_or_init(|| {
        std::env::var(\"DALEMBERT_MUTANT\").ok().and_then(|id| id.parse().ok()).unwrap_or(0)
    }) == id
}
";

/// Functions whose result changes no answer when it is 1 % larger, and why: `file | function | why`.
const EQUIVALENT: &str = include_str!("equivalent.txt");

/// A function that returns one number.
struct Mutant {
    name: String,
    /// Below the sources of mechanics.
    file: String,
    line: usize,
}

/// Builds the mutated program, judges each mutant, and prints the survivors.
pub(super) fn soak(root: &Path) -> Result<()> {
    let folder = target(root).join("soak");
    let tree = folder.join("mutants");
    copy_tracked(root, &tree)?;
    let mutants = mutate(&tree.join("crates/mechanics/src"))?;
    ensure!(!mutants.is_empty(), "no function of mechanics returns a number");
    println!("building the program with {} mutants", mutants.len());
    let built = folder.join("build");
    run(cargo(&tree)
        .args(["build", "--quiet", "--release", "--package", "dalembert"])
        .env("CARGO_TARGET_DIR", &built)
        // Built once, run some hundred times for half a second.
        .env("CARGO_PROFILE_RELEASE_LTO", "off")
        .env("CARGO_PROFILE_RELEASE_CODEGEN_UNITS", "16")
        .env("RUSTFLAGS", "-Awarnings"))?;
    let program = built.join("release").join(format!("dalembert{}", std::env::consts::EXE_SUFFIX));
    ensure!(passes(&program, 0)?, "the catalogue does not pass without a mutant");
    let judged = judged(&program, mutants.len())?;
    let reported = reported(&mutants, &judged, EQUIVALENT)?;
    print!("{}", reported.text);
    ensure!(reported.share >= WANTED, "at least {} % are wanted", 100.0 * WANTED);
    ensure!(
        reported.stale.is_empty(),
        "listed as equivalent, but noticed or not there: {}",
        reported.stale.join(", ")
    );
    Ok(())
}

/// Result of the mutation run.
struct Report {
    text: String,
    /// Of the mutants that are not equivalent, those that were noticed.
    share: f64,
    /// Rows of the list of equivalent mutants that are none.
    stale: Vec<String>,
}

/// Weighs the survivors, given by their numbers from 1, against the list of equivalent mutants.
fn reported(mutants: &[Mutant], survivors: &[usize], equivalent: &str) -> Result<Report> {
    let rows = equivalent.lines().filter(|line| !line.is_empty() && !line.starts_with('#'));
    let mut listed: Vec<([&str; 2], &str, usize)> = Vec::new();
    for row in rows {
        let parts: Vec<&str> = row.split(" | ").collect();
        let [file, name, why] = parts[..] else { bail!("`{row}` is not `file | function | why`") };
        listed.push(([file, name], why, 0));
    }
    let mut text = String::new();
    let (mut missed, mut spared) = (0, 0);
    for id in survivors {
        let Mutant { name, file, line } = &mutants[id - 1];
        let place = format!("{name}  crates/mechanics/src/{file}:{line}");
        if let Some((_, why, met)) = listed.iter_mut().find(|(of, ..)| *of == [file, name]) {
            *met += 1;
            spared += 1;
            writeln!(text, "equivalent ({why}): {place}")?;
        } else {
            missed += 1;
            writeln!(text, "not noticed: {place}")?;
        }
    }
    let counted = mutants.len() - spared;
    let share = (counted - missed) as f64 / counted as f64;
    let all = mutants.len();
    let noticed = counted - missed;
    writeln!(
        text,
        "{all} mutants, {spared} equivalent; {noticed} of {counted} noticed ({:.1} %)",
        100.0 * share
    )?;
    let stale = listed.iter().filter(|(.., met)| *met == 0);
    let stale = stale.map(|([file, name], ..)| format!("{file} {name}")).collect();
    Ok(Report { text, share, stale })
}

/// The numbers, from 1, of the mutants that the catalogue lets pass.
fn judged(program: &Path, mutants: usize) -> Result<Vec<usize>> {
    let (next, survivors) = (AtomicUsize::new(1), Mutex::new(Vec::new()));
    let threads = thread::available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| {
        let judges: Vec<_> = (0..threads)
            .map(|_| {
                scope.spawn(|| {
                    loop {
                        let id = next.fetch_add(1, Ordering::Relaxed);
                        if id > mutants {
                            return Ok(());
                        }
                        if passes(program, id)? {
                            survivors.lock().expect("no judge panics with the list").push(id);
                        }
                    }
                })
            })
            .collect();
        judges.into_iter().try_for_each(|judge| judge.join().expect("a judge does not panic"))
    })
    .map_err(|error: anyhow::Error| error)?;
    let mut survivors = survivors.into_inner().expect("no judge panics with the list");
    survivors.sort_unstable();
    Ok(survivors)
}

/// Returns true if the catalogue passes with this mutant.
fn passes(program: &Path, mutant: usize) -> Result<bool> {
    let mut command = Command::new(program);
    command.arg("verify").env(VARIABLE, mutant.to_string()).stdout(Stdio::null()).stderr(Stdio::null());
    let mut judge = command.spawn().context("the mutated program cannot be run")?;
    // A mutant may send an iteration round for ever: that is noticed too.
    for _ in 0..600 {
        if let Some(status) = judge.try_wait()? {
            return Ok(status.success());
        }
        thread::sleep(std::time::Duration::from_millis(100));
    }
    judge.kill()?;
    judge.wait()?;
    Ok(false)
}

/// Rewrites every source below `sources`, and lists the functions that can be mutated now.
fn mutate(sources: &Path) -> Result<Vec<Mutant>> {
    let mut files = Vec::new();
    walk(sources, &mut files)?;
    files.sort();
    let mut mutants = Vec::new();
    for file in files {
        let name = file.strip_prefix(sources).unwrap_or(&file).display().to_string();
        if LEFT_OUT.contains(&name.as_str()) || name.contains("tests") {
            continue;
        }
        let text = fs::read_to_string(&file)?;
        let parsed = syn::parse_file(&text).with_context(|| format!("{name} cannot be parsed"))?;
        let mut found = Finder { generics: Vec::new(), found: Vec::new() };
        found.visit_file(&parsed);
        let rewritten = rewrite(&text, &found.found, mutants.len() + 1);
        for function in &found.found {
            mutants.push(Mutant {
                name: function.name.clone(),
                file: name.clone(),
                line: function.open.line,
            });
        }
        fs::write(&file, rewritten)?;
    }
    let library = sources.join("lib.rs");
    let text = fs::read_to_string(&library)?;
    fs::write(library, text + SWITCH)?;
    Ok(mutants)
}

fn walk(folder: &Path, files: &mut Vec<PathBuf>) -> Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            walk(&path, files)?;
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    Ok(())
}

/// The text with the body of each function in a closure whose result is multiplied when the function is chosen.
fn rewrite(text: &str, functions: &[Function], first: usize) -> String {
    let mut insertions: Vec<(usize, String)> = Vec::new();
    for (n, function) in functions.iter().enumerate() {
        let result = &function.result;
        insertions.push((offset(text, function.open) + 1, format!(" let result = (move || -> {result} {{")));
        let mut close = String::new();
        let id = first + n;
        let _ = write!(close, "}})(); if crate::mutated({id}) {{ result * 1.01 }} else {{ result }} ");
        insertions.push((offset(text, function.close) - 1, close));
    }
    insertions.sort_by_key(|(at, _)| std::cmp::Reverse(*at));
    let mut text = text.to_owned();
    for (at, inserted) in insertions {
        text.insert_str(at, &inserted);
    }
    text
}

fn offset(text: &str, place: LineColumn) -> usize {
    let line: usize = text.split_inclusive('\n').take(place.line - 1).map(str::len).sum();
    let rest = &text[line..];
    line + rest.char_indices().nth(place.column).map_or(rest.len(), |(at, _)| at)
}

struct Function {
    name: String,
    result: String,
    /// Position of the opening brace of its body, and after the closing one.
    open: LineColumn,
    close: LineColumn,
}

/// Finds the functions that return `f64` or a number generic over `Real`.
struct Finder {
    /// The type parameters over `Real` of the blocks around.
    generics: Vec<Vec<String>>,
    found: Vec<Function>,
}

impl Finder {
    fn function(&mut self, attributes: &[Attribute], signature: &Signature, block: &Block) {
        if signature.constness.is_some() || is_test(attributes) {
            return;
        }
        let ReturnType::Type(_, result) = &signature.output else { return };
        let Type::Path(result) = &**result else { return };
        let Some(result) = result.path.get_ident().map(ToString::to_string) else { return };
        let own = reals(&signature.generics);
        let is_number = result == "f64"
            || own.contains(&result)
            || self.generics.iter().flatten().any(|of| *of == result);
        if !is_number {
            return;
        }
        let span: Span = block.brace_token.span.join();
        let name = signature.ident.to_string();
        self.found.push(Function { name, result, open: span.start(), close: span.end() });
    }
}

impl<'ast> Visit<'ast> for Finder {
    fn visit_item_mod(&mut self, item: &'ast ItemMod) {
        if !is_test(&item.attrs) {
            syn::visit::visit_item_mod(self, item);
        }
    }

    fn visit_item_fn(&mut self, item: &'ast ItemFn) {
        self.function(&item.attrs, &item.sig, &item.block);
    }

    fn visit_item_impl(&mut self, item: &'ast ItemImpl) {
        self.generics.push(reals(&item.generics));
        syn::visit::visit_item_impl(self, item);
        self.generics.pop();
    }

    fn visit_impl_item_fn(&mut self, item: &'ast ImplItemFn) {
        self.function(&item.attrs, &item.sig, &item.block);
    }
}

fn is_test(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().is_ident("test")
            || attribute.path().is_ident("cfg")
                && attribute.parse_args::<SynPath>().is_ok_and(|of| of.is_ident("test"))
    })
}

/// The type parameters that are bound by `Real`.
fn reals(generics: &Generics) -> Vec<String> {
    fn is_real<'a>(bounds: impl IntoIterator<Item = &'a TypeParamBound>) -> bool {
        bounds.into_iter().any(|bound| match bound {
            TypeParamBound::Trait(of) => of.path.segments.last().is_some_and(|last| last.ident == "Real"),
            _ => false,
        })
    }
    let mut found: Vec<String> = generics
        .type_params()
        .filter(|parameter| is_real(&parameter.bounds))
        .map(|parameter| parameter.ident.to_string())
        .collect();
    for predicate in generics.where_clause.iter().flat_map(|of| &of.predicates) {
        if let WherePredicate::Type(of) = predicate
            && let Type::Path(path) = &of.bounded_ty
            && let Some(ident) = path.path.get_ident()
            && is_real(&of.bounds)
        {
            found.push(ident.to_string());
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equivalent_mutants_do_not_count_and_are_survivors() {
        let mutant = |name: &str| Mutant { name: name.to_owned(), file: "a.rs".to_owned(), line: 1 };
        let mutants = ["force", "size", "mass", "root"].map(mutant);
        let list = "# file | function | why\na.rs | size | size\n";
        let some = reported(&mutants, &[2, 3], list).unwrap();
        assert!((some.share - 2.0 / 3.0).abs() < 1e-15 && some.stale.is_empty(), "{}", some.text);
        assert!(some.text.contains("not noticed: mass  crates/mechanics/src/a.rs:1"), "{}", some.text);
        assert_eq!(reported(&mutants, &[3], list).unwrap().stale, ["a.rs size"]);
        assert!(reported(&mutants, &[], "a.rs size").is_err());
    }

    #[test]
    fn functions_that_return_one_number_are_mutated() {
        let source = "
pub fn force<S: Real>(mass: S) -> S { mass * 9.81 }
pub fn root(x: f64) -> f64 {
    // Äther: columns count characters.
    if x < 0.0 { return 0.0; }
    x.sqrt()
}
pub fn count() -> usize { 3 }
struct Pair<S>(S);
impl<S: Real> Pair<S> { pub fn first(self) -> S { self.0 } pub fn both(self) -> Vec<S> { vec![] } }
#[cfg(test)]
mod tests { fn helper() -> f64 { 1.0 } }
";
        let mut found = Finder { generics: Vec::new(), found: Vec::new() };
        found.visit_file(&syn::parse_file(source).unwrap());
        let names: Vec<&str> = found.found.iter().map(|function| function.name.as_str()).collect();
        assert_eq!(names, ["force", "root", "first"]);
        let text = rewrite(source, &found.found, 7);
        let force = "pub fn force<S: Real>(mass: S) -> S { let result = (move || -> S { mass * 9.81 })(); \
                     if crate::mutated(7) { result * 1.01 } else { result } }";
        assert!(text.contains(force), "{text}");
        assert!(syn::parse_file(&text).is_ok(), "{text}");
    }
}
