//! Tests that hold for every analysis, over those of balancing with their crate alone: built in seconds after a change,
//! they are the judge of mutants. The tests of the workspace run the same over all analyses.

use dalembert_balancing as _;
use dalembert_testkit::{Laboratory, registry_tests};

registry_tests!(Laboratory::of("balancing") => catalogue {
    every_printed_answer_agrees_or_is_disputed
    every_solution_is_sound
});
registry_tests!(Laboratory::of("balancing") => invariance {
    every_answer_scales_with_its_dimension
    the_plain_reading_is_the_worked_reading
});
registry_tests!(Laboratory::of("balancing") => exhibits {
    every_mark_equals_an_answer_or_a_point_of_a_curve
});
registry_tests!(Laboratory::of("balancing") => printed {
    printed_steps_give_their_results
});
registry_tests!(Laboratory::of("balancing") => unknowns {
    an_input_is_found_back_from_an_answer
});
