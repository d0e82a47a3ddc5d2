//! Names of the motion of the points of linkages.

/// Names of the motion of a point, or of one point relative to another: keys and labels of its answers.
pub(crate) struct Names {
    /// Subscript of its symbols.
    pub(super) of: &'static str,
    /// Notation of the field: `B/A` is B relative to A.
    pub(super) words: &'static str,
    /// Symbols of the magnitudes of velocity and acceleration.
    pub(super) size: [&'static str; 2],
    pub(super) velocity: [&'static str; 2],
    pub(super) speed: [&'static str; 2],
    pub(super) heading: [&'static str; 2],
    pub(super) normal: [&'static str; 2],
    pub(super) tangential: [&'static str; 2],
    pub(super) acceleration: [&'static str; 2],
    pub(super) magnitude: [&'static str; 2],
    pub(super) direction: [&'static str; 2],
}

/// Pin A.
pub(crate) const A: Names = Names {
    of: "A",
    words: "A",
    size: ["|v_A|", "|a_A|"],
    velocity: ["velocity_a", "Velocity of A"],
    speed: ["speed_a", "Speed of A"],
    heading: ["velocity_angle_a", "Direction of the velocity of A"],
    normal: ["normal_acceleration_a", "Normal acceleration of A"],
    tangential: ["tangential_acceleration_a", "Tangential acceleration of A"],
    acceleration: ["acceleration_a", "Acceleration of A"],
    magnitude: ["acceleration_size_a", "Magnitude of the acceleration of A"],
    direction: ["acceleration_angle_a", "Direction of the acceleration of A"],
};

/// Pin B.
pub(crate) const B: Names = Names {
    of: "B",
    words: "B",
    size: ["|v_B|", "|a_B|"],
    velocity: ["velocity_b", "Velocity of B"],
    speed: ["speed_b", "Speed of B"],
    heading: ["velocity_angle_b", "Direction of the velocity of B"],
    normal: ["normal_acceleration_b", "Normal acceleration of B"],
    tangential: ["tangential_acceleration_b", "Tangential acceleration of B"],
    acceleration: ["acceleration_b", "Acceleration of B"],
    magnitude: ["acceleration_size_b", "Magnitude of the acceleration of B"],
    direction: ["acceleration_angle_b", "Direction of the acceleration of B"],
};

/// Pin B relative to pin A.
pub(crate) const B_RELATIVE_TO_A: Names = Names {
    of: "BA",
    words: "B/A",
    size: ["|v_BA|", "|a_BA|"],
    velocity: ["velocity_ba", "Velocity of B relative to A"],
    speed: ["speed_ba", "Speed of B relative to A"],
    heading: ["velocity_angle_ba", "Direction of the velocity of B relative to A"],
    normal: ["normal_acceleration_ba", "Normal acceleration of B relative to A"],
    tangential: ["tangential_acceleration_ba", "Tangential acceleration of B relative to A"],
    acceleration: ["acceleration_ba", "Acceleration of B relative to A"],
    magnitude: ["acceleration_size_ba", "Magnitude of the acceleration of B relative to A"],
    direction: ["acceleration_angle_ba", "Direction of the acceleration of B relative to A"],
};

/// The point of link 4 that is under pin A.
pub(crate) const A4: Names = Names {
    of: "A4",
    words: "A4",
    size: ["|v_A4|", "|a_A4|"],
    velocity: ["velocity_a4", "Velocity of A on link 4"],
    speed: ["speed_a4", "Speed of A on link 4"],
    heading: ["velocity_angle_a4", "Direction of the velocity of A on link 4"],
    normal: ["normal_acceleration_a4", "Normal acceleration of A on link 4"],
    tangential: ["tangential_acceleration_a4", "Tangential acceleration of A on link 4"],
    acceleration: ["acceleration_a4", "Acceleration of A on link 4"],
    magnitude: ["acceleration_size_a4", "Magnitude of the acceleration of A on link 4"],
    direction: ["acceleration_angle_a4", "Direction of the acceleration of A on link 4"],
};

/// Pin D.
pub(crate) const D: Names = Names {
    of: "D",
    words: "D",
    size: ["|v_D|", "|a_D|"],
    velocity: ["velocity_d", "Velocity of D"],
    speed: ["speed_d", "Speed of D"],
    heading: ["velocity_angle_d", "Direction of the velocity of D"],
    normal: ["normal_acceleration_d", "Normal acceleration of D"],
    tangential: ["tangential_acceleration_d", "Tangential acceleration of D"],
    acceleration: ["acceleration_d", "Acceleration of D"],
    magnitude: ["acceleration_size_d", "Magnitude of the acceleration of D"],
    direction: ["acceleration_angle_d", "Direction of the acceleration of D"],
};

/// Point P.
pub(crate) const P: Names = Names {
    of: "P",
    words: "P",
    size: ["|v_P|", "|a_P|"],
    velocity: ["velocity_p", "Velocity of P"],
    speed: ["speed_p", "Speed of P"],
    heading: ["velocity_angle_p", "Direction of the velocity of P"],
    normal: ["normal_acceleration_p", "Normal acceleration of P"],
    tangential: ["tangential_acceleration_p", "Tangential acceleration of P"],
    acceleration: ["acceleration_p", "Acceleration of P"],
    magnitude: ["acceleration_size_p", "Magnitude of the acceleration of P"],
    direction: ["acceleration_angle_p", "Direction of the acceleration of P"],
};
