//! The books and notes that the analyses by virtual work follow.

use dalembert_core::Source;

/// J. A. Riul, course notes, Unit II.
pub(crate) static RIUL: Source = Source {
    short: "Riul II",
    full: "J. A. Riul, Dinâmica das Máquinas, course notes, Unit II: virtual work, balancing, rigid bodies in space",
};

/// J. J. Uicker, G. R. Pennock, J. E. Shigley, Theory of Machines and Mechanisms.
pub(crate) static SHIGLEY: Source = Source {
    short: "Shigley",
    full: "J. J. Uicker, G. R. Pennock, J. E. Shigley, Theory of Machines and Mechanisms, 4th ed., Oxford University Press, 2011",
};

/// F. P. Beer, E. R. Johnston, Vector Mechanics for Engineers: Statics.
pub(crate) static BEER: Source = Source {
    short: "Beer & Johnston",
    full: "F. P. Beer, E. R. Johnston Jr., D. F. Mazurek, Vector Mechanics for Engineers: Statics, 12th ed., McGraw-Hill, 2019",
};

/// T. Bevan, The Theory of Machines.
pub(crate) static BEVAN: Source =
    Source { short: "Bevan", full: "T. Bevan, The Theory of Machines, 3rd ed., Longmans, 1956" };

/// R. L. Norton, Design of Machinery.
pub(crate) static NORTON: Source =
    Source { short: "Norton", full: "R. L. Norton, Design of Machinery, 5th ed., McGraw-Hill, 2012" };

/// R. S. Khurmi and J. K. Gupta, Theory of Machines.
pub(crate) static KHURMI: Source = Source {
    short: "Khurmi & Gupta",
    full: "R. S. Khurmi, J. K. Gupta, Theory of Machines, 14th ed., S. Chand, 2005",
};

/// P. E. Nikravesh, Computer-Aided Analysis of Mechanical Systems.
pub(crate) static NIKRAVESH: Source = Source {
    short: "Nikravesh",
    full: "P. E. Nikravesh, Computer-Aided Analysis of Mechanical Systems, Prentice Hall, 1988",
};

/// E. J. Haug, Computer-Aided Kinematics and Dynamics of Mechanical Systems.
pub(crate) static HAUG: Source = Source {
    short: "Haug",
    full: "E. J. Haug, Computer-Aided Kinematics and Dynamics of Mechanical Systems, Vol. I: Basic Methods, Allyn and Bacon, 1989",
};

/// R. C. Hibbeler, Engineering Mechanics: Statics.
pub(crate) static HIBBELER: Source = Source {
    short: "Hibbeler",
    full: "R. C. Hibbeler, Engineering Mechanics: Statics, 14th ed., Pearson, 2016",
};

/// E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I.
pub(crate) static HAIRER: Source = Source {
    short: "Hairer, Nørsett & Wanner",
    full: "E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I: Nonstiff Problems, 2nd ed., Springer, 1993",
};

/// F. Pfeiffer, C. Glocker, Multibody Dynamics with Unilateral Contacts.
pub(crate) static PFEIFFER: Source = Source {
    short: "Pfeiffer & Glocker",
    full: "F. Pfeiffer, C. Glocker, Multibody Dynamics with Unilateral Contacts, Wiley, 1996",
};
