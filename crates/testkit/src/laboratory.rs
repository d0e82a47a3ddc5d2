//! The analyses of a crate of its own, and all tests over them.

use std::path::{Path, PathBuf};

use dalembert_core::{Entry, registry};

use crate::{languages::SourceFile, path_independence::Exceptions, perturbation::Draws};

/// The analyses of one family, and what is special about them.
#[derive(Clone, Debug)]
pub struct Laboratory {
    family: &'static str,
    folder: Option<PathBuf>,
    exceptions: Exceptions<'static>,
    draws: Draws<'static>,
}

impl Laboratory {
    /// The analyses whose ids begin with `family/`.
    pub fn of(family: &'static str) -> Self {
        Self { family, folder: None, exceptions: Exceptions::default(), draws: Draws::default() }
    }

    /// With the folder of the crate, `env!("CARGO_MANIFEST_DIR")`, in whose sources and translations sentences are
    /// searched.
    #[must_use]
    pub fn crate_at(mut self, folder: impl AsRef<Path>) -> Self {
        self.folder = Some(folder.as_ref().to_owned());
        self
    }

    /// With exceptions from the comparison of plots with direct solves.
    #[must_use]
    pub fn exceptions(mut self, exceptions: Exceptions<'static>) -> Self {
        self.exceptions = exceptions;
        self
    }

    /// With other random draws, or with a table of the refusals that are permitted.
    #[must_use]
    pub fn draws(mut self, draws: Draws<'static>) -> Self {
        self.draws = draws;
        self
    }

    /// The registered analyses of the family.
    pub fn entries(&self) -> Vec<&'static Entry> {
        let entries: Vec<_> =
            registry().iter().copied().filter(|entry| entry.family() == self.family).collect();
        assert!(
            !entries.is_empty(),
            "no analysis of the family {} is linked: name its crate, `use … as _;`",
            self.family
        );
        entries
    }

    /// The exceptions from the comparison of plots.
    pub fn known_exceptions(&self) -> &Exceptions<'static> {
        &self.exceptions
    }

    /// The random draws.
    pub fn random_draws(&self) -> &Draws<'static> {
        &self.draws
    }

    /// The folders with translation files: that of the crate.
    pub fn folders(&self) -> Vec<PathBuf> {
        vec![
            self.folder
                .clone()
                .expect("the folder of the crate is named: `.crate_at(env!(\"CARGO_MANIFEST_DIR\"))`"),
        ]
    }

    /// The sources of the crate.
    pub fn sources(&self) -> Vec<SourceFile> {
        self.folders().iter().flat_map(|folder| SourceFile::below(folder, true)).collect()
    }
}

/// Expands to the tests of a [`Laboratory`], one `#[test]` each; with `english_only` behind it, without those of the
/// Portuguese; with `=> module { name … }`, to these tests of a module alone.
#[macro_export]
macro_rules! registry_tests {
    ($laboratory:expr => $module:ident { $($name:ident)* }) => {
        $(
            #[test]
            fn $name() {
                $crate::$module::$name(&$laboratory.entries());
            }
        )*
    };
    ($laboratory:expr) => {
        $crate::registry_tests!($laboratory, english_only);

        #[test]
        fn every_sentence_has_its_portuguese() {
            let laboratory = $laboratory;
            $crate::languages::every_sentence_has_its_portuguese(&laboratory.entries(), &laboratory.sources());
        }

        #[test]
        fn the_translations_are_well_formed_and_use_the_same_arguments() {
            let laboratory = $laboratory;
            $crate::languages::the_translations_are_well_formed_and_use_the_same_arguments(
                &laboratory.sources(),
                &laboratory.folders(),
            );
        }

        #[test]
        fn every_translation_is_in_use() {
            let laboratory = $laboratory;
            $crate::languages::every_translation_is_in_use(
                &laboratory.entries(),
                &laboratory.sources(),
                &laboratory.folders(),
            );
        }

        $crate::registry_tests!($laboratory => languages {
            labels_begin_with_capitals_in_both_languages
        });
    };
    ($laboratory:expr, english_only) => {
        $crate::registry_tests!($laboratory => catalogue {
            every_printed_answer_agrees_or_is_disputed
            a_companion_is_named_where_its_output_was_seen
            the_right_value_of_a_dispute_has_five_digits
            every_solution_is_sound
            every_worked_solution_is_written_down
            a_solve_is_a_pure_function
            every_analysis_is_well_described
        });
        $crate::registry_tests!($laboratory => invariance {
            every_answer_scales_with_its_dimension
            the_plain_reading_is_the_worked_reading
        });
        $crate::registry_tests!($laboratory => alternatives {
            every_alternative_is_reached_by_a_case
        });
        $crate::registry_tests!($laboratory => coverage {
            every_answer_is_covered_or_has_a_reason
        });
        $crate::registry_tests!($laboratory => exhibits {
            every_mark_equals_an_answer_or_a_point_of_a_curve
            words_of_drawings_stand_over_no_other_words_and_over_no_head_of_an_arrow
            words_of_figures_stand_over_no_other_words
        });
        $crate::registry_tests!($laboratory => extremes {
            a_longer_time_has_no_smaller_maximum
        });
        $crate::registry_tests!($laboratory => inputs {
            every_gravity_has_the_same_default
            a_problem_has_one_gravity
            frequencies_in_tables_are_in_hertz
            published_tables_name_their_units
        });
        $crate::registry_tests!($laboratory => languages {
            every_sentence_of_a_case_has_a_key_of_its_own
        });
        $crate::registry_tests!($laboratory => papers {
            every_analysis_is_written_well_in_every_format
            every_picture_keeps_inside_its_frame
        });
        $crate::registry_tests!($laboratory => printed {
            printed_steps_give_their_results
            what_is_shown_is_right_to_any_number_of_digits
        });
        $crate::registry_tests!($laboratory => unknowns {
            an_input_is_found_back_from_an_answer
        });

        #[test]
        fn points_read_by_simd_are_those_read_one_by_one() {
            $crate::invariance::points_read_by_simd_are_those_read_one_by_one(
                &$laboratory.entries(),
                usize::MAX,
            );
        }

        #[test]
        fn an_optimum_is_no_worse_than_a_scan() {
            $crate::optima::an_optimum_is_no_worse_than_a_scan(&$laboratory.entries(), usize::MAX);
        }

        #[test]
        fn the_unit_of_an_input_does_not_change_the_answers() {
            $crate::invariance::the_unit_of_an_input_does_not_change_the_answers(
                &$laboratory.entries(),
                usize::MAX,
            );
        }

        #[test]
        fn extreme_values_are_answered_or_refused() {
            $crate::invariance::extreme_values_are_answered_or_refused(&$laboratory.entries(), 1);
        }

        #[test]
        fn every_curve_over_an_input_is_what_a_direct_solve_gives() {
            let laboratory = $laboratory;
            $crate::path_independence::every_curve_over_an_input_is_what_a_direct_solve_gives(
                &laboratory.entries(),
                laboratory.known_exceptions(),
                |_, _| true,
                1,
            );
        }

        #[test]
        fn numbers_near_those_of_a_case_are_answered_or_refused_with_reason() {
            let laboratory = $laboratory;
            $crate::perturbation::numbers_near_those_of_a_case_are_answered_or_refused_with_reason(
                &laboratory.entries(),
                laboratory.random_draws(),
                |_| {},
            );
        }
    };
}
