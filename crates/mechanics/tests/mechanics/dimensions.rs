//! A constant with a hidden dimension shows when the units of mass, length and time change.

use dalembert_mechanics::{balance, beam, rigid, sdof, section, slider_crank, spring, whirl};

use crate::close::{ROUNDING, close};

/// Exponents of mass, length and time.
type Dimension = [i32; 3];

const NUMBER: Dimension = [0, 0, 0];
const MASS: Dimension = [1, 0, 0];
const LENGTH: Dimension = [0, 1, 0];
const AREA: Dimension = [0, 2, 0];
const SECOND_MOMENT: Dimension = [0, 4, 0];
const STRESS: Dimension = [1, -1, -2];
const FORCE: Dimension = [1, 1, -2];
const STIFFNESS: Dimension = [1, 0, -2];
const DAMPING: Dimension = [1, 0, -1];
const RATE: Dimension = [0, 0, -1];
const ACCELERATION: Dimension = [0, 0, -2];
const TIME: Dimension = [0, 0, 1];
const RECEPTANCE: Dimension = [-1, 0, 2];
const UNBALANCE: Dimension = [1, 1, 0];
const MOMENT: Dimension = [1, 2, 0];
const INERTIA: Dimension = [1, 2, 0];
const VELOCITY: Dimension = [0, 1, -1];

fn factor([mass, length, time]: Dimension) -> f64 {
    3.7f64.powi(mass) * 0.21f64.powi(length) * 1.9f64.powi(time)
}

#[track_caller]
fn scales<const N: usize>(
    formula: impl Fn([f64; N]) -> f64,
    arguments: [f64; N],
    dimensions: [Dimension; N],
    result: Dimension,
) {
    let before = formula(arguments);
    assert!(before.is_finite() && before != 0.0, "the arguments say nothing: {before}");
    let scaled = std::array::from_fn(|i| arguments[i] * factor(dimensions[i]));
    close(formula(scaled), before * factor(result), ROUNDING);
}

#[test]
fn one_degree_of_freedom() {
    let (k, m, c, w) = (STIFFNESS, MASS, DAMPING, RATE);
    let values = [900.0, 2.5, 13.0, 14.0];
    let forced = [77.0, 900.0, 2.5, 13.0, 14.0];
    scales(|[k, m]| sdof::natural_frequency(k, m), [900.0, 2.5], [k, m], w);
    scales(|[k, w]| sdof::mass_from_natural_frequency(k, w), [900.0, 2.5], [k, w], m);
    scales(|[m, w]| sdof::stiffness_from_natural_frequency(m, w), [900.0, 2.5], [m, w], k);
    scales(|[h]| sdof::stiffness_from_static_receptance(h), [900.0], [RECEPTANCE], k);
    scales(|[k, m]| sdof::critical_damping(k, m), [900.0, 2.5], [k, m], c);
    scales(|[c, k, m]| sdof::damping_ratio(c, k, m), [3.0, 900.0, 2.5], [c, k, m], NUMBER);
    scales(|[z, k, m]| sdof::damping_from_ratio(z, k, m), [0.3, 900.0, 2.5], [NUMBER, k, m], c);
    scales(|[w, z]| sdof::damped_frequency(w, z), [9.0, 0.5], [w, NUMBER], w);
    scales(|[w, z]| sdof::natural_frequency_from_damped(w, z), [9.0, 0.5], [w, NUMBER], w);
    scales(|[w, n]| sdof::frequency_ratio(w, n), [9.0, 0.5], [w, w], NUMBER);
    scales(|[t]| sdof::angular_frequency(t), [9.0], [TIME], w);
    scales(|[k, m, c, w]| sdof::receptance(k, m, c, w), values, [k, m, c, w], RECEPTANCE);
    scales(|[k, m, c, w]| sdof::dynamic_stiffness(k, m, c, w), values, [k, m, c, w], k);
    scales(|[k, m, c, w]| sdof::phase_lag(k, m, c, w), values, [k, m, c, w], NUMBER);
    scales(|[f, k, m, c, w]| sdof::forced_amplitude(f, k, m, c, w), forced, [FORCE, k, m, c, w], LENGTH);
    scales(
        |[u, k, m, c, w]| sdof::unbalance_amplitude(u, k, m, c, w),
        forced,
        [UNBALANCE, k, m, c, w],
        LENGTH,
    );
    scales(|[x, k, c, w]| sdof::transmitted_force(x, k, c, w), values, [LENGTH, k, c, w], FORCE);
    scales(|[w, z]| sdof::natural_frequency_from_force_peak(w, z), [9.0, 0.5], [w, NUMBER], w);
    scales(|[h, w]| sdof::damping_from_resonant_receptance(h, w), [9.0, 0.5], [RECEPTANCE, w], c);
    scales(|[p, q]| sdof::damping_ratio_from_half_power(p, q), [8.0, 9.0], [w, w], NUMBER);
    scales(|[p, q, w]| sdof::damping_ratio_from_bandwidth(p, q, w), [8.0, 9.0, 8.4], [w, w, w], NUMBER);
}

#[test]
fn beams_springs_and_sections() {
    let bending = [STRESS, SECOND_MOMENT, LENGTH, LENGTH];
    let along = |f: fn(f64, f64, f64) -> f64| {
        scales(|[e, i, l]| f(e, i, l), [2e11, 1e-6, 1.7], [STRESS, SECOND_MOMENT, LENGTH], STIFFNESS);
    };
    let at = |f: fn(f64, f64, f64, f64) -> f64| {
        scales(|[e, i, l, a]| f(e, i, l, a), [2e11, 1e-6, 1.7, 0.4], bending, STIFFNESS);
    };
    along(beam::cantilever);
    along(beam::clamped_guided);
    along(beam::simply_supported_middle);
    along(beam::clamped_clamped_middle);
    along(beam::clamped_pinned_middle);
    at(beam::simply_supported);
    at(beam::clamped_clamped);
    at(beam::clamped_pinned);
    at(beam::overhang);
    scales(|[e, a, l]| spring::axial(e, a, l), [2.0, 3.0, 5.0], [STRESS, AREA, LENGTH], STIFFNESS);
    scales(
        |[g, j, l]| spring::torsional(g, j, l),
        [2.0, 3.0, 5.0],
        [STRESS, SECOND_MOMENT, LENGTH],
        [1, 2, -2],
    );
    scales(
        |[g, d, coil, n]| spring::helical(g, d, coil, n),
        [2.0, 3.0, 5.0, 7.0],
        [STRESS, LENGTH, LENGTH, NUMBER],
        STIFFNESS,
    );
    scales(|[p, q]| spring::series([p, q]), [2.0, 3.0], [STIFFNESS; 2], STIFFNESS);
    scales(|[p, q]| spring::parallel([p, q]), [2.0, 3.0], [STIFFNESS; 2], STIFFNESS);
    scales(|[d]| section::round_area(d), [2.0], [LENGTH], AREA);
    scales(|[d]| section::round_second_moment(d), [2.0], [LENGTH], SECOND_MOMENT);
    scales(|[d]| section::round_polar_moment(d), [2.0], [LENGTH], SECOND_MOMENT);
    scales(|[i]| section::round_diameter(i), [2.0], [SECOND_MOMENT], LENGTH);
    scales(|[p, q]| section::tube_area(p, q), [2.0, 1.0], [LENGTH; 2], AREA);
    scales(|[p, q]| section::tube_second_moment(p, q), [2.0, 1.0], [LENGTH; 2], SECOND_MOMENT);
    scales(|[p, q]| section::tube_polar_moment(p, q), [2.0, 1.0], [LENGTH; 2], SECOND_MOMENT);
    scales(|[b, h]| section::rectangle_area(b, h), [2.0, 1.0], [LENGTH; 2], AREA);
    scales(|[b, h]| section::rectangle_second_moment(b, h), [2.0, 1.0], [LENGTH; 2], SECOND_MOMENT);
}

#[test]
fn balancing_and_whirling() {
    let rotor = [UNBALANCE, LENGTH, UNBALANCE, LENGTH, LENGTH, LENGTH];
    let values = [2.0, 0.3, -5.0, 0.8, 0.1, 0.9];
    scales(|[m, r]| balance::component_x(m, r, 0.3), [2.0, 3.0], [MASS, LENGTH], UNBALANCE);
    scales(|[m, r]| balance::component_y(m, r, 0.3), [2.0, 3.0], [MASS, LENGTH], UNBALANCE);
    scales(|[u, v, p, q, a, b]| balance::correction_in_b([(u, v), (p, q)], a, b), values, rotor, UNBALANCE);
    scales(
        |[u, v, p, q, a, b]| balance::correction_in_a_by_moments([(u, v), (p, q)], a, b),
        values,
        rotor,
        UNBALANCE,
    );
    scales(|[u, v, p, q, a, _]| balance::moment([(u, v), (p, q)], a), values, rotor, MOMENT);
    let plane = [UNBALANCE, UNBALANCE, LENGTH];
    scales(|[x, y, r]| balance::correction_mass(x, y, r), [2.0, 3.0, 0.1], plane, MASS);
    scales(|[x, y]| balance::direction(x, y), [2.0, 3.0], [UNBALANCE; 2], NUMBER);
    scales(|[u, w]| balance::centrifugal_force(u, w), [2.0, 3.0], [UNBALANCE, RATE], FORCE);

    let turbine = [MASS, UNBALANCE, LENGTH, RATE];
    let (values, damped) = ([250.0, 0.2, 2e-3, 60.0], [250.0, 0.2, 2e-3, 60.0, 0.1]);
    let with_ratio = [MASS, UNBALANCE, LENGTH, RATE, NUMBER];
    scales(|[m, u, r, w]| whirl::soft_limit_undamped(m, u, r, w), values, turbine, STIFFNESS);
    scales(|[m, u, r, w]| whirl::stiff_limit_undamped(m, u, r, w), values, turbine, STIFFNESS);
    scales(|[m, u, r, w, z]| whirl::soft_limit(m, u, r, w, z), damped, with_ratio, STIFFNESS);
    scales(|[m, u, r, w, z]| whirl::stiff_limit(m, u, r, w, z), damped, with_ratio, STIFFNESS);
    scales(|[e, r, z]| whirl::whirl_amplitude(e, r, z), [1e-3, 0.9, 0.1], [LENGTH, NUMBER, NUMBER], LENGTH);
}

#[test]
fn bodies_and_mechanisms() {
    let body = [MASS, LENGTH];
    scales(|[m, l]| rigid::rod_inertia(m, l), [2.0, 3.0], body, INERTIA);
    scales(|[m, l]| rigid::rod_inertia_half_length(m, l), [2.0, 3.0], body, INERTIA);
    scales(|[m, l]| rigid::disc_axial_inertia(m, l), [2.0, 3.0], body, INERTIA);
    scales(|[m, l]| rigid::disc_diametral_inertia(m, l), [2.0, 3.0], body, INERTIA);
    scales(
        |[m, r, h]| rigid::cylinder_diametral_inertia(m, r, h),
        [2.0, 3.0, 5.0],
        [MASS, LENGTH, LENGTH],
        INERTIA,
    );
    scales(|[i, m, d]| rigid::parallel_axis(i, m, d), [2.0, 3.0, 5.0], [INERTIA, MASS, LENGTH], INERTIA);

    let lengths = [LENGTH; 2];
    scales(|[r, l]| slider_crank::rod_angle(r, l, 0.02 * r, 0.6), [0.1, 0.4], lengths, NUMBER);
    scales(|[r, l]| slider_crank::slider_position(r, l, 0.6, -0.1), [0.1, 0.4], lengths, LENGTH);
    let turning = [LENGTH, LENGTH, RATE, RATE, ACCELERATION, ACCELERATION];
    let values = [0.1, 0.4, 9.0, -3.0, 5.0, -7.0];
    scales(|[r, l, w, ..]| slider_crank::rod_speed(r, l, 0.6, -0.1, w), values, turning, RATE);
    scales(|[_, _, w, ..]| slider_crank::rod_speed_in_line(0.6, -0.1, w), values, turning, RATE);
    scales(
        |[v, w]| slider_crank::crank_from_slider_velocity(v, 0.6, -0.1, w),
        [3.0, 9.0],
        [VELOCITY, RATE],
        LENGTH,
    );
    scales(
        |[r, l, w, q, ..]| slider_crank::slider_velocity(r, l, 0.6, -0.1, w, q),
        values,
        turning,
        VELOCITY,
    );
    scales(
        |[r, l, w, q, a, _]| slider_crank::rod_acceleration(r, l, 0.6, -0.1, w, q, a),
        values,
        turning,
        ACCELERATION,
    );
    scales(
        |[r, l, w, q, a, b]| slider_crank::slider_acceleration(r, l, 0.6, -0.1, w, q, a, b),
        values,
        turning,
        [0, 1, -2],
    );
}
