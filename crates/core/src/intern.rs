//! Names that users write, kept for the whole run: symbols and names of answers are `&'static str`.

use std::{
    collections::{HashMap, HashSet},
    sync::{LazyLock, Mutex, PoisonError, RwLock},
};

use dalembert_units::Unit;

/// The same text, kept once for the whole run. The pool grows by the names that are typed, a few bytes each.
pub(crate) fn intern(text: &str) -> &'static str {
    static POOL: Mutex<Option<HashSet<&'static str>>> = Mutex::new(None);
    let mut pool = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    let pool = pool.get_or_insert_default();
    if let Some(known) = pool.get(text) {
        return known;
    }
    let kept: &'static str = String::from(text).leak();
    pool.insert(kept);
    kept
}

/// The unit of a field, read once for the whole run: a study asks for it at every sample.
///
/// # Panics
/// If the text is no unit.
pub(crate) fn unit_of_field(text: &'static str) -> &'static Unit {
    static UNITS: LazyLock<RwLock<HashMap<&str, &Unit>>> = LazyLock::new(RwLock::default);
    if let Some(known) = UNITS.read().unwrap_or_else(PoisonError::into_inner).get(text) {
        return known;
    }
    let unit = dalembert_units::unit(text);
    let unit = unit.expect("the derive and a test hold the units of fields to be well formed");
    UNITS
        .write()
        .unwrap_or_else(PoisonError::into_inner)
        .entry(text)
        .or_insert_with(|| Box::leak(unit.into()))
}

/// The text of a unit for as long as the program runs.
pub(crate) fn fixed(unit: &Unit) -> &'static str {
    intern(&unit.ascii())
}

/// The text of a unit for a step; `1` for a pure number.
pub(crate) fn unit_text(unit: &Unit) -> &'static str {
    match unit.ascii() {
        unit if unit.is_empty() => "1",
        unit => intern(&unit),
    }
}
