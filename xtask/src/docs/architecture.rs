//! `docs/architecture.svg`: the packages of the tree and what each is built on, from their manifests.
//!
//! A package stands one row below the lowest of those that depend on it, so that lines are short. A line that others imply is left out: where a package
//! depends on another through a third one, the lines go through the third.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::Path,
};

use anyhow::{Context, Result};
use toml::Table;

use super::escaped;

/// Path of the picture.
const PICTURE: &str = "docs/architecture.svg";
/// Size of a box and the space between boxes, in pixels.
const BOX: [usize; 2] = [236, 92];
const SPACE: [usize; 2] = [22, 56];
/// Characters of a description in a line of its box.
const LINE: usize = 34;
/// Folders that hold packages, and those that are one.
const HOLDING: [&str; 2] = ["crates", "plugins"];
const SINGLE: [&str; 4] = ["tests", "xtask", "python", "examples/out-of-tree"];

/// A package of the tree.
struct Package {
    folder: String,
    description: String,
    /// Folders of the packages that it depends on, without those of its tests.
    below: BTreeSet<String>,
}

/// Package, or line between packages that goes through a row.
struct Item {
    package: Option<usize>,
    /// The items of the next row that it is joined to.
    below: Vec<usize>,
    /// Left end and width.
    place: [usize; 2],
}

impl Item {
    fn middle(&self) -> usize {
        self.place[0] + self.place[1] / 2
    }
}

/// Path and text of the picture.
///
/// # Errors
/// A manifest that cannot be read, or a dependency on a package that is not in the tree.
pub(super) fn picture(root: &Path) -> Result<(String, String)> {
    let packages = packages(root)?;
    let (mut items, mut rows) = rows(&without_implied(&packages));
    let wide = |row: &Vec<usize>, items: &[Item]| {
        row.iter().map(|item| items[*item].place[1] + SPACE[0]).sum::<usize>()
    };
    let width = rows.iter().map(|row| wide(row, &items)).max().unwrap_or_default() + SPACE[0];
    for row in rows.iter_mut().rev() {
        // An item stands as near to the middle of what it is joined to as the others let it.
        row.sort_by_key(|item| (mean(items[*item].below.iter().map(|below| items[*below].middle())), *item));
        let mut left = SPACE[0] + (width - SPACE[0] - wide(row, &items)) / 2;
        for item in row.iter() {
            items[*item].place[0] = left;
            left += items[*item].place[1] + SPACE[0];
        }
    }
    Ok((PICTURE.to_owned(), drawn(width, &packages, &items, &rows)))
}

/// Packages and lines in rows, from the top.
fn rows(direct: &[Vec<usize>]) -> (Vec<Item>, Vec<Vec<usize>>) {
    let levels: Vec<usize> = (0..direct.len()).map(|package| row(direct, package)).collect();
    let mut rows = vec![Vec::new(); levels.iter().max().map_or(0, |last| last + 1)];
    let mut items: Vec<Item> = Vec::new();
    for (package, level) in levels.iter().enumerate() {
        rows[*level].push(package);
        items.push(Item { package: Some(package), below: Vec::new(), place: [0, BOX[0]] });
    }
    for (package, below) in direct.iter().enumerate() {
        for other in below {
            let mut end = package;
            for row in rows.iter_mut().take(levels[*other]).skip(levels[package] + 1) {
                let through = items.len();
                row.push(through);
                items.push(Item { package: None, below: Vec::new(), place: [0, 0] });
                items[end].below.push(through);
                end = through;
            }
            items[end].below.push(*other);
        }
    }
    (items, rows)
}

/// The packages and what they depend on; the families of analyses are one.
fn packages(root: &Path) -> Result<Vec<Package>> {
    let mut folders: Vec<String> = SINGLE.map(str::to_owned).to_vec();
    for group in HOLDING {
        for entry in fs::read_dir(root.join(group)).with_context(|| format!("{group} cannot be read"))? {
            folders.push(format!("{group}/{}", entry?.file_name().to_string_lossy()));
        }
    }
    folders.sort();
    let mut read: BTreeMap<String, (String, String, Vec<String>)> = BTreeMap::new();
    for folder in folders {
        let path = root.join(&folder).join("Cargo.toml");
        let text = fs::read_to_string(&path).with_context(|| format!("{} cannot be read", path.display()))?;
        let manifest: Table = text.parse().with_context(|| format!("{} is no TOML", path.display()))?;
        let text = |key: &str| manifest["package"].get(key).and_then(toml::Value::as_str).unwrap_or_default();
        let dependencies = manifest.get("dependencies").and_then(toml::Value::as_table);
        let names = dependencies.into_iter().flat_map(|all| all.keys().cloned()).collect();
        read.insert(text("name").to_owned(), (shown(&folder), text("description").to_owned(), names));
    }
    let folder_of = |name: &String| read.get(name).map(|(folder, ..)| folder.clone());
    let mut packages: BTreeMap<&str, Package> = BTreeMap::new();
    for (folder, description, names) in read.values() {
        let below = names.iter().filter_map(folder_of).filter(|below| below != folder).collect();
        let description = match folder.as_str() {
            FAMILIES => {
                "The analyses, one file each: virtual work, balancing, rigid-body dynamics, vibration."
            }
            "examples/out-of-tree" => "A program of a laboratory with an analysis of its own.",
            _ => description,
        };
        let package = Package { folder: folder.clone(), description: description.to_owned(), below };
        packages.entry(folder).and_modify(|one| one.below.extend(package.below.clone())).or_insert(package);
    }
    Ok(packages.into_values().collect())
}

/// Name of the families together.
const FAMILIES: &str = "plugins/<family>";

/// Folder of a package as the picture names it.
fn shown(folder: &str) -> String {
    let family = folder.starts_with("plugins/") && folder != "plugins/bundle";
    if family { FAMILIES } else { folder }.to_owned()
}

/// For each package the places of those it depends on and reaches through no other.
fn without_implied(packages: &[Package]) -> Vec<Vec<usize>> {
    let place = |folder: &String| packages.iter().position(|package| package.folder == *folder);
    let below: Vec<Vec<usize>> =
        packages.iter().map(|package| package.below.iter().filter_map(place).collect()).collect();
    let implied =
        |package: usize, other: usize| below[package].iter().any(|through| reaches(&below, *through, other));
    let direct = |package: usize| {
        below[package].iter().copied().filter(move |other| !implied(package, *other)).collect()
    };
    (0..packages.len()).map(direct).collect()
}

/// Returns true if a package depends on another one, directly or through others.
fn reaches(below: &[Vec<usize>], package: usize, other: usize) -> bool {
    below[package].iter().any(|next| *next == other || reaches(below, *next, other))
}

/// Row of a package, counted from the top.
fn row(direct: &[Vec<usize>], package: usize) -> usize {
    let above = (0..direct.len()).filter(|other| direct[*other].contains(&package));
    above.map(|above| row(direct, above) + 1).max().unwrap_or_default()
}

fn mean(values: impl Iterator<Item = usize>) -> usize {
    let (count, sum) = values.fold((0, 0), |(count, sum), value| (count + 1, sum + value));
    sum.checked_div(count).unwrap_or_default()
}

/// The SVG document.
fn drawn(width: usize, packages: &[Package], items: &[Item], rows: &[Vec<usize>]) -> String {
    let height = rows.len() * (BOX[1] + SPACE[1]) + SPACE[1];
    let top = |level: usize| SPACE[1] + level * (BOX[1] + SPACE[1]);
    let (mut lines, mut boxes) = (String::new(), String::new());
    let mut line = |[x, y]: [usize; 2], [to_x, to_y]: [usize; 2]| {
        lines += &format!("<line x1=\"{x}\" y1=\"{y}\" x2=\"{to_x}\" y2=\"{to_y}\"/>\n");
    };
    for (level, row) in rows.iter().enumerate() {
        let (y, bottom) = (top(level), top(level) + BOX[1]);
        for item in row.iter().map(|item| &items[*item]) {
            for below in &item.below {
                line([item.middle(), bottom], [items[*below].middle(), top(level + 1)]);
            }
            match item.package {
                Some(package) => boxes += &boxed(&packages[package], [item.place[0], y]),
                None => line([item.middle(), y], [item.middle(), bottom]),
            }
        }
    }
    format!(
        "<!-- Written by `cargo xtask docs`. -->\n<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} \
         {height}\" font-family=\"sans-serif\">\n<title>Packages of the tree, each above those it depends on</title>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n<g stroke=\"#8a97a6\" stroke-width=\"1.5\">\n{lines}</g>\n\
         {boxes}</svg>\n"
    )
}

/// Box of a package: its folder and its description.
fn boxed(package: &Package, [x, y]: [usize; 2]) -> String {
    let mut svg = format!(
        "<rect x=\"{x}\" y=\"{y}\" width=\"{}\" height=\"{}\" rx=\"5\" fill=\"{}\" stroke=\"#30506e\"/>\n\
         <text x=\"{}\" y=\"{}\" font-size=\"15\" font-weight=\"bold\">{}</text>\n",
        BOX[0],
        BOX[1],
        colour(&package.folder),
        x + 10,
        y + 22,
        escaped(&package.folder)
    );
    for (n, line) in lines(&package.description).iter().enumerate() {
        let (x, y) = (x + 10, y + 40 + 15 * n);
        svg += &format!("<text x=\"{x}\" y=\"{y}\" font-size=\"11.5\">{}</text>\n", escaped(line));
    }
    svg
}

/// Ground of a box: libraries, analyses, and what is built on the whole.
fn colour(folder: &str) -> &'static str {
    match folder.split_once('/').map(|(group, _)| group) {
        Some("crates") => "#e8f1fa",
        Some("plugins") => "#eaf6e4",
        _ => "#f6f0e4",
    }
}

/// Words in lines of at most [`LINE`] characters.
fn lines(text: &str) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= LINE => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    fn package(folder: &str, below: &[&str]) -> Package {
        let below = below.iter().map(|one| (*one).to_owned()).collect();
        Package { folder: folder.to_owned(), description: String::new(), below }
    }

    #[test]
    fn a_line_that_others_imply_is_left_out() {
        let tree = [package("core", &["units"]), package("tui", &["core", "units"]), package("units", &[])];
        let direct = without_implied(&tree);
        assert_eq!(direct, [vec![2], vec![0], vec![]]);
        assert_eq!([row(&direct, 0), row(&direct, 1), row(&direct, 2)], [1, 0, 2]);
    }

    #[test]
    fn descriptions_stay_in_their_boxes() {
        let root = crate::root();
        for Package { folder, description, .. } in packages(&root).unwrap() {
            let lines = lines(&description);
            assert!((1..=4).contains(&lines.len()), "{folder}: {lines:#?}");
        }
    }
}
