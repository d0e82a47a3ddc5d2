//! The books and notes that the analyses of rigid bodies follow.

use dalembert_core::Source;

/// J. A. Riul, course notes, Unit II.
pub(crate) static RIUL: Source = Source {
    short: "Riul II",
    full: "J. A. Riul, Dinâmica das Máquinas, course notes, Unit II: virtual work, balancing, rigid bodies in space",
};

/// F. P. Beer, E. R. Johnston, Vector Mechanics for Engineers: Dynamics.
pub(crate) static BEER: Source = Source {
    short: "Beer & Johnston",
    full: "F. P. Beer, E. R. Johnston Jr., P. J. Cornwell, B. P. Self, Vector Mechanics for Engineers: Dynamics, 11th ed., McGraw-Hill, 2016",
};

/// I. E. Irodov, Problems in General Physics.
pub(crate) static IRODOV: Source = Source {
    short: "Irodov",
    full: "I. E. Irodov, Problems in General Physics, translated by Y. Atanov, Mir Publishers, Moscow, 1981",
};

/// R. S. Khurmi, J. K. Gupta, Theory of Machines.
pub(crate) static KHURMI: Source = Source {
    short: "Khurmi & Gupta",
    full: "R. S. Khurmi, J. K. Gupta, Theory of Machines, 14th ed., S. Chand, 2005",
};

/// J. L. Meriam and L. G. Kraige, Engineering Mechanics: Dynamics.
pub(crate) static MERIAM: Source = Source {
    short: "Meriam",
    full: "J. L. Meriam and L. G. Kraige, Engineering Mechanics: Dynamics, 7th ed., Wiley, 2012",
};

/// T. Bevan, The Theory of Machines.
pub(crate) static BEVAN: Source =
    Source { short: "Bevan", full: "T. Bevan, The Theory of Machines, 3rd ed., Longmans, 1956" };

/// R. C. Hibbeler, Engineering Mechanics: Dynamics.
pub(crate) static HIBBELER: Source = Source {
    short: "Hibbeler",
    full: "R. C. Hibbeler, Engineering Mechanics: Dynamics, 14th ed., Pearson, 2016",
};

/// H. Goldstein, Classical Mechanics.
pub(crate) static GOLDSTEIN: Source =
    Source { short: "Goldstein", full: "H. Goldstein, Classical Mechanics, 2nd ed., Addison-Wesley, 1980" };

/// E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration.
pub(crate) static HAIRER_LUBICH_WANNER: Source = Source {
    short: "Hairer, Lubich & Wanner",
    full: "E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, 2nd ed., Springer, 2006",
};

/// E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I.
pub(crate) static HAIRER: Source = Source {
    short: "Hairer, Nørsett & Wanner",
    full: "E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed., Springer, 1993",
};

/// O. Brüls, A. Cardona, M. Arnold, the heavy-top benchmark.
pub(crate) static BRULS: Source = Source {
    short: "Brüls, Cardona & Arnold",
    full: "O. Brüls, A. Cardona, M. Arnold, Lie group generalized-α time integration of constrained flexible multibody systems, Mechanism and Machine Theory 48 (2012), pp. 121–137",
};

/// E. J. Routh, Dynamics of a System of Rigid Bodies.
pub(crate) static ROUTH: Source = Source {
    short: "Routh",
    full: "E. J. Routh, The Advanced Part of a Treatise on the Dynamics of a System of Rigid Bodies, 6th ed., Macmillan, 1905",
};

/// L. D. Landau, E. M. Lifshitz, Mechanics.
pub(crate) static LANDAU: Source = Source {
    short: "Landau & Lifshitz",
    full: "L. D. Landau, E. M. Lifshitz, Mechanics, 3rd ed., Pergamon, 1976",
};

/// T. W. B. Kibble, F. H. Berkshire, Classical Mechanics.
pub(crate) static KIBBLE: Source = Source {
    short: "Kibble & Berkshire",
    full: "T. W. B. Kibble, F. H. Berkshire, Classical Mechanics, 5th ed., Imperial College Press, 2004",
};

/// M. Schuler, on pendulous gyroscopes of vehicles.
pub(crate) static SCHULER: Source = Source {
    short: "Schuler",
    full: "M. Schuler, Die Störung von Pendel- und Kreiselapparaten durch die Beschleunigung des Fahrzeuges, Physikalische Zeitschrift 24 (1923), pp. 344–350",
};

/// M. Fowler, Graduate Classical Mechanics.
pub(crate) static FOWLER: Source = Source {
    short: "Fowler",
    full: "M. Fowler, Graduate Classical Mechanics, University of Virginia, LibreTexts, ch. 30: a rolling sphere on a rotating plane",
};

/// H. Schaub, J. L. Junkins, Analytical Mechanics of Space Systems.
pub(crate) static SCHAUB: Source = Source {
    short: "Schaub & Junkins",
    full: "H. Schaub, J. L. Junkins, Analytical Mechanics of Space Systems, 3rd ed., AIAA, 2014",
};

/// M. D. Shuster, A Survey of Attitude Representations.
pub(crate) static SHUSTER: Source = Source {
    short: "Shuster",
    full: "M. D. Shuster, A Survey of Attitude Representations, Journal of the Astronautical Sciences 41 (1993), pp. 439–517",
};
