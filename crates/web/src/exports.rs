//! Exports: the functions that JavaScript calls.

use wasm_bindgen::prelude::wasm_bindgen;

/// See [`crate::solved`].
#[wasm_bindgen]
pub fn solved(problem_file: &str, language: &str) -> String {
    crate::solved(problem_file, language)
}

/// See [`crate::opened`].
#[wasm_bindgen]
pub fn opened(problem_file: &str, language: &str) -> String {
    crate::opened(problem_file, language)
}

/// See [`crate::changed`].
#[wasm_bindgen]
pub fn changed(problem_file: &str, change: &str, language: &str) -> String {
    crate::changed(problem_file, change, language)
}

/// See [`crate::checked`].
#[wasm_bindgen]
pub fn checked(problem_file: &str, answers: &str, language: &str) -> String {
    crate::checked(problem_file, answers, language)
}

/// See [`crate::analyses`].
#[wasm_bindgen]
pub fn analyses() -> usize {
    crate::analyses()
}
