//! All representations of an attitude, from its direction cosine matrix.

use dalembert_core::{
    Exhibit, TableExhibit, Text, Worksheet,
    exhibit::{Cell, Column},
};
use dalembert_mechanics::{Real, Vector};
use nalgebra::{Matrix3, Quaternion, Rotation3, Unit, UnitQuaternion};

use super::{
    euler::{EulerSequence, ReportedAngles, angles_of, from_elements},
    rotations::{matrix, off_cayley_formula, off_rotation},
};
use crate::sources::{SCHAUB, SHUSTER};

/// Below this half the sine of the principal angle is none, or its cosine.
const NONE: f64 = 1e-9;
/// A scalar part that is smaller is rounding alone.
const ROUNDING: f64 = 1e-12;

/// Representations that further steps go on with.
pub(crate) struct Representations<W: Worksheet> {
    /// Euler angles of the sequence of the answers.
    pub angles: ReportedAngles<W::Num>,
    /// Euler parameters, β₀ ≥ 0.
    pub parameters: (W::Num, W::Vec),
    /// Rodrigues parameters; none at 180°.
    pub rodrigues: Option<W::Vec>,
    /// Modified Rodrigues parameters, no longer than 1.
    pub modified: W::Vec,
}

/// Answers all representations of an attitude, with the rows of `[BN]`.
pub(crate) fn answer_representations<W: Worksheet>(
    rows: [W::Vec; 3],
    sequence: EulerSequence,
    sheet: W,
) -> Representations<W> {
    for (n, row) in rows.into_iter().enumerate() {
        sheet.answer_vector(("direction_cosines", n + 1), "Row of [BN]", row);
    }
    let parameters = euler_parameters(rows, sheet);
    let (scalar, vector) = parameters;
    sheet.answer("euler_parameter_scalar", "Euler parameter β₀, scalar part", scalar);
    sheet.answer_vector("euler_parameter_vector", "Euler parameters β₁, β₂, β₃", vector);
    let half = sheet.step("s", "1", vector.magnitude(), "Length of the vector part: sin(Φ/2)");
    sheet.common_error("Φ", "the three Euler angles combined as the components of a vector", || {
        let [first, second, third] = from_elements(sequence, rows.map(Vector::components)).1;
        (first.powi(2) + second.powi(2) + third.powi(2)).sqrt()
    });
    let angle = sheet.step(
        "Φ",
        "deg",
        half.atan2(scalar) * 2.0,
        ("Principal angle, from 0° to 180°", SCHAUB.at("§3.4")),
    );
    sheet.answer("principal_angle", "Principal angle", angle);
    let c = matrix(rows);
    let still = half.value() <= NONE;
    if still {
        sheet.warn(|| {
            "the frames coincide: the principal angle is 0°, and any axis is the principal one".into()
        });
    } else {
        let axis = sheet.step_vector(
            "e",
            "1",
            vector / half,
            ("Principal axis, in components in N and in B alike", SCHAUB.at("§3.4")),
        );
        sheet.answer_vector("principal_axis", "Principal axis", axis);
        let turned =
            sheet.step_vector("γ", "rad", axis * angle, "Principal rotation vector: axis times angle");
        sheet.answer_vector("rotation_vector", "Principal rotation vector", turned);
        sheet.verify(|| {
            let off =
                c - Rotation3::from_axis_angle(&Unit::new_unchecked(axis.value()), -angle.value()).matrix();
            sheet.check_zeros("[BN] by a rotation about the principal axis", off.iter().copied(), 1.0);
            let off = c - Rotation3::from_scaled_axis(-turned.value()).matrix();
            sheet.check_zeros("[BN] by the principal rotation vector", off.iter().copied(), 1.0);
        });
    }
    let angles = angles_of(sequence, rows, sheet);
    for (n, angle) in angles.angles.into_iter().enumerate() {
        sheet.answer(("euler_angle", n + 1), "Euler angle", angle);
    }
    if angles.gimbal_lock {
        sheet.warn(|| {
            Text::new("gimbal lock: at this second angle the first and the third rotation of {sequence} are about one line; the third angle was set to zero")
                .with("sequence", sequence.name())
        });
    }
    let rodrigues = (scalar.value() > NONE).then(|| {
        let q = sheet.step_vector(
            "q",
            "1",
            vector / scalar,
            ("Rodrigues parameters, along the axis with tan(Φ/2)", SCHAUB.at("§3.6")),
        );
        sheet.answer_vector("rodrigues_parameters", "Rodrigues parameters: Gibbs vector", q);
        q
    });
    if rodrigues.is_none() {
        sheet.warn(|| {
            "the principal angle is 180°: the Rodrigues parameters are infinite, and the principal axis may be taken in either sense".into()
        });
    }
    let modified = sheet.step_vector(
        "σ",
        "1",
        vector / (scalar + 1.0),
        ("Modified Rodrigues parameters, along the axis with tan(Φ/4)", SHUSTER.at("pp. 475–476")),
    );
    sheet.answer_vector("modified_rodrigues", "Modified Rodrigues parameters", modified);
    let shadow = (!still).then(|| {
        let shadow = sheet.step_vector(
            "σ_s",
            "1",
            -modified / modified.dot(modified),
            ("Shadow set: the rotation the long way round, by Φ − 360°", SCHAUB.at("§3.7")),
        );
        sheet.answer_vector("modified_rodrigues_shadow", "Shadow set: the long way round", shadow);
        shadow
    });
    sheet.verify(|| {
        sheet.check_zeros("the rows of [BN] are orthonormal", off_rotation(&c).iter().copied(), 1.0);
        let quaternion =
            UnitQuaternion::new_unchecked(Quaternion::from_parts(scalar.value(), vector.value()));
        let off = c - Matrix3::from_columns(&[0, 1, 2].map(|n| quaternion.inverse() * super::euler::unit(n)));
        sheet.check_zeros("[BN] from vectors rotated by the quaternion", off.iter().copied(), 1.0);
        let off = c - sequence.product(angles.angles.map(Real::value));
        sheet.check_zeros("[BN] as the product of the three Euler rotations", off.iter().copied(), 1.0);
        if let Some(q) = rodrigues {
            let q = q.value();
            sheet.check_zeros(
                "Cayley's formula for the Rodrigues parameters",
                off_cayley_formula(&c, q, false).iter().copied(),
                1.0 + q.norm(),
            );
        }
        for sigma in [Some(modified), shadow].into_iter().flatten() {
            let sigma = sigma.value();
            sheet.check_zeros(
                "Cayley's formula, squared, for modified Rodrigues parameters",
                off_cayley_formula(&c, sigma, true).iter().copied(),
                (1.0 + sigma.norm()).powi(2),
            );
        }
        let trace = (c.trace() - 1.0) / 2.0;
        sheet.check_sum("cos Φ from the trace of [BN]", angle.cos(), trace.into(), 1.0);
    });
    sheet.show(|| {
        Exhibit::Table(both_sets((scalar.value(), vector.value()), sequence, angles.angles.map(Real::value)))
    });
    Representations { angles, parameters, rodrigues, modified }
}

/// Euler parameters by Stanley's method: the largest one from the diagonal, the others by division by it.
fn euler_parameters<W: Worksheet>(rows: [W::Vec; 3], sheet: W) -> (W::Num, W::Vec) {
    let c = rows.map(Vector::components);
    let trace = sheet.step("tr", "1", c[0][0] + c[1][1] + c[2][2], "Trace of [BN]");
    let plain = [c[0][0], c[1][1], c[2][2]].map(Real::value);
    let sum: f64 = plain.iter().sum();
    let mut largest = 0;
    let mut most = sum;
    for (n, element) in plain.into_iter().enumerate() {
        // 4 β² − 1 of each.
        if 2.0 * element - sum > most {
            (largest, most) = (n + 1, 2.0 * element - sum);
        }
    }
    const WHY: &str = "Largest Euler parameter, from the diagonal of [BN]: the others by division by it";
    let why = (WHY, SCHAUB.at("§3.5"));
    let (scalar, parts) = if largest == 0 {
        let size = sheet.step("β_m", "1", (trace + 1.0).sqrt() / 2.0, why);
        let part = |n: usize| {
            let (j, k) = ((n + 1) % 3, (n + 2) % 3);
            (c[j][k] - c[k][j]) / (size * 4.0)
        };
        (size, [part(0), part(1), part(2)])
    } else {
        let n = largest - 1;
        let (j, k) = ((n + 1) % 3, (n + 2) % 3);
        let size = sheet.step("β_m", "1", (c[n][n] * 2.0 - trace + 1.0).sqrt() / 2.0, why);
        let mut parts = [size; 3];
        parts[j] = (c[n][j] + c[j][n]) / (size * 4.0);
        parts[k] = (c[n][k] + c[k][n]) / (size * 4.0);
        let scalar = (c[j][k] - c[k][j]) / (size * 4.0);
        if scalar.value() >= 0.0 {
            (scalar, parts)
        } else if scalar.value() > -ROUNDING {
            (-scalar, parts)
        } else {
            (-scalar, parts.map(|part| -part))
        }
    };
    sheet.common_error("β₀", "the cosine of the whole principal angle used", || (trace - 1.0) / 2.0);
    let scalar = sheet.step(
        "β₀",
        "1",
        scalar,
        ("Scalar Euler parameter; of the two sets of opposite sign that with β₀ ≥ 0", SCHAUB.at("§3.5")),
    );
    let [x, y, z] = parts;
    let vector = sheet.step_vector(
        "ε",
        "1",
        W::Vec::from_components(x, y, z),
        ("Vector part of the Euler parameters: e sin(Φ/2)", SCHAUB.at("§3.5")),
    );
    (scalar, vector)
}

/// Both sets of Euler parameters, of principal rotations and of Euler angles.
fn both_sets(
    (scalar, vector): (f64, nalgebra::Vector3<f64>),
    sequence: EulerSequence,
    [first, second, third]: [f64; 3],
) -> TableExhibit {
    use std::f64::consts::{PI, TAU};
    let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
    let angle = 2.0 * vector.norm().atan2(scalar);
    let clean = |x: f64| Cell::Number(if x.abs() < 1e-15 { 0.0 } else { x });
    let wrap = |x: f64| {
        if x > PI {
            x - TAU
        } else if x <= -PI {
            x + TAU
        } else {
            x
        }
    };
    // The other middle angle of the same attitude: −θ₂ where the axis comes back, 180° − θ₂ otherwise.
    let other_second = if sequence.repeats() { -second } else { wrap(PI - second) };
    let row = |label: &'static str, sign: f64, angle: f64, angles: [f64; 3]| {
        let mut cells = vec![Cell::Text(label.into()), clean(sign * scalar)];
        cells.extend(vector.iter().map(|x| clean(sign * x)));
        cells.push(clean(angle));
        cells.extend(angles.map(clean));
        cells
    };
    TableExhibit {
        title: "Both sets of parameters of this attitude".into(),
        columns: vec![
            column("Set", ""),
            column("β₀", "1"),
            column("β₁", "1"),
            column("β₂", "1"),
            column("β₃", "1"),
            column("Φ", "deg"),
            column("θ₁", "deg"),
            column("θ₂", "deg"),
            column("θ₃", "deg"),
        ],
        rows: vec![
            row("short way", 1.0, angle, [first, second, third]),
            row("long way", -1.0, angle - TAU, [wrap(first + PI), other_second, wrap(third + PI)]),
        ],
        foot: Vec::new(),
    }
}
