//! `cargo xtask new-analysis FAMILY NAME`: a small analysis that works, as a place to begin.

use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
};

use anyhow::{Context, Result, bail};

use crate::{
    cargo::format,
    names::{check_kebab, nearest, pascal, snake, title},
};

const ANALYSIS: &str = include_str!("new_analysis/analysis.rs");
const CASES: &str = include_str!("new_analysis/cases.toml");
const PORTUGUESE: &str = include_str!("new_analysis/pt-BR.ftl");

/// Writes the analysis, its cases, one line of `lib.rs` and the translations of its sentences.
///
/// # Errors
/// A name that is none or is taken, an unknown family; nothing is written then.
pub fn run(root: &Path, family: &str, name: &str) -> Result<()> {
    check_kebab(name)?;
    let families = families(root)?;
    if !families.iter().any(|known| known == family) {
        let hint =
            nearest(family, &families).map(|near| format!("; did you mean `{near}`?")).unwrap_or_default();
        bail!("there is no family `{family}`{hint} (`cargo xtask new-plugin` begins one)");
    }
    let file = snake(name);
    let folder = root.join("plugins").join(family);
    let source = folder.join("src").join(&file).with_extension("rs");
    let cases = folder.join("cases").join(&file).with_extension("toml");
    for taken in [&source, &cases, &source.with_extension("")] {
        if taken.exists() {
            bail!("`{name}` is taken: there is {}", below(root, taken));
        }
    }
    if is_keyword(&file) || ["lib", "sources"].contains(&file.as_str()) {
        bail!("`{name}` cannot name a file of Rust code; take another word");
    }
    let library = folder.join("src/lib.rs");
    let library_text = with_module(&read(&library)?, &file);
    let translations = folder.join("locales/pt-BR.ftl");
    let translations_text = with_translations(root, &translations, name)?;
    write(&source, &filled(ANALYSIS, family, name))?;
    format(&source);
    write(&cases, CASES)?;
    write(&library, &library_text)?;
    write(&translations, &translations_text)?;
    println!("written: {}, {}", below(root, &source), below(root, &cases));
    println!("changed: {}, {}", below(root, &library), below(root, &translations));
    println!("run it: cargo run -- solve {family}/{name}");
    println!("then write it into the reference: cargo xtask docs");
    Ok(())
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
fn filled(template: &str, family: &str, name: &str) -> String {
    template
        .replace("family/analysis-name", &format!("{family}/{name}"))
        .replace("AnalysisName", &pascal(name))
        .replace("analysis_name", &snake(name))
        .replace("Analysis name", &title(name))
}

/// The library with `pub mod name;` among its modules, in their order.
fn with_module(library: &str, file: &str) -> String {
    let line = format!("pub mod {file};");
    let mut lines: Vec<&str> = library.lines().collect();
    let modules: Vec<usize> = (0..lines.len()).filter(|n| lines[*n].starts_with("pub mod ")).collect();
    let at = match (modules.iter().find(|n| lines[**n] > line.as_str()), modules.last()) {
        (Some(after), _) => *after,
        (None, Some(last)) => last + 1,
        // Below the documentation of the library.
        (None, None) => {
            let start = lines.iter().position(|line| !line.starts_with("//!")).unwrap_or(lines.len());
            lines.insert(start, "");
            start + 1
        }
    };
    lines.insert(at, &line);
    lines.join("\n") + "\n"
}

/// The translations of a family with those sentences of the template that it lacks. Where the family has other words
/// for a sentence, those of the template are for the new analysis alone; those of the program hold everywhere.
fn with_translations(root: &Path, translations: &Path, name: &str) -> Result<String> {
    let own = read(translations)?;
    let mut program: BTreeMap<String, String> = BTreeMap::new();
    for path in translation_files(&root.join("crates"))? {
        let text = read(&path)?;
        let messages = text.lines().filter_map(|line| line.split_once(" = "));
        program.extend(messages.map(|(key, words)| (key.to_owned(), words.to_owned())));
    }
    let mut lines: Vec<String> = own.lines().map(str::to_owned).collect();
    let mut added = String::new();
    for line in PORTUGUESE.replace("analysis-name", name).replace("Analysis name", &title(name)).lines() {
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
