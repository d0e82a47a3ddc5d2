//! Properties of every analysis, every case and every problem file.

mod alternatives;
mod catalogue;
mod configurations;
mod coverage;
mod engines;
mod examples;
mod exhibits;
mod extremes;
mod file_forms;
mod glossary;
mod gravity_and_tables;
mod invariance;
mod inverse;
mod languages;
mod linked;
mod near_singular;
mod papers;
mod path_independence;
mod perturbation;
mod reports;
mod suggestions;
mod symbols;
mod tidy;
mod unit_systems;
mod unknowns;
