//! Comparison of lists in tests.

use super::{Tree, lines};

/// A test that pairs a list with a shorter one examines what they have in common, and at nothing if one is empty.
pub(super) fn tests_pair_lists_of_one_length(tree: &Tree) -> Vec<String> {
    // In halves, so that this file is not among what it finds.
    let call = [".zi", "p("].concat();
    let mut faults = Vec::new();
    for (path, text) in tree.sources() {
        let first = first_line_of_tests(path, text);
        let of_tests = lines(text).filter(|(n, _)| first.is_some_and(|first| *n >= first));
        for (n, line) in of_tests.filter(|(_, line)| line.contains(&call) && !is_endless(line, &call)) {
            if !line.trim_start().starts_with("//") {
                faults.push(format!(
                    "{path}:{n}: lists of different lengths would pass; pair them by `itertools::zip_eq`"
                ));
            }
        }
    }
    faults
}

/// First line of the tests of a source: its own, that of its module of tests, or none.
fn first_line_of_tests(path: &str, text: &str) -> Option<usize> {
    if path.starts_with("tests/benches/") {
        return None;
    }
    if path.starts_with("tests/") || path.contains("/tests/") || path.ends_with("/tests.rs") {
        return Some(1);
    }
    let mut marked = false;
    for (n, line) in lines(text) {
        if line == "#[cfg(test)]" {
            marked = true;
        } else if marked && !line.starts_with("#[") {
            if line.starts_with("mod ") && line.ends_with('{') {
                return Some(n);
            }
            marked = false;
        }
    }
    None
}

/// Returns true if one of the two is infinite: a range without an end, or a repeated list.
fn is_endless(line: &str, call: &str) -> bool {
    let is_range = |rest: &str| {
        let start = rest.split_once("..)").map(|(start, _)| start);
        start.is_some_and(|start| start.chars().all(|c| c.is_alphanumeric() || c == '_'))
    };
    line.contains(&format!("..){call}"))
        || line.contains(".cycle()")
        || line.split(call).skip(1).any(is_range)
}
