//! Tests of `slider_crank::links`.

use dalembert_mechanics::{
    linkage::{LinkMass, PointMotion, ReducedMasses},
    slider_crank::{Branch, CrankMotion, SliderCrank, links},
};

#[test]
fn torque_is_that_of_the_equation_of_motion() {
    // Lagrange's equation derived by computer algebra, with a force of 200 N on the slider along x.
    let torques =
        [4.949497872144, 10.471218321386, 4.391767367560, -2.352141859274, -8.501153170190, -8.858462404553];
    for (step, printed) in (0..).zip(torques) {
        let angle = 0.3 + f64::from(step) * std::f64::consts::FRAC_PI_3;
        let links = links(0.05, 0.2, 0.0, Branch::Ahead, angle);
        let masses = LinkMass { mass: 1.2, centre: [0.02, 0.0], inertia: 8e-4 }
            .reduced(PointMotion::fixed([0.0; 2]), links.crank)
            .and(
                LinkMass { mass: 0.8, centre: [0.07, 0.0], inertia: 3.5e-3 }
                    .reduced(links.crank_pin, links.rod),
            )
            .and(ReducedMasses::mass(0.5, links.slider));
        let torque = masses.torque(30.0, 5.0, 9.81) - 200.0 * links.slider.first[0];
        assert!((torque - printed).abs() < 1e-11, "at {angle}: {torque} for {printed}");
    }
}

#[test]
fn motion_is_that_of_the_formulas_with_angles() {
    for (branch, offset) in [(Branch::Ahead, 0.0), (Branch::Ahead, 0.02), (Branch::Behind, -0.01)] {
        let mechanism = SliderCrank { crank: 0.05, rod: 0.2, offset, branch };
        for step in 0..12 {
            let angle = 0.1 + 0.5 * f64::from(step);
            let links = links(0.05, 0.2, offset, branch, angle);
            let steady = CrankMotion { angle, speed: 1.0, acceleration: 0.0 };
            let motion = mechanism.motion(steady).expect("the mechanism can be assembled");
            let [c, s] = links.rod.direction;
            for (ours, theirs) in [
                ((s.atan2(c) - motion.rod_angle).sin(), 0.0),
                (links.rod.first, motion.rod_speed),
                (links.rod.second, motion.rod_acceleration),
                (links.slider.at[0], motion.slider_position),
                (links.slider.first[0], motion.slider_velocity),
                (links.slider.second[0], motion.slider_acceleration),
                (links.slider.at[1], offset),
                (links.slider.first[1], 0.0),
                (links.slider.second[1], 0.0),
            ] {
                assert!((ours - theirs).abs() < 1e-15, "{branch:?}, {angle}: {ours} for {theirs}");
            }
        }
    }
}
