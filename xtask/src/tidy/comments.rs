//! Beginnings of doc comments.

use super::{Tree, lines};

/// Words of relative clauses and pronouns, which say neither what an item is nor what it does.
const RELATIVE: [&str; 10] =
    ["What", "Whether", "How", "Where", "Its", "Which", "Who", "Whose", "Why", "When"];

/// Labels are excepted: the comments of the fields and alternatives of an input type are read in a form, below the name
/// of what they belong to.
pub(super) fn doc_comments_begin_with_a_noun_or_a_verb(tree: &Tree) -> Vec<String> {
    let mut faults = Vec::new();
    for (path, text) in tree.sources() {
        let mut was_doc = false;
        let mut end_of_labels: Option<String> = None;
        for (n, line) in lines(text) {
            if is_of_inputs(line) {
                let indent = line.len() - line.trim_start().len();
                end_of_labels = Some(format!("{}}}", &line[..indent]));
            } else if end_of_labels.as_deref() == Some(line) {
                end_of_labels = None;
            }
            let doc = doc(line);
            if let Some(text) = doc.filter(|_| !was_doc && end_of_labels.is_none())
                && let Some(word) = RELATIVE.iter().find(|word| first_word(text) == **word)
            {
                faults.push(format!(
                    "{path}:{n}: a doc comment begins with a noun or a verb, not with `{word}`"
                ));
            }
            was_doc = doc.is_some();
        }
    }
    faults
}

/// Returns true if the line derives `Inputs` for the item below it.
fn is_of_inputs(line: &str) -> bool {
    line.trim_start().starts_with("#[derive(") && line.contains("Inputs)")
}

/// Text of a line of a doc comment.
fn doc(line: &str) -> Option<&str> {
    let line = line.trim_start();
    line.strip_prefix("///").filter(|rest| !rest.starts_with('/')).or_else(|| line.strip_prefix("//!"))
}

fn first_word(text: &str) -> &str {
    text.trim_start().split(|c: char| !c.is_alphanumeric()).next().unwrap_or_default()
}
