//! `cargo xtask pictures --sheet`: first screen, drawing and plot of every analysis, side by side.

use std::{fs, path::Path};

use anyhow::{Context, Result, bail, ensure};
use serde::Deserialize;

use crate::cargo::{Program, output, target};

/// The screens of an analysis: their names, and what is typed on the first one.
const SCREENS: [(&str, &str); 3] =
    [("first", ""), ("drawing", "tab Drawing\ntype e\n"), ("plot", "tab Plot\ntype e\n")];
/// Columns and rows of the screens without `--rows` and `--cols`.
const SIZES: [(u16, u16); 2] = [(80, 24), (160, 45)];

/// Choice of sheets.
struct Options<'w> {
    sizes: Vec<(u16, u16)>,
    language: &'w str,
    names: Vec<&'w str>,
}

/// Analysis, as `dalembert list --json` describes it.
#[derive(Deserialize)]
struct Listed {
    id: String,
    title: String,
}

/// Draws the sheets that the words of the command line ask for: a page of HTML for each size, with its pictures beside it.
pub fn write(root: &Path, words: &[&str]) -> Result<()> {
    let options = Options::read(words)?;
    let program = Program::built(root, root)?;
    let listed = output(&mut program.with(&["list", "--json"]))?;
    let mut listed: Vec<Listed> = serde_json::from_str(&listed).context("the list cannot be read")?;
    listed.retain(|one| options.names.is_empty() || options.names.iter().any(|name| one.id.contains(name)));
    ensure!(!listed.is_empty(), "no id contains {}", options.names.join(" or "));
    for (columns, rows) in options.sizes {
        let folder = target(root).join("sheet").join(format!("{columns}x{rows}-{}", options.language));
        fs::create_dir_all(&folder).with_context(|| format!("{} cannot be made", folder.display()))?;
        let setup = format!("screen {columns}x{rows}\nlanguage {}\n", options.language);
        let mut sections = String::new();
        for one in &listed {
            sections += &section(&program, one, &setup, &folder)?;
        }
        let page = folder.join("index.html");
        fs::write(&page, html(&format!("{columns}×{rows}"), &sections))
            .with_context(|| format!("{} cannot be written", page.display()))?;
        println!("written: {}", page.display());
    }
    Ok(())
}

impl<'w> Options<'w> {
    fn read(words: &[&'w str]) -> Result<Self> {
        let (mut rows, mut cols, mut language, mut names) = (None, None, "en", Vec::new());
        let mut words = words.iter();
        while let Some(word) = words.next() {
            let mut value = || words.next().copied().with_context(|| format!("write a value behind {word}"));
            match *word {
                "--rows" => rows = Some(value()?.parse().context("--rows is a number")?),
                "--cols" => cols = Some(value()?.parse().context("--cols is a number")?),
                "--language" => language = value()?,
                option if option.starts_with('-') => bail!("{option} is no option of --sheet"),
                name => names.push(name),
            }
        }
        let sizes = match (cols, rows) {
            (Some(cols), Some(rows)) => vec![(cols, rows)],
            (None, None) => SIZES.to_vec(),
            _ => bail!("write --rows and --cols together"),
        };
        Ok(Self { sizes, language, names })
    }
}

/// The screens of an analysis; one that has no drawing or no plot has none of it here.
fn section(program: &Program, one: &Listed, setup: &str, folder: &Path) -> Result<String> {
    let mut figures = String::new();
    let stem = one.id.replace('/', "+");
    let session = folder.join("session.replay");
    for (screen, typed) in SCREENS {
        let name = format!("{stem}-{screen}");
        let svg = folder.join(format!("{name}.svg"));
        // What an earlier run has left is of another program.
        let _ = fs::remove_file(&svg);
        let short = format!("picture-{screen}");
        fs::write(&session, format!("{setup}open {}\n{typed}picture {short}\n", one.id))?;
        let played = play(program, &session, folder)?;
        if played {
            fs::rename(folder.join(format!("{short}.svg")), &svg)
                .with_context(|| format!("{} is not drawn", svg.display()))?;
            figures += &format!("<img src=\"{name}.svg\" loading=\"lazy\" alt=\"{screen}\">\n");
        }
    }
    fs::remove_file(&session)?;
    Ok(format!("<section><h2>{} <small>{}</small></h2>\n{figures}</section>\n", one.title, one.id))
}

/// Plays a session; says whether it came to its picture.
fn play(program: &Program, session: &Path, folder: &Path) -> Result<bool> {
    let (session, folder) = (session.to_string_lossy(), folder.to_string_lossy());
    let played = program.with(&["replay", &session, "--headless", "--pictures", &folder]).output()?;
    let errors = String::from_utf8_lossy(&played.stderr);
    let has_no_tab = errors.contains("has no tab");
    ensure!(played.status.success() || has_no_tab, "{session}: {errors}");
    Ok(!has_no_tab)
}

fn html(size: &str, sections: &str) -> String {
    format!(
        "<!DOCTYPE html>\n<meta charset=\"utf-8\">\n<title>{size}</title>\n<style>\n\
         body{{background:#333;color:#ddd;font-family:sans-serif;margin:1em}}\n\
         section{{display:grid;grid-template-columns:repeat(3,1fr);gap:.5em;margin-bottom:1.5em}}\n\
         h2{{grid-column:1/-1;font-size:1em;margin:0}}\nsmall{{color:#999}}\nimg{{width:100%}}\n</style>\n{sections}"
    )
}
