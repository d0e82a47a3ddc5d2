//! The books and notes that the analyses of vibration follow.

use dalembert_core::Source;

/// S. S. Rao, Mechanical Vibrations.
pub(crate) static RAO: Source =
    Source { short: "Rao", full: "S. S. Rao, Mechanical Vibrations, 5th ed., Prentice Hall, 2011" };

/// S. G. Kelly, Mechanical Vibrations.
pub(crate) static KELLY: Source = Source {
    short: "Kelly",
    full: "S. G. Kelly, Mechanical Vibrations: Theory and Applications, Cengage, 2012",
};

/// F. P. Beer and E. R. Johnston, Mechanics of Materials.
pub(crate) static BEER: Source = Source {
    short: "Beer & Johnston",
    full: "F. P. Beer, E. R. Johnston, J. T. DeWolf and D. F. Mazurek, Mechanics of Materials, 6th ed., McGraw-Hill, 2012",
};

/// J. E. Shigley, Mechanical Engineering Design.
pub(crate) static SHIGLEY: Source = Source {
    short: "Shigley",
    full: "R. G. Budynas and J. K. Nisbett, Shigley's Mechanical Engineering Design, 9th ed., McGraw-Hill, 2011",
};

/// D. J. Ewins, Modal Testing.
pub(crate) static EWINS: Source = Source {
    short: "Ewins",
    full: "D. J. Ewins, Modal Testing: Theory, Practice and Application, 2nd ed., Research Studies Press, 2000",
};

/// Exercise lists 06, 07 and 08 of a course on vibration.
pub(crate) static LISTS: Source =
    Source { short: "Lists 06–08", full: "Exercise lists 06, 07 and 08, course on mechanical vibration" };

/// W. T. Thomson, Theory of Vibration with Applications.
pub(crate) static THOMSON: Source = Source {
    short: "Thomson",
    full: "W. T. Thomson, Theory of Vibration with Applications, 2nd ed., Prentice Hall, 1981",
};

/// G. K. Grover, Mechanical Vibrations.
pub(crate) static GROVER: Source =
    Source { short: "Grover", full: "G. K. Grover, Mechanical Vibrations, 8th ed., Nem Chand & Bros, 2009" };

/// J. P. Den Hartog, Forced vibrations with combined Coulomb and viscous friction.
pub(crate) static DEN_HARTOG_1931: Source = Source {
    short: "Den Hartog 1931",
    full: "J. P. Den Hartog, Forced vibrations with combined Coulomb and viscous friction, Transactions of the ASME 53 (1931), APM-53-9",
};

/// T. Bevan, The Theory of Machines.
pub(crate) static BEVAN: Source =
    Source { short: "Bevan", full: "T. Bevan, The Theory of Machines, 3rd ed., Longmans, 1956" };

/// M. I. Friswell and others, Dynamics of Rotating Machines.
pub(crate) static FRISWELL: Source = Source {
    short: "Friswell",
    full: "M. I. Friswell, J. E. T. Penny, S. D. Garvey and A. W. Lees, Dynamics of Rotating Machines, Cambridge University Press, 2010",
};

/// H. D. Nelson and J. M. McVaugh on rotors by finite elements.
pub(crate) static NELSON: Source = Source {
    short: "Nelson & McVaugh",
    full: "H. D. Nelson and J. M. McVaugh, The dynamics of rotor-bearing systems using finite elements, ASME Journal of Engineering for Industry 98 (1976) 593–600",
};

/// E. S. Zorzi and H. D. Nelson on internal damping.
pub(crate) static ZORZI: Source = Source {
    short: "Zorzi & Nelson",
    full: "E. S. Zorzi and H. D. Nelson, Finite element simulation of rotor-bearing systems with internal damping, ASME Journal of Engineering for Power 99 (1977) 71–76",
};

/// J. P. Den Hartog, Mechanical Vibrations.
pub(crate) static DEN_HARTOG: Source = Source {
    short: "Den Hartog",
    full: "J. P. Den Hartog, Mechanical Vibrations, 4th ed., McGraw-Hill, 1956; Dover, 1985",
};

/// B. K. Sarkar, Theory of Machines.
pub(crate) static SARKAR: Source =
    Source { short: "Sarkar", full: "B. K. Sarkar, Theory of Machines, Tata McGraw-Hill, 2002" };
/// M. Abramowitz and I. A. Stegun, Handbook of Mathematical Functions.
pub(crate) static ABRAMOWITZ: Source = Source {
    short: "Abramowitz & Stegun",
    full: "M. Abramowitz and I. A. Stegun (eds.), Handbook of Mathematical Functions, National Bureau of Standards, 1964",
};

/// A. H. Nayfeh and D. T. Mook, Nonlinear Oscillations.
pub(crate) static NAYFEH: Source = Source {
    short: "Nayfeh & Mook",
    full: "A. H. Nayfeh and D. T. Mook, Nonlinear Oscillations, Wiley, 1979",
};

/// R. W. Clough and J. Penzien, Dynamics of Structures.
pub(crate) static CLOUGH: Source = Source {
    short: "Clough & Penzien",
    full: "R. W. Clough and J. Penzien, Dynamics of Structures, 2nd ed., McGraw-Hill, 1993",
};

/// R. D. Blevins, Formulas for Natural Frequency and Mode Shape.
pub(crate) static BLEVINS: Source = Source {
    short: "Blevins",
    full: "R. D. Blevins, Formulas for Natural Frequency and Mode Shape, Van Nostrand Reinhold, 1979",
};

/// G. R. Cowper, The shear coefficient in Timoshenko's beam theory.
pub(crate) static COWPER: Source = Source {
    short: "Cowper",
    full: "G. R. Cowper, The shear coefficient in Timoshenko's beam theory, J. Appl. Mech. 33 (1966), pp. 335–340",
};

/// S. Timoshenko, Vibration Problems in Engineering.
pub(crate) static TIMOSHENKO: Source = Source {
    short: "Timoshenko",
    full: "S. Timoshenko, Vibration Problems in Engineering, 3rd ed., Van Nostrand, 1955",
};

/// W. H. Wittrick and F. W. Williams, A general algorithm for computing natural frequencies of elastic structures.
pub(crate) static WITTRICK: Source = Source {
    short: "Wittrick & Williams",
    full: "W. H. Wittrick and F. W. Williams, A general algorithm for computing natural frequencies of elastic structures, Q. J. Mech. Appl. Math. 24 (1971), pp. 263–284",
};

/// A. K. Chopra, Dynamics of Structures.
pub(crate) static CHOPRA: Source = Source {
    short: "Chopra",
    full: "A. K. Chopra, Dynamics of Structures: Theory and Applications to Earthquake Engineering, 4th ed., Pearson, 2012",
};

/// K.-J. Bathe, Finite Element Procedures.
pub(crate) static BATHE: Source =
    Source { short: "Bathe", full: "K.-J. Bathe, Finite Element Procedures, Prentice Hall, 1996" };

/// J. L. Meriam and L. G. Kraige, Engineering Mechanics: Dynamics.
pub(crate) static MERIAM: Source = Source {
    short: "Meriam",
    full: "J. L. Meriam and L. G. Kraige, Engineering Mechanics: Dynamics, 7th ed., Wiley, 2012",
};

/// C. M. Harris and A. G. Piersol, Harris' Shock and Vibration Handbook.
pub(crate) static HARRIS: Source = Source {
    short: "Harris",
    full: "C. M. Harris and A. G. Piersol, Harris' Shock and Vibration Handbook, 5th ed., McGraw-Hill, 2002",
};

/// J. W. Miles, On structural fatigue under random loading.
pub(crate) static MILES: Source = Source {
    short: "Miles",
    full: "J. W. Miles, On structural fatigue under random loading, Journal of the Aeronautical Sciences 21 (1954), 753–762",
};

/// J. M. Biggs, Introduction to Structural Dynamics.
pub(crate) static BIGGS: Source =
    Source { short: "Biggs", full: "J. M. Biggs, Introduction to Structural Dynamics, McGraw-Hill, 1964" };

/// O. Nishihara and T. Asami, the exact least peak of a damped absorber.
pub(crate) static NISHIHARA: Source = Source {
    short: "Nishihara & Asami",
    full: "O. Nishihara and T. Asami, Closed-form solutions to the exact optimizations of dynamic vibration absorbers (minimizations of the maximum amplitude magnification factors), Journal of Vibration and Acoustics 124 (2002), 576–582",
};

/// J. E. Brock, the damping of a tuned absorber.
pub(crate) static BROCK: Source = Source {
    short: "Brock",
    full: "J. E. Brock, A note on the damped vibration absorber, Journal of Applied Mechanics 13 (1946), A-284",
};

/// A. W. Leissa, Vibration of Plates.
pub(crate) static LEISSA: Source =
    Source { short: "Leissa", full: "A. W. Leissa, Vibration of Plates, NASA SP-160, 1969" };

/// A. D. Wright and others on rotating beams.
pub(crate) static WRIGHT: Source = Source {
    short: "Wright",
    full: "A. D. Wright, C. E. Smith, R. W. Thresher and J. L. C. Wang, Vibration modes of centrifugally stiffened beams, Journal of Applied Mechanics 49 (1982), 197–202",
};

/// R. V. Southwell and B. S. Gough on the vibration of airscrew blades.
pub(crate) static SOUTHWELL: Source = Source {
    short: "Southwell & Gough",
    full: "R. V. Southwell and B. S. Gough, On the free transverse vibrations of airscrew blades, British Aeronautical Research Committee, Reports and Memoranda 766, 1921",
};

/// W. Ker Wilson, Practical Solution of Torsional Vibration Problems.
pub(crate) static KER_WILSON: Source = Source {
    short: "Ker Wilson",
    full: "W. Ker Wilson, Practical Solution of Torsional Vibration Problems, 3rd ed., vol. 1, Chapman & Hall, 1956",
};

/// R. L. Norton, Design of Machinery.
pub(crate) static NORTON: Source =
    Source { short: "Norton", full: "R. L. Norton, Design of Machinery, 5th ed., McGraw-Hill, 2012" };
