//! The tree keeps its own rules.

use xtask::{
    root,
    tidy::{Tree, faults},
};

#[test]
fn the_tree_is_tidy() {
    let faults = faults(&Tree::read(&root()).unwrap());
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
