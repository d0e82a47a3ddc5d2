//! Prints every unit that can be read as tables in Markdown, a kind of quantity a table.

use dalembert_units::{Kind, Unit, spellings, unit};

fn main() {
    let mut kinds: Vec<(&'static str, Vec<String>)> = Vec::new();
    for spelling in spellings() {
        let unit = unit(spelling.symbols[0]).expect("a listed unit can be read");
        let kind = match unit.dim {
            dim if dim == dalembert_units::Dim::NONE => "a pure number",
            _ => Kind::of(&unit).name(),
        };
        let code = |text: &str| format!("`{text}`");
        let symbols: Vec<String> = spelling.symbols.iter().map(|symbol| code(symbol)).collect();
        let names = spelling.names.join(", ");
        let row = format!(
            "| {} | {} | {names} | {} |",
            symbols.join(" "),
            prefixes(spelling.prefixes),
            size(&unit)
        );
        match kinds.iter_mut().find(|(name, _)| *name == kind) {
            Some((_, rows)) => rows.push(row),
            None => kinds.push((kind, vec![row])),
        }
    }
    for (kind, rows) in kinds {
        println!("\n## {}\n\n| symbols | prefixes | names | in SI |\n|---|---|---|---|", heading(kind));
        println!("{}", rows.join("\n"));
    }
}

/// `an angular velocity` as `Angular velocity`.
fn heading(kind: &str) -> String {
    let words = kind.strip_prefix("an ").or_else(|| kind.strip_prefix("a ")).unwrap_or(kind);
    let mut letters = words.chars();
    letters.next().map(|first| first.to_ascii_uppercase()).into_iter().chain(letters).collect()
}

/// The signs of micro are one prefix.
fn prefixes(prefixes: &[&str]) -> String {
    prefixes.iter().copied().filter(|prefix| !["μ", "u"].contains(prefix)).collect::<Vec<_>>().join(" ")
}

fn size(unit: &Unit) -> String {
    if unit.factor == 0.0 || !unit.factor.is_finite() || unit.sense == dalembert_units::UnitMeaning::Level {
        return "a level: 20 log₁₀ of a ratio".to_owned();
    }
    format!("{} {}", unit.factor, unit.dim).trim_end().to_owned()
}
