//! The quantities that the usual questions are about, and the names that the analyses have for them.

/// A physical quantity, and where the analyses have it.
pub(super) struct Role {
    /// Name, as the formulas of rules write it in braces.
    pub(super) name: &'static str,
    /// A unit of its dimension.
    pub(super) unit: &'static str,
    /// Scopes, the narrower first, each with the paths of inputs and the names of answers that mean this; the first one
    /// that a problem has is taken. A scope is an id, a topic, or a family with a stroke; only the first one that fits
    /// counts, so that one without names takes an analysis out of those behind it.
    pub(super) of: &'static [(&'static str, &'static [&'static str])],
}

const fn role(
    name: &'static str,
    unit: &'static str,
    of: &'static [(&'static str, &'static [&'static str])],
) -> Role {
    Role { name, unit, of }
}

const ISOLATION: &str = "vibration/vibration-isolation";
const ABSORBER: &str = "vibration/vibration-absorber";
const UNBALANCE: &str = "vibration/rotating-unbalance";
const BASE: &str = "vibration/base-excitation";
const FORCE: &str = "vibration/harmonic-force";
const EQUIVALENT: &str = "vibration/equivalent-damping";
const COULOMB: &str = "vibration/forced-coulomb";
const DAMPER: &str = "vibration/friction-damper";
const SUM: &str = "vibration/harmonic-sum";
const BEAM: &str = "vibration/beam-and-springs";
const NETWORK: &str = "vibration/spring-network";
const WHIRL: &str = "vibration/whirling-shaft";
const ROTOR: &str = "vibration/rotor-dynamics";
const FREE: &str = "vibration/free-vibration";
const ENGINE: &str = "virtual-work/engine";
const FLYWHEEL: &str = "virtual-work/flywheel";

/// Every role.
pub(super) static ROLES: &[Role] = &[
    // Harmonic motion.
    role(
        "amplitude",
        "m",
        &[
            (UNBALANCE, &["amplitude"]),
            (BASE, &["amplitude"]),
            (FORCE, &["amplitude"]),
            (EQUIVALENT, &["amplitude"]),
            (COULOMB, &["amplitude"]),
            (DAMPER, &["amplitude"]),
            (SUM, &["amplitude", "question.work.amplitude"]),
            (BEAM, &["amplitude"]),
            (NETWORK, &["amplitude"]),
            (ISOLATION, &["amplitude"]),
            ("vibration/vibration-instrument", &["amplitude"]),
            ("vibration/damped-absorber", &["amplitude"]),
            (WHIRL, &["amplitude"]),
            (ROTOR, &["response_major"]),
        ],
    ),
    // The frequency of the motion of that amplitude.
    role(
        "frequency",
        "rad/s",
        &[
            (UNBALANCE, &["speed"]),
            (BASE, &["frequency"]),
            (FORCE, &["frequency"]),
            (EQUIVALENT, &["frequency"]),
            (COULOMB, &["frequency"]),
            (DAMPER, &["frequency"]),
            (SUM, &["frequency", "question.work.frequency"]),
            (BEAM, &["excitation.frequency"]),
            (NETWORK, &["frequency"]),
            ("vibration/vibration-instrument", &["frequency"]),
            (WHIRL, &["speed.given.speed"]),
            (ROTOR, &["speed"]),
        ],
    ),
    // The amplitude by which the spring of the role `stiffness` is deflected.
    role(
        "deflection",
        "m",
        &[
            (BASE, &["relative_amplitude"]),
            (UNBALANCE, &["amplitude"]),
            (FORCE, &["amplitude"]),
            (EQUIVALENT, &["amplitude"]),
            (COULOMB, &["amplitude"]),
            (DAMPER, &["amplitude"]),
            (BEAM, &["amplitude"]),
            (ISOLATION, &["amplitude"]),
            ("vibration/damped-absorber", &["amplitude"]),
        ],
    ),
    // The maximum deflection of the spring under a shock.
    role(
        "maximum",
        "m",
        &[
            ("vibration/transient-response", &["maximum"]),
            ("vibration/gun-recoil", &["distance", "recoil.distance.distance"]),
        ],
    ),
    role(
        "stiffness",
        "N/m",
        &[
            ("Nonlinear vibration", &[]),
            (ABSORBER, &[]),
            ("vibration/damped-absorber", &["main.masses.springs.stiffness.stiffness"]),
            (ISOLATION, &["stiffness", "question.judge.elasticity.stiffness.stiffness"]),
            ("vibration/", &["stiffness", "elasticity.stiffness.stiffness"]),
        ],
    ),
    role(
        "torsional stiffness",
        "N*m/rad",
        &[(ABSORBER, &[]), ("vibration/", &["torsional_stiffness", "stiffness"])],
    ),
    // Of a viscous damper in parallel with the spring.
    role(
        "damping",
        "N*s/m",
        &[
            (UNBALANCE, &["damping"]),
            (BASE, &["damping"]),
            (FORCE, &["damping"]),
            (BEAM, &["damping"]),
            ("vibration/periodic-excitation", &["damping"]),
        ],
    ),
    role(
        "mass",
        "kg",
        &[
            ("Nonlinear vibration", &["mass"]),
            ("vibration/pendulum-absorber", &[]),
            ("vibration/beam-with-tip-body", &["mass"]),
            (ISOLATION, &["mass"]),
            ("vibration/damped-absorber", &["main.masses.mass.mass.mass"]),
            (ABSORBER, &["problem.translation.mass.mass.mass"]),
            ("vibration/equivalent-stiffness", &["mass"]),
            ("vibration/", &["mass", "mass.mass.mass", "body.mass.mass"]),
            ("rigid-body/mass-properties", &["mass"]),
            ("rigid-body/momentum", &["mass"]),
            ("rigid-body/steady-rolling", &["mass"]),
            ("rigid-body/edge-mill", &["mass"]),
            ("balancing/tolerance", &["mass"]),
            (FLYWHEEL, &["mass", "sought.fluctuation.inertia.gyration.mass"]),
            ("virtual-work/equivalent-rod", &["mass"]),
        ],
    ),
    role(
        "force",
        "N",
        &[
            (FORCE, &["force"]),
            (EQUIVALENT, &["force"]),
            (COULOMB, &["force", "excitation.force.force"]),
            (BEAM, &["excitation.force"]),
            (ISOLATION, &["question.judge.disturbance.force.force"]),
            ("vibration/damped-absorber", &["main.masses.force"]),
        ],
    ),
    // The amplitude or the maximum of the force through spring and damper.
    role(
        "transmitted force",
        "N",
        &[
            (UNBALANCE, &["transmitted_force"]),
            (BEAM, &["transmitted_force"]),
            (FORCE, &["transmitted_force"]),
            (ISOLATION, &["transmitted_force"]),
            (BASE, &["force"]),
            ("vibration/transient-response", &["support_force"]),
            ("vibration/drop-impact", &["force"]),
        ],
    ),
    role("stiffness of a mount", "N/m", &[(ISOLATION, &["stiffness_each"])]),
    role("unbalance", "kg*m", &[(UNBALANCE, &["unbalance"]), (WHIRL, &["imbalance.unbalance.unbalance"])]),
    role(
        "cantilever length",
        "m",
        &[(UNBALANCE, &["support.cantilever.length"]), (BEAM, &["springs.cantilever.length"])],
    ),
    role("friction force", "N", &[(COULOMB, &["friction", "friction.force.force"])]),
    role("friction amplitude", "m", &[(COULOMB, &["exact_amplitude", "excitation.amplitude.amplitude"])]),
    role("energy per cycle", "J", &[(EQUIVALENT, &["energy"]), (FORCE, &["work"])]),
    // The mass that moves with the amplitude.
    role(
        "oscillating mass",
        "kg",
        &[
            (UNBALANCE, &["mass"]),
            (BASE, &["mass"]),
            (FORCE, &["mass"]),
            (EQUIVALENT, &["mass.mass.mass"]),
            (COULOMB, &["mass.mass.mass"]),
            (DAMPER, &["mass.mass.mass"]),
            (BEAM, &["mass"]),
        ],
    ),
    // The mass whose weight the spring may carry.
    role(
        "suspended mass",
        "kg",
        &[
            (UNBALANCE, &["mass"]),
            (BASE, &["mass"]),
            (FORCE, &["mass"]),
            (EQUIVALENT, &["mass.mass.mass"]),
            (BEAM, &["mass"]),
            (FREE, &["oscillator.translation.mass.mass.mass"]),
            ("vibration/drop-impact", &["body.mass.mass"]),
            ("vibration/transient-response", &["mass.mass.mass"]),
            ("vibration/periodic-excitation", &["mass"]),
            ("vibration/random-response", &["mass.mass.mass"]),
            ("vibration/damped-absorber", &["main.masses.mass.mass.mass"]),
        ],
    ),
    // Free vibration.
    role(
        "natural frequency",
        "rad/s",
        &[
            ("Nonlinear vibration", &[]),
            (ABSORBER, &[]),
            ("vibration/shaft-with-discs", &["exact"]),
            (WHIRL, &["critical_speed"]),
            ("vibration/", &["natural_frequency", "oscillator.ratios.natural_frequency"]),
        ],
    ),
    role(
        "damping ratio",
        "1",
        &[
            ("vibration/rayleigh-damping", &[]),
            (ABSORBER, &[]),
            ("vibration/", &["damping_ratio", "oscillator.ratios.ratio"]),
        ],
    ),
    role("transverse frequency", "rad/s", &[("vibration/mass-on-shaft", &["transverse"])]),
    role("first frequency", "rad/s", &[("vibration/", &["frequency[1]"])]),
    role("second frequency", "rad/s", &[("vibration/", &["frequency[2]"])]),
    role(
        "small oscillations",
        "rad/s",
        &[
            ("rigid-body/dynamic-equilibrium", &["swing_frequency"]),
            ("rigid-body/rolling-stability", &["wobble"]),
            ("rigid-body/steady-rolling", &["wobble"]),
            ("rigid-body/heavy-top", &["nutation_frequency"]),
        ],
    ),
    role("displacement then", "m", &[(FREE, &["displacement"])]),
    role("velocity then", "m/s", &[(FREE, &["velocity"])]),
    // Shock, random vibration, instruments.
    role(
        "speed at contact",
        "m/s",
        &[
            ("vibration/drop-impact", &["contact_speed", "fall.speed.speed"]),
            ("vibration/gun-recoil", &["speed", "recoil.speed.speed"]),
            (ISOLATION, &["velocity"]),
        ],
    ),
    role("impact force", "N", &[("vibration/drop-impact", &["force"])]),
    role("deceleration", "m/s^2", &[("vibration/drop-impact", &["deceleration"])]),
    role("impact speed", "m/s", &[("vibration/rod-impact", &["speed"])]),
    role("wave speed", "m/s", &[("vibration/rod-impact", &["wave_speed"])]),
    role("shock ordinate", "m/s^2", &[("vibration/shock-response-spectrum", &["largest"])]),
    role("rms displacement", "m", &[("vibration/random-response", &["displacement"])]),
    role("rms velocity", "m/s", &[("vibration/random-response", &["velocity"])]),
    role("rms support force", "N", &[("vibration/random-response", &["support_force"])]),
    role("maximum displacement", "m", &[("vibration/periodic-excitation", &["largest"])]),
    role("minimum displacement", "m", &[("vibration/periodic-excitation", &["least"])]),
    role("rms of the motion", "m", &[("vibration/periodic-excitation", &["rms"])]),
    role(
        "absorber stiffness",
        "N/m",
        &[
            (ABSORBER, &["absorber_stiffness"]),
            (
                "vibration/damped-absorber",
                &["absorber_stiffness", "absorber.given.tuning.stiffness.stiffness"],
            ),
        ],
    ),
    role(
        "absorber mass",
        "kg",
        &[(ABSORBER, &["absorber_mass"]), ("vibration/damped-absorber", &["main.masses.absorber"])],
    ),
    // The deflection of the absorber's spring.
    role("absorber stroke", "m", &[("vibration/damped-absorber", &["stroke"])]),
    role("absorber motion", "m", &[(ABSORBER, &["absorber_motion"])]),
    role("main motion", "m", &[(ABSORBER, &["main_motion"])]),
    role("pendulum period", "s", &[("vibration/large-pendulum", &["period"])]),
    role("pendulum length", "m", &[("vibration/large-pendulum", &["length"])]),
    role("pendulum speed", "rad/s", &[("vibration/large-pendulum", &["largest_angular_velocity"])]),
    role("spring force of the cycle", "N", &[("vibration/piecewise-spring", &["largest_force"])]),
    role("speed of the cycle", "m/s", &[("vibration/piecewise-spring", &["largest_speed"])]),
    // Rotors.
    role(
        "critical speed",
        "rad/s",
        &[(ROTOR, &["critical_speed[1]"]), ("vibration/overhung-disc", &["forward_critical[1]"])],
    ),
    role("running speed", "rad/s", &[(ROTOR, &["speed"]), ("vibration/overhung-disc", &["speed"])]),
    role("bearing load", "N", &[(WHIRL, &["shaft_force"])]),
    role("clearance", "m", &[("vibration/shaft-clearance", &["clearance"])]),
    role("whirl at worst", "m", &[("vibration/shaft-clearance", &["largest_amplitude"])]),
    // Balancing.
    role(
        "correction unbalance",
        "kg*m",
        &[
            ("balancing/single-plane", &["unbalance"]),
            ("balancing/known-masses", &["correction[1]"]),
            ("balancing/two-plane", &["unbalance_a"]),
            ("balancing/field", &["unbalance[1]"]),
            ("balancing/locomotive", &["balance[1]"]),
            ("balancing/linkage-balance", &["crank_unbalance"]),
        ],
    ),
    role(
        "second correction",
        "kg*m",
        &[
            ("balancing/known-masses", &["correction[2]"]),
            ("balancing/two-plane", &["unbalance_b"]),
            ("balancing/field", &["unbalance[2]"]),
        ],
    ),
    role(
        "rotor speed",
        "rad/s",
        &[
            ("balancing/single-plane", &["speed"]),
            ("balancing/known-masses", &["speed"]),
            ("balancing/two-plane", &["speed"]),
            ("balancing/tolerance", &["speed"]),
        ],
    ),
    role("permissible at a", "kg*m", &[("balancing/tolerance", &["permissible_a"])]),
    role("permissible at b", "kg*m", &[("balancing/tolerance", &["permissible_b"])]),
    role("shaking moment", "N*m", &[("balancing/linkage-balance", &["shaking_moment"])]),
    role("shaking moment after", "N*m", &[("balancing/linkage-balance", &["shaking_moment_after"])]),
    role("primary force", "N", &[("balancing/reciprocating", &["force[1]"])]),
    role("secondary force", "N", &[("balancing/reciprocating", &["force[2]"])]),
    role("maximum load", "N", &[("balancing/locomotive", &["load_max"])]),
    role("minimum load", "N", &[("balancing/locomotive", &["load_min"])]),
    // Bodies in space.
    role(
        "spin inertia",
        "kg*m^2",
        &[
            ("rigid-body/gyroscopic-couple", &["axial_inertia", "rotor.moment-of-inertia.inertia"]),
            ("rigid-body/spinning-disc-on-arm", &["axial_inertia"]),
            ("rigid-body/turn-indicator", &["axial_inertia", "rotor.moments.axial"]),
            ("rigid-body/two-bladed-rotor", &["axial_inertia", "rotor.slender.inertia"]),
            ("rigid-body/dipping-rail", &["axial_inertia"]),
            (FLYWHEEL, &["inertia", "sought.fluctuation.inertia.moment.inertia"]),
        ],
    ),
    role(
        "spin speed",
        "rad/s",
        &[
            ("rigid-body/gyroscopic-couple", &["spin"]),
            ("rigid-body/spinning-disc-on-arm", &["spin"]),
            ("rigid-body/turn-indicator", &["spin"]),
            ("rigid-body/two-bladed-rotor", &["spin"]),
            ("rigid-body/dipping-rail", &["wheel_speed"]),
            (FLYWHEEL, &["speed"]),
        ],
    ),
    role(
        "couple on the bearings",
        "N*m",
        &[
            ("rigid-body/gyroscopic-couple", &["couple"]),
            ("rigid-body/spinning-disc-on-arm", &["gyroscopic_couple"]),
            ("rigid-body/rod-on-shaft", &["tilting_couple"]),
            ("rigid-body/two-bladed-rotor", &["largest_resultant"]),
            ("rigid-body/turn-indicator", &["couple"]),
        ],
    ),
    role(
        "revolution",
        "rad/s",
        &[
            ("rigid-body/steady-rolling", &["precession", "known.precession.precession"]),
            ("rigid-body/rolling-cone", &["precession", "known.precession.precession"]),
            ("rigid-body/edge-mill", &["speed.shaft.speed", "shaft_speed"]),
            ("rigid-body/dynamic-equilibrium", &["speed"]),
            ("rigid-body/turn-indicator", &["rate_of_turn", "turn.rate.rate"]),
        ],
    ),
    role(
        "speed on the circle",
        "m/s",
        &[
            ("rigid-body/steady-rolling", &["speed", "known.speed.speed"]),
            ("rigid-body/wheel-loads", &["speed"]),
            ("rigid-body/two-wheeler-lean", &["motion.speed.speed", "speed"]),
            ("rigid-body/gyroscopic-couple", &["motion.steady-turn.speed"]),
            ("rigid-body/turn-indicator", &["turn.speed-and-radius.speed"]),
        ],
    ),
    role(
        "radius of the circle",
        "m",
        &[
            (
                "rigid-body/steady-rolling",
                &["centre_radius", "known.centre-circle.radius", "known.speed.radius"],
            ),
            ("rigid-body/wheel-loads", &["radius"]),
            ("rigid-body/two-wheeler-lean", &["radius"]),
            ("rigid-body/gyroscopic-couple", &["motion.steady-turn.radius"]),
            ("rigid-body/turn-indicator", &["turn.speed-and-radius.radius"]),
        ],
    ),
    role("energy before", "J", &[("rigid-body/impulse", &["energy_before"])]),
    role("energy after", "J", &[("rigid-body/impulse", &["energy_after"])]),
    role("rotation energy", "J", &[("rigid-body/momentum", &["rotation_energy"])]),
    role("kinetic energy", "J", &[("rigid-body/momentum", &["kinetic_energy"])]),
    role("radius of gyration", "m", &[("virtual-work/equivalent-rod", &["radius_of_gyration"])]),
    role("body period", "s", &[("rigid-body/free-triaxial", &["period"])]),
    // Mechanisms.
    role(
        "crank torque",
        "N*m",
        &[
            ("Plane linkages", &["torque", "unknown.force.torque", "unknown.load.torque"]),
            ("virtual-work/rolling-disc", &["torque", "unknown.force.torque"]),
            (ENGINE, &["turning_moment"]),
        ],
    ),
    role(
        "crank speed",
        "rad/s",
        &[
            ("Plane linkages", &["speed"]),
            ("virtual-work/rolling-disc", &["speed"]),
            (ENGINE, &["motion.running.speed"]),
        ],
    ),
    role("first effort", "N*m", &[("virtual-work/mechanism", &["effort[1]"])]),
    role("first driver", "rad/s", &[("virtual-work/mechanism", &["drivers[1].what.angle.velocity"])]),
    role("maximum moment", "N*m", &[(ENGINE, &["greatest_moment"])]),
    role("mean moment", "N*m", &[(ENGINE, &["mean_moment"])]),
    role(
        "pin force",
        "N",
        &[
            (
                "Plane linkages",
                &[
                    "crank_pin_force",
                    "pin_force",
                    "crank_bearing_force",
                    "bearing_force",
                    "first_bearing_force",
                ],
            ),
            ("virtual-work/rolling-disc", &["bearing_force"]),
        ],
    ),
    role(
        "member force",
        "N",
        &[
            ("virtual-work/toggle-press", &["fixed_link_force"]),
            ("virtual-work/screw-jack", &["axial_force", "sought.effort.load", "sought.held.force"]),
        ],
    ),
    role(
        "cylinder force",
        "N",
        &[
            ("virtual-work/scissor-lift", &["cylinder_force", "sought.load.cylinder"]),
            ("virtual-work/oscillating-cylinder", &["cylinder_force", "force"]),
        ],
    ),
    role(
        "load",
        "N",
        &[
            ("virtual-work/bar-and-cord", &["hanging_weight"]),
            ("virtual-work/compound-lever", &["force"]),
            ("virtual-work/rhombus", &["load"]),
            ("virtual-work/screw-jack", &["load"]),
            ("virtual-work/scissor-lift", &["load"]),
            ("virtual-work/rack-press", &["ram"]),
            ("virtual-work/toggle-press", &["thrust"]),
        ],
    ),
    role("driving torque", "N*m", &[("virtual-work/epicyclic-train", &["driving_torque"])]),
    role("holding torque", "N*m", &[("virtual-work/epicyclic-train", &["holding_torque"])]),
    role(
        "rim radius",
        "m",
        &[(FLYWHEEL, &["sought.fluctuation.inertia.gyration.radius", "sought.inertia.radius"])],
    ),
    role("energy fluctuation", "J", &[(FLYWHEEL, &["energy_fluctuation"])]),
];
