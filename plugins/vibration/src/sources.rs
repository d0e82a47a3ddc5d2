//! The books and notes that the analyses of vibration follow.

use dalembert_core::Source;

/// S. S. Rao, Mechanical Vibrations.
pub(crate) static RAO: Source =
    Source { short: "Rao", full: "S. S. Rao, Mechanical Vibrations, 5th ed., Prentice Hall, 2011" };

/// S. G. Kelly, Mechanical Vibrations.
pub(crate) static KELLY: Source =
    Source { short: "Kelly", full: "S. G. Kelly, Mechanical Vibrations: Theory and Applications, Cengage, 2012" };

/// Exercise lists 06, 07 and 08 of a course on vibration.
pub(crate) static LISTS: Source =
    Source { short: "Lists 06–08", full: "Exercise lists 06, 07 and 08, course on mechanical vibration" };
