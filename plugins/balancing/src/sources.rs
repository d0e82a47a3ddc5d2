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

/// R. L. Norton, Design of Machinery.
pub(crate) static NORTON: Source =
    Source { short: "Norton", full: "R. L. Norton, Design of Machinery, 5th ed., McGraw-Hill, 2012" };

/// R. S. Khurmi and J. K. Gupta, Theory of Machines.
pub(crate) static KHURMI: Source = Source {
    short: "Khurmi & Gupta",
    full: "R. S. Khurmi, J. K. Gupta, Theory of Machines, 14th ed., S. Chand, 2005",
};

/// ISO 21940-2, the vocabulary of balancing.
pub(crate) static ISO_TERMS: Source = Source {
    short: "ISO 21940-2",
    full: "ISO 21940-2:2017, Mechanical vibration — Rotor balancing — Part 2: Vocabulary",
};

/// S. S. Rao, Mechanical Vibrations.
pub(crate) static RAO: Source =
    Source { short: "Rao", full: "S. S. Rao, Mechanical Vibrations, 5th ed., Prentice Hall, 2011" };

/// T. P. Goodman, on least squares.
pub(crate) static GOODMAN: Source = Source {
    short: "Goodman",
    full: "T. P. Goodman, A Least-Squares Method for Computing Balance Corrections, Trans. ASME, J. Eng. Ind. 86 (1964) 273–277",
};

/// M. S. Darlow, Balancing of High-Speed Machinery.
pub(crate) static DARLOW: Source =
    Source { short: "Darlow", full: "M. S. Darlow, Balancing of High-Speed Machinery, Springer, 1989" };

/// S. Boyd and L. Vandenberghe, Convex Optimization.
pub(crate) static BOYD: Source = Source {
    short: "Boyd",
    full: "S. Boyd, L. Vandenberghe, Convex Optimization, Cambridge University Press, 2004",
};

/// ISO 21940-11, tolerances of rigid rotors.
pub(crate) static ISO_TOLERANCES: Source = Source {
    short: "ISO 21940-11",
    full: "ISO 21940-11:2016 (before: ISO 1940-1:2003), Mechanical vibration — Rotor balancing — Part 11: Procedures and tolerances for rotors with rigid behaviour",
};

/// MIL-STD-167-1, vibration of shipboard equipment.
pub(crate) static MIL_STD_167: Source = Source {
    short: "MIL-STD-167-1",
    full: "MIL-STD-167-1A, Mechanical vibrations of shipboard equipment, US Department of Defense, 2005",
};

/// R. S. Berkof and G. G. Lowen, force balance of linkages.
pub(crate) static BERKOF: Source = Source {
    short: "Berkof & Lowen",
    full: "R. S. Berkof, G. G. Lowen, A new method for completely force balancing simple linkages, ASME J. Eng. Ind. 91 (1969) 21–26",
};

/// T. Bevan, The Theory of Machines.
pub(crate) static BEVAN: Source =
    Source { short: "Bevan", full: "T. Bevan, The Theory of Machines, 3rd ed., Longmans, 1956" };

/// J. P. Den Hartog, Mechanical Vibrations.
pub(crate) static DEN_HARTOG: Source = Source {
    short: "Den Hartog",
    full: "J. P. Den Hartog, Mechanical Vibrations, 4th ed., McGraw-Hill, 1956; Dover, 1985",
};

/// Manual of an instrument for field balancing.
pub(crate) static EZ_BALANCE: Source =
    Source { short: "eZ-Balance", full: "Measurement Computing, eZ-Balance User Manual, rev. 9.0" };

/// V. Wowk, Machinery Vibration: Balancing.
pub(crate) static WOWK: Source =
    Source { short: "Wowk", full: "V. Wowk, Machinery Vibration: Balancing, McGraw-Hill, 1995" };

/// Note on balancing with portable instruments.
pub(crate) static BRUEL_KJAER: Source = Source {
    short: "Brüel & Kjær",
    full: "M. MacCamhaoil, Static and Dynamic Balancing of Rigid Rotors, Brüel & Kjær application note BO 0276",
};
