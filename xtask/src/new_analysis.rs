//! `cargo xtask new-analysis FAMILY NAME --topic TOPIC`: a small analysis that works, as a place to begin.

use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
};

use anyhow::{Context, Result, bail};

use crate::{
    cargo::format,
    names::{check_kebab, is_slip, nearest, pascal, snake, snake_of, title},
};

const ANALYSIS: &str = include_str!("new_analysis/analysis.rs");
const CASES: &str = include_str!("new_analysis/cases.toml");
const PORTUGUESE: &str = include_str!("new_analysis/pt-BR.ftl");
/// The file of the sections of the theory that derive what analyses compute.
pub(crate) const DERIVATIONS: &str = "docs/theory/derivations.toml";
/// The section of the theory that derives what the template computes.
const SECTION: &str = "\"one-degree-of-freedom#viscous-damping\" = [\"\"]";

/// Writes the analysis, its cases, one line of its topic and the translations of its sentences. A topic that the family
/// has not is begun with it.
///
/// # Errors
/// A name that is none or is taken, an unknown family, no topic; nothing is written then.
pub fn run(root: &Path, family: &str, name: &str, topic: Option<&str>) -> Result<()> {
    check_kebab(name)?;
    let families = families(root)?;
    if !families.iter().any(|known| known == family) {
        let hint =
            nearest(family, &families).map(|near| format!("; did you mean `{near}`?")).unwrap_or_default();
        bail!("there is no family `{family}`{hint} (`cargo xtask new-plugin` begins one)");
    }
    let file = snake(name);
    let folder = root.join("plugins").join(family);
    let topic = chosen(topic, &topics(&folder.join("src"))?)?;
    let within = folder.join("src").join(snake_of(&topic));
    let source = within.join(&file).with_extension("rs");
    let cases = folder.join("cases").join(&file).with_extension("toml");
    for taken in [&source, &cases, &source.with_extension("")] {
        if taken.exists() {
            bail!("`{name}` is taken: there is {}", below(root, taken));
        }
    }
    if is_keyword(&file) || ["lib", "sources"].contains(&file.as_str()) {
        bail!("`{name}` cannot name a file of Rust code; take another word");
    }
    let mut changed = Vec::new();
    let face = within.with_extension("rs");
    if face.exists() {
        changed.push((face.clone(), with_module(&read(&face)?, &file)));
    } else {
        let library = folder.join("src/lib.rs");
        changed.push((library.clone(), with_module(&read(&library)?, &snake_of(&topic))));
        changed.push((face, format!("//! {topic}.\n\npub mod {file};\n")));
    }
    let translations = folder.join("locales/pt-BR.ftl");
    changed.push((translations.clone(), with_translations(root, &translations, name, &topic)?));
    let derivations = root.join(DERIVATIONS);
    let derived = with_derivation(&read(&derivations)?, &format!("{family}/{name}"));
    changed.push((derivations, derived));
    write(&source, &filled(ANALYSIS, family, name, &topic))?;
    format(&source);
    write(&cases, CASES)?;
    println!("written: {}, {}", below(root, &source), below(root, &cases));
    for (path, text) in changed {
        write(&path, &text)?;
        println!("changed: {}", below(root, &path));
    }
    println!("look at it: cargo run -- solve {family}/{name}");
    println!("then write it into the reference: cargo xtask docs");
    Ok(())
}

/// The topics of a family, as the first line of the file of each names them, sorted.
fn topics(sources: &Path) -> Result<Vec<String>> {
    let mut topics = Vec::new();
    for entry in fs::read_dir(sources).with_context(|| format!("{} cannot be read", sources.display()))? {
        let path = entry?.path();
        if path.is_dir() && !path.ends_with("shared") {
            let text = read(&path.with_extension("rs"))?;
            let heading = text.lines().next().and_then(|line| line.strip_prefix("//! "));
            topics.extend(heading.map(|heading| heading.trim_end_matches('.').to_owned()));
        }
    }
    topics.sort();
    Ok(topics)
}

/// The topic that an analysis will stand under: one of the family's, or a new one that is no slip for one of those.
fn chosen(asked: Option<&str>, known: &[String]) -> Result<String> {
    let list = match known {
        [] => "the family has none yet".to_owned(),
        known => format!(
            "the family has {}",
            known.iter().map(|topic| format!("\"{topic}\"")).collect::<Vec<_>>().join(", ")
        ),
    };
    let Some(asked) = asked else { bail!("say the topic, with `--topic \"…\"`: {list}") };
    let file = snake_of(asked);
    if let Some(topic) = known.iter().find(|topic| snake_of(topic) == file) {
        return Ok(topic.clone());
    }
    if let Some(near) = known.iter().find(|topic| is_slip(&snake_of(topic), &file)) {
        bail!("there is no topic \"{asked}\"; did you mean \"{near}\"?");
    }
    let is_plain = |c: char| c.is_ascii_alphabetic() || c == ' ' || c == ',';
    let is_named = asked.starts_with(|c: char| c.is_ascii_uppercase()) && asked.chars().all(is_plain);
    if !is_named || is_keyword(&file) || ["lib", "shared", "sources"].contains(&file.as_str()) {
        bail!("\"{asked}\" cannot be a topic: write words like \"Shock and impact\"; {list}");
    }
    Ok(asked.to_owned())
}

/// The families there are: the folders of plugins but for the bundle, sorted.
pub(crate) fn families(root: &Path) -> Result<Vec<String>> {
    let plugins = root.join("plugins");
    let mut names = Vec::new();
    for entry in fs::read_dir(&plugins).with_context(|| format!("{} cannot be read", plugins.display()))? {
        let path = entry?.path();
        if path.join("src/lib.rs").is_file() && !path.ends_with("bundle") {
            names.extend(path.file_name().map(|name| name.to_string_lossy().into_owned()));
        }
    }
    names.sort();
    Ok(names)
}

pub(crate) fn read(path: &Path) -> Result<String> {
    fs::read_to_string(path).with_context(|| format!("{} cannot be read", path.display()))
}

/// Writes a file, its folder included.
pub(crate) fn write(path: &Path, text: &str) -> Result<()> {
    let cannot = || format!("{} cannot be written", path.display());
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).with_context(cannot)?;
    }
    fs::write(path, text).with_context(cannot)
}

/// A path as a user in the root writes it.
pub(crate) fn below(root: &Path, path: &Path) -> String {
    path.strip_prefix(root).unwrap_or(path).display().to_string()
}

/// Returns true if a name is a keyword and cannot be a module.
pub(crate) fn is_keyword(name: &str) -> bool {
    const KEYWORDS: &str = " abstract as async await become box break const continue crate do dyn else enum extern \
        false final fn for gen if impl in let loop macro match mod move mut override priv pub ref return self static \
        struct super trait true try type typeof unsafe unsized use virtual where while yield ";
    KEYWORDS.contains(&format!(" {name} "))
}

/// The template with its names filled in.
fn filled(template: &str, family: &str, name: &str, topic: &str) -> String {
    template
        .replace("Topic of it", topic)
        .replace("family/analysis-name", &format!("{family}/{name}"))
        .replace("AnalysisName", &pascal(name))
        .replace("analysis_name", &snake(name))
        .replace("Analysis name", &title(name))
}

/// A file with `pub mod name;` among its modules, in their order.
fn with_module(text: &str, file: &str) -> String {
    let line = format!("pub mod {file};");
    let mut lines: Vec<&str> = text.lines().collect();
    let modules: Vec<usize> = (0..lines.len()).filter(|n| lines[*n].starts_with("pub mod ")).collect();
    let at = match (modules.iter().find(|n| lines[**n] > line.as_str()), modules.last()) {
        (Some(after), _) => *after,
        (None, Some(last)) => last + 1,
        // Below the documentation.
        (None, None) => {
            let start = lines.iter().position(|line| !line.starts_with("//!")).unwrap_or(lines.len());
            lines.insert(start, "");
            start + 1
        }
    };
    lines.insert(at, &line);
    lines.join("\n") + "\n"
}

/// The sections of the theory with that of the template, in the order of the analyses.
fn with_derivation(text: &str, id: &str) -> String {
    let heading = format!("[\"{id}\"]");
    let at = text.lines().position(|line| line.starts_with("[\"") && line > heading.as_str());
    let mut lines: Vec<&str> = text.trim_end().lines().collect();
    let table = [heading.as_str(), SECTION, ""];
    match at {
        Some(at) => drop(lines.splice(at..at, table)),
        None => lines.extend(["", &heading, SECTION]),
    }
    lines.join("\n") + "\n"
}

/// The translations of a family with those sentences of the template that it lacks. Where the family has other words
/// for a sentence, those of the template are for the new analysis alone; those of the program hold everywhere.
fn with_translations(root: &Path, translations: &Path, name: &str, topic: &str) -> Result<String> {
    let own = read(translations)?;
    let mut program: BTreeMap<String, String> = BTreeMap::new();
    for path in translation_files(&root.join("crates"))? {
        let text = read(&path)?;
        let messages = text.lines().filter_map(|line| line.split_once(" = "));
        program.extend(messages.map(|(key, words)| (key.to_owned(), words.to_owned())));
    }
    let mut lines: Vec<String> = own.lines().map(str::to_owned).collect();
    let mut added = String::new();
    let portuguese = PORTUGUESE
        .replace("analysis-name", name)
        .replace("Analysis name", &title(name))
        .replace("topic-of-it", &snake_of(topic).replace('_', "-"))
        .replace("Topic of it", topic);
    for line in portuguese.lines() {
        let Some((key, words)) = line.split_once(" = ") else { continue };
        let words = program.get(key).map_or(words, String::as_str);
        let known = |line: &String| line.split_once(" = ").is_some_and(|(have, _)| have == key);
        match lines.iter().position(known) {
            None => added += &format!("{key} = {words}\n"),
            Some(at) if lines[at] != line && !program.contains_key(key) => {
                lines.insert(at + 1, format!("    .{name} = {words}"));
            }
            Some(_) => {}
        }
    }
    Ok(format!("{}\n\n# {}\n{added}", lines.join("\n").trim_end(), title(name)))
}

/// Every file of translations of the packages in a folder.
pub(crate) fn translation_files(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).with_context(|| format!("{} cannot be read", folder.display()))? {
        let Ok(locales) = fs::read_dir(entry?.path().join("locales")) else { continue };
        for file in locales {
            found.push(file?.path());
        }
    }
    found.retain(|path| path.extension().is_some_and(|ending| ending == "ftl"));
    found.sort();
    Ok(found)
}

#[cfg(test)]
mod tests;
