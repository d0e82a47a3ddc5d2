//! The books and notes that the analyses of balancing follow.

use dalembert_core::Source;

/// J. A. Riul, course notes.
pub(crate) static RIUL: Source =
    Source { short: "Riul", full: "J. A. Riul, Dinâmica das Máquinas, course notes, Unit II" };

/// H. H. Mabie and C. F. Reinholtz, Mechanisms and Dynamics of Machinery.
pub(crate) static MABIE: Source = Source {
    short: "Mabie",
    full: "H. H. Mabie, C. F. Reinholtz, Mechanisms and Dynamics of Machinery, 4th ed., Wiley, 1987",
};
